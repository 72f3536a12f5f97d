//! What sixteen neighbouring rays have in common.

use super::group::{Found, Group};
use super::lanes::{Wide, each, load, splat};
use super::slabs::{OFFSET_SLACK, Slabs};
use crate::math::ray::LANES;
use fearless_simd::prelude::*;
use fearless_simd::{f32x16, mask32x16, u32x16};

/// The box test for a whole group at once, by interval arithmetic over origins and inverse directions: a box that no
/// ray of the group meets is mostly not met by the bundle either, and one that a ray meets always is.
/// (Boulos, Wald, Shirley, "Geometric and Arithmetic Culling Methods for Entire Ray Packets", 2006.)
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bundle {
    pub(crate) slabs: Slabs,
    /// The longest axis of the directions, if it is the same for all.
    pub(crate) along: Option<u32>,
}

impl Bundle {
    /// The bundle of the rays in `alive`; `None` if their directions differ in sign on some axis, or there are no rays.
    #[inline(always)]
    pub(crate) fn of<S: Wide>(simd: S, group: &Group, found: &Found, alive: u32) -> Option<Self> {
        let mask = mask32x16::from_bitmask(simd, u64::from(alive));
        let first = alive.trailing_zeros() as usize & (LANES - 1);
        if alive == 0 || !same(simd, &group.octant, alive) {
            return None;
        }
        let mut slabs = Slabs {
            near_mul: [0.0; 3],
            near_add: [0.0; 3],
            far_mul: [0.0; 3],
            far_add: [0.0; 3],
            t_min: least(simd, mask, load(simd, &group.t_min)),
            t_max: most(simd, mask, load(simd, &found.t)),
            octant: group.octant[first],
        };
        for axis in 0..3 {
            let origin = load(simd, &group.origin[axis]);
            let (low, high) = (least(simd, mask, origin), most(simd, mask, origin));
            let negative = slabs.octant >> axis & 1 != 0;
            let sign = if negative { -1.0_f32 } else { 1.0 };
            // The near plane comes no sooner than for the ray that starts closest to it and is fastest; where that is
            // negative the box surrounds the origins, and any negative number says so.
            let near = least(simd, mask, load(simd, &group.near_mul[axis]).abs()).copysign(sign);
            let far = most(simd, mask, load(simd, &group.far_mul[axis]).abs()).copysign(sign);
            let (near_origin, far_origin) = if negative { (low, high) } else { (high, low) };
            let (near_offset, far_offset) = (near_origin * near, far_origin * far);
            slabs.near_mul[axis] = near;
            slabs.far_mul[axis] = far;
            slabs.near_add[axis] = -near_offset - near_offset.abs() * OFFSET_SLACK;
            slabs.far_add[axis] = -far_offset + far_offset.abs() * OFFSET_SLACK;
        }
        let along = same(simd, &group.along, alive).then_some(group.along[first]);
        Some(Self { slabs, along })
    }

    /// Which rays of the group meet a box before what they have found.
    #[inline(always)]
    pub(crate) fn rays_meeting<S: Wide>(&self, simd: S, group: &Group, found: &Found, bounds: &[[f32; 3]; 2]) -> u32 {
        let octant = self.slabs.octant;
        let near = each(
            #[inline(always)]
            |axis| {
                let plane = splat(simd, bounds[(octant >> axis) as usize & 1][axis]);
                plane.mul_add(load(simd, &group.near_mul[axis]), load(simd, &group.near_add[axis]))
            },
        );
        let far = each(
            #[inline(always)]
            |axis| {
                let plane = splat(simd, bounds[!(octant >> axis) as usize & 1][axis]);
                plane.mul_add(load(simd, &group.far_mul[axis]), load(simd, &group.far_add[axis]))
            },
        );
        let enter = near[0].max(near[1]).max(near[2].max(load(simd, &group.t_min)));
        let leave = far[0].min(far[1]).min(far[2].min(load(simd, &found.t)));
        enter.simd_le(leave).to_bitmask() as u32
    }
}

/// Whether all lanes in `alive`, of which there are some, hold the same.
#[inline(always)]
fn same<S: Wide>(simd: S, values: &[u32; LANES], alive: u32) -> bool {
    let first = values[alive.trailing_zeros() as usize & (LANES - 1)];
    let equal = u32x16::load_array_ref(simd, values).simd_eq(u32x16::splat(simd, first));
    equal.to_bitmask() as u32 & alive == alive
}

/// The smallest of the lanes in `mask`.
#[inline(always)]
fn least<S: Wide>(simd: S, mask: mask32x16<S>, v: f32x16<S>) -> f32 {
    mask.select(v, splat(simd, f32::INFINITY)).reduce_min()
}

/// The largest of the lanes in `mask`.
#[inline(always)]
pub(crate) fn most<S: Wide>(simd: S, mask: mask32x16<S>, v: f32x16<S>) -> f32 {
    mask.select(v, splat(simd, f32::NEG_INFINITY)).reduce_max()
}
