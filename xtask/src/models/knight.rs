//! The knight: a horse's head and neck on a turned base, sculpted as a distance field.
//!
//! Coordinates of the sculpture: x forward, y up, z aside (the two sides are mirror images). The piece faces +z in the file.

use glam::{DVec2, DVec3};

use super::contour::Grid;
use super::head::attach;
use super::lathe::turn;
use super::loft::{Loft, section};
use super::mesh::Mesh;
use super::mouldings::{base, base_top};
use super::profile::Profile;
use super::sdf::{carve, ellipsoid, smooth_max, smooth_min, tapered, turned};
use super::simplify::Budget;

/// Radius of the base, millimetres.
const RADIUS: f64 = 17.5;

fn stand() -> Profile {
    let (r, y) = base_top(RADIUS);
    base(RADIUS).curve((r - 1.0, y + 0.8), (11.4, y + 1.4), (11.4, y + 2.4)).line(12.3, 13.4).arc(12.3, 15.4, 0.5)
}

struct Horse {
    neck: Loft,
    head: Loft,
    locks: Vec<[DVec3; 4]>,
    stand: Profile,
}

/// Makes the knight, about 66 mm high.
#[must_use]
pub fn build() -> Mesh {
    let horse = Horse::new();
    let field = |p: DVec3| horse.at(DVec3::new(p.z, p.y, p.x));
    let grid = Grid { min: DVec3::new(-14.0, 14.2, -18.0), max: DVec3::new(14.0, 70.0, 22.0), cell: 0.22 };
    let mut path = stand();
    path.segments.pop();
    let _ = &mut path;
    attach(turn(&path_to_rim()), &field, &grid, Budget { triangles: 48000, error: 0.02 })
}

fn path_to_rim() -> Profile {
    let (r, y) = base_top(RADIUS);
    base(RADIUS).curve((r - 1.0, y + 0.8), (11.4, y + 1.4), (11.4, y + 2.4)).line(12.5, 13.3).line(12.7, 13.7)
}

impl Horse {
    fn new() -> Self {
        let neck = Loft::new(
            &[
                section(-0.6, 8.0, 12.2, 9.6, 0.0),
                section(-0.8, 16.0, 12.0, 9.2, 0.0),
                section(-1.2, 23.0, 11.4, 8.5, 0.0),
                section(-2.4, 30.0, 10.2, 7.4, 0.0),
                section(-3.4, 37.0, 9.2, 6.5, 0.0),
                section(-3.8, 44.0, 8.6, 5.8, 0.0),
                section(-2.6, 50.5, 7.2, 5.0, 0.0),
                section(0.2, 55.2, 5.0, 4.2, 0.0),
            ],
            2.2,
        );
        let head = Loft::new(
            &[
                section(-0.5, 55.0, 5.6, 4.4, 0.0),
                section(2.6, 52.0, 7.4, 5.2, 0.1),
                section(6.6, 48.4, 6.6, 4.7, 0.1),
                section(10.6, 44.8, 4.9, 3.6, 0.1),
                section(13.6, 42.2, 4.2, 3.4, 0.0),
                section(14.8, 41.2, 3.9, 3.3, 0.0),
            ],
            2.2,
        );
        let stand = Profile::from(12.5, 13.3).line(12.7, 13.7).arc(12.2, 15.6, 0.5).curve(
            (11.8, 15.8),
            (3.0, 16.2),
            (0.0, 16.2),
        );
        Self { neck, head, locks: Vec::new(), stand }
    }

    fn at(&self, p: DVec3) -> f64 {
        let z = libm::sqrt(p.z * p.z + 0.3);
        let q = DVec3::new(p.x, p.y, z);
        let mut d = smooth_min(self.neck.at(p), self.head.at(p), 1.2);
        // Jaw.
        d = smooth_min(d, ellipsoid(q - DVec3::new(3.4, 48.2, 2.8), DVec3::new(5.6, 5.8, 2.9)), 1.2);
        // Ears.
        let ear = smooth_max(tapered(q, DVec3::new(-0.5, 57.0, 2.4), DVec3::new(1.6, 66.0, 3.1), 2.4, 0.5), -10.0, 0.1);
        let hollow = tapered(q, DVec3::new(1.6, 58.5, 3.0), DVec3::new(2.8, 65.0, 3.6), 1.3, 0.3);
        d = smooth_min(d, carve(ear, hollow, 0.5), 1.0);
        // Eye.
        let socket = ellipsoid(q - DVec3::new(6.6, 51.6, 5.6), DVec3::new(2.0, 1.5, 1.4));
        d = carve(d, socket, 0.8);
        d = smooth_min(d, (q - DVec3::new(6.5, 51.6, 4.2)).length() - 1.15, 0.2);
        // Nostril and mouth.
        d = carve(d, ellipsoid(q - DVec3::new(16.2, 42.6, 2.9), DVec3::new(1.2, 0.8, 1.2)), 0.6);
        let mouth = tapered(q, DVec3::new(18.5, 39.8, 3.2), DVec3::new(11.5, 42.0, 4.2), 0.5, 0.3);
        d = carve(d, mouth, 0.4);
        for lock in &self.locks {
            d = smooth_min(d, tapered(q, lock[0], lock[1], 2.0, 0.5), 0.3);
        }
        let base = turned(DVec3::new(p.x, p.y, p.z), &self.stand);
        let neck_above = d;
        let _ = DVec2::ZERO;
        smooth_min(base, smooth_max(neck_above, 14.0 - p.y, 0.1), 1.6)
    }
}
