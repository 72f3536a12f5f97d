//! The bishop: a mitre with a slanting cut and a finial.

use glam::DVec3;

use super::contour::Grid;
use super::head::attach;
use super::lathe::turn;
use super::mesh::Mesh;
use super::mouldings::{base, base_top, collar};
use super::profile::Profile;
use super::sdf::{carve, smooth_max, turned};
use super::simplify::Budget;

/// Radius of the base, millimetres.
const RADIUS: f64 = 17.5;

/// The stem up to the foot of the mitre.
fn stem() -> Profile {
    let (r, y) = base_top(RADIUS);
    let path = base(RADIUS).curve((r - 4.8, y + 2.0), (5.8, y + 9.0), (5.1, 32.0)).curve(
        (4.8, 37.0),
        (4.9, 41.0),
        (5.6, 44.6),
    );
    collar(path, 5.4, 44.6, 9.8, 0.86).line(5.4, 51.2)
}

/// Makes the bishop, 74 mm high.
#[must_use]
pub fn build() -> Mesh {
    let outline = Profile::from(5.4, 50.4)
        .line(5.4, 51.4)
        .curve((7.4, 52.6), (8.4, 55.2), (8.2, 57.8))
        .curve((7.9, 62.0), (4.2, 66.0), (1.9, 69.0))
        .line(1.6, 69.6)
        .ball(71.6);
    let (sin, cos) = libm::sincos(0.72);
    let slot = |p: DVec3| {
        let q = p - DVec3::new(1.6, 60.6, 0.0);
        let (across, along) = (q.x * cos - q.y * sin, q.x * sin + q.y * cos);
        smooth_max(across.abs() - 0.85, -1.4 - along, 0.6)
    };
    let field = |p: DVec3| carve(turned(p, &outline), slot(p), 0.4);
    let grid = Grid { min: DVec3::new(-10.0, 51.5, -10.0), max: DVec3::new(10.0, 75.0, 10.0), cell: 0.15 };
    attach(turn(&stem()), &field, &grid, Budget { triangles: 12000, error: 0.02 })
}
