//! Fewer triangles for the same shape: edge collapse with quadric error metrics.
//!
//! Michael Garland, Paul Heckbert, "Surface Simplification Using Quadric Error Metrics", 1997. Each new vertex is put back
//! onto the field's surface, and a collapse that would break the manifold (link condition) or turn a face is refused.

use std::cmp::Ordering;
use std::collections::{BTreeSet, BinaryHeap};

use glam::{DMat3, DVec3};

use super::contour::Surface;
use super::field::Field;
use super::mesh::index;

/// When to stop.
#[derive(Clone, Copy, Debug)]
pub struct Budget {
    /// Stop at this many triangles.
    pub triangles: usize,
    /// Or when the next collapse would move the surface by more than this, millimetres (root mean square).
    pub error: f64,
}

/// Faces lower than this (millimetres) are removed at the end.
const LOW: f64 = 0.012;
/// Weight of smeared shading against the displacement squared.
const SHADING: f64 = 0.006;
/// Edges shorter than this (millimetres) are always worth collapsing.
const SHORT: f64 = 0.02;
/// The least height of a face over its longest side that a collapse may leave.
const SLIM: f64 = 0.06;

/// A sum of squared distances to planes, weighted by area: x'Ax - 2b'x + c.
#[derive(Clone, Copy)]
struct Quadric {
    a: DMat3,
    b: DVec3,
    c: f64,
    weight: f64,
}

impl Quadric {
    const ZERO: Self = Self { a: DMat3::ZERO, b: DVec3::ZERO, c: 0.0, weight: 0.0 };

    fn of_plane(normal: DVec3, point: DVec3, weight: f64) -> Self {
        let d = normal.dot(point);
        let n = normal * weight;
        Self { a: DMat3::from_cols(n * normal.x, n * normal.y, n * normal.z), b: n * d, c: weight * d * d, weight }
    }

    fn plus(self, other: Self) -> Self {
        Self { a: self.a + other.a, b: self.b + other.b, c: self.c + other.c, weight: self.weight + other.weight }
    }

    /// Mean squared distance of `p` to the planes.
    fn error(&self, p: DVec3) -> f64 {
        ((self.a * p).dot(p) - 2.0 * self.b.dot(p) + self.c).max(0.0) / self.weight.max(1e-30)
    }

    /// The point of least error, drawn slightly to `near` so that flat regions are well posed.
    fn best(&self, near: DVec3) -> DVec3 {
        let pull = 1e-3 * self.weight;
        let a = self.a + DMat3::from_diagonal(DVec3::splat(pull));
        let p = a.inverse() * (self.b + near * pull);
        if p.is_finite() { p } else { near }
    }
}

/// A possible collapse; the queue's order is total, so the result is the same everywhere.
struct Candidate {
    cost: f64,
    edge: [u32; 2],
    stamp: [u32; 2],
    to: DVec3,
}

impl PartialEq for Candidate {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}
impl Eq for Candidate {}
impl PartialOrd for Candidate {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
impl Ord for Candidate {
    fn cmp(&self, other: &Self) -> Ordering {
        other.cost.total_cmp(&self.cost).then(other.edge.cmp(&self.edge))
    }
}

struct Work<'a> {
    field: &'a dyn Field,
    positions: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    alive: Vec<bool>,
    faces_of: Vec<Vec<u32>>,
    quadrics: Vec<Quadric>,
    /// Unit normals of the field at the vertices.
    normals: Vec<DVec3>,
    stamps: Vec<u32>,
    locked: usize,
}

/// Simplifies `surface`. Its first `locked` positions stay where they are.
#[must_use]
pub fn simplify(field: &dyn Field, surface: Surface, locked: usize, budget: Budget) -> Surface {
    let mut work = Work::new(field, surface, locked);
    let mut queue = BinaryHeap::new();
    for v in 0..work.positions.len() {
        for u in work.neighbours(index(v)) {
            if (v as u32) < u {
                queue.extend(work.candidate(index(v), u));
            }
        }
    }
    let mut count = work.triangles.len();
    while count > budget.triangles {
        let Some(candidate) = queue.pop() else { break };
        if candidate.cost > budget.error * budget.error {
            break;
        }
        let [u, v] = candidate.edge;
        if [work.stamps[u as usize], work.stamps[v as usize]] != candidate.stamp {
            continue;
        }
        let to = work.settle(u, v, candidate.to);
        if !work.is_allowed(u, v, to) {
            continue;
        }
        count -= work.collapse(u, v, to);
        for w in work.neighbours(u) {
            queue.extend(work.candidate(u.min(w), u.max(w)));
        }
    }
    work.remove_needles();
    work.finish()
}

impl<'a> Work<'a> {
    fn new(field: &'a dyn Field, surface: Surface, locked: usize) -> Self {
        let Surface { positions, triangles } = surface;
        let mut faces_of = vec![Vec::new(); positions.len()];
        let mut quadrics = vec![Quadric::ZERO; positions.len()];
        for (f, t) in triangles.iter().enumerate() {
            let [a, b, c] = t.map(|i| positions[i as usize]);
            let area = (b - a).cross(c - a);
            let q = Quadric::of_plane(area.normalize_or_zero(), a, area.length() / 6.0);
            for &i in t {
                faces_of[i as usize].push(index(f));
                quadrics[i as usize] = quadrics[i as usize].plus(q);
            }
        }
        let alive = vec![true; triangles.len()];
        let stamps = vec![0; positions.len()];
        let normals = positions.iter().map(|p| field.gradient(*p).normalize_or_zero()).collect();
        Self { field, positions, triangles, alive, faces_of, quadrics, normals, stamps, locked }
    }

    fn is_locked(&self, v: u32) -> bool {
        (v as usize) < self.locked
    }

    /// The vertices joined to `v` by an edge, ascending.
    fn neighbours(&self, v: u32) -> BTreeSet<u32> {
        self.faces_of[v as usize].iter().flat_map(|f| self.triangles[*f as usize]).filter(|u| *u != v).collect()
    }

    fn candidate(&self, u: u32, v: u32) -> Option<Candidate> {
        if self.is_locked(u) && self.is_locked(v) {
            return None;
        }
        let q = self.quadrics[u as usize].plus(self.quadrics[v as usize]);
        let (pu, pv) = (self.positions[u as usize], self.positions[v as usize]);
        let length = pu.distance(pv);
        let to = if self.is_locked(u) {
            pu
        } else if self.is_locked(v) {
            pv
        } else {
            let middle = (pu + pv) * 0.5;
            let best = q.best(middle);
            if best.distance(middle) < length { best } else { middle }
        };
        // A little of the length keeps flat regions from collapsing into fans of needles.
        // What is shorter than a few file digits goes first.
        let cost =
            if length < SHORT { 0.0 } else { q.error(to) + 1e-7 * length * length + SHADING * self.shading(u, v, to) };
        Some(Candidate { cost, edge: [u, v], stamp: [self.stamps[u as usize], self.stamps[v as usize]], to })
    }

    /// How far a change of the normal would be smeared around the new vertex: the largest 1 - cos(angle) times length squared.
    fn shading(&self, u: u32, v: u32, to: DVec3) -> f64 {
        let normal = (self.normals[u as usize] + self.normals[v as usize]).normalize_or_zero();
        let ring =
            [u, v].into_iter().flat_map(|w| self.faces_of[w as usize].iter()).flat_map(|f| self.triangles[*f as usize]);
        ring.map(|w| (1.0 - normal.dot(self.normals[w as usize])) * to.distance_squared(self.positions[w as usize]))
            .fold(0.0, f64::max)
    }

    /// Puts the new vertex of edge (u, v) onto the field's surface; locked vertices stay.
    fn settle(&self, u: u32, v: u32, to: DVec3) -> DVec3 {
        if self.is_locked(u) || self.is_locked(v) {
            return to;
        }
        self.field.project(to, self.positions[u as usize].distance(self.positions[v as usize]))
    }

    fn is_allowed(&self, u: u32, v: u32, to: DVec3) -> bool {
        // Link condition: exactly the two faces of the edge vanish.
        let shared = self.neighbours(u).intersection(&self.neighbours(v)).count();
        let common = self.faces_of[u as usize].iter().filter(|f| self.triangles[**f as usize].contains(&v)).count();
        if shared != 2 || common != 2 {
            return false;
        }
        // No face may turn or become a needle.
        [(u, v), (v, u)].iter().all(|&(moved, other)| {
            self.faces_of[moved as usize].iter().all(|f| {
                let t = self.triangles[*f as usize];
                if t.contains(&other) {
                    return true;
                }
                let old = t.map(|i| self.positions[i as usize]);
                let new = t.map(|i| if i == moved { to } else { self.positions[i as usize] });
                let (n0, n1) = ((old[1] - old[0]).cross(old[2] - old[0]), (new[1] - new[0]).cross(new[2] - new[0]));
                let longest = |t: [DVec3; 3]| (0..3).map(|i| t[i].distance_squared(t[(i + 1) % 3])).fold(0.0, f64::max);
                let (slim0, slim1) = (n0.length() / longest(old).max(1e-12), n1.length() / longest(new).max(1e-12));
                // A needle's own direction means little.
                let turns = slim0 > SLIM && n1.dot(n0) < 0.8 * n1.length() * n0.length();
                !turns && slim1 > SLIM.min(slim0)
            })
        })
    }

    /// Moves `u` to `to` and merges `v` into it; returns the number of faces that vanish. A locked vertex keeps its index.
    fn collapse(&mut self, u: u32, v: u32, to: DVec3) -> usize {
        let mut gone = 0;
        for f in std::mem::take(&mut self.faces_of[v as usize]) {
            if self.triangles[f as usize].contains(&u) {
                self.alive[f as usize] = false;
                gone += 1;
                for w in self.triangles[f as usize] {
                    self.faces_of[w as usize].retain(|g| *g != f);
                }
            } else {
                self.triangles[f as usize] = self.triangles[f as usize].map(|w| if w == v { u } else { w });
                self.faces_of[u as usize].push(f);
            }
        }
        self.positions[u as usize] = to;
        self.normals[u as usize] = self.field.gradient(to).normalize_or_zero();
        self.quadrics[u as usize] = self.quadrics[u as usize].plus(self.quadrics[v as usize]);
        self.stamps[u as usize] += 1;
        self.stamps[v as usize] += 1;
        gone
    }

    /// Collapses an edge of each face that is lower than the file's digits can tell.
    fn remove_needles(&mut self) {
        for f in 0..self.triangles.len() {
            if !self.alive[f] {
                continue;
            }
            let t = self.triangles[f];
            let p = t.map(|i| self.positions[i as usize]);
            let sides: [f64; 3] = std::array::from_fn(|i| p[i].distance(p[(i + 1) % 3]));
            let height = (p[1] - p[0]).cross(p[2] - p[0]).length() / sides.iter().copied().fold(1e-9, f64::max);
            if height > LOW {
                continue;
            }
            let mut edges = [0, 1, 2];
            edges.sort_by(|a, b| sides[*a].total_cmp(&sides[*b]));
            for i in edges {
                let (u, v) = (t[i], t[(i + 1) % 3]);
                let (u, v) = if self.is_locked(v) { (v, u) } else { (u, v) };
                let (pu, pv) = (self.positions[u as usize], self.positions[v as usize]);
                let targets = if self.is_locked(u) { [pu; 3] } else { [pu, pv, (pu + pv) * 0.5] };
                let to = targets.into_iter().find(|to| !self.is_locked(v) && self.is_allowed(u, v, *to));
                if let Some(to) = to {
                    self.collapse(u, v, to);
                    break;
                }
            }
        }
    }

    /// Drops what vanished; the locked positions keep their indices.
    fn finish(self) -> Surface {
        let mut new_index = vec![u32::MAX; self.positions.len()];
        let mut positions = self.positions[..self.locked].to_vec();
        for (i, slot) in new_index.iter_mut().enumerate().take(self.locked) {
            *slot = index(i);
        }
        let mut triangles = Vec::new();
        for (t, _) in self.triangles.iter().zip(&self.alive).filter(|(_, alive)| **alive) {
            triangles.push(t.map(|i| {
                let slot = &mut new_index[i as usize];
                if *slot == u32::MAX {
                    *slot = index(positions.len());
                    positions.push(self.positions[i as usize]);
                }
                *slot
            }));
        }
        Surface { positions, triangles }
    }
}
