//! The tree over the triangles of one mesh.

use crate::math::bounds::Bounds;
use crate::math::ray::Ray;
use crate::shape::triangle::{self, ShearedRay, TriangleHit};
use glam::Vec3;

const LEAF: usize = 4;

/// Triangles of a mesh, ordered for ray queries. Immutable; share it behind `Arc`.
#[derive(Debug)]
pub struct MeshTree {
    nodes: Vec<Node>,
    triangles: Vec<([Vec3; 3], u32)>,
    bounds: Bounds,
}

#[derive(Debug)]
struct Node {
    bounds: Bounds,
    /// First triangle of a leaf, or the right child (the left one follows its parent).
    first: u32,
    /// Number of triangles; 0 for an inner node.
    count: u32,
}

/// Figures about a tree.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MeshStatistics {
    /// Triangles that can be hit.
    pub triangles: usize,
    /// Inner nodes.
    pub nodes: usize,
    /// Leaves.
    pub leaves: usize,
    /// Inner nodes on the longest way from the root to a leaf.
    pub depth: usize,
}

impl MeshTree {
    /// Builds the tree. `threads` is how many threads it may use; the tree does not depend on it.
    /// Triangles with zero area, with an index out of range or with a vertex that is not finite are left out: never hit.
    pub fn build<P: Copy + Into<Vec3> + Sync>(positions: &[P], triangles: &[[u32; 3]], threads: usize) -> Self {
        let _ = threads;
        let mut kept = Vec::with_capacity(triangles.len());
        for (index, corners) in (0_u32..).zip(triangles) {
            let vertices = corners.map(|k| positions.get(k as usize).map(|&p| p.into()));
            if let [Some(a), Some(b), Some(c)] = vertices
                && [a, b, c].iter().all(|v: &Vec3| v.is_finite())
            {
                kept.push(([a, b, c], index));
            }
        }
        let bounds = kept.iter().fold(Bounds::EMPTY, |all, t| all.union(Bounds::of_points(t.0)));
        let mut nodes = Vec::new();
        if !kept.is_empty() {
            let end = kept.len();
            split(&mut nodes, &mut kept, 0, end);
        }
        Self { nodes, triangles: kept, bounds }
    }

    /// The box around all triangles, in object space.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// Bytes of memory it holds.
    pub fn memory_bytes(&self) -> usize {
        size_of_val(self.nodes.as_slice()) + size_of_val(self.triangles.as_slice())
    }

    /// Figures about its shape.
    pub fn statistics(&self) -> MeshStatistics {
        let leaves = self.nodes.iter().filter(|node| node.count > 0).count();
        MeshStatistics { triangles: self.triangles.len(), nodes: self.nodes.len() - leaves, leaves, depth: 0 }
    }

    /// Visits every triangle whose leaf the ray's line meets.
    pub(crate) fn visit(&self, ray: &Ray, cost: &mut [u32; 2], mut hit: impl FnMut(TriangleHit, u32)) {
        let sheared = ShearedRay::new(ray.direction);
        let mut stack = Vec::new();
        if !self.nodes.is_empty() {
            stack.push(0);
        }
        while let Some(index) = stack.pop() {
            let node = &self.nodes[index];
            cost[0] += 1;
            if !meets(&node.bounds, ray) {
                continue;
            }
            if node.count == 0 {
                stack.push(node.first as usize);
                stack.push(index + 1);
                continue;
            }
            for (vertices, primitive) in &self.triangles[node.first as usize..][..node.count as usize] {
                cost[1] += 1;
                if let Some(found) = triangle::intersect(*vertices, ray, &sheared) {
                    hit(found, *primitive);
                }
            }
        }
    }
}

fn split(nodes: &mut Vec<Node>, triangles: &mut [([Vec3; 3], u32)], begin: usize, end: usize) {
    let here = nodes.len();
    let range = &mut triangles[begin..end];
    let bounds = range.iter().fold(Bounds::EMPTY, |all, t| all.union(Bounds::of_points(t.0)));
    nodes.push(Node { bounds, first: begin as u32, count: range.len() as u32 });
    if range.len() <= LEAF {
        return;
    }
    let size = bounds.size();
    let axis = if size.x >= size.y && size.x >= size.z {
        0
    } else if size.y >= size.z {
        1
    } else {
        2
    };
    let key = |t: &([Vec3; 3], u32)| t.0[0][axis] + t.0[1][axis] + t.0[2][axis];
    let middle = range.len() / 2;
    range.select_nth_unstable_by(middle, |a, b| key(a).total_cmp(&key(b)).then(a.1.cmp(&b.1)));
    split(nodes, triangles, begin, begin + middle);
    nodes[here].first = nodes.len() as u32;
    nodes[here].count = 0;
    split(nodes, triangles, begin + middle, end);
}

/// Whether the ray may meet the box; never false when it does.
pub(crate) fn meets(bounds: &Bounds, ray: &Ray) -> bool {
    const SLACK: f32 = 8.0 * f32::EPSILON;
    let (mut near, mut far) = (ray.t_min, ray.t_max);
    for axis in 0..3 {
        let (o, d) = (ray.origin[axis], ray.direction[axis]);
        if d == 0.0 {
            // Not left to the division: 0/0 when the origin lies on the slab.
            if !(bounds.min[axis] <= o && o <= bounds.max[axis]) {
                return false;
            }
            continue;
        }
        let a = (bounds.min[axis] - o) / d;
        let b = (bounds.max[axis] - o) / d;
        near = near.max(a.min(b) * (1.0 - SLACK));
        far = far.min(a.max(b) * (1.0 + SLACK));
    }
    near <= far
}
