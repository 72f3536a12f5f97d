//! The pawn: a ball on a slender stem.

use super::lathe::turn;
use super::mesh::Mesh;
use super::mouldings::{base, base_top, collar, stem};

/// Radius of the base, millimetres.
const RADIUS: f64 = 15.5;

/// Makes the pawn, 49 mm high.
#[must_use]
pub fn build() -> Mesh {
    let path = stem(base(RADIUS), base_top(RADIUS), (4.0, 25.0), (4.6, 28.6));
    let path = collar(path, 4.4, 28.6, 8.9, 0.72).arc(4.4, 35.0, -0.25).ball(41.4);
    turn(&path).mesh
}
