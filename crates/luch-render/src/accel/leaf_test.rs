//! One ray against the triangles of a leaf, in lanes: [`crate::shape::triangle::intersect`], step by step.

use super::lanes::{Wide, each, load, splat};
use super::nodes::{Leaf, WIDTH};
use crate::shape::triangle::ShearedRay;
use fearless_simd::prelude::*;
use fearless_simd::{f32x16, mask32x16};
use glam::Vec3;

/// What the triangle test needs of a ray.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    /// Which axis becomes x, y, z.
    pub(crate) axes: [u8; 3],
    /// The origin along those.
    pub(crate) origin: [f32; 3],
    pub(crate) shear: [f32; 3],
}

impl Frame {
    #[inline(always)]
    pub(crate) fn new(origin: Vec3, direction: Vec3) -> Self {
        let ShearedRay { kz, kx, ky, shear } = ShearedRay::new(direction);
        Self { axes: [kx as u8, ky as u8, kz as u8], origin: [origin[kx], origin[ky], origin[kz]], shear }
    }
}

/// Triangles that a ray meets inside its interval, by lane.
pub(crate) struct Met<S: Wide> {
    /// Never empty.
    pub(crate) mask: mask32x16<S>,
    pub(crate) t: f32x16<S>,
    pub(crate) u: f32x16<S>,
    pub(crate) v: f32x16<S>,
}

/// The triangles with a hit at `t_min < t <= t_last`; `None` if there are none.
#[inline(always)]
pub(crate) fn meet<S: Wide>(simd: S, leaf: &Leaf, frame: &Frame, t_min: f32, t_last: f32) -> Option<Met<S>> {
    // Each vertex into the frame of the ray, once for all triangles around it.
    let [x, y, z] = each(
        #[inline(always)]
        |k| load(simd, &leaf.vertex[frame.axes[k] as usize]) - splat(simd, frame.origin[k]),
    );
    let x = x - splat(simd, frame.shear[0]) * z;
    let y = y - splat(simd, frame.shear[1]) * z;
    let [a, b, c] = each(
        #[inline(always)]
        |k| simd.index(leaf.corner[k]),
    );
    let (ax, ay) = (simd.pick(x, a), simd.pick(y, a));
    let (bx, by) = (simd.pick(x, b), simd.pick(y, b));
    let (cx, cy) = (simd.pick(x, c), simd.pick(y, c));
    let u = cx * by - cy * bx;
    let v = ax * cy - ay * cx;
    let w = bx * ay - by * ax;
    let zero = splat(simd, 0.0);
    let positive = u.simd_ge(zero) & v.simd_ge(zero) & w.simd_ge(zero);
    let negative = u.simd_le(zero) & v.simd_le(zero) & w.simd_le(zero);
    let determinant = (u + v) + w;
    let inside = (positive | negative) & determinant.simd_ne(zero);
    if inside.to_bitmask() == 0 {
        return None;
    }
    let z = z * splat(simd, frame.shear[2]);
    let scale = splat(simd, 1.0) / determinant;
    let t = ((u * simd.pick(z, a) + v * simd.pick(z, b)) + w * simd.pick(z, c)) * scale;
    let mask = inside & t.simd_gt(splat(simd, t_min)) & t.simd_le(splat(simd, t_last));
    (mask.to_bitmask() != 0).then(|| Met { mask, t, u: v * scale, v: w * scale })
}

impl<S: Wide> Met<S> {
    /// The smallest `t` and its lane, ties going to the smaller primitive.
    #[inline(always)]
    pub(crate) fn nearest(&self, simd: S, primitives: &[u32; WIDTH]) -> (f32, usize) {
        let nearest = self.mask.select(self.t, f32x16::splat(simd, f32::INFINITY)).reduce_min();
        let mut ties = (self.mask & self.t.simd_eq(f32x16::splat(simd, nearest))).to_bitmask() as u32;
        let mut best = ties.trailing_zeros() as usize & (WIDTH - 1);
        while ties & ties.wrapping_sub(1) != 0 {
            ties &= ties - 1;
            let other = ties.trailing_zeros() as usize & (WIDTH - 1);
            if primitives[other] < primitives[best] {
                best = other;
            }
        }
        (nearest, best)
    }
}
