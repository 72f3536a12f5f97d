//! The tree over the objects of a scene, and the ray queries.

use super::Level;
use super::geometry::Geometry;
use super::lanes::at_level;
use super::objects::{Object, Objects};
use super::single::{self, Job};
use crate::math::bounds::Bounds;
use crate::math::ray::{Coherence, Hit, HitBatch, Mask, Ray, RayBatch};

/// Work done per ray, for the cost view.
#[derive(Clone, Debug, Default)]
pub struct CostBatch {
    /// Tree nodes visited.
    pub nodes: Vec<u32>,
    /// Triangles and other shapes tested.
    pub primitives: Vec<u32>,
}

/// The objects of a scene, ordered for ray queries. Immutable; building it again after an edit is cheap.
#[derive(Debug)]
pub struct SceneTree {
    objects: Objects,
    bounds: Bounds,
}

impl SceneTree {
    /// Builds the tree; the index in `objects` is the object index of hits. Costs well under a millisecond for a
    /// thousand instances: mesh trees are shared, not copied.
    pub fn build(objects: &[Geometry]) -> Self {
        let bounds = objects.iter().filter_map(Geometry::bounds).fold(Bounds::EMPTY, Bounds::union);
        Self { objects: Objects::new(objects), bounds }
    }

    /// The box around all bounded objects; empty if there are none.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// The nearest hit of every ray. `hits` gets the length of `rays`.
    pub fn closest_hits(&self, level: Level, rays: &RayBatch, coherence: Coherence, hits: &mut HitBatch) {
        let _ = coherence;
        hits.reset(rays.len());
        let mut job = Closest { tree: self, rays, hits, next: 0 };
        at_level!(level, simd => single::trace(simd, &self.objects, &mut job));
    }

    /// Whether anything lies in the open interval of each ray. `occluded` gets the length of `rays`.
    pub fn occluded(&self, level: Level, rays: &RayBatch, coherence: Coherence, occluded: &mut Mask) {
        let _ = coherence;
        occluded.reset(rays.len());
        let mut job = Any { tree: self, rays, occluded, next: 0 };
        at_level!(level, simd => single::trace(simd, &self.objects, &mut job));
    }

    /// Like [`SceneTree::closest_hits`], and counts the work of each ray. Slower; a debug view's.
    pub fn closest_hits_counted(&self, level: Level, rays: &RayBatch, hits: &mut HitBatch, cost: &mut CostBatch) {
        hits.reset(rays.len());
        for counts in [&mut cost.nodes, &mut cost.primitives] {
            counts.clear();
            counts.resize(rays.len(), 0);
        }
        let mut job = Counted { closest: Closest { tree: self, rays, hits, next: 0 }, cost };
        at_level!(level, simd => single::trace(simd, &self.objects, &mut job));
    }

    /// The nearest hit with the shapes outside the tree.
    fn closest_always(&self, ray: &Ray) -> Option<Hit> {
        let mut best: Option<Hit> = None;
        for &object in &self.objects.always {
            if let Object::Shape(shape) = &self.objects.list[object as usize]
                && let Some((t, primitive)) = shape.intersect(ray)
                && best.is_none_or(|old| (t, object, primitive) < (old.t, old.object, old.primitive))
            {
                best = Some(Hit { t, u: 0.0, v: 0.0, object, primitive });
            }
        }
        best
    }
}

struct Closest<'a> {
    tree: &'a SceneTree,
    rays: &'a RayBatch,
    hits: &'a mut HitBatch,
    next: usize,
}

impl Job for Closest<'_> {
    const ANY: bool = false;
    const COUNT: bool = false;

    #[inline(always)]
    fn next(&mut self) -> Option<(usize, Ray, Option<Hit>)> {
        let name = self.next;
        self.next += 1;
        (name < self.rays.len()).then(|| {
            let ray = self.rays.get(name);
            (name, ray, self.tree.closest_always(&ray))
        })
    }

    #[inline(always)]
    fn done(&mut self, name: usize, hit: Option<Hit>) {
        self.hits.set(name, hit);
    }

    fn count(&mut self, _name: usize, _nodes: u32, _primitives: u32) {}
}

struct Any<'a> {
    tree: &'a SceneTree,
    rays: &'a RayBatch,
    occluded: &'a mut Mask,
    next: usize,
}

impl Job for Any<'_> {
    const ANY: bool = true;
    const COUNT: bool = false;

    #[inline(always)]
    fn next(&mut self) -> Option<(usize, Ray, Option<Hit>)> {
        loop {
            let name = self.next;
            if name >= self.rays.len() {
                return None;
            }
            self.next += 1;
            let ray = self.rays.get(name);
            if self.tree.closest_always(&ray).is_none() {
                return Some((name, ray, None));
            }
            self.occluded.set(name, true);
        }
    }

    #[inline(always)]
    fn done(&mut self, name: usize, hit: Option<Hit>) {
        self.occluded.set(name, hit.is_some());
    }

    fn count(&mut self, _name: usize, _nodes: u32, _primitives: u32) {}
}

struct Counted<'a> {
    closest: Closest<'a>,
    cost: &'a mut CostBatch,
}

impl Job for Counted<'_> {
    const ANY: bool = false;
    const COUNT: bool = true;

    fn next(&mut self) -> Option<(usize, Ray, Option<Hit>)> {
        self.closest.next()
    }

    fn done(&mut self, name: usize, hit: Option<Hit>) {
        self.closest.done(name, hit);
    }

    fn count(&mut self, name: usize, nodes: u32, primitives: u32) {
        self.cost.nodes[name] += nodes;
        self.cost.primitives[name] += primitives;
    }
}
