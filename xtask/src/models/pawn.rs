//! The pawn: a ball on a slender stem.

use super::lathe::turn;
use super::mesh::Mesh;
use super::mouldings::{base, base_top, collar};

/// Radius of the base, millimetres.
const RADIUS: f64 = 15.5;

/// Makes the pawn, 49 mm high.
#[must_use]
pub fn build() -> Mesh {
    let (r, y) = base_top(RADIUS);
    let path = base(RADIUS).curve((r - 4.2, y + 1.6), (4.9, y + 6.5), (4.4, 24.0)).curve(
        (4.2, 26.0),
        (4.3, 27.4),
        (4.7, 28.6),
    );
    let path = collar(path, 4.6, 28.6, 8.9, 0.72).arc(4.4, 35.0, -0.25).ball(41.4);
    turn(&path).mesh
}
