//! The queen: a flared cup whose rim is scooped into a coronet, with a ball.

use glam::DVec3;

use super::contour::Grid;
use super::head::attach;
use super::lathe::turn;
use super::mesh::Mesh;
use super::mouldings::{base, base_top, collar, stem};
use super::profile::Profile;
use super::sdf::{carve, turned};
use super::simplify::Budget;

/// Radius of the base, millimetres.
const RADIUS: f64 = 19.2;
/// Number of points of the coronet.
const POINTS: f64 = 9.0;

/// Radius and height of the foot of the cup, millimetres.
const FOOT: (f64, f64) = (5.8, 57.935);
/// The cup's outline from there to the rim.
const CUP: [(f64, f64); 3] = [(5.8, 64.8), (8.9, 70.5), (11.6, 77.0)];

/// The stem and the cup up to just below the coronet.
fn cup() -> Profile {
    let path = stem(base(RADIUS), base_top(RADIUS), (5.1, 41.0), (6.0, 51.0));
    collar(path, FOOT.0, 51.0, 11.0, 0.95).curve_until(0.68, CUP[0], CUP[1], CUP[2])
}

/// Makes the queen, 85 mm high.
#[must_use]
pub fn build() -> Mesh {
    let outline = Profile::from(FOOT.0, FOOT.1)
        .curve(CUP[0], CUP[1], CUP[2])
        .line(9.4, 77.2)
        .curve((9.0, 75.6), (8.6, 75.1), (7.6, 75.3))
        .curve((5.6, 75.9), (3.0, 76.9), (2.2, 78.5))
        .curve((2.0, 78.9), (1.98, 79.4), (2.2, 79.62))
        .ball(81.8);
    let scoop = |p: DVec3| {
        let turn = libm::atan2(p.z, p.x) / std::f64::consts::TAU;
        let angle = (turn * POINTS - libm::round(turn * POINTS)) / POINTS * std::f64::consts::TAU;
        let r = libm::hypot(p.x, p.z);
        let (sin, cos) = libm::sincos(angle);
        let q = DVec3::new(r * cos - 11.0, p.y - 78.6, r * sin);
        // A ball cutter that enters from outside and leaves a little lower inside.
        let along = q.x.clamp(-2.5, 2.5);
        (q - DVec3::X * along).length() - 3.6
    };
    let field = |p: DVec3| carve(turned(p, &outline), scoop(p), 0.35);
    let grid = Grid { min: DVec3::new(-13.0, 72.2, -13.0), max: DVec3::new(13.0, 86.0, 13.0), cell: 0.15 };
    attach(turn(&cup()), &field, &grid, Budget { triangles: 12000, error: 0.02 }, 35.0)
}
