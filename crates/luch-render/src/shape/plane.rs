//! Ray against plane and rectangle.

use crate::math::ray::Ray;
use glam::Vec3;

/// The bounds of a rectangle in its plane, around the plane's point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rectangle {
    /// Unit vector along the first side, in the plane.
    pub axis_u: Vec3,
    /// Unit vector along the second side, in the plane.
    pub axis_v: Vec3,
    /// Half the first side.
    pub half_u: f32,
    /// Half the second side.
    pub half_v: f32,
}

/// The `t` at which the ray meets the plane, if inside the ray's open interval and, where there are `bounds`, inside
/// them (edges included). Either side counts; a parallel ray misses.
pub fn intersect(point: Vec3, normal: Vec3, bounds: Option<&Rectangle>, ray: &Ray) -> Option<f32> {
    let t = dot(point - ray.origin, normal) / dot(ray.direction, normal);
    // Parallel: t is infinite or NaN, and neither passes a comparison with a finite interval; an infinite t_max is
    // not above an infinite t.
    if !(ray.t_min < t && t < ray.t_max) {
        return None;
    }
    let inside = bounds.is_none_or(|r| {
        let from_point = (ray.origin - point) + ray.direction * t;
        dot(from_point, r.axis_u).abs() <= r.half_u && dot(from_point, r.axis_v).abs() <= r.half_v
    });
    inside.then_some(t)
}

fn dot(a: Vec3, b: Vec3) -> f32 {
    (a.x * b.x + a.y * b.y) + a.z * b.z
}
