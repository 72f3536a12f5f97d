//! The rook: a tower with a hollow, crenellated top.

use glam::DVec3;

use super::contour::Grid;
use super::head::attach;
use super::lathe::turn;
use super::mesh::Mesh;
use super::mouldings::{base, base_top};
use super::profile::Profile;
use super::sdf::{carve, smooth_max, turned};
use super::simplify::Budget;

/// Radius of the base, millimetres.
const RADIUS: f64 = 17.5;

/// The tower up to just below the battlements.
fn tower() -> Profile {
    let (r, y) = base_top(RADIUS);
    base(RADIUS)
        .curve((r - 3.0, y + 2.2), (8.6, y + 10.0), (8.0, 34.0))
        .line(8.9, 34.2)
        .arc(8.8, 36.2, 0.65)
        .line(8.2, 36.4)
        .curve((8.4, 39.5), (9.6, 41.5), (11.8, 42.6))
        .line(12.4, 42.8)
        .arc(12.4, 44.6, 0.55)
        .line(11.7, 44.8)
        .line(11.8, 46.0)
}

/// Makes the rook, 57 mm high.
#[must_use]
pub fn build() -> Mesh {
    let outline = Profile::from(11.7, 45.0).line(11.8, 46.0).line(12.3, 57.0).line(8.9, 57.0).line(8.7, 50.6).curve(
        (6.0, 49.6),
        (3.0, 49.3),
        (0.0, 49.3),
    );
    let slots = |p: DVec3| {
        let mut d = f64::INFINITY;
        for i in 0..3 {
            let (sin, cos) = libm::sincos((f64::from(i) + 0.5) * std::f64::consts::PI / 3.0);
            d = d.min(smooth_max((p.x * sin - p.z * cos).abs() - 1.75, 52.6 - p.y, 0.5));
        }
        d
    };
    let field = |p: DVec3| carve(turned(p, &outline), slots(p), 0.5);
    let grid = Grid { min: DVec3::new(-13.5, 46.2, -13.5), max: DVec3::new(13.5, 58.0, 13.5), cell: 0.16 };
    attach(turn(&tower()), &field, &grid, Budget { triangles: 12000, error: 0.02 }, 35.0)
}
