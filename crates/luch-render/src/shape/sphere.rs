//! Ray against sphere.

use crate::math::ray::Ray;
use glam::{DVec3, Vec3};

/// The smallest `t` in the ray's open interval at which it meets the surface: from outside the near side, from inside
/// the far side. A radius that is not positive is never hit.
///
/// Works in f64: an origin a million radii away leaves f32 no digits for the discriminant, and a sphere is too cheap
/// for the difference to show. The form of the discriminant and of the roots is that of Haines, Günther, Akenine-Möller,
/// "Precision Improvements for Ray/Sphere Intersection" (Ray Tracing Gems, 2019): the distance of the line from the
/// centre is taken from the vector between them, not from the difference of two squares, and the root that would cancel
/// comes from the product of both.
pub fn intersect(center: Vec3, radius: f32, ray: &Ray) -> Option<f32> {
    let from_center = ray.origin.as_dvec3() - center.as_dvec3();
    let (direction, radius) = (ray.direction.as_dvec3(), f64::from(radius));
    let a = dot(direction, direction);
    let b = -dot(from_center, direction);
    let from_line = from_center + direction * (b / a);
    let discriminant = radius * radius - dot(from_line, from_line);
    // Not `discriminant < 0`: a NaN (zero direction) must miss.
    let hit = discriminant >= 0.0 && radius > 0.0;
    if !hit {
        return None;
    }
    let root = (a * discriminant).sqrt();
    let q = if b < 0.0 { b - root } else { b + root };
    let c = dot(from_center, from_center) - radius * radius;
    let (t0, t1) = ((c / q) as f32, (q / a) as f32);
    // b >= 0: q/a is the far root; b < 0: the near one.
    let (near, far) = if b < 0.0 { (t1, t0) } else { (t0, t1) };
    let inside = |t: f32| ray.t_min < t && t < ray.t_max;
    if inside(near) {
        Some(near)
    } else if inside(far) {
        Some(far)
    } else {
        None
    }
}

fn dot(a: DVec3, b: DVec3) -> f64 {
    (a.x * b.x + a.y * b.y) + a.z * b.z
}
