//! Rays against sixteen boxes at a time.

use super::lanes::{Wide, each, load, splat};
use super::nodes::{Leaf, Node};
use fearless_simd::f32x16;
use fearless_simd::mask32x16;
use fearless_simd::prelude::*;

/// What the box test needs of a ray, or of a bundle of rays with one octant: the parameter at which it meets a plane
/// `p` across an axis is `p * mul + add`, rounded down for the plane it comes to first and up for the other.
///
/// The test never misses a box with a true hit in it. The way to a plane is computed with a few roundings (here, and
/// again in the triangle test, which sees vertices moved by as much); the factors take in eight units in the last place
/// of the result, the summands four of `origin / direction`, which bounds what cancels. Ize, "Robust BVH Ray
/// Traversal" (2013) has the argument for the form without the summand. A zero direction counts as a tiny one, so no
/// 0 * infinity arises: on a slab within rounding the ray is inside it.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub(crate) struct Slabs {
    pub(crate) near_mul: [f32; 3],
    pub(crate) near_add: [f32; 3],
    pub(crate) far_mul: [f32; 3],
    pub(crate) far_add: [f32; 3],
    pub(crate) t_min: f32,
    /// Where the nearest hit so far lies.
    pub(crate) t_max: f32,
    /// Bit `axis` is set when the direction is negative along it.
    pub(crate) octant: u32,
}

/// Relative widening of distances, and that of `origin / direction`.
pub(crate) const SLACK: f32 = 8.0 * f32::EPSILON;
pub(crate) const OFFSET_SLACK: f32 = 4.0 * f32::EPSILON;

impl Slabs {
    /// `reach` is the largest coordinate of any box, by size.
    #[inline(always)]
    pub(crate) fn new(origin: [f32; 3], direction: [f32; 3], t_min: f32, t_max: f32, reach: f32) -> Self {
        let mut slabs = Self {
            near_mul: [0.0; 3],
            near_add: [0.0; 3],
            far_mul: [0.0; 3],
            far_add: [0.0; 3],
            t_min,
            t_max,
            octant: 0,
        };
        for axis in 0..3 {
            let (o, d) = (origin[axis], direction[axis]);
            let steepest = steepest(o.abs().max(reach));
            let inverse = (1.0 / d.abs()).min(steepest).copysign(d);
            let (near, far) = (inverse * (1.0 - SLACK), inverse * (1.0 + SLACK));
            let (near_offset, far_offset) = (o * near, o * far);
            slabs.near_mul[axis] = near;
            slabs.far_mul[axis] = far;
            slabs.near_add[axis] = -near_offset - near_offset.abs() * OFFSET_SLACK;
            slabs.far_add[axis] = -far_offset + far_offset.abs() * OFFSET_SLACK;
            slabs.octant |= u32::from(d.is_sign_negative()) << axis;
        }
        slabs
    }

    /// Meets the children of a node: where the ray enters each box, and which of them it meets.
    #[inline(always)]
    pub(crate) fn meet<S: Wide>(&self, simd: S, node: &Node) -> (f32x16<S>, mask32x16<S>) {
        let near = each(
            #[inline(always)]
            |axis| {
                let plane = load(simd, &node.planes[(self.octant >> axis) as usize & 1][axis]);
                plane.mul_add(splat(simd, self.near_mul[axis]), splat(simd, self.near_add[axis]))
            },
        );
        let far = each(
            #[inline(always)]
            |axis| {
                let plane = load(simd, &node.planes[!(self.octant >> axis) as usize & 1][axis]);
                plane.mul_add(splat(simd, self.far_mul[axis]), splat(simd, self.far_add[axis]))
            },
        );
        let enter = near[0].max(near[1]).max(near[2].max(splat(simd, self.t_min)));
        let leave = far[0].min(far[1]).min(far[2].min(splat(simd, self.t_max)));
        (enter, enter.simd_le(leave))
    }
}

impl Slabs {
    /// Meets the boxes of a leaf's triangles; a bit for each that is met.
    #[inline(always)]
    pub(crate) fn meet_triangles<S: Wide>(&self, simd: S, leaf: &Leaf) -> u32 {
        let corner = each(
            #[inline(always)]
            |k| simd.index(leaf.corner[k]),
        );
        let (mut enter, mut leave) = (splat(simd, self.t_min), splat(simd, self.t_max));
        for axis in 0..3 {
            let row = load(simd, &leaf.vertex[axis]);
            let [a, b, c] = each(
                #[inline(always)]
                |k| simd.pick(row, corner[k]),
            );
            let (low, high) = (a.min(b).min(c), a.max(b).max(c));
            let (near, far) = if self.octant >> axis & 1 != 0 { (high, low) } else { (low, high) };
            enter = enter.max(near.mul_add(splat(simd, self.near_mul[axis]), splat(simd, self.near_add[axis])));
            leave = leave.min(far.mul_add(splat(simd, self.far_mul[axis]), splat(simd, self.far_add[axis])));
        }
        enter.simd_le(leave).to_bitmask() as u32 & ((1 << leaf.count) - 1)
    }
}

/// The largest inverse direction at which no product with a coordinate up to `reach` overflows.
#[inline(always)]
pub(crate) fn steepest(reach: f32) -> f32 {
    (1e36 / reach).min(1e30)
}
