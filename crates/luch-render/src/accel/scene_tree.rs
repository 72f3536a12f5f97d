//! The tree over the objects of a scene, and the ray queries.

use super::Level;
use super::geometry::Geometry;
use super::jobs::{Any, Closest, Counted, Job};
use super::lanes::at_level;
use super::objects::Objects;
use super::{packet, single};
use crate::math::bounds::Bounds;
use crate::math::ray::{Coherence, HitBatch, LANES, Mask, RayBatch};
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
        hits.reset(rays.len());
        self.trace(level, coherence, &mut Closest { objects: &self.objects, rays, hits });
    }

    /// Whether anything lies in the open interval of each ray. `occluded` gets the length of `rays`.
    pub fn occluded(&self, level: Level, rays: &RayBatch, coherence: Coherence, occluded: &mut Mask) {
        occluded.reset(rays.len());
        self.trace(level, coherence, &mut Any { objects: &self.objects, rays, occluded });
    }

    /// Like [`SceneTree::closest_hits`], and counts the work of each ray. Slower; a debug view's.
    pub fn closest_hits_counted(&self, level: Level, rays: &RayBatch, hits: &mut HitBatch, cost: &mut CostBatch) {
        hits.reset(rays.len());
        for counts in [&mut cost.nodes, &mut cost.primitives] {
            counts.clear();
            counts.resize(rays.len(), 0);
        }
        let closest = Closest { objects: &self.objects, rays, hits };
        let groups = rays.padded_len() / LANES;
        self.trace_alone(level, &mut Counted { closest, cost }, &mut (0..groups));
    }

    /// What the tree is over.
    pub(super) const fn objects(&self) -> &Objects {
        &self.objects
    }

    fn trace<J: Job>(&self, level: Level, coherence: Coherence, job: &mut J) {
        if coherence == Coherence::Incoherent {
            let groups = job.groups();
            return self.trace_alone(level, job, &mut (0..groups));
        }
        let mut left = Vec::new();
        let objects = &self.objects;
        PACKET_SCRATCH.with_borrow_mut(|scratch| {
            at_level!(level, simd => packet::trace(simd, objects, scratch, job, &mut left));
        });
        self.trace_alone(level, job, &mut left.into_iter());
    }

    /// Each ray of the groups on its own.
    fn trace_alone<J: Job>(&self, level: Level, job: &mut J, groups: &mut dyn Iterator<Item = usize>) {
        let objects = &self.objects;
        SINGLE_SCRATCH.with_borrow_mut(|scratch| {
            at_level!(level, simd => single::trace(simd, objects, scratch, job, groups));
        });
    }
}

thread_local! {
    /// Memory of the kernels: each thread its own.
    static PACKET_SCRATCH: RefCell<Box<packet::Scratch>> = RefCell::new(Box::new(packet::Scratch::new()));
    static SINGLE_SCRATCH: RefCell<Box<single::Scratch>> = RefCell::new(Box::new(single::Scratch::new()));
}
