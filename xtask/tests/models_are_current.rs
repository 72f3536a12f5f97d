//! The committed models are what the generator makes, to the byte.

use std::path::Path;

use xtask::MODELS_DIR;
use xtask::models::{Piece, obj};

fn is_current(piece: Piece) {
    let path = Path::new(MODELS_DIR).join(format!("{}.obj", piece.name()));
    let committed = std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let made = obj::write(piece.name(), &piece.build());
    // Not assert_eq: megabytes of text would drown the message.
    let line = committed.lines().zip(made.lines()).position(|(a, b)| a != b);
    assert!(
        committed == made,
        "{} differs from what `cargo xtask models` makes, first in line {line:?}",
        path.display()
    );
}

#[test]
fn king_is_current() {
    is_current(Piece::King);
}

#[test]
fn queen_is_current() {
    is_current(Piece::Queen);
}

#[test]
fn rook_is_current() {
    is_current(Piece::Rook);
}

#[test]
fn bishop_is_current() {
    is_current(Piece::Bishop);
}

#[test]
fn knight_is_current() {
    is_current(Piece::Knight);
}

#[test]
fn pawn_is_current() {
    is_current(Piece::Pawn);
}
