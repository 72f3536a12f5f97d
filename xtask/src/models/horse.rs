//! The horse's neck and head as a field.
//!
//! Coordinates: x forward, y up, z aside, millimetres; both sides are mirror images. The head has a frame of its own, see
//! `in_head`; its features are in `face`.

use glam::{DVec2, DVec3};

use super::face::Face;
use super::loft::{Loft, section};
use super::mane;
use super::sdf::{ellipsoid, smooth_min};

/// The whole animal is shifted back by this much, so that the muzzle stays over the base.
const SHIFT: f64 = 1.7;
/// The poll (the joint of head and neck).
const POLL: DVec2 = DVec2::new(0.5, 54.8);
/// The direction from the poll to the muzzle.
const NOSE: DVec2 = DVec2::new(0.811, -0.585);

/// Below this height (less a margin) there is only the neck.
const JAW: f64 = 38.0;
/// The head is drawn a little smaller than it is.
const HEAD: f64 = 1.06;

/// The sculpture.
pub struct Horse {
    neck: Loft,
    face: Face,
}

impl Default for Horse {
    fn default() -> Self {
        Self::new()
    }
}

impl Horse {
    /// Sets up the limbs.
    #[must_use]
    pub fn new() -> Self {
        // From the chest up along the neck to the poll: forward, up, depth, width, lean.
        let neck = Loft::new(&[
            section(0.6, 10.0, 10.2, 8.9, 0.0),
            section(0.9, 18.0, 10.2, 8.5, 0.0),
            section(-0.4, 25.5, 10.5, 7.9, -0.05),
            section(-2.4, 32.5, 9.3, 6.9, -0.1),
            section(-4.2, 39.5, 8.0, 6.1, -0.15),
            section(-4.3, 47.0, 7.4, 5.5, -0.15),
            section(-1.8, 53.5, 6.4, 4.8, -0.1),
            section(1.6, 57.0, 4.4, 4.0, 0.0),
        ]);
        Self { neck, face: Face::new() }
    }

    /// The field at (forward, up, aside).
    #[must_use]
    pub fn at(&self, p: DVec3) -> f64 {
        let p = p + DVec3::X * SHIFT;
        // Soft |z|: features of both sides meet without a ridge.
        let q = DVec3::new(p.x, p.y, libm::sqrt(p.z * p.z + 0.2));
        let near = self.neck.nearest(p.truncate());
        let extent = self.neck.extent(near.t);
        let neck = self.neck.at_nearest(&near, p.z);
        let chest = ellipsoid(q - DVec3::new(6.0, 22.5, 3.2), DVec3::new(4.6, 6.5, 4.0));
        let neck = mane::over(smooth_min(neck, chest, 2.5), &near, extent, q.z);
        if q.y < JAW - 5.0 {
            return neck;
        }
        let h = in_head(q) / HEAD;
        let d = smooth_min(neck, mane::forelock(h, self.face.at(h)) * HEAD, 0.6);
        ears(q, d)
    }
}

/// The point in the head's frame: x along the nose from the poll, y towards the forehead, z aside.
fn in_head(q: DVec3) -> DVec3 {
    let offset = q.truncate() - POLL;
    DVec3::new(offset.dot(NOSE), NOSE.perp_dot(offset), q.z)
}

/// Adds the ears: leaves that stand on the poll, hollow towards the front.
fn ears(q: DVec3, d: f64) -> f64 {
    let root = DVec3::new(-0.6, 57.6, 2.5);
    let along = DVec3::new(0.14, 0.98, 0.14);
    let front = DVec3::new(0.85, -0.2, 0.48);
    let across = along.cross(front);
    let e = q - root;
    let (s, w, c) = (e.dot(along), e.dot(across), e.dot(front));
    let c = c - 0.012 * s * s;
    // The outline is the meet of two circles: pointed at the tip.
    let outline = libm::hypot(s - 4.2, w.abs() + 8.3) - 10.7;
    let thickness = libm::hypot(c, 0.25 * w) - 1.5 + 0.07 * s.max(0.0);
    let leaf = super::sdf::smooth_max(outline, thickness, 1.0);
    let hollow = ellipsoid(DVec3::new(s - 5.0, w, c - 1.35), DVec3::new(4.4, 1.45, 1.5));
    let leaf = smooth_min(leaf, e.length() - 1.9, 1.0);
    smooth_min(d, super::sdf::carve(leaf, hollow, 0.35), 0.9)
}
