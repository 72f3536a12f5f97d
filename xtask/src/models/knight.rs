//! The knight: a horse's head and neck on a turned stand.

use glam::DVec3;

use super::contour::Grid;
use super::head::attach;
use super::horse::Horse;
use super::lathe::turn;
use super::mesh::Mesh;
use super::mouldings::{base, base_top};
use super::profile::Profile;
use super::sdf::{smooth_max, smooth_min, turned};
use super::simplify::Budget;

/// Radius of the base, millimetres.
const RADIUS: f64 = 17.5;
/// Where the turned stand ends and the sculpture begins, millimetres.
const RIM: f64 = 15.7;

/// The stand up to the rim, on the side of the collar that carries the horse.
fn stand() -> Profile {
    let (r, y) = base_top(RADIUS);
    base(RADIUS).curve((r - 1.6, y + 0.9), (10.0, y + 1.8), (10.0, 14.1)).line(11.3, 14.5).arc(12.15, RIM, 0.32)
}

/// Makes the knight, 68 mm high.
#[must_use]
pub fn build() -> Mesh {
    let horse = Horse::new();
    let top = Profile::from(11.3, 14.5).arc(12.15, RIM, 0.32).arc(11.35, 17.0, 0.283).curve(
        (9.0, 17.2),
        (3.0, 17.4),
        (0.0, 17.4),
    );
    let field = |p: DVec3| {
        let animal = smooth_max(horse.at(DVec3::new(p.z, p.y, p.x)), 15.0 - p.y, 0.1);
        smooth_min(turned(p, &top), animal, 1.4)
    };
    let grid = Grid { min: DVec3::new(-13.0, RIM + 0.25, -16.0), max: DVec3::new(13.0, 72.0, 20.0), cell: 0.2 };
    attach(turn(&stand()), &field, &grid, Budget { triangles: 49000, error: 0.02 }, 65.0)
}
