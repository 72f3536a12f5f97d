//! The tree over the objects of a scene, and the ray queries.

use super::Level;
use super::geometry::Geometry;
use super::jobs::{Any, Closest, Counted};
use super::lanes::at_level;
use super::objects::Objects;
use super::single::{self, Scratch};
use crate::math::bounds::Bounds;
use crate::math::ray::{Coherence, HitBatch, Mask, RayBatch};
use std::cell::RefCell;

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
        let mut job = Closest { objects: &self.objects, rays, hits, next: 0 };
        with_scratch(|scratch| at_level!(level, simd => single::trace(simd, &self.objects, scratch, &mut job)));
    }

    /// Whether anything lies in the open interval of each ray. `occluded` gets the length of `rays`.
    pub fn occluded(&self, level: Level, rays: &RayBatch, coherence: Coherence, occluded: &mut Mask) {
        let _ = coherence;
        occluded.reset(rays.len());
        let mut job = Any { objects: &self.objects, rays, occluded, next: 0 };
        with_scratch(|scratch| at_level!(level, simd => single::trace(simd, &self.objects, scratch, &mut job)));
    }

    /// Like [`SceneTree::closest_hits`], and counts the work of each ray. Slower; a debug view's.
    pub fn closest_hits_counted(&self, level: Level, rays: &RayBatch, hits: &mut HitBatch, cost: &mut CostBatch) {
        hits.reset(rays.len());
        for counts in [&mut cost.nodes, &mut cost.primitives] {
            counts.clear();
            counts.resize(rays.len(), 0);
        }
        let mut job = Counted { closest: Closest { objects: &self.objects, rays, hits, next: 0 }, cost };
        with_scratch(|scratch| at_level!(level, simd => single::trace(simd, &self.objects, scratch, &mut job)));
    }
}

/// Hands out the thread's own scratch memory.
fn with_scratch(use_it: impl FnOnce(&mut Scratch)) {
    thread_local! {
        static SCRATCH: RefCell<Box<Scratch>> = RefCell::new(Box::new(Scratch::new()));
    }
    SCRATCH.with_borrow_mut(|scratch| use_it(scratch));
}
