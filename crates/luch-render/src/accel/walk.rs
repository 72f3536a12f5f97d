//! One ray on its way through the trees, step by step: for those who want to see the way, not just its end.
//!
//! It meets the same boxes of the same trees as the kernels and the shapes by [`crate::shape`], nearest box first, and
//! finds the same hit bit for bit. In which order the kernels visit boxes depends on the instruction set, and rays that
//! walk together share visits; this walk is one ray's own, and the same on every machine.

use super::nodes::{Child, Leaf, Link, Node, Tree, WIDTH};
use super::objects::Object;
use super::scene_tree::SceneTree;
use super::slabs::Slabs;
use crate::math::ray::{Hit, Ray};
use crate::shape::triangle::{self, ShearedRay, TriangleHit};
use crate::simd::baseline;
use fearless_simd::prelude::*;
use glam::Vec3;

/// Told of each step of a walk.
pub(crate) trait Steps {
    /// The ray goes into a box, given by its corners in the space of `object`, or of the world.
    fn enter(&mut self, bounds: &[[f32; 3]; 2], level: u32, leaf: bool, object: Option<u32>);

    /// The ray is tested against a triangle or shape, and meets it at `t`, if at all before what it has met.
    fn test(&mut self, object: u32, primitive: u32, t: Option<f32>);
}

/// What a walk looks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Query {
    /// The nearest hit: camera and mirror rays.
    Closest,
    /// Any hit: shadow rays, which stop at the first.
    Any,
}

impl SceneTree {
    /// Walks with one ray, telling `steps` of the way. Answers with the hit that [`SceneTree::closest_hits`] finds;
    /// looking for any, with some hit if there is one.
    pub(crate) fn walk(&self, ray: &Ray, query: Query, steps: &mut dyn Steps) -> Option<Hit> {
        let mut walk = Walk { ray: *ray, query, hit: None, steps };
        let objects = self.objects();
        for &index in &objects.always {
            if let Object::Shape(shape) = &objects.list[index as usize] {
                walk.shape(shape, index);
                if walk.is_done() {
                    return walk.hit;
                }
            }
        }
        let world = *ray;
        walk.tree(&objects.tree, &world, 0, None, &mut |walk, index, level| match &objects.list[index as usize] {
            Object::Instance { tree, inverse } => {
                let local = inverse.ray(&world);
                // A mesh holds no objects.
                walk.tree(tree, &local, level, Some(index), &mut |_, _, _| {});
            }
            Object::Shape(shape) => {
                walk.steps.enter(&objects.bounds[index as usize], level, true, None);
                walk.shape(shape, index);
            }
        });
        walk.hit
    }
}

/// A walk on its way.
struct Walk<'a> {
    /// In world space; `t_max` stays where it was.
    ray: Ray,
    query: Query,
    hit: Option<Hit>,
    steps: &'a mut dyn Steps,
}

/// A box that waits: where the ray enters it, what is in it, how deep it lies, and its corners.
struct Waiting {
    near: f32,
    link: Link,
    level: u32,
    bounds: [[f32; 3]; 2],
}

/// What a walk does at an object of the tree.
type AtObject<'a, 'b> = &'a mut dyn FnMut(&mut Walk<'b>, u32, u32);

impl<'a> Walk<'a> {
    /// Walks through a tree with the ray in the tree's space. Its root is at `level`.
    fn tree(&mut self, tree: &Tree, ray: &Ray, level: u32, object: Option<u32>, at_object: AtObject<'_, 'a>) {
        let Some(root) = tree.root else { return };
        let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
        let mut slabs = Slabs::new(o, d, ray.t_min, self.last(), tree.reach);
        let Some(near) = slabs.meet_one(&tree.bounds) else { return };
        let sheared = ShearedRay::new(ray.direction);
        let mut stack = vec![Waiting { near, link: root, level, bounds: tree.bounds }];
        while let Some(Waiting { near, link, level, bounds }) = stack.pop() {
            slabs.t_max = self.last();
            if near > slabs.t_max {
                continue;
            }
            match link.child() {
                Child::Node(index) => {
                    self.steps.enter(&bounds, level, false, object);
                    push_children(&slabs, &tree.nodes[index as usize], level + 1, &mut stack);
                }
                Child::Leaf(index) => {
                    self.steps.enter(&bounds, level, true, object);
                    self.leaf(&tree.leaves[index as usize], ray, &sheared, object.unwrap_or_default());
                }
                Child::Object(index) => at_object(self, index, level),
            }
            if self.is_done() {
                return;
            }
        }
    }

    /// Tests the triangles of a leaf.
    fn leaf(&mut self, leaf: &Leaf, ray: &Ray, sheared: &ShearedRay, object: u32) {
        for lane in 0..leaf.count as usize {
            let vertices = leaf.corner.map(|corner| {
                let vertex = corner.get(lane);
                Vec3::from(leaf.vertex.map(|axis| axis[vertex]))
            });
            let ray = Ray { t_max: self.last().next_up(), ..*ray };
            let met = triangle::intersect(vertices, &ray, sheared);
            self.offer(object, leaf.primitive[lane], met);
            if self.is_done() {
                return;
            }
        }
    }

    /// Tests an analytic shape.
    fn shape(&mut self, shape: &super::Geometry, object: u32) {
        let met = shape.intersect(&Ray { t_max: self.last().next_up(), ..self.ray });
        let primitive = met.map_or(0, |(_, primitive)| primitive);
        self.offer(object, primitive, met.map(|(t, _)| TriangleHit { t, u: 0.0, v: 0.0 }));
    }

    /// Takes a hit if it is nearer, ties going to the smaller object and primitive.
    fn offer(&mut self, object: u32, primitive: u32, met: Option<TriangleHit>) {
        self.steps.test(object, primitive, met.map(|met| met.t));
        let Some(TriangleHit { t, u, v }) = met else { return };
        let nearer =
            self.hit.is_none_or(|old| t < old.t || t == old.t && (object, primitive) < (old.object, old.primitive));
        if nearer {
            self.hit = Some(Hit { t, u, v, object, primitive });
        }
    }

    /// The last `t` that still counts.
    fn last(&self) -> f32 {
        self.hit.map_or(self.ray.t_max.next_down(), |hit| hit.t)
    }

    fn is_done(&self) -> bool {
        self.query == Query::Any && self.hit.is_some()
    }
}

/// Pushes the children that the ray meets, the nearest last.
fn push_children(slabs: &Slabs, node: &Node, level: u32, stack: &mut Vec<Waiting>) {
    let (enter, mask) = slabs.meet(baseline(), node);
    let bits = mask.to_bitmask();
    let first = stack.len();
    for slot in (0..WIDTH).filter(|slot| bits >> slot & 1 != 0) {
        let bounds = node.planes.map(|side| side.map(|axis| axis[slot]));
        stack.push(Waiting { near: enter[slot], link: Link(node.child[slot]), level, bounds });
    }
    stack[first..].sort_by(|a, b| b.near.total_cmp(&a.near));
}

impl Slabs {
    /// Where the ray enters a single box, if it meets it: [`Slabs::meet`] for one.
    fn meet_one(&self, bounds: &[[f32; 3]; 2]) -> Option<f32> {
        let side = |axis: usize| (self.octant >> axis & 1) as usize;
        let near = |axis: usize| bounds[side(axis)][axis] * self.near_mul[axis] + self.near_add[axis];
        let far = |axis: usize| bounds[1 - side(axis)][axis] * self.far_mul[axis] + self.far_add[axis];
        let enter = near(0).max(near(1)).max(near(2)).max(self.t_min);
        let leave = far(0).min(far(1)).min(far(2)).min(self.t_max);
        (enter <= leave).then_some(enter)
    }
}
