//! Polygons to triangles: fans where they are convex, clipped ears where they are not.
//!
//! Ear clipping (Meisters, "Polygons have ears", 1975) in the polygon's plane. Only corners that bend inwards can lie in
//! an ear (Eberly, "Triangulation by ear clipping", 1998); they wait in a grid, so that an ear looks at those near it.
//! Each corner is looked at again only when a neighbour goes, which makes the usual polygon nearly linear in time; the
//! worst is quadratic and ends at a stated number of steps, after which ears are clipped unseen.

use std::collections::VecDeque;

/// A polygon in triangles.
#[derive(Debug, Default, PartialEq, Eq)]
pub struct Triangulation {
    /// Three corner numbers each, in the polygon's own sense of rotation.
    pub triangles: Vec<[u32; 3]>,
    /// Whether the outline crosses itself, or was too much work: the triangles cover it only about.
    pub is_tangled: bool,
}

/// How many times a corner may be compared with an ear, over all polygons of a file: seconds, not minutes.
pub const EFFORT: u64 = 1_000_000_000;
/// The same for one polygon.
const EFFORT_EACH: u64 = 200_000_000;

/// Cuts a polygon of at least three corners into `n - 2` triangles.
///
/// The outline may be concave, may touch itself (holes joined by a bridge) and need not be quite flat. Outlines that cross
/// themselves are covered as well as can be. `effort` is what is left of [`EFFORT`].
#[must_use]
pub fn polygon(outline: &[[f32; 3]], effort: &mut u64) -> Triangulation {
    let count = u32::try_from(outline.len()).unwrap_or(u32::MAX);
    if let [_, _, _] = outline {
        return Triangulation { triangles: vec![[0, 1, 2]], is_tangled: false };
    }
    let points = flattened(outline);
    if let &[a, b, c, d] = points.as_slice() {
        // The diagonal that leaves both halves facing the same way; the one from the first corner if both do.
        let by_first = area(a, b, c) >= 0.0 && area(a, c, d) >= 0.0;
        let by_second = area(b, c, d) >= 0.0 && area(b, d, a) >= 0.0;
        let triangles = if by_first || !by_second { vec![[0, 1, 2], [0, 2, 3]] } else { vec![[1, 2, 3], [1, 3, 0]] };
        return Triangulation { triangles, is_tangled: !by_first && !by_second };
    }
    if is_convex(&points) {
        let fan = (1..count.saturating_sub(1)).map(|i| [0, i, i.saturating_add(1)]);
        return Triangulation { triangles: fan.collect(), is_tangled: false };
    }
    let mut granted = EFFORT_EACH.min(*effort);
    *effort = effort.saturating_sub(granted);
    let result = Clipper::new(points).run(&mut granted);
    *effort = effort.saturating_add(granted);
    result
}

type Point = [f64; 2];

/// The outline without the coordinate along which it is flattest, turned to run counter-clockwise.
///
/// Leaving out a coordinate keeps the others exact, and keeps what is inside inside.
fn flattened(outline: &[[f32; 3]]) -> Vec<Point> {
    let first = outline.first().copied().unwrap_or_default().map(f64::from);
    // Newell's normal, from differences so that a polygon far from the origin keeps its digits.
    let mut normal = [0.0_f64; 3];
    let mut previous = outline.last().copied().unwrap_or_default().map(f64::from);
    for corner in outline {
        let corner = corner.map(f64::from);
        let [ax, ay, az] = [previous[0] - first[0], previous[1] - first[1], previous[2] - first[2]];
        let [bx, by, bz] = [corner[0] - first[0], corner[1] - first[1], corner[2] - first[2]];
        normal = [normal[0] + (ay * bz - az * by), normal[1] + (az * bx - ax * bz), normal[2] + (ax * by - ay * bx)];
        previous = corner;
    }
    let [nx, ny, nz] = normal;
    let flat = |[x, y, z]: [f32; 3]| -> Point {
        let [x, y, z] = [x, y, z].map(f64::from);
        let ([u, v], facing) = if nz.abs() >= nx.abs() && nz.abs() >= ny.abs() {
            ([x, y], nz)
        } else if nx.abs() >= ny.abs() {
            ([y, z], nx)
        } else {
            ([z, x], ny)
        };
        if facing < 0.0 { [v, u] } else { [u, v] }
    };
    outline.iter().copied().map(flat).collect()
}

/// Twice the area of a triangle; above zero where it runs counter-clockwise.
#[inline]
fn area([ax, ay]: Point, [bx, by]: Point, [cx, cy]: Point) -> f64 {
    (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
}

/// Whether every corner bends the same way, strictly, and the outline goes round once.
fn is_convex(points: &[Point]) -> bool {
    let next = points.iter().cycle().skip(1);
    let after = points.iter().cycle().skip(2);
    let corners = points.iter().zip(next).zip(after);
    // Round once: the direction along x turns over twice. A five-pointed star bends one way, too, but goes round twice.
    let mut turns = 0_u32;
    for ((a, b), c) in corners {
        if area(*a, *b, *c) <= 0.0 {
            return false;
        }
        turns = turns.saturating_add(u32::from((b[0] >= a[0]) != (c[0] >= b[0])));
    }
    turns == 2
}

/// The outline that is left, as a ring of corners.
struct Clipper {
    points: Vec<Point>,
    next: Vec<u32>,
    previous: Vec<u32>,
    /// Whether a corner is still there and does not bend outwards, so that it may lie in an ear.
    blocks: Vec<bool>,
    gone: Vec<bool>,
    /// A corner that is still there.
    some: u32,
    grid: Grid,
}

impl Clipper {
    fn new(points: Vec<Point>) -> Self {
        let count = u32::try_from(points.len()).unwrap_or(u32::MAX);
        let last = count.saturating_sub(1);
        let mut clipper = Self {
            next: (0..count).map(|i| if i == last { 0 } else { i.saturating_add(1) }).collect(),
            previous: (0..count).map(|i| if i == 0 { last } else { i.saturating_sub(1) }).collect(),
            blocks: Vec::new(),
            gone: vec![false; points.len()],
            some: 0,
            grid: Grid::default(),
            points,
        };
        clipper.blocks = (0..count).map(|i| clipper.bend(i) <= 0.0).collect();
        clipper.grid = Grid::new(&clipper.points, &clipper.blocks);
        clipper
    }

    fn run(mut self, effort: &mut u64) -> Triangulation {
        let count = u32::try_from(self.points.len()).unwrap_or(u32::MAX);
        let mut result = Triangulation::default();
        let mut left = count;
        let mut waiting: VecDeque<u32> = (0..count).collect();
        let mut clipped_since_scan = true;
        while left > 3 {
            let Some(corner) = waiting.pop_front() else {
                if clipped_since_scan && *effort > 0 {
                    // Corners that were blocked may have come free without a neighbour going, where outlines touch.
                    waiting.extend((0..count).filter(|i| !self.is_gone(*i)));
                    clipped_since_scan = false;
                    continue;
                }
                let corner = self.least_bad(effort);
                result.is_tangled |= self.bend(corner) != 0.0;
                self.clip(corner, &mut result.triangles, &mut waiting);
                left = left.saturating_sub(1);
                continue;
            };
            if self.is_gone(corner) || !self.is_ear(corner, effort) {
                continue;
            }
            result.is_tangled |= *effort == 0;
            self.clip(corner, &mut result.triangles, &mut waiting);
            clipped_since_scan = true;
            left = left.saturating_sub(1);
        }
        if let Some(corner) = (0..count).find(|i| !self.is_gone(*i)) {
            result.triangles.push(self.ear(corner));
        }
        result
    }

    /// Takes a corner away and notes what its neighbours have become.
    fn clip(&mut self, corner: u32, triangles: &mut Vec<[u32; 3]>, waiting: &mut VecDeque<u32>) {
        let [before, _, after] = self.ear(corner);
        triangles.push([before, corner, after]);
        set(&mut self.gone, corner, true);
        self.some = before;
        set(&mut self.blocks, corner, false);
        set(&mut self.next, before, after);
        set(&mut self.previous, after, before);
        for neighbour in [before, after] {
            let blocks = self.bend(neighbour) <= 0.0;
            set(&mut self.blocks, neighbour, blocks);
            if !blocks {
                waiting.push_back(neighbour);
            }
        }
    }

    /// What to clip when there is no ear: a corner without area if there is one, else one that bends outwards; any, once
    /// the effort is used up.
    fn least_bad(&self, effort: &mut u64) -> u32 {
        let last = get(&self.previous, self.some);
        let mut best = self.some;
        let mut bends_outwards = false;
        let mut i = self.some;
        loop {
            *effort = effort.saturating_sub(1);
            let bend = self.bend(i);
            if bend == 0.0 {
                return i;
            }
            if bend > 0.0 && !bends_outwards {
                (best, bends_outwards) = (i, true);
            }
            if *effort == 0 || i == last {
                return best;
            }
            i = get(&self.next, i);
        }
    }

    /// Whether the corner bends outwards and nothing lies in the triangle that goes with it.
    fn is_ear(&self, corner: u32, effort: &mut u64) -> bool {
        let [before, _, after] = self.ear(corner);
        let [a, b, c] = [before, corner, after].map(|i| self.point(i));
        if area(a, b, c) <= 0.0 {
            return false;
        }
        // On the new edge counts as inside, on the two old ones not: there an outline may touch itself, and what goes on
        // into the ear has a corner in it.
        let inside = |p: Point| area(a, b, p) > 0.0 && area(b, c, p) > 0.0 && area(c, a, p) >= 0.0;
        let is_free = |i: u32| !get(&self.blocks, i) || !inside(self.point(i));
        self.grid.all_near([a, b, c], effort, is_free)
    }

    fn ear(&self, corner: u32) -> [u32; 3] {
        [get(&self.previous, corner), corner, get(&self.next, corner)]
    }

    /// Above zero where the corner bends outwards, zero where it is straight or turns right back.
    fn bend(&self, corner: u32) -> f64 {
        let [a, b, c] = self.ear(corner).map(|i| self.point(i));
        area(a, b, c)
    }

    fn point(&self, i: u32) -> Point {
        get(&self.points, i)
    }

    fn is_gone(&self, i: u32) -> bool {
        get(&self.gone, i)
    }
}

fn get<T: Copy + Default>(list: &[T], i: u32) -> T {
    usize::try_from(i).ok().and_then(|i| list.get(i)).copied().unwrap_or_default()
}

fn set<T>(list: &mut [T], i: u32, value: T) {
    if let Some(slot) = usize::try_from(i).ok().and_then(|i| list.get_mut(i)) {
        *slot = value;
    }
}

/// The inward corners by place.
#[derive(Default)]
struct Grid {
    low: Point,
    /// Cells per unit along each axis.
    scale: Point,
    side: usize,
    /// Where each cell's corners begin in `corners`, and the end.
    starts: Vec<u32>,
    corners: Vec<u32>,
}

impl Grid {
    fn new(points: &[Point], blocks: &[bool]) -> Self {
        let inward = || (0_u32..).zip(points.iter().zip(blocks)).filter(|(_, (_, b))| **b).map(|(i, (p, _))| (i, *p));
        let count = inward().count();
        let fold = |pick: fn(f64, f64) -> f64, from: f64| {
            inward().fold([from; 2], |[x, y], (_, [px, py])| [pick(x, px), pick(y, py)])
        };
        let (low, high) = (fold(f64::min, f64::INFINITY), fold(f64::max, f64::NEG_INFINITY));
        let side = count.isqrt().clamp(1, 512);
        #[allow(clippy::cast_precision_loss, reason = "at most 512")]
        let cells = side as f64;
        let along = |low: f64, high: f64| if high > low { cells / (high - low) } else { 0.0 };
        let scale = [along(low[0], high[0]), along(low[1], high[1])];
        let mut grid = Self { low, scale, side, starts: Vec::new(), corners: vec![0; count] };
        // Counting sort: the ends of the cells first, then each corner to the place before its cell's end.
        let mut ends = vec![0_u32; side.saturating_mul(side).saturating_add(1)];
        for (_, p) in inward() {
            if let Some(end) = ends.get_mut(grid.cell_of(p)) {
                *end = end.saturating_add(1);
            }
        }
        let mut sum = 0_u32;
        for end in &mut ends {
            sum = sum.saturating_add(*end);
            *end = sum;
        }
        for (i, p) in inward() {
            if let Some(end) = ends.get_mut(grid.cell_of(p)) {
                *end = end.saturating_sub(1);
                set(&mut grid.corners, *end, i);
            }
        }
        grid.starts = ends;
        grid
    }

    fn cell_of(&self, [x, y]: Point) -> usize {
        let [column, row] = [self.step(x, 0), self.step(y, 1)];
        row.saturating_mul(self.side).saturating_add(column)
    }

    /// The column or row of a coordinate; outside the grid the nearest.
    fn step(&self, value: f64, axis: usize) -> usize {
        let low = self.low.get(axis).copied().unwrap_or_default();
        let scale = self.scale.get(axis).copied().unwrap_or_default();
        let cell = (value - low) * scale;
        let most = self.side.saturating_sub(1);
        #[allow(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "cut off at 0, saturating, NaN is 0"
        )]
        let cell = cell.max(0.0) as usize;
        cell.min(most)
    }

    /// Whether `is_free` holds for every corner in the cells that the triangle's box touches; true, too, once the effort
    /// is used up.
    fn all_near(&self, triangle: [Point; 3], effort: &mut u64, is_free: impl Fn(u32) -> bool) -> bool {
        let [a, b, c] = triangle;
        let span = |axis: fn(&Point) -> f64, number: usize| {
            let (a, b, c) = (axis(&a), axis(&b), axis(&c));
            (self.step(a.min(b).min(c), number), self.step(a.max(b).max(c), number))
        };
        let (left, right) = span(|p| p[0], 0);
        let (bottom, top) = span(|p| p[1], 1);
        for row in bottom..=top {
            // The cells of a row lie side by side, and so do their corners.
            let cell = |column: usize| row.saturating_mul(self.side).saturating_add(column);
            let start = |cell: usize| self.starts.get(cell).and_then(|s| usize::try_from(*s).ok()).unwrap_or(0);
            let near = self.corners.get(start(cell(left))..start(cell(right).saturating_add(1))).unwrap_or(&[]);
            let work = u64::try_from(near.len()).unwrap_or(u64::MAX).saturating_add(1);
            if *effort < work {
                *effort = 0;
                return true;
            }
            *effort = effort.saturating_sub(work);
            if !near.iter().all(|i| is_free(*i)) {
                return false;
            }
        }
        true
    }
}
