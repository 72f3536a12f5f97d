//! The queen: a flared cup whose rim is scooped into a coronet, with a ball.

use glam::DVec3;

use super::contour::Grid;
use super::head::attach;
use super::lathe::turn;
use super::mesh::Mesh;
use super::mouldings::{base, base_top, collar};
use super::profile::Profile;
use super::sdf::{carve, turned};
use super::simplify::Budget;

/// Radius of the base, millimetres.
const RADIUS: f64 = 19.2;
/// Number of points of the coronet.
const POINTS: f64 = 9.0;

/// The stem and the cup up to just below the coronet.
fn cup() -> Profile {
    let (r, y) = base_top(RADIUS);
    let path = base(RADIUS).curve((r - 5.2, y + 2.2), (6.7, y + 10.0), (5.9, 36.0)).curve(
        (5.5, 42.0),
        (5.6, 46.5),
        (6.4, 51.0),
    );
    collar(path, 6.3, 51.0, 11.0, 0.95).curve((6.2, 63.0), (8.4, 67.5), (9.3, 71.5))
}

/// Makes the queen, 85 mm high.
#[must_use]
pub fn build() -> Mesh {
    let outline = Profile::from(9.2, 70.5)
        .line(9.3, 71.5)
        .curve((9.8, 73.4), (10.6, 75.2), (11.7, 77.0))
        .line(9.4, 77.2)
        .curve((9.0, 75.6), (8.6, 75.1), (7.6, 75.3))
        .curve((5.6, 75.9), (3.4, 76.6), (2.3, 78.8))
        .line(2.3, 79.2)
        .ball(81.8);
    let scoop = |p: DVec3| {
        let turn = libm::atan2(p.z, p.x) / std::f64::consts::TAU;
        let angle = (turn * POINTS - libm::round(turn * POINTS)) / POINTS * std::f64::consts::TAU;
        let r = libm::hypot(p.x, p.z);
        let (sin, cos) = libm::sincos(angle);
        let q = DVec3::new(r * cos - 11.0, p.y - 78.3, r * sin);
        // A ball cutter that enters from outside and leaves a little lower inside.
        let along = q.x.clamp(-2.5, 2.5);
        (q - DVec3::X * along).length() - 3.0
    };
    let field = |p: DVec3| carve(turned(p, &outline), scoop(p), 0.35);
    let grid = Grid { min: DVec3::new(-13.0, 71.7, -13.0), max: DVec3::new(13.0, 86.0, 13.0), cell: 0.15 };
    attach(turn(&cup()), &field, &grid, Budget { triangles: 12000, error: 0.02 })
}
