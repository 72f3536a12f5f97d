//! The chess set, generated: each piece is a closed triangle mesh made of a turned body and a carved head.
//!
//! Lengths inside the generator are millimetres of a tournament set (king 95 mm high, squares of 57 mm); the files are in
//! board squares, see [`SQUARE`]. All arithmetic is f64 with `libm`, single-threaded, in a fixed order: the same bytes on
//! every machine.

pub mod bishop;
pub mod contour;
pub mod face;
pub mod field;
pub mod head;
pub mod horse;
pub mod king;
pub mod knight;
pub mod lathe;
pub mod loft;
pub mod mane;
pub mod mesh;
pub mod mouldings;
pub mod obj;
pub mod pawn;
pub mod profile;
pub mod queen;
pub mod rook;
pub mod sdf;
pub mod simplify;
pub mod zip;

use mesh::Mesh;

/// The side of a board square in millimetres: one unit of the OBJ files.
pub const SQUARE: f64 = 57.0;

/// The six kinds of chess pieces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Piece {
    /// 95 mm, with a cross pattée.
    King,
    /// With a coronet and a ball.
    Queen,
    /// With a crenellated tower.
    Rook,
    /// With a mitre and its cut.
    Bishop,
    /// A horse's head; it faces +z.
    Knight,
    /// With a ball.
    Pawn,
}

impl Piece {
    /// Every kind, from the tallest rank down the back row to the pawn.
    pub const ALL: [Self; 6] = [Self::King, Self::Queen, Self::Rook, Self::Bishop, Self::Knight, Self::Pawn];

    /// The stem of the piece's file name.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::King => "king",
            Self::Queen => "queen",
            Self::Rook => "rook",
            Self::Bishop => "bishop",
            Self::Knight => "knight",
            Self::Pawn => "pawn",
        }
    }

    /// Makes the mesh, in millimetres: closed, outward, the centre of the bottom face at the origin, +y up.
    #[must_use]
    pub fn build(self) -> Mesh {
        match self {
            Self::King => king::build(),
            Self::Queen => queen::build(),
            Self::Rook => rook::build(),
            Self::Bishop => bishop::build(),
            Self::Knight => knight::build(),
            Self::Pawn => pawn::build(),
        }
    }
}
