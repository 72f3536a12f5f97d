//! Distance fields of simple solids and the ways to join them.
//!
//! Formulas after Inigo Quilez, "Distance functions" and "Smooth minimum", 2008-2023.

use glam::DVec3;

use super::profile::Profile;

/// The smaller of two distances, rounded over a band of width `k` where they are close: a fillet.
#[must_use]
pub fn smooth_min(a: f64, b: f64, k: f64) -> f64 {
    let h = (k - (a - b).abs()).max(0.0) / k;
    a.min(b) - h * h * k * 0.25
}

/// The larger of two distances, rounded: a rounded edge.
#[must_use]
pub fn smooth_max(a: f64, b: f64, k: f64) -> f64 {
    -smooth_min(-a, -b, k)
}

/// `a` without `b`, with edges rounded over `k`.
#[must_use]
pub fn carve(a: f64, b: f64, k: f64) -> f64 {
    smooth_max(a, -b, k)
}

/// A sphere.
#[must_use]
pub fn sphere(p: DVec3, center: DVec3, radius: f64) -> f64 {
    p.distance(center) - radius
}

/// An ellipsoid with half axes `r`, centred on the origin; near the surface close to the distance.
#[must_use]
pub fn ellipsoid(p: DVec3, r: DVec3) -> f64 {
    let k0 = (p / r).length();
    let k1 = (p / (r * r)).length();
    if k1 < 1e-9 { -r.min_element() } else { k0 * (k0 - 1.0) / k1 }
}

/// A capsule whose radius runs from `ra` at `a` to `rb` at `b`, as the distance to the nearest axis point less its radius.
#[must_use]
pub fn tapered(p: DVec3, a: DVec3, b: DVec3, ra: f64, rb: f64) -> f64 {
    let ab = b - a;
    let t = ((p - a).dot(ab) / ab.length_squared()).clamp(0.0, 1.0);
    p.distance(a + ab * t) - (ra + (rb - ra) * t)
}

/// A box with half sides `half`, centred on the origin.
#[must_use]
pub fn cuboid(p: DVec3, half: DVec3) -> f64 {
    let q = p.abs() - half;
    q.max(DVec3::ZERO).length() + q.max_element().min(0.0)
}

/// A profile turned about the y axis.
#[must_use]
pub fn turned(p: DVec3, profile: &Profile) -> f64 {
    profile.distance(glam::DVec2::new(libm::hypot(p.x, p.z), p.y))
}

/// 0 below `from`, 1 above `to`, smooth between (Hermite).
#[must_use]
pub fn smooth_step(from: f64, to: f64, x: f64) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}
