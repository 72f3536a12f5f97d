//! Normals for the corners that the file gives none.
//!
//! The corners that meet at a vertex fall into fans, and a fan has one normal: the sum of its facets' normals, each
//! weighted by its angle at the vertex, so that it does not matter how a surface is cut into triangles (Thuermer and
//! Wuethrich, "Computing vertex normals from polygonal facets", 1998). Which corners make a fan:
//! - the file has `s` statements: those of the same smoothing group; with `s off` none, the facet's own normal serves;
//! - it has none: those that reach each other over edges that bend by at most [`CREASE_DEGREES`].

use super::triangles::{NO_NORMAL, NormalIndices, Triangles};
use super::weld::welded;
use crate::budget::{Budget, OverBudget};

/// An edge that bends by more is sharp, where the file says nothing of smoothing.
pub const CREASE_DEGREES: f32 = 40.0;
/// Cosine of 40 degrees.
const CREASE_COS: f64 = 0.766_044_443_118_978;
/// Cosine of 20 degrees: facets within it of one facet are within 40 of each other.
const HALF_CREASE_COS: f64 = 0.939_692_620_785_908_4;

/// Gives every corner a normal. On return each normal index of `triangles` is in range.
pub(super) fn complete(
    positions: &[[f32; 3]],
    triangles: &mut Triangles,
    normals: &mut Vec<[f32; 3]>,
    budget: &mut Budget,
) -> Result<(), OverBudget> {
    let has_own = match &triangles.normals {
        NormalIndices::SameAsVertices => return Ok(()),
        NormalIndices::Own(list) if list.iter().all(|n| *n != [NO_NORMAL; 3]) => return Ok(()),
        NormalIndices::Own(_) => true,
        NormalIndices::Absent => {
            // Normals that no face names.
            normals.clear();
            false
        }
    };
    let groups = groups(triangles, budget)?;
    let own = match std::mem::take(&mut triangles.normals) {
        NormalIndices::Own(list) if has_own => Some(list),
        _ => None,
    };
    let mut completion = Completion { positions, vertices: &triangles.vertices, own, base: normals.len(), normals };
    let facing_alone = completion.give_faceted_corners_none(groups.as_deref(), budget)?;
    if !facing_alone {
        let weld = if groups.is_none() { welded(positions, triangles.vertices.len(), budget)? } else { None };
        completion.give_fans_theirs(groups.as_deref(), weld.as_deref(), budget)?;
        if let Some(list) = weld {
            budget.release_list(&list, list.capacity());
        }
    }
    let own = completion.own;
    if let Some(list) = groups {
        budget.release_list(&list, list.capacity());
    }
    triangles.normals = own.map_or(NormalIndices::SameAsVertices, NormalIndices::Own);
    Ok(())
}

/// The smoothing group of each triangle, where the file has `s` statements; 0 is off, also before the first.
fn groups(triangles: &Triangles, budget: &mut Budget) -> Result<Option<Vec<u32>>, OverBudget> {
    if triangles.smoothing.is_empty() {
        return Ok(None);
    }
    let mut list = Vec::new();
    budget.reserve(&mut list, triangles.len(), "smoothing groups")?;
    list.extend(triangles.smoothing.values(triangles.len(), 0));
    Ok(Some(list))
}

struct Completion<'a> {
    positions: &'a [[f32; 3]],
    vertices: &'a [[u32; 3]],
    /// The normal indices; `None` as long as they equal the vertex indices.
    own: Option<Vec<[u32; 3]>>,
    /// How many normals the file gives. The first fan of vertex v gets number `base + v`, further ones come after.
    base: usize,
    normals: &'a mut Vec<[f32; 3]>,
}

/// A corner at a vertex.
struct Facet {
    /// Its place: three times the triangle, plus 0, 1 or 2.
    corner: usize,
    /// The vertices of its triangle before and after.
    neighbours: [u32; 2],
    group: u32,
    normal: [f64; 3],
    /// Angle at the vertex in radians; 0 for a triangle without area.
    angle: f64,
    /// The first facet of its fan.
    fan: usize,
}

impl Completion<'_> {
    fn needs(&self, triangle: usize) -> bool {
        self.own.as_ref().is_none_or(|list| list.get(triangle) == Some(&[NO_NORMAL; 3]))
    }

    /// Corners of `s off` share one normal, zero, which shading reads as "the facet's own". Answers whether no others
    /// are left.
    fn give_faceted_corners_none(&mut self, groups: Option<&[u32]>, budget: &mut Budget) -> Result<bool, OverBudget> {
        let Some(groups) = groups else { return Ok(false) };
        let count = self.vertices.len();
        let is_faceted = |triangle: usize| groups.get(triangle) == Some(&0);
        let needed = || (0..count).filter(|t| self.needs(*t));
        if !needed().any(is_faceted) {
            return Ok(false);
        }
        let none_left = needed().all(is_faceted);
        budget.reserve(self.normals, 1, "normals")?;
        let zero = u32::try_from(self.normals.len()).unwrap_or(u32::MAX);
        self.normals.push([0.0; 3]);
        self.base = self.normals.len();
        if self.own.is_none() {
            let mut list = Vec::new();
            budget.reserve(&mut list, count, "normal indices")?;
            list.resize(count, [NO_NORMAL; 3]);
            self.own = Some(list);
        }
        for (slot, group) in self.own.iter_mut().flatten().zip(groups) {
            if *group == 0 && *slot == [NO_NORMAL; 3] {
                *slot = [zero; 3];
            }
        }
        Ok(none_left)
    }

    fn give_fans_theirs(
        &mut self,
        groups: Option<&[u32]>,
        weld: Option<&[u32]>,
        budget: &mut Budget,
    ) -> Result<(), OverBudget> {
        let same = |vertex: u32| weld.map_or(vertex, |weld| at(weld, vertex));
        let (ends, corners) = self.corners_by_vertex(&same, budget)?;
        let count = self.positions.len();
        budget.reserve(self.normals, count, "normals")?;
        self.normals.resize(self.base.saturating_add(count), [0.0; 3]);
        let mut facets: Vec<Facet> = Vec::new();
        let mut order: Vec<(u32, usize)> = Vec::new();
        let mut start = 0_usize;
        for (vertex, end) in ends.iter().enumerate().take(count) {
            let end = usize::try_from(*end).unwrap_or(usize::MAX);
            let here = corners.get(start..end).unwrap_or(&[]);
            start = end;
            if here.is_empty() {
                continue;
            }
            facets.clear();
            facets.extend(here.iter().filter_map(|c| self.facet(*c, groups, &same)));
            match groups {
                Some(_) => join_groups(&mut facets, &mut order),
                None => join_over_soft_edges(&mut facets, &mut order),
            }
            self.give_normals(vertex, &facets, &mut order, budget)?;
        }
        budget.release_list(&ends, ends.capacity());
        budget.release_list(&corners, corners.capacity());
        Ok(())
    }

    /// The corners without normals, sorted by vertex: where each vertex's end, and their places.
    fn corners_by_vertex(
        &self,
        same: &dyn Fn(u32) -> u32,
        budget: &mut Budget,
    ) -> Result<(Vec<u32>, Vec<u32>), OverBudget> {
        let mut ends: Vec<u32> = Vec::new();
        budget.reserve(&mut ends, self.positions.len().saturating_add(1), "corners of vertices")?;
        ends.resize(self.positions.len().saturating_add(1), 0);
        let wanted = || (0_u32..).zip(self.vertices).enumerate().filter(|(t, _)| self.needs(*t)).map(|(_, v)| v);
        let slot = |vertex: u32| usize::try_from(same(vertex)).unwrap_or(usize::MAX);
        let mut total = 0_usize;
        for (_, triangle) in wanted() {
            total = total.saturating_add(3);
            for vertex in triangle {
                // One place further, so that the running sum below yields beginnings.
                if let Some(n) = ends.get_mut(slot(*vertex).saturating_add(1)) {
                    *n = n.saturating_add(1);
                }
            }
        }
        let mut sum = 0_u32;
        for end in &mut ends {
            sum = sum.saturating_add(*end);
            *end = sum;
        }
        let mut corners = Vec::new();
        budget.reserve(&mut corners, total, "corners of vertices")?;
        corners.resize(total, 0_u32);
        for (t, triangle) in wanted() {
            for (k, vertex) in (0_u32..).zip(triangle) {
                if let Some(place) = ends.get_mut(slot(*vertex)) {
                    if let Some(corner) = usize::try_from(*place).ok().and_then(|p| corners.get_mut(p)) {
                        *corner = t.saturating_mul(3).saturating_add(k);
                    }
                    *place = place.saturating_add(1);
                }
            }
        }
        Ok((ends, corners))
    }

    fn facet(&self, corner: u32, groups: Option<&[u32]>, same: &dyn Fn(u32) -> u32) -> Option<Facet> {
        let corner = usize::try_from(corner).ok()?;
        let triangle = corner / 3;
        let [a, b, c] = *self.vertices.get(triangle)?;
        let [here, after, before] = match corner % 3 {
            0 => [a, b, c],
            1 => [b, c, a],
            _ => [c, a, b],
        };
        let place = |v: u32| at(self.positions, v).map(f64::from);
        let p = place(here);
        let (u, v) = (minus(place(after), p), minus(place(before), p));
        let (normal, angle) = normal_and_angle(u, v);
        let group = groups.and_then(|g| g.get(triangle)).copied().unwrap_or(0);
        Some(Facet { corner, neighbours: [same(after), same(before)], group, normal, angle, fan: 0 })
    }

    /// Sums each fan and tells its corners where the sum lies.
    fn give_normals(
        &mut self,
        vertex: usize,
        facets: &[Facet],
        order: &mut Vec<(u32, usize)>,
        budget: &mut Budget,
    ) -> Result<(), OverBudget> {
        order.clear();
        order.extend(facets.iter().enumerate().map(|(i, f)| (u32::try_from(f.fan).unwrap_or(u32::MAX), i)));
        order.sort_unstable();
        for fan in order.chunk_by(|a, b| a.0 == b.0) {
            let facets = || fan.iter().filter_map(|(_, i)| facets.get(*i));
            let mut sum = [0.0_f64; 3];
            for facet in facets() {
                let [x, y, z] = facet.normal;
                sum = [sum[0] + x * facet.angle, sum[1] + y * facet.angle, sum[2] + z * facet.angle];
            }
            #[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
            let sum = sum.map(|c| c as f32);
            let is_first = matches!(fan, [(0, _), ..]);
            let number = if is_first { self.base.saturating_add(vertex) } else { self.normals.len() };
            match self.normals.get_mut(number) {
                Some(slot) => *slot = sum,
                None => {
                    if self.normals.len() == self.normals.capacity() {
                        budget.reserve(self.normals, (self.normals.len() / 2).max(64), "normals")?;
                    }
                    self.normals.push(sum);
                }
            }
            let number = u32::try_from(number).unwrap_or(u32::MAX);
            for facet in facets() {
                self.set(facet.corner, number, budget)?;
            }
        }
        Ok(())
    }

    /// Notes the normal of a corner. The list comes into being when the first differs from its vertex.
    fn set(&mut self, corner: usize, number: u32, budget: &mut Budget) -> Result<(), OverBudget> {
        let (triangle, k) = (corner / 3, corner % 3);
        if self.own.is_none() {
            if self.vertices.get(triangle).and_then(|v| v.get(k)) == Some(&number) {
                return Ok(());
            }
            let mut list = Vec::new();
            budget.reserve(&mut list, self.vertices.len(), "normal indices")?;
            list.extend_from_slice(self.vertices);
            self.own = Some(list);
        }
        if let Some(slot) = self.own.as_mut().and_then(|l| l.get_mut(triangle)).and_then(|t| t.get_mut(k)) {
            *slot = number;
        }
        Ok(())
    }
}

/// One fan for each smoothing group.
fn join_groups(facets: &mut [Facet], order: &mut Vec<(u32, usize)>) {
    order.clear();
    order.extend(facets.iter().enumerate().map(|(i, f)| (f.group, i)));
    order.sort_unstable();
    for same in order.chunk_by(|a, b| a.0 == b.0) {
        let Some((_, first)) = same.first() else { continue };
        for (_, i) in same {
            if let Some(facet) = facets.get_mut(*i) {
                facet.fan = *first;
            }
        }
    }
}

/// One fan for all that hang together by edges that do not bend much.
fn join_over_soft_edges(facets: &mut [Facet], order: &mut Vec<(u32, usize)>) {
    // Nearly always the whole neighbourhood is about flat; `fan` is 0 already.
    let first = facets.first().map_or([0.0; 3], |f| f.normal);
    if facets.iter().all(|f| dot(first, f.normal) > HALF_CREASE_COS) {
        return;
    }
    facets.iter_mut().enumerate().for_each(|(i, f)| f.fan = i);
    order.clear();
    order.extend(facets.iter().enumerate().flat_map(|(i, f)| f.neighbours.map(|n| (n, i))));
    order.sort_unstable();
    for pair in order.windows(2) {
        let [(v, i), (w, j)] = *pair else { continue };
        let normal = |i: usize| facets.get(i).map_or([0.0; 3], |f| f.normal);
        if v == w && dot(normal(i), normal(j)) >= CREASE_COS {
            let (a, b) = (root(facets, i), root(facets, j));
            if let Some(facet) = facets.get_mut(a.max(b)) {
                facet.fan = a.min(b);
            }
        }
    }
    for i in 0..facets.len() {
        let root = root(facets, i);
        if let Some(facet) = facets.get_mut(i) {
            facet.fan = root;
        }
    }
}

/// The first facet of the fan so far, with the path to it made shorter.
fn root(facets: &mut [Facet], mut i: usize) -> usize {
    loop {
        let parent = facets.get(i).map_or(i, |f| f.fan);
        if parent == i {
            return i;
        }
        let above = facets.get(parent).map_or(parent, |f| f.fan);
        if let Some(facet) = facets.get_mut(i) {
            facet.fan = above;
        }
        i = above;
    }
}

/// Unit normal of two edges from a vertex, and the angle between them; zeros if they span no area.
fn normal_and_angle(u: [f64; 3], v: [f64; 3]) -> ([f64; 3], f64) {
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let length = dot(n, n).sqrt();
    let edges = (dot(u, u) * dot(v, v)).sqrt();
    // Below f64's own rounding the direction would be noise.
    if length <= edges * 1e-14 || length.is_nan() {
        return ([0.0; 3], 0.0);
    }
    (n.map(|c| c / length), arc_cosine(dot(u, v) / edges))
}

/// Arc cosine to 7e-5, which is plenty for a weight (Abramowitz and Stegun, 4.4.45); only roots and products, so that
/// every machine finds the same bits.
fn arc_cosine(x: f64) -> f64 {
    let a = x.abs().min(1.0);
    let near_one = (1.0 - a).sqrt() * (1.570_728_8 + a * (-0.212_114_4 + a * (0.074_261 - a * 0.018_729_3)));
    if x < 0.0 { std::f64::consts::PI - near_one } else { near_one }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn at<T: Copy + Default>(list: &[T], i: u32) -> T {
    usize::try_from(i).ok().and_then(|i| list.get(i)).copied().unwrap_or_default()
}
