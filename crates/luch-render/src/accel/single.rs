//! Single rays, many at a time: the kernel for rays that have nothing in common.
//!
//! A ray alone is a chain of dependent steps (a node's boxes, a push, a pop, the next node), each waiting for memory and
//! for the one before, so most of the machine idles. Here a few dozen rays walk in turn: one pass takes every ray at an
//! inner node one node further, the next every ray at a leaf through that leaf. Steps of different rays do not depend on
//! each other, so the processor overlaps them, and there is no branch on whether a ray is at a node or a leaf.

use super::lanes::Wide;
use super::leaf_test::{self, Frame};
use super::nodes::{Child, Link, Tree, WIDTH};
use super::objects::{Object, Objects};
use super::slabs::Slabs;
use crate::math::ray::{Hit, NO_OBJECT, Ray};
use fearless_simd::f32x16;
use fearless_simd::prelude::*;
use fearless_simd::u32x16;

/// Rays in flight: enough to cover a miss to main memory, few enough for their stacks to stay in the first cache.
const FLIGHT: usize = 32;

/// Where rays come from and hits go.
pub(crate) trait Job {
    /// Any hit will do.
    const ANY: bool;
    /// Whether the counts are wanted.
    const COUNT: bool;

    /// The next ray and what is known of its nearest hit, and a name for it.
    fn next(&mut self) -> Option<(usize, Ray, Option<Hit>)>;
    fn done(&mut self, name: usize, hit: Option<Hit>);
    fn count(&mut self, name: usize, nodes: u32, primitives: u32);
}

/// What a ray looks like in the space it is in.
#[derive(Clone, Copy)]
struct Walk<'a> {
    slabs: Slabs,
    frame: Frame,
    tree: &'a Tree,
    /// The instance the ray is in.
    object: u32,
}

/// A ray in flight.
struct Flyer<'a> {
    walk: Walk<'a>,
    name: usize,
    depth: usize,
    hit: Hit,
    ray: Ray,
}

pub(crate) fn trace<S: Wide, J: Job>(simd: S, objects: &Objects, job: &mut J) {
    simd.vectorize(
        #[inline(always)]
        || Flight::new(objects).run(simd, job),
    );
}

struct Flight<'a> {
    objects: &'a Objects,
    flyers: Vec<Flyer<'a>>,
    /// Stacks, `capacity` entries each.
    child: Vec<u32>,
    near: Vec<f32>,
    capacity: usize,
}

/// Some of the rays in flight. Appending is free of branches.
struct List {
    /// Twice as long as the list: an append that does not count still writes.
    slots: [u32; 2 * FLIGHT],
    len: usize,
}

impl List {
    const EMPTY: Self = Self { slots: [0; 2 * FLIGHT], len: 0 };

    #[inline(always)]
    fn push_if(&mut self, condition: bool, slot: usize) {
        self.slots[self.len & (2 * FLIGHT - 1)] = slot as u32;
        self.len += usize::from(condition);
    }
}

impl<'a> Flight<'a> {
    fn new(objects: &'a Objects) -> Self {
        let capacity = objects.stack_capacity;
        Self {
            objects,
            flyers: Vec::with_capacity(FLIGHT),
            child: vec![0; capacity * FLIGHT],
            near: vec![0.0; capacity * FLIGHT],
            capacity,
        }
    }

    #[inline(always)]
    fn run<S: Wide, J: Job>(&mut self, simd: S, job: &mut J) {
        let Some(root) = self.objects.tree.root else {
            while let Some((name, _, hit)) = job.next() {
                job.done(name, hit);
            }
            return;
        };
        let mut at_node = List::EMPTY;
        let mut at_leaf = List::EMPTY;
        for slot in 0..FLIGHT {
            if !self.start(slot, root, job) {
                break;
            }
            at_node.push_if(!root.ends(), slot);
            at_leaf.push_if(root.ends(), slot);
        }
        while at_node.len + at_leaf.len > 0 {
            let mut next_node = List::EMPTY;
            let mut finished = List::EMPTY;
            for k in 0..at_node.len {
                let slot = at_node.slots[k & (FLIGHT - 1)] as usize;
                let top = self.step_node(simd, slot, job);
                next_node.push_if(!top.ends() & (top != DONE), slot);
                at_leaf.push_if(top.ends() & (top != DONE), slot);
                finished.push_if(top == DONE, slot);
            }
            let mut next_leaf = List::EMPTY;
            for k in 0..at_leaf.len {
                let slot = at_leaf.slots[k & (FLIGHT - 1)] as usize;
                let top = self.step_end(simd, slot, job);
                next_node.push_if(!top.ends() & (top != DONE), slot);
                next_leaf.push_if(top.ends() & (top != DONE), slot);
                finished.push_if(top == DONE, slot);
            }
            for k in 0..finished.len {
                let slot = finished.slots[k & (FLIGHT - 1)] as usize;
                let flyer = &self.flyers[slot];
                job.done(flyer.name, (flyer.hit.object != NO_OBJECT).then_some(flyer.hit));
                if self.start(slot, root, job) {
                    next_node.push_if(!root.ends(), slot);
                    next_leaf.push_if(root.ends(), slot);
                }
            }
            (at_node, at_leaf) = (next_node, next_leaf);
        }
    }

    /// Puts the next ray into a slot; false if there is none.
    #[inline(always)]
    fn start<J: Job>(&mut self, slot: usize, root: Link, job: &mut J) -> bool {
        let Some((name, ray, known)) = job.next() else { return false };
        let nothing = Hit { t: ray.t_max.next_down(), u: 0.0, v: 0.0, object: NO_OBJECT, primitive: NO_OBJECT };
        let hit = known.unwrap_or(nothing);
        let (origin, direction) = (ray.origin, ray.direction);
        let tree = &self.objects.tree;
        let walk = Walk {
            slabs: Slabs::new(origin.to_array(), direction.to_array(), ray.t_min, hit.t, tree.reach),
            frame: Frame::new(origin, direction),
            tree,
            object: NO_OBJECT,
        };
        let flyer = Flyer { walk, name, depth: 1, hit, ray };
        if slot == self.flyers.len() {
            self.flyers.push(flyer);
        } else {
            self.flyers[slot] = flyer;
        }
        self.child[slot * self.capacity] = root.0;
        self.near[slot * self.capacity] = f32::NEG_INFINITY;
        true
    }

    /// Takes a ray whose stack has an inner node on top through that node. Returns the new top.
    #[inline(always)]
    fn step_node<S: Wide, J: Job>(&mut self, simd: S, slot: usize, job: &mut J) -> Link {
        let flyer = &mut self.flyers[slot];
        let top = slot * self.capacity + flyer.depth - 1;
        let node = &flyer.walk.tree.nodes[self.child[top] as usize];
        if J::COUNT {
            job.count(flyer.name, 1, 0);
        }
        let (near, mask) = flyer.walk.slabs.meet(simd, node);
        let child = u32x16::load_array(simd, node.child.map(|link| link.0));
        let order = node.near_to_far(!flyer.walk.slabs.octant);
        let to_child: &mut [u32; WIDTH] = (&mut self.child[top..top + WIDTH]).try_into().expect("a whole vector");
        let to_near: &mut [f32; WIDTH] = (&mut self.near[top..top + WIDTH]).try_into().expect("a whole vector");
        let pushed = simd.push_hit(child, near, mask, order, to_child, to_near);
        flyer.depth += pushed;
        flyer.depth -= 1;
        self.top(slot)
    }

    /// What a ray has to do next.
    #[inline(always)]
    fn top(&self, slot: usize) -> Link {
        let depth = self.flyers[slot].depth;
        // Read first, decide after: no branch.
        let top = self.child[(slot * self.capacity + depth).saturating_sub(1)];
        if depth == 0 { DONE } else { Link(top) }
    }

    /// Takes a ray whose stack has something else on top through that. Returns the new top.
    #[inline(always)]
    fn step_end<S: Wide, J: Job>(&mut self, simd: S, slot: usize, job: &mut J) -> Link {
        let flyer = &mut self.flyers[slot];
        flyer.depth -= 1;
        let link = Link(self.child[slot * self.capacity + flyer.depth]);
        if let Child::Leaf(index) = link.child()
            && link != Link::LEAVE_INSTANCE
        {
            let walk = &flyer.walk;
            let leaf = &walk.tree.leaves[index as usize];
            if J::COUNT {
                job.count(flyer.name, 0, leaf.count);
            }
            if let Some(met) = leaf_test::meet(simd, leaf, &walk.frame, walk.slabs.t_min, flyer.hit.t) {
                if J::ANY {
                    flyer.hit.object = walk.object;
                    flyer.depth = 0;
                    return DONE;
                }
                let none = f32x16::splat(simd, f32::INFINITY);
                let nearest = met.mask.select(met.t, none).reduce_min();
                let mut ties = (met.mask & met.t.simd_eq(f32x16::splat(simd, nearest))).to_bitmask() as u32;
                let primitives = &walk.tree.primitives[index as usize];
                let mut lane = ties.trailing_zeros() as usize & (WIDTH - 1);
                while ties & (ties - 1) != 0 {
                    ties &= ties - 1;
                    let other = ties.trailing_zeros() as usize & (WIDTH - 1);
                    if primitives[other] < primitives[lane] {
                        lane = other;
                    }
                }
                let (u, v) = (met.u[lane], met.v[lane]);
                let hit = Hit { t: nearest, u, v, object: walk.object, primitive: primitives[lane] };
                self.offer(slot, hit);
            }
            return self.top(slot);
        }
        self.step_object(slot, link, job)
    }

    /// The rare ends: an object of the scene, or the way out of one.
    #[inline(never)]
    fn step_object<J: Job>(&mut self, slot: usize, link: Link, job: &mut J) -> Link {
        let flyer = &mut self.flyers[slot];
        let base = slot * self.capacity;
        let Child::Object(index) = link.child() else {
            // Back from an instance: the world looks as at the start.
            let (ray, tree) = (flyer.ray, &self.objects.tree);
            let (o, d) = (ray.origin.to_array(), ray.direction.to_array());
            flyer.walk.slabs = Slabs::new(o, d, ray.t_min, flyer.hit.t, tree.reach);
            flyer.walk.tree = tree;
            return self.top(slot);
        };
        match &self.objects.list[index as usize] {
            Object::Instance { tree, inverse } => {
                let Some(root) = tree.root else { return self.top(slot) };
                if flyer.depth > 0 {
                    self.child[base + flyer.depth] = Link::LEAVE_INSTANCE.0;
                    self.near[base + flyer.depth] = f32::NEG_INFINITY;
                    flyer.depth += 1;
                }
                self.child[base + flyer.depth] = root.0;
                self.near[base + flyer.depth] = f32::NEG_INFINITY;
                flyer.depth += 1;
                let ray = inverse.ray(&flyer.ray);
                let (o, d) = (ray.origin, ray.direction);
                flyer.walk = Walk {
                    slabs: Slabs::new(o.to_array(), d.to_array(), ray.t_min, flyer.hit.t, tree.reach),
                    frame: Frame::new(o, d),
                    tree,
                    object: index,
                };
            }
            Object::Shape(shape) => {
                if J::COUNT {
                    job.count(flyer.name, 0, 1);
                }
                if let Some((t, primitive)) = shape.intersect(&flyer.ray) {
                    if J::ANY {
                        flyer.hit.object = index;
                        flyer.depth = 0;
                        return DONE;
                    }
                    self.offer(slot, Hit { t, u: 0.0, v: 0.0, object: index, primitive });
                }
            }
        }
        self.top(slot)
    }

    /// Takes a hit if it is nearer, and drops from the stack what lies behind it.
    #[inline(always)]
    fn offer(&mut self, slot: usize, hit: Hit) {
        let flyer = &mut self.flyers[slot];
        let old = &flyer.hit;
        let wins = hit.t < old.t || hit.t == old.t && (hit.object, hit.primitive) < (old.object, old.primitive);
        if !wins {
            return;
        }
        flyer.hit = hit;
        flyer.walk.slabs.t_max = hit.t;
        let base = slot * self.capacity;
        let mut kept = 0;
        for k in 0..flyer.depth {
            let near = self.near[base + k];
            self.near[base + kept] = near;
            self.child[base + kept] = self.child[base + k];
            kept += usize::from(near <= hit.t);
        }
        flyer.depth = kept;
    }
}

/// No way on.
const DONE: Link = Link(0x7fff_ffff);
