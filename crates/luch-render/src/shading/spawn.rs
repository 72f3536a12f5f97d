//! New rays from surfaces: to a light, and along the mirror direction.

use super::surface::SurfaceBatch;
use super::surface::views;
use crate::math::lanes::{LANES, Lanes, Vec3Lanes};
use crate::math::ray::RayBatch;
use fearless_simd::prelude::*;

/// A shadow ray ends this share short of the light, so that a surface which the light itself lies on does not count.
const SHORT_OF_LIGHT: f32 = 1.0 - 1.0e-4;

/// The lowest sine over the true face at which a mirror ray leaves: one that the shading normal sends below is raised.
const LOWEST_MIRROR: f32 = 1.0e-3;

/// Shadow rays of sixteen surfaces: origin, unit direction, and how far to look.
#[inline(always)]
pub(crate) fn shadow_rays<S: Simd>(
    simd: S,
    surfaces: &SurfaceBatch,
    at: usize,
    light: Vec3Lanes<S>,
) -> (Vec3Lanes<S>, Vec3Lanes<S>, Lanes<S>) {
    let origin = Vec3Lanes::load(simd, views(&surfaces.shadow_origin), at);
    let to_light = light - origin;
    let distance = to_light.length();
    (origin, to_light.unit_or_zero(simd), distance * SHORT_OF_LIGHT)
}

/// Mirror rays of sixteen surfaces: origin and unit direction.
#[inline(always)]
pub(crate) fn mirror_rays<S: Simd>(
    simd: S,
    surfaces: &SurfaceBatch,
    rays: &RayBatch,
    at: usize,
) -> (Vec3Lanes<S>, Vec3Lanes<S>) {
    let direction = Vec3Lanes::load(simd, [rays.direction(0), rays.direction(1), rays.direction(2)], at);
    let normal = Vec3Lanes::load(simd, views(&surfaces.normal), at);
    let geometric = Vec3Lanes::load(simd, views(&surfaces.geometric_normal), at);
    let position = Vec3Lanes::load(simd, views(&surfaces.position), at);
    let offset = Lanes::from_slice(simd, &surfaces.offset[at..at + LANES]);
    let mirrored = direction - normal.scale(direction.dot(normal) * 2.0);
    let height = mirrored.dot(geometric);
    let lowest = Lanes::splat(simd, LOWEST_MIRROR);
    let low = height.simd_lt(lowest);
    let raised = mirrored + geometric.scale(lowest - height);
    let direction = Vec3Lanes::select(low, raised, mirrored).unit_or_zero(simd);
    (position + geometric.scale(offset), direction)
}
