//! Sixteen rays against an analytic shape: the functions of [`crate::shape`], step by step, in lanes.

use super::geometry::Geometry;
use super::group::{Found, Group};
use super::lanes::{Wide, each, load, splat};
use crate::math::ray::NO_OBJECT;
use crate::shape::cuboid::Cuboid;
use crate::shape::plane::Rectangle;
use fearless_simd::prelude::*;
use fearless_simd::{f32x16, f64x8, mask32x16, u32x16};
use glam::Vec3;

/// Three coordinates of sixteen points.
type Points<S> = [f32x16<S>; 3];

/// Where rays meet a shape before what they have found: the lanes that do, and for those `t` and the primitive.
type Met<S> = (mask32x16<S>, f32x16<S>, u32x16<S>);

impl Geometry {
    /// Meets the shape with the rays in `rays`, and notes what is nearer than what they have found; a bit for each that
    /// took the hit. Instances are met elsewhere.
    #[inline(always)]
    pub(crate) fn meet<S: Wide>(&self, simd: S, world: &Group, found: &mut Found, object: u32, rays: u32) -> u32 {
        let (met, t, primitive) = match self {
            Self::Sphere { center, radius } => sphere(simd, *center, *radius, world, found),
            Self::Cuboid(shape) => cuboid(simd, shape, world, found),
            Self::Plane { point, normal, bounds } => plane(simd, *point, *normal, bounds.as_ref(), world, found),
            Self::Instance { .. } | Self::Hidden => return 0,
        };
        let met = met & mask32x16::from_bitmask(simd, u64::from(rays));
        if met.to_bitmask() == 0 {
            return 0;
        }
        let last = load(simd, &found.t);
        let (old_object, old) =
            (u32x16::load_array_ref(simd, &found.object), u32x16::load_array_ref(simd, &found.primitive));
        let object = u32x16::splat(simd, object);
        let smaller = object.simd_lt(old_object) | object.simd_eq(old_object) & primitive.simd_lt(old);
        let takes = met & (t.simd_lt(last) | t.simd_eq(last) & smaller);
        takes.select(t, last).store_array(&mut found.t);
        takes.select(splat(simd, 0.0), load(simd, &found.u)).store_array(&mut found.u);
        takes.select(splat(simd, 0.0), load(simd, &found.v)).store_array(&mut found.v);
        takes.select(object, old_object).store_array(&mut found.object);
        takes.select(primitive, old).store_array(&mut found.primitive);
        takes.to_bitmask() as u32
    }
}

/// Whether `t` counts for each ray. A tie with what was found counts; the caller decides it.
#[inline(always)]
fn inside<S: Wide>(simd: S, t: f32x16<S>, world: &Group, found: &Found) -> mask32x16<S> {
    t.simd_gt(load(simd, &world.t_min)) & t.simd_le(load(simd, &found.t))
}

/// The near root where that counts, else the far one.
#[inline(always)]
fn first_inside<S: Wide>(
    simd: S,
    near: f32x16<S>,
    far: f32x16<S>,
    world: &Group,
    found: &Found,
) -> (mask32x16<S>, mask32x16<S>, f32x16<S>) {
    let near_counts = inside(simd, near, world, found);
    let far_counts = inside(simd, far, world, found);
    (near_counts | far_counts, near_counts, near_counts.select(near, far))
}

/// Eight rays of a sphere test: whether the line meets the sphere, and the two roots, near first.
struct Roots<S: Wide> {
    valid: u32,
    near: f64x8<S>,
    far: f64x8<S>,
}

/// [`crate::shape::sphere::intersect`] for half of the rays.
#[inline(always)]
fn roots<S: Wide>(simd: S, from_center: [f64x8<S>; 3], direction: [f64x8<S>; 3], radius: f64) -> Roots<S> {
    let zero = f64x8::splat(simd, 0.0);
    let square = f64x8::splat(simd, radius * radius);
    let a = dot(direction, direction);
    let b = -dot(from_center, direction);
    let along = b / a;
    let from_line = each(
        #[inline(always)]
        |axis| from_center[axis] + direction[axis] * along,
    );
    let discriminant = square - dot(from_line, from_line);
    let valid = discriminant.simd_ge(zero).to_bitmask() as u32;
    if valid == 0 {
        return Roots { valid, near: zero, far: zero };
    }
    let root = (a * discriminant).sqrt();
    let away = b.simd_lt(zero);
    let q = away.select(b - root, b + root);
    let (t0, t1) = ((dot(from_center, from_center) - square) / q, q / a);
    Roots { valid, near: away.select(t1, t0), far: away.select(t0, t1) }
}

#[inline(always)]
fn dot<S: Wide>(a: [f64x8<S>; 3], b: [f64x8<S>; 3]) -> f64x8<S> {
    (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]
}

#[inline(always)]
fn sphere<S: Wide>(simd: S, center: Vec3, radius: f32, world: &Group, found: &Found) -> Met<S> {
    let zero = (splat(simd, 0.0), u32x16::splat(simd, 0));
    let missed = (mask32x16::splat(simd, false), zero.0, zero.1);
    // Not `radius <= 0`: a NaN must miss.
    let has_surface = radius > 0.0;
    if !has_surface {
        return missed;
    }
    let center = center.as_dvec3().to_array();
    let (mut low_origin, mut high_origin) = ([f64x8::splat(simd, 0.0); 3], [f64x8::splat(simd, 0.0); 3]);
    let (mut low_direction, mut high_direction) = (low_origin, high_origin);
    for axis in 0..3 {
        let middle = f64x8::splat(simd, center[axis]);
        let (low, high) = load(simd, &world.origin[axis]).widen();
        (low_origin[axis], high_origin[axis]) = (low - middle, high - middle);
        (low_direction[axis], high_direction[axis]) = load(simd, &world.direction[axis]).widen();
    }
    let low = roots(simd, low_origin, low_direction, f64::from(radius));
    let high = roots(simd, high_origin, high_direction, f64::from(radius));
    let valid = low.valid | high.valid << 8;
    if valid == 0 {
        return missed;
    }
    let near = simd.narrow_f64x8(low.near, high.near);
    let far = simd.narrow_f64x8(low.far, high.far);
    let (met, _, t) = first_inside(simd, near, far, world, found);
    (met & mask32x16::from_bitmask(simd, u64::from(valid)), t, zero.1)
}

#[inline(always)]
fn cuboid<S: Wide>(simd: S, shape: &Cuboid, world: &Group, found: &Found) -> Met<S> {
    let mut origin: Points<S> = each(
        #[inline(always)]
        |axis| load(simd, &world.origin[axis]) - splat(simd, shape.center[axis]),
    );
    let mut direction: Points<S> = each(
        #[inline(always)]
        |axis| load(simd, &world.direction[axis]),
    );
    if let Some(rotation) = &shape.rotation {
        let axes = [rotation.x_axis, rotation.y_axis, rotation.z_axis];
        (origin, direction) = (
            each(
                #[inline(always)]
                |k| along(simd, origin, axes[k]),
            ),
            each(
                #[inline(always)]
                |k| along(simd, direction, axes[k]),
            ),
        );
    }
    let zero = splat(simd, 0.0);
    let (mut near, mut far) = (splat(simd, f32::NEG_INFINITY), splat(simd, f32::INFINITY));
    let (mut near_face, mut far_face) = (u32x16::splat(simd, 0), u32x16::splat(simd, 0));
    let mut beside = mask32x16::splat(simd, false);
    for axis in 0..3 {
        let (o, d) = (origin[axis], direction[axis]);
        let (low, high) = (splat(simd, -shape.half_size[axis]), splat(simd, shape.half_size[axis]));
        let parallel = d.simd_eq(zero);
        beside |= parallel & !(low.simd_le(o) & o.simd_le(high));
        let (at_low, at_high) = ((low - o) / d, (high - o) / d);
        let positive = d.simd_gt(zero);
        let (enter, leave) = (positive.select(at_low, at_high), positive.select(at_high, at_low));
        let (low_face, high_face) = (u32x16::splat(simd, 2 * axis as u32), u32x16::splat(simd, 2 * axis as u32 + 1));
        let later = !parallel & enter.simd_gt(near);
        near = later.select(enter, near);
        near_face = later.select(positive.select(low_face, high_face), near_face);
        let sooner = !parallel & leave.simd_lt(far);
        far = sooner.select(leave, far);
        far_face = sooner.select(positive.select(high_face, low_face), far_face);
    }
    let (met, at_near, t) = first_inside(simd, near, far, world, found);
    (met & !beside & !near.simd_gt(far), t, at_near.select(near_face, far_face))
}

#[inline(always)]
fn plane<S: Wide>(
    simd: S,
    point: Vec3,
    normal: Vec3,
    bounds: Option<&Rectangle>,
    world: &Group,
    found: &Found,
) -> Met<S> {
    let origin: Points<S> = each(
        #[inline(always)]
        |axis| load(simd, &world.origin[axis]),
    );
    let direction: Points<S> = each(
        #[inline(always)]
        |axis| load(simd, &world.direction[axis]),
    );
    let to_plane = each(
        #[inline(always)]
        |axis| splat(simd, point[axis]) - origin[axis],
    );
    let t = along(simd, to_plane, normal) / along(simd, direction, normal);
    let mut met = inside(simd, t, world, found);
    if let Some(r) = bounds {
        let from_point = each(
            #[inline(always)]
            |axis| (origin[axis] - splat(simd, point[axis])) + direction[axis] * t,
        );
        met &= along(simd, from_point, r.axis_u).abs().simd_le(splat(simd, r.half_u));
        met &= along(simd, from_point, r.axis_v).abs().simd_le(splat(simd, r.half_v));
    }
    (met, t, u32x16::splat(simd, 0))
}

/// Dot products with one vector, added in order.
#[inline(always)]
fn along<S: Wide>(simd: S, p: Points<S>, axis: Vec3) -> f32x16<S> {
    (p[0] * splat(simd, axis.x) + p[1] * splat(simd, axis.y)) + p[2] * splat(simd, axis.z)
}

impl Found {
    /// A bit for each ray that has found something.
    #[inline(always)]
    pub(crate) fn rays<S: Wide>(&self, simd: S) -> u32 {
        u32x16::load_array_ref(simd, &self.object).simd_ne(u32x16::splat(simd, NO_OBJECT)).to_bitmask() as u32
    }
}
