//! The king: a flared crown with a dome and a cross pattée.

use glam::DVec3;

use super::contour::Grid;
use super::head::attach;
use super::lathe::turn;
use super::mesh::Mesh;
use super::mouldings::{base, base_top, collar, stem};
use super::profile::Profile;
use super::sdf::{smooth_max, smooth_min, turned};
use super::simplify::Budget;

/// Radius of the base, millimetres.
const RADIUS: f64 = 20.5;
/// Height of the middle of the cross, millimetres.
const CROSS: f64 = 90.4;
/// Length of an arm of the cross.
const ARM: f64 = 4.6;

/// The stem and the crown, up to the collar under the cross.
fn crown() -> Profile {
    let path = stem(base(RADIUS), base_top(RADIUS), (5.5, 46.0), (6.4, 57.0));
    collar(path, 6.2, 57.0, 11.8, 1.0)
        .curve((6.2, 70.0), (9.2, 75.0), (10.7, 79.0))
        .line(11.2, 79.2)
        .arc(11.0, 80.9, 0.6)
        .line(10.2, 81.1)
        .curve((8.4, 82.6), (4.6, 82.8), (2.8, 84.6))
}

/// Makes the king, 95 mm high.
#[must_use]
pub fn build() -> Mesh {
    let neck = Profile::from(2.8, 84.2).line(2.8, 84.6).arc(2.5, 86.2, 0.55).line(0.0, 86.9);
    let field = |p: DVec3| smooth_min(turned(p, &neck), cross(p - DVec3::Y * CROSS), 0.5);
    let grid = Grid { min: DVec3::new(-7.0, 85.0, -7.0), max: DVec3::new(7.0, 97.0, 7.0), cell: 0.11 };
    attach(turn(&crown()), &field, &grid, Budget { triangles: 6000, error: 0.02 }, 35.0)
}

/// A cross pattée in the xy plane: four arms that widen outwards with hollow sides, edges rounded.
fn cross(p: DVec3) -> f64 {
    let arm = |along: f64, across: f64| {
        let s = along.abs() / ARM;
        let width = 0.95 + 1.35 * s * s;
        smooth_max((across.abs() - width) * 0.82, along.abs() - ARM, 0.4)
    };
    let flat = smooth_min(arm(p.x, p.y), arm(p.y, p.x), 0.4);
    smooth_max(flat, p.z.abs() - 1.35, 0.5)
}
