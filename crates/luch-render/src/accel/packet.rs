//! Groups of sixteen neighbouring rays that walk together: the kernel for camera rays, and for shadow rays to one light.
//!
//! A node is tested once for the whole group: its sixteen boxes against the bundle. What comes off the stack is then
//! tested for each ray, so a group pays for no node or leaf that none of its rays meets. At a leaf, triangles that the
//! bundle misses are put aside, sixteen at a time, and the rest are tested against sixteen rays each, or, when fewer
//! rays than triangles are left, each ray against sixteen triangles. Groups that point every which way are left to the
//! single-ray kernel.

use super::bundle::{Bundle, most};
use super::group::{Found, Group};
use super::jobs::Job;
use super::lanes::{Wide, each, load, splat};
use super::leaf_test;
use super::nodes::{Child, Leaf, Link, Tree, WIDTH};
use super::objects::{Object, Objects};
use crate::math::ray::LANES;
use fearless_simd::prelude::*;
use fearless_simd::{mask32x16, u32x16};

/// Memory of the kernel, kept between calls.
#[derive(Debug)]
pub(crate) struct Scratch {
    world: Group,
    object: Group,
    found: Found,
    /// The stack in the scene's tree, then that in a mesh's.
    child: Vec<u32>,
    near: Vec<f32>,
}

impl Scratch {
    pub(crate) fn new() -> Self {
        Self {
            world: Group::NOTHING,
            object: Group::NOTHING,
            found: Found::NOTHING,
            child: Vec::new(),
            near: Vec::new(),
        }
    }
}

/// Traces all groups of a job but those it names in `left`: they are not coherent.
pub(crate) fn trace<S: Wide, J: Job>(
    simd: S,
    objects: &Objects,
    scratch: &mut Scratch,
    job: &mut J,
    left: &mut Vec<usize>,
) {
    let entries = objects.stack_capacity + 2 * WIDTH;
    if scratch.child.len() < entries {
        scratch.child.resize(entries, 0);
        scratch.near.resize(entries, 0.0);
    }
    simd.vectorize(
        #[inline(always)]
        || {
            for name in 0..job.groups() {
                let alive = job.load(simd, name, &mut scratch.world, &mut scratch.found);
                if trace_group::<S, J>(simd, objects, scratch, alive) {
                    job.done(simd, name, &scratch.found);
                } else {
                    left.push(name);
                }
            }
        },
    );
}

/// Traces one group; false if it is not coherent, and then nothing has been done.
#[inline(always)]
fn trace_group<S: Wide, J: Job>(simd: S, objects: &Objects, scratch: &mut Scratch, mut alive: u32) -> bool {
    let Scratch { world, object, found, child, near } = scratch;
    let Some(root) = objects.tree.root else { return true };
    let own = objects.tree.stack_capacity();
    let (scene_child, mesh_child) = child.split_at_mut(own);
    let (scene_near, mesh_near) = near.split_at_mut(own);
    if let Child::Object(index) = root.child()
        && let Object::Instance { tree, inverse } = &objects.list[index as usize]
    {
        // A scene of one mesh.
        object.load_transformed(simd, world, inverse);
        object.prepare(simd, tree.reach);
        alive &= object.meet(simd, &tree.bounds, &found.t).1.to_bitmask() as u32;
        if alive == 0 {
            return true;
        }
        let Some(bundle) = Bundle::of(simd, object, found, alive) else { return false };
        let walk = Walk { tree, group: object, bundle, object: index };
        walk.run::<S, J>(simd, found, &mut alive, mesh_child, mesh_near);
        return true;
    }
    world.prepare(simd, objects.tree.reach);
    alive &= world.meet(simd, &objects.tree.bounds, &found.t).1.to_bitmask() as u32;
    if alive == 0 {
        return true;
    }
    let Some(mut bundle) = Bundle::of(simd, world, found, alive) else { return false };
    scene_child[0] = root.0;
    scene_near[0] = f32::NEG_INFINITY;
    let mut depth = 1;
    while depth > 0 {
        depth -= 1;
        if scene_near[depth] > bundle.slabs.t_max {
            continue;
        }
        match Link(scene_child[depth]).child() {
            Child::Node(index) => {
                let node = &objects.tree.nodes[index as usize];
                if bundle.rays_meeting(simd, world, found, &node.bounds) & alive == 0 {
                    continue;
                }
                depth += push(simd, &bundle, node, &mut scene_child[depth..], &mut scene_near[depth..]);
            }
            Child::Object(index) => {
                let object_index = index as usize;
                let rays = bundle.rays_meeting(simd, world, found, &objects.bounds[object_index]) & alive;
                if rays == 0 {
                    continue;
                }
                match &objects.list[object_index] {
                    Object::Instance { tree, inverse } => {
                        object.load_transformed(simd, world, inverse);
                        object.prepare(simd, tree.reach);
                        let rays = object.meet(simd, &tree.bounds, &found.t).1.to_bitmask() as u32 & rays;
                        let mut rest = rays;
                        if let Some(bundle) = Bundle::of(simd, object, found, rays) {
                            let walk = Walk { tree, group: object, bundle, object: index };
                            walk.run::<S, J>(simd, found, &mut rest, mesh_child, mesh_near);
                        } else if rays != 0 {
                            // Turned into the mesh's space the rays straddle an axis.
                            walk_apart::<S, J>(simd, tree, object, index, found, &mut rest, mesh_child, mesh_near);
                        }
                        alive &= !(rays & !rest);
                    }
                    Object::Shape(shape) => {
                        let hit = shape.meet(simd, world, found, index, rays);
                        if J::ANY {
                            alive &= !hit;
                        }
                    }
                }
                if J::ANY && alive == 0 {
                    return true;
                }
                bundle.slabs.t_max = farthest(simd, found, alive);
            }
            Child::Leaf(_) => {}
        }
    }
    true
}

/// Pushes the children that a bundle meets; returns how many.
#[inline(always)]
fn push<S: Wide>(simd: S, bundle: &Bundle, node: &super::nodes::Node, child: &mut [u32], near: &mut [f32]) -> usize {
    let (enter, mask) = bundle.slabs.meet(simd, node);
    let links = u32x16::load_array_ref(simd, &node.child);
    let order = node.near_to_far(!bundle.slabs.octant);
    let to_child: &mut [u32; WIDTH] = (&mut child[..WIDTH]).try_into().expect("a whole vector");
    let to_near: &mut [f32; WIDTH] = (&mut near[..WIDTH]).try_into().expect("a whole vector");
    simd.push_hit(links, enter, mask, order, to_child, to_near)
}

/// Where the last of the rays ends.
#[inline(always)]
fn farthest<S: Wide>(simd: S, found: &Found, alive: u32) -> f32 {
    most(simd, mask32x16::from_bitmask(simd, u64::from(alive)), load(simd, &found.t))
}

/// A group on its way through one mesh.
struct Walk<'a> {
    tree: &'a Tree,
    group: &'a Group,
    bundle: Bundle,
    object: u32,
}

impl Walk<'_> {
    /// Walks from the root. With `J::ANY` takes the rays that met something out of `alive`.
    #[inline(always)]
    fn run<S: Wide, J: Job>(
        mut self,
        simd: S,
        found: &mut Found,
        alive: &mut u32,
        child: &mut [u32],
        near: &mut [f32],
    ) {
        let Some(root) = self.tree.root else { return };
        child[0] = root.0;
        near[0] = f32::NEG_INFINITY;
        let mut depth = 1;
        while depth > 0 {
            depth -= 1;
            if near[depth] > self.bundle.slabs.t_max {
                continue;
            }
            let link = Link(child[depth]);
            let Some(index) = link.as_leaf() else {
                let node = &self.tree.nodes[link.0 as usize];
                if self.bundle.rays_meeting(simd, self.group, found, &node.bounds) & *alive != 0 {
                    depth += push(simd, &self.bundle, node, &mut child[depth..], &mut near[depth..]);
                }
                continue;
            };
            let leaf = &self.tree.leaves[index];
            let rays = self.bundle.rays_meeting(simd, self.group, found, &leaf.bounds) & *alive;
            if rays == 0 {
                continue;
            }
            let hit = self.leaf::<S, J>(simd, leaf, found, rays);
            if hit == 0 {
                continue;
            }
            if J::ANY {
                *alive &= !hit;
                if *alive == 0 {
                    return;
                }
            }
            self.bundle.slabs.t_max = farthest(simd, found, *alive);
        }
    }

    /// Tests a leaf; returns the rays that found something.
    #[inline(always)]
    fn leaf<S: Wide, J: Job>(&self, simd: S, leaf: &Leaf, found: &mut Found, rays: u32) -> u32 {
        let mut triangles = self.bundle.slabs.meet_triangles(simd, leaf);
        let mut hit = 0;
        match self.bundle.along {
            Some(along) if rays.count_ones() >= triangles.count_ones() => {
                while triangles != 0 {
                    let lane = triangles.trailing_zeros() as usize & (WIDTH - 1);
                    triangles &= triangles - 1;
                    hit |= self.triangle::<S, J>(simd, (leaf, lane), along as usize, found, rays & !hit_if::<J>(hit));
                    if J::ANY && rays & !hit == 0 {
                        break;
                    }
                }
            }
            _ if triangles != 0 => {
                let mut rest = rays;
                while rest != 0 {
                    let lane = rest.trailing_zeros() as usize & (LANES - 1);
                    rest &= rest - 1;
                    if ray_in_leaf::<S, J>(simd, self.group, lane, leaf, self.object, found) {
                        hit |= 1 << lane;
                    }
                }
            }
            _ => {}
        }
        hit
    }

    /// One triangle against sixteen rays: [`crate::shape::triangle::intersect`] in lanes. `along` is the longest axis of
    /// all the directions. Returns the rays that took the hit.
    #[inline(always)]
    fn triangle<S: Wide, J: Job>(
        &self,
        simd: S,
        (leaf, lane): (&Leaf, usize),
        along: usize,
        found: &mut Found,
        rays: u32,
    ) -> u32 {
        const AXES: [[usize; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];
        let (axes, primitive) = (AXES[along % 3], leaf.primitive[lane]);
        let group = self.group;
        let (sx, sy) = (load(simd, &group.shear[0]), load(simd, &group.shear[1]));
        let origin = each(
            #[inline(always)]
            |k| load(simd, &group.origin[axes[k]]),
        );
        let [a, b, c] = each(
            #[inline(always)]
            |corner| {
                let k = leaf.corner[corner].get(lane);
                let [x, y, z] = each(
                    #[inline(always)]
                    |axis| splat(simd, leaf.vertex[axes[axis]][k]) - origin[axis],
                );
                [x - sx * z, y - sy * z, z]
            },
        );
        let u = c[0] * b[1] - c[1] * b[0];
        let v = a[0] * c[1] - a[1] * c[0];
        let w = b[0] * a[1] - b[1] * a[0];
        let zero = splat(simd, 0.0);
        let positive = u.simd_ge(zero) & v.simd_ge(zero) & w.simd_ge(zero);
        let negative = u.simd_le(zero) & v.simd_le(zero) & w.simd_le(zero);
        let determinant = (u + v) + w;
        let inside = (positive | negative) & determinant.simd_ne(zero);
        if inside.to_bitmask() as u32 & rays == 0 {
            return 0;
        }
        let sz = load(simd, &group.shear[2]);
        let scale = splat(simd, 1.0) / determinant;
        let t = ((u * (sz * a[2]) + v * (sz * b[2])) + w * (sz * c[2])) * scale;
        let last = load(simd, &found.t);
        let met = inside & mask32x16::from_bitmask(simd, u64::from(rays)) & t.simd_gt(load(simd, &group.t_min));
        let mut takes = met & t.simd_lt(last);
        let ties = met & t.simd_eq(last);
        if ties.to_bitmask() != 0 {
            let object = u32x16::splat(simd, self.object);
            let (old_object, old) =
                (u32x16::load_array_ref(simd, &found.object), u32x16::load_array_ref(simd, &found.primitive));
            let smaller =
                object.simd_lt(old_object) | object.simd_eq(old_object) & u32x16::splat(simd, primitive).simd_lt(old);
            takes |= ties & smaller;
        }
        let bits = takes.to_bitmask() as u32;
        if bits == 0 {
            return 0;
        }
        let object = u32x16::splat(simd, self.object);
        takes.select(object, u32x16::load_array_ref(simd, &found.object)).store_array(&mut found.object);
        if J::ANY {
            takes.select(splat(simd, f32::NEG_INFINITY), last).store_array(&mut found.t);
            return bits;
        }
        takes.select(t, last).store_array(&mut found.t);
        takes.select(v * scale, load(simd, &found.u)).store_array(&mut found.u);
        takes.select(w * scale, load(simd, &found.v)).store_array(&mut found.v);
        let primitive = u32x16::splat(simd, primitive);
        takes.select(primitive, u32x16::load_array_ref(simd, &found.primitive)).store_array(&mut found.primitive);
        bits
    }
}

/// The rays that need no more tests once they are in `hit`.
#[inline(always)]
fn hit_if<J: Job>(hit: u32) -> u32 {
    if J::ANY { hit } else { 0 }
}

/// One ray against the triangles of a leaf; whether it found something.
#[inline(always)]
pub(crate) fn ray_in_leaf<S: Wide, J: Job>(
    simd: S,
    group: &Group,
    lane: usize,
    leaf: &Leaf,
    object: u32,
    found: &mut Found,
) -> bool {
    let Some(met) = leaf_test::meet(simd, leaf, &group.frame(lane), group.t_min[lane], found.t[lane]) else {
        return false;
    };
    if J::ANY {
        found.object[lane] = object;
        found.t[lane] = f32::NEG_INFINITY;
        return true;
    }
    let (nearest, best) = met.nearest(simd, &leaf.primitive);
    found.offer(lane, nearest, [met.u[best], met.v[best]], object, leaf.primitive[best])
}

/// Walks a mesh with one ray after the other: for the few groups that are coherent in the world but not in the mesh.
#[allow(clippy::too_many_arguments, reason = "the state of the group, which its owner keeps apart")]
fn walk_apart<S: Wide, J: Job>(
    simd: S,
    tree: &Tree,
    group: &Group,
    object: u32,
    found: &mut Found,
    alive: &mut u32,
    child: &mut [u32],
    near: &mut [f32],
) {
    simd.vectorize(
        #[inline(always)]
        || {
            let mut rest = *alive;
            while rest != 0 {
                let lane = rest.trailing_zeros() as usize & (LANES - 1);
                rest &= rest - 1;
                if let Some(bundle) = Bundle::of(simd, group, found, 1 << lane) {
                    let mut one = 1 << lane;
                    Walk { tree, group, bundle, object }.run::<S, J>(simd, found, &mut one, child, near);
                    *alive &= !((1 << lane) & !one);
                }
            }
        },
    );
}
