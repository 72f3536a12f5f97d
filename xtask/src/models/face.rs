//! The horse's head: bones, eye, nostril, mouth. Coordinates of the head's frame: x along the nose from the poll, y towards
//! the forehead, z aside (never negative: both sides are mirror images), millimetres.

use glam::{DVec2, DVec3};

use super::loft::{Loft, section};
use super::sdf::{carve, ellipsoid, smooth_max, smooth_min, smooth_step, tapered};

/// Where the eye sits, seen from the side.
const EYE: DVec2 = DVec2::new(6.9, 2.5);

/// The head.
pub struct Face {
    bare: Loft,
    /// A point of the skin where the nostril opens.
    nostril: DVec3,
}

impl Default for Face {
    fn default() -> Self {
        Self::new()
    }
}

impl Face {
    /// Sets up the head.
    #[must_use]
    pub fn new() -> Self {
        // From the poll to the muzzle: along, above, depth, width, lean (wider above).
        let bare = Loft::new(&[
            section(0.0, 0.0, 5.8, 4.5, 0.0),
            section(4.1, -0.1, 7.3, 4.9, 0.1),
            section(8.3, -0.05, 6.4, 4.3, 0.12),
            section(12.5, 0.0, 5.0, 3.3, 0.1),
            section(15.9, 0.3, 3.9, 2.9, 0.0),
            section(18.0, 0.6, 3.1, 2.7, 0.0),
        ]);
        let mut face = Self { bare, nostril: DVec3::ZERO };
        let open = DVec3::new(0.62, 0.12, 0.775);
        face.nostril = face.reach(DVec3::new(18.0, 0.9, 0.5), open);
        face
    }

    /// The head's surface on the ray from an inner point, by bisection.
    fn reach(&self, from: DVec3, direction: DVec3) -> DVec3 {
        let (mut low, mut high) = (0.0, 10.0);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if self.bones(from + direction * middle) < 0.0 { low = middle } else { high = middle }
        }
        from + direction * low
    }

    /// The field at a point of the head's frame.
    #[must_use]
    pub fn at(&self, h: DVec3) -> f64 {
        let skin = self.bones(h);
        self.mouth(h, self.nostril(h, self.eye(h, skin)))
    }

    /// The head without openings.
    fn bones(&self, h: DVec3) -> f64 {
        let mut d = self.bare.at(h);
        // The cheek: a disc that stands out from head and neck.
        d = smooth_min(d, ellipsoid(h - DVec3::new(4.4, -2.7, 2.6), DVec3::new(5.7, 5.5, 3.3)), 0.9);
        // The temple, which fills the corner below the ear.
        d = smooth_min(d, ellipsoid(h - DVec3::new(-0.2, 1.2, 2.3), DVec3::new(3.8, 4.6, 3.1)), 1.5);
        // The bones: brow over the eye, cheek bone from the eye towards the muzzle.
        d = smooth_min(d, tapered(h, DVec3::new(4.4, 4.9, 2.9), DVec3::new(8.6, 4.0, 3.5), 1.2, 0.9), 1.4);
        d = smooth_min(d, tapered(h, DVec3::new(8.0, 0.2, 3.9), DVec3::new(13.6, -0.2, 2.6), 0.8, 0.5), 1.4);
        // The muzzle: wings of the nose, upper lip, chin.
        d = smooth_min(d, ellipsoid(h - DVec3::new(18.0, 1.1, 1.9), DVec3::new(2.7, 2.0, 1.8)), 0.9);
        d = smooth_min(d, ellipsoid(h - DVec3::new(19.0, -0.4, 0.0), DVec3::new(2.4, 2.0, 2.6)), 1.2);
        smooth_min(d, ellipsoid(h - DVec3::new(16.5, -3.2, 0.0), DVec3::new(3.2, 1.9, 2.2)), 0.9)
    }

    /// An almond with lids around an eyeball.
    fn eye(&self, h: DVec3, skin: f64) -> f64 {
        if h.truncate().distance_squared(EYE) > 16.0 || h.z < 1.0 {
            return skin;
        }
        let (sin, cos) = libm::sincos(0.12);
        let e = h.truncate() - EYE;
        let e = DVec2::new(e.x * cos + e.y * sin, e.y * cos - e.x * sin);
        // The meet of two circles, 4.6 long and 2.7 wide.
        let almond = libm::hypot(e.x, libm::hypot(e.y, 0.15) + 1.28) - 2.63;
        let lids =
            0.16 * bump((almond - 0.3) / 0.34) + 0.36 * bump((almond - 0.5) / 0.55) * smooth_step(-0.2, 1.0, e.y);
        let ball = 1.1 * bump(libm::hypot(e.x / 1.9, e.y / 1.3)) - 0.48;
        skin - lids - ball * smooth_step(0.05, -0.25, almond)
    }

    /// A hole with a raised rim, like a comma.
    fn nostril(&self, h: DVec3, d: f64) -> f64 {
        let p = self.nostril;
        let tail = p + DVec3::new(-1.6, 1.1, 0.35);
        let hole = tapered(h, p + DVec3::new(0.3, -0.3, 0.0), tail, 0.78, 0.25);
        let inside = smooth_max(hole, -(d + 1.7), 0.3);
        carve(d - 0.2 * bump((hole - 0.4) / 0.6), inside, 0.5)
    }

    /// The line of the lips, from the front of the muzzle to its corner.
    #[allow(clippy::unused_self, reason = "reads as the other features do")]
    fn mouth(&self, h: DVec3, d: f64) -> f64 {
        let line = -2.3 + 0.035 * (h.x - 17.5) * (h.x - 17.5);
        let here = smooth_step(12.6, 14.4, h.x);
        d + 0.6 * here * bump((h.y - line) / 0.38) - 0.15 * here * bump((h.y - line - 0.9) / 0.5)
    }
}

/// A bell: 1 at 0, nearly 0 beyond 2.
fn bump(x: f64) -> f64 {
    libm::exp(-x * x)
}
