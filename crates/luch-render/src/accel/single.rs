//! Single rays, many at a time: the kernel for rays that have nothing in common.
//!
//! A ray alone is a chain of dependent steps (a node's boxes, a push, a pop, the next node), each waiting for memory and
//! for the one before, so most of the machine idles. Here a few dozen rays walk in turn: one pass takes every ray at an
//! inner node one node further, the next every ray at a leaf through that leaf. Steps of different rays do not depend on
//! each other, so the processor overlaps them, and there is no branch on whether a ray is at a node or a leaf.

use super::group::{Found, Group};
use super::jobs::Job;
use super::lanes::Wide;
use super::nodes::{Child, Link, Tree, WIDTH};
use super::objects::{Object, Objects};
use super::packet;
use crate::math::ray::{LANES, NO_OBJECT};
use fearless_simd::prelude::*;
use fearless_simd::u32x16;

/// Groups of rays in flight at most.
const POOL: usize = 8;
/// Rays in flight at most.
const FLIGHT: usize = POOL * LANES;
/// With this many rays in flight or fewer, the next group starts: enough for the steps to overlap.
const ENOUGH: usize = 48;

/// Memory of the kernel, kept between calls: zeroing it costs more than tracing a few rays.
#[derive(Debug)]
pub(crate) struct Scratch {
    /// Rays in world space, and in that of the instance they are in.
    groups: [[Group; POOL]; 2],
    found: [Found; POOL],
    /// Stacks, `capacity` entries for each ray.
    child: Vec<u32>,
    near: Vec<f32>,
}

impl Scratch {
    pub(crate) fn new() -> Self {
        Self {
            groups: std::array::from_fn(|_| std::array::from_fn(|_| Group::NOTHING)),
            found: std::array::from_fn(|_| Found::NOTHING),
            child: Vec::new(),
            near: Vec::new(),
        }
    }
}

/// A ray in flight. Its slot, `16 * group + lane`, says where the rest of it lies.
#[derive(Clone, Copy)]
struct Flyer<'a> {
    tree: &'a Tree,
    /// Entries on its stack.
    depth: usize,
    /// The instance it is in, and 1; or 0 in world space.
    object: u32,
    space: usize,
}

/// Some of the rays in flight. Appending is free of branches.
struct List {
    /// Twice as long as the list: an append that does not count still writes.
    slots: [u8; 2 * FLIGHT],
    len: usize,
}

impl List {
    const EMPTY: Self = Self { slots: [0; 2 * FLIGHT], len: 0 };

    #[inline(always)]
    fn push_if(&mut self, condition: bool, slot: usize) {
        self.slots[self.len & (2 * FLIGHT - 1)] = slot as u8;
        self.len += usize::from(condition);
    }

    #[inline(always)]
    fn get(&self, k: usize) -> usize {
        usize::from(self.slots[k & (FLIGHT - 1)]) & (FLIGHT - 1)
    }
}

/// No way on. Ends like a leaf.
const DONE: Link = Link(0x7fff_ffff);

/// Traces the groups of a job that `names` gives.
pub(crate) fn trace<S: Wide, J: Job>(
    simd: S,
    objects: &Objects,
    scratch: &mut Scratch,
    job: &mut J,
    names: &mut dyn Iterator<Item = usize>,
) {
    let Some(root) = objects.tree.root else { return finish_all(simd, scratch, job, names) };
    let entries = objects.stack_capacity * FLIGHT;
    if scratch.child.len() < entries {
        scratch.child.resize(entries, 0);
        scratch.near.resize(entries, 0.0);
    }
    let flyer = Flyer { tree: &objects.tree, depth: 0, object: NO_OBJECT, space: 0 };
    let mut flight = Flight { objects, scratch, flyers: [flyer; FLIGHT], capacity: objects.stack_capacity, root };
    simd.vectorize(
        #[inline(always)]
        || flight.run(simd, job, names),
    );
}

/// There is no tree: what is known already is the answer.
fn finish_all<S: Wide, J: Job>(simd: S, scratch: &mut Scratch, job: &mut J, names: &mut dyn Iterator<Item = usize>) {
    let Scratch { groups: [[world, ..], _], found: [found, ..], .. } = scratch;
    simd.vectorize(
        #[inline(always)]
        || {
            for name in names {
                job.load(simd, name, world, found);
                job.done(simd, name, found);
            }
        },
    );
}

struct Flight<'a> {
    objects: &'a Objects,
    scratch: &'a mut Scratch,
    flyers: [Flyer<'a>; FLIGHT],
    capacity: usize,
    root: Link,
}

impl<'a> Flight<'a> {
    #[inline(always)]
    fn run<S: Wide, J: Job>(&mut self, simd: S, job: &mut J, todo: &mut dyn Iterator<Item = usize>) {
        let (mut at_node, mut at_end) = (List::EMPTY, List::EMPTY);
        // Of each group in flight its name, and how many of its rays are not done.
        let mut names = [0; POOL];
        let mut left = [0_u32; POOL];
        let mut next = todo.next();
        loop {
            while at_node.len + at_end.len <= ENOUGH {
                let Some(name) = next else { break };
                let Some(pool) = left.iter().position(|&rays| rays == 0) else { break };
                next = todo.next();
                let rays = self.start(simd, pool, name, job);
                (names[pool], left[pool]) = (name, rays.count_ones());
                if rays == 0 {
                    job.done(simd, name, &self.scratch.found[pool]);
                }
                let mut bits = rays;
                while bits != 0 {
                    let slot = pool * LANES + bits.trailing_zeros() as usize;
                    bits &= bits - 1;
                    let top = self.top(slot);
                    at_node.push_if(!top.ends(), slot);
                    at_end.push_if(top.ends(), slot);
                }
            }
            if at_node.len + at_end.len == 0 {
                return;
            }
            let (mut next_node, mut next_end) = (List::EMPTY, List::EMPTY);
            let mut finished = List::EMPTY;
            for k in 0..at_node.len {
                let slot = at_node.get(k);
                let top = self.step_node(simd, slot, &names, job);
                next_node.push_if(!top.ends(), slot);
                at_end.push_if(top.ends() & (top != DONE), slot);
                finished.push_if(top == DONE, slot);
            }
            for k in 0..at_end.len {
                let slot = at_end.get(k);
                let top = self.step_end(simd, slot, &names, job);
                next_node.push_if(!top.ends(), slot);
                next_end.push_if(top.ends() & (top != DONE), slot);
                finished.push_if(top == DONE, slot);
            }
            for k in 0..finished.len {
                let pool = finished.get(k) / LANES;
                left[pool] -= 1;
                if left[pool] == 0 {
                    job.done(simd, names[pool], &self.scratch.found[pool]);
                }
            }
            (at_node, at_end) = (next_node, next_end);
        }
    }

    /// Starts a group in a free place of the pool; a bit for each ray that goes on its way.
    #[inline(always)]
    fn start<S: Wide, J: Job>(&mut self, simd: S, pool: usize, name: usize, job: &mut J) -> u32 {
        let Scratch { groups: [world, object], found, child, near } = &mut *self.scratch;
        let (world, found) = (&mut world[pool], &mut found[pool]);
        let mut rays = job.load(simd, name, world, found);
        let mut flyer = Flyer { tree: &self.objects.tree, depth: 1, object: NO_OBJECT, space: 0 };
        let mut root = self.root;
        if let Child::Object(index) = root.child()
            && let Object::Instance { tree, inverse } = &self.objects.list[index as usize]
            && let Some(top) = tree.root
        {
            // A scene of one mesh: all rays enter it at once.
            let group = &mut object[pool];
            group.load_transformed(simd, world, inverse);
            group.prepare(simd, tree.reach);
            flyer = Flyer { tree, depth: 1, object: index, space: 1 };
            root = top;
            rays &= group.meet(simd, &tree.bounds, &found.t).1.to_bitmask() as u32;
        } else {
            world.prepare(simd, self.objects.tree.reach);
            rays &= world.meet(simd, &self.objects.tree.bounds, &found.t).1.to_bitmask() as u32;
        }
        for lane in 0..LANES {
            let slot = pool * LANES + lane;
            self.flyers[slot] = flyer;
            child[slot * self.capacity] = root.0;
            near[slot * self.capacity] = f32::NEG_INFINITY;
        }
        rays
    }

    /// Takes a ray whose stack has an inner node on top through that node. Returns the new top.
    #[inline(always)]
    fn step_node<S: Wide, J: Job>(&mut self, simd: S, slot: usize, names: &[usize; POOL], job: &mut J) -> Link {
        let flyer = &mut self.flyers[slot];
        let (pool, lane) = (slot / LANES, slot % LANES);
        let Scratch { groups, found, child, near } = &mut *self.scratch;
        let at = slot * self.capacity + flyer.depth - 1;
        let node = &flyer.tree.nodes[child[at] as usize];
        if J::COUNT {
            job.count(names[pool], lane, 1, 0);
        }
        let slabs = groups[flyer.space & 1][pool].slabs(lane, found[pool].t[lane]);
        let (enter, mask) = slabs.meet(simd, node);
        let links = u32x16::load_array_ref(simd, &node.child);
        let order = node.near_to_far(!slabs.octant);
        let to_child: &mut [u32; WIDTH] = (&mut child[at..at + WIDTH]).try_into().expect("a whole vector");
        let to_near: &mut [f32; WIDTH] = (&mut near[at..at + WIDTH]).try_into().expect("a whole vector");
        flyer.depth += simd.push_hit(links, enter, mask, order, to_child, to_near);
        flyer.depth -= 1;
        self.top(slot)
    }

    /// What a ray has to do next.
    #[inline(always)]
    fn top(&self, slot: usize) -> Link {
        let depth = self.flyers[slot].depth;
        // Read first, decide after: no branch.
        let top = self.scratch.child[(slot * self.capacity + depth).saturating_sub(1)];
        if depth == 0 { DONE } else { Link(top) }
    }

    /// Takes a ray whose stack has something else on top through that. Returns the new top.
    #[inline(always)]
    fn step_end<S: Wide, J: Job>(&mut self, simd: S, slot: usize, names: &[usize; POOL], job: &mut J) -> Link {
        let flyer = &mut self.flyers[slot];
        let (pool, lane) = (slot / LANES, slot % LANES);
        flyer.depth -= 1;
        let link = Link(self.scratch.child[slot * self.capacity + flyer.depth]);
        let Some(index) = link.as_leaf() else {
            return simd.vectorize(
                #[inline(always)]
                || self.step_object(slot, link, names, job),
            );
        };
        let leaf = &flyer.tree.leaves[index];
        if J::COUNT {
            job.count(names[pool], lane, 0, leaf.count);
        }
        let group = &self.scratch.groups[flyer.space & 1][pool];
        let found = &mut self.scratch.found[pool];
        if packet::ray_in_leaf::<S, J>(simd, group, lane, leaf, flyer.object, found) {
            if J::ANY {
                flyer.depth = 0;
                return DONE;
            }
            let t = found.t[lane];
            self.drop_behind(slot, t);
        }
        self.top(slot)
    }

    /// The rare ends: an object of the scene, or the way out of one.
    #[inline(always)]
    fn step_object<J: Job>(&mut self, slot: usize, link: Link, names: &[usize; POOL], job: &mut J) -> Link {
        let flyer = &mut self.flyers[slot];
        let (pool, lane, base) = (slot / LANES, slot % LANES, slot * self.capacity);
        let Scratch { groups: [world, object], found, child, near } = &mut *self.scratch;
        let Child::Object(index) = link.child() else {
            (flyer.tree, flyer.object, flyer.space) = (&self.objects.tree, NO_OBJECT, 0);
            return self.top(slot);
        };
        let ray = world[pool].ray(lane, found[pool].t[lane].next_up());
        match &self.objects.list[index as usize] {
            Object::Instance { tree, inverse } => {
                let Some(root) = tree.root else { return self.top(slot) };
                for link in [Link::LEAVE_INSTANCE, root] {
                    child[base + flyer.depth] = link.0;
                    near[base + flyer.depth] = f32::NEG_INFINITY;
                    flyer.depth += 1;
                }
                object[pool].set(lane, &inverse.ray(&ray), tree.reach);
                (flyer.tree, flyer.object, flyer.space) = (tree, index, 1);
            }
            Object::Shape(shape) => {
                if J::COUNT {
                    job.count(names[pool], lane, 0, 1);
                }
                if let Some((t, primitive)) = shape.intersect(&ray) {
                    if J::ANY {
                        found[pool].object[lane] = index;
                        flyer.depth = 0;
                        return DONE;
                    }
                    if found[pool].offer(lane, t, [0.0; 2], index, primitive) {
                        self.drop_behind(slot, t);
                    }
                }
            }
        }
        self.top(slot)
    }

    /// Drops from a ray's stack what lies behind its hit. Then a pop never meets anything stale.
    #[inline(always)]
    fn drop_behind(&mut self, slot: usize, t: f32) {
        let (base, depth) = (slot * self.capacity, self.flyers[slot].depth);
        let near = &mut self.scratch.near[base..base + depth];
        let child = &mut self.scratch.child[base..base + depth];
        let mut kept = 0;
        for k in 0..depth {
            let (distance, link) = (near[k], child[k]);
            (near[kept], child[kept]) = (distance, link);
            kept += usize::from(distance <= t);
        }
        self.flyers[slot].depth = kept;
    }
}
