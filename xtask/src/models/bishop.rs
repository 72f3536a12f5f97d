//! The bishop: a mitre with a slanting cut and a finial.

use glam::DVec3;

use super::contour::Grid;
use super::head::attach;
use super::lathe::turn;
use super::mesh::Mesh;
use super::mouldings::{base, base_top, collar, stem};
use super::profile::Profile;
use super::sdf::{carve, smooth_max, turned};
use super::simplify::Budget;

/// Radius of the base, millimetres.
const RADIUS: f64 = 17.5;

/// The stem and the lower half of the mitre.
fn body() -> Profile {
    let path = stem(base(RADIUS), base_top(RADIUS), (4.5, 36.0), (5.2, 44.6));
    collar(path, 5.0, 44.6, 9.8, 0.86).line(5.2, 51.2).curve((7.4, 52.4), (8.4, 55.0), (8.2, 57.8))
}

/// Makes the bishop, 74 mm high.
#[must_use]
pub fn build() -> Mesh {
    let outline = Profile::from(5.2, 51.2)
        .curve((7.4, 52.4), (8.4, 55.0), (8.2, 57.8))
        .curve((7.9, 62.0), (4.0, 65.6), (1.8, 68.7))
        .curve((1.6, 69.0), (1.45, 69.6), (1.62, 69.86))
        .ball(71.5);
    let (sin, cos) = libm::sincos(0.72);
    let slot = |p: DVec3| {
        let q = p - DVec3::new(1.6, 60.6, 0.0);
        let (across, along) = (q.x * cos - q.y * sin, q.x * sin + q.y * cos);
        smooth_max(across.abs() - 0.85, -1.4 - along, 0.6)
    };
    let field = |p: DVec3| carve(turned(p, &outline), slot(p), 0.4);
    let grid = Grid { min: DVec3::new(-10.0, 58.1, -10.0), max: DVec3::new(10.0, 75.0, 10.0), cell: 0.15 };
    attach(turn(&body()), &field, &grid, Budget { triangles: 8000, error: 0.02 }, 35.0)
}
