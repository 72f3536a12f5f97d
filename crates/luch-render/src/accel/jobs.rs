//! What the queries ask of a kernel, and where the answers go.

use super::group::{Found, Group};
use super::lanes::Wide;
use super::objects::Objects;
use super::scene_tree::CostBatch;
use crate::math::ray::{HitBatch, LANES, Mask, RayBatch};

/// Where groups of rays come from and answers go.
pub(crate) trait Job {
    /// Any hit will do.
    const ANY: bool;
    /// Whether [`Job::count`] is wanted.
    const COUNT: bool;

    /// How many groups there are; their names are the numbers below.
    fn groups(&self) -> usize;
    /// Loads a group and what is known of its hits; a bit for each ray to trace.
    fn load<S: Wide>(&mut self, simd: S, name: usize, world: &mut Group, found: &mut Found) -> u32;
    /// Takes the answers of a group.
    fn done<S: Wide>(&mut self, simd: S, name: usize, found: &Found);
    /// Takes the work done for one ray.
    fn count(&mut self, name: usize, lane: usize, nodes: u32, primitives: u32);
}

/// The nearest hit of every ray.
pub(crate) struct Closest<'a> {
    pub(crate) objects: &'a Objects,
    pub(crate) rays: &'a RayBatch,
    pub(crate) hits: &'a mut HitBatch,
}

impl Job for Closest<'_> {
    const ANY: bool = false;
    const COUNT: bool = false;

    fn groups(&self) -> usize {
        self.rays.padded_len() / LANES
    }

    #[inline(always)]
    fn load<S: Wide>(&mut self, simd: S, name: usize, world: &mut Group, found: &mut Found) -> u32 {
        world.load(simd, self.rays, name);
        found.reset(simd, self.rays, name);
        self.objects.meet_always(simd, world, found);
        0xffff
    }

    #[inline(always)]
    fn done<S: Wide>(&mut self, simd: S, name: usize, found: &Found) {
        found.store(simd, self.hits, name);
    }

    fn count(&mut self, _name: usize, _lane: usize, _nodes: u32, _primitives: u32) {}
}

/// Whether anything lies on each ray.
pub(crate) struct Any<'a> {
    pub(crate) objects: &'a Objects,
    pub(crate) rays: &'a RayBatch,
    pub(crate) occluded: &'a mut Mask,
}

impl Job for Any<'_> {
    const ANY: bool = true;
    const COUNT: bool = false;

    fn groups(&self) -> usize {
        self.rays.padded_len() / LANES
    }

    #[inline(always)]
    fn load<S: Wide>(&mut self, simd: S, name: usize, world: &mut Group, found: &mut Found) -> u32 {
        world.load(simd, self.rays, name);
        found.reset(simd, self.rays, name);
        self.objects.meet_always(simd, world, found);
        !found.rays(simd) & 0xffff
    }

    #[inline(always)]
    fn done<S: Wide>(&mut self, simd: S, name: usize, found: &Found) {
        self.occluded.set_word(name, found.rays(simd) as u16);
    }

    fn count(&mut self, _name: usize, _lane: usize, _nodes: u32, _primitives: u32) {}
}

/// The nearest hit of every ray, and the work it took.
pub(crate) struct Counted<'a> {
    pub(crate) closest: Closest<'a>,
    pub(crate) cost: &'a mut CostBatch,
}

impl Job for Counted<'_> {
    const ANY: bool = false;
    const COUNT: bool = true;

    fn groups(&self) -> usize {
        self.closest.groups()
    }

    #[inline(always)]
    fn load<S: Wide>(&mut self, simd: S, name: usize, world: &mut Group, found: &mut Found) -> u32 {
        self.closest.load(simd, name, world, found)
    }

    #[inline(always)]
    fn done<S: Wide>(&mut self, simd: S, name: usize, found: &Found) {
        self.closest.done(simd, name, found);
    }

    fn count(&mut self, name: usize, lane: usize, nodes: u32, primitives: u32) {
        let ray = name * LANES + lane;
        if ray < self.closest.rays.len() {
            self.cost.nodes[ray] += nodes;
            self.cost.primitives[ray] += primitives;
        }
    }
}
