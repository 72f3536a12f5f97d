//! What the queries ask of a kernel, and where the answers go.

use super::group::{Found, Group};
use super::lanes::Wide;
use super::objects::Objects;
use super::scene_tree::CostBatch;
use super::single::Job;
use crate::math::ray::{HitBatch, LANES, Mask, NO_OBJECT, RayBatch};

/// The nearest hit of every ray.
pub(crate) struct Closest<'a> {
    pub(crate) objects: &'a Objects,
    pub(crate) rays: &'a RayBatch,
    pub(crate) hits: &'a mut HitBatch,
    pub(crate) next: usize,
}

impl Job for Closest<'_> {
    const ANY: bool = false;
    const COUNT: bool = false;

    #[inline(always)]
    fn next<S: Wide>(&mut self, simd: S, world: &mut Group, found: &mut Found) -> Option<(usize, u32)> {
        let k = self.next;
        if k * LANES >= self.rays.len() {
            return None;
        }
        self.next += 1;
        world.load(self.rays, k);
        found.reset(simd, self.rays, k);
        self.objects.meet_always(world, found);
        Some((k, 0xffff))
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
    pub(crate) next: usize,
}

impl Job for Any<'_> {
    const ANY: bool = true;
    const COUNT: bool = false;

    #[inline(always)]
    fn next<S: Wide>(&mut self, simd: S, world: &mut Group, found: &mut Found) -> Option<(usize, u32)> {
        let k = self.next;
        if k * LANES >= self.rays.len() {
            return None;
        }
        self.next += 1;
        world.load(self.rays, k);
        found.reset(simd, self.rays, k);
        self.objects.meet_always(world, found);
        Some((k, u32::from(!occluded_word(found))))
    }

    #[inline(always)]
    fn done<S: Wide>(&mut self, _simd: S, name: usize, found: &Found) {
        self.occluded.set_word(name, occluded_word(found));
    }

    fn count(&mut self, _name: usize, _lane: usize, _nodes: u32, _primitives: u32) {}
}

#[inline(always)]
fn occluded_word(found: &Found) -> u16 {
    found.object.iter().enumerate().fold(0, |word, (lane, &object)| word | u16::from(object != NO_OBJECT) << lane)
}

/// The nearest hit of every ray, and the work it took.
pub(crate) struct Counted<'a> {
    pub(crate) closest: Closest<'a>,
    pub(crate) cost: &'a mut CostBatch,
}

impl Job for Counted<'_> {
    const ANY: bool = false;
    const COUNT: bool = true;

    #[inline(always)]
    fn next<S: Wide>(&mut self, simd: S, world: &mut Group, found: &mut Found) -> Option<(usize, u32)> {
        self.closest.next(simd, world, found)
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
