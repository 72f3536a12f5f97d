//! Wavefront OBJ models and their MTL libraries, read by our own reader.
//!
//! What is read: `v`, `vn`, `f` (also the old `fo`), `s`, `usemtl`, `mtllib`; `vt` is counted, `o` and `g` are passed
//! over. Polygons become triangles ([`triangulate`]), missing normals are computed ([`normals`]). Lines, points,
//! curves and surfaces are skipped, unknown statements too; each is told in the report. Nothing is ever run or fetched.
//!
//! Where the format is silent or files in the wild differ, this is what holds:
//! - **Corners** are `1`, `1/2`, `1//3` or `1/2/3`; an empty slot (`1/`, `1//`) is an absent index. A face may mix the
//!   forms: where a corner lacks its normal, the whole face's normals are computed.
//! - **Indices** below zero count from what was read so far, the face's own line included. Indices above zero may name
//!   vertices that come later in the file. A vertex or normal that never comes is an error; a texture coordinate that
//!   never comes is a warning, since nothing here uses it.
//! - **Faces** of one or two corners are skipped; a corner that repeats its neighbour is dropped. Both are counted.
//! - **Smoothing** as the format says where the file has an `s` statement: `s off` (or `0`, and before the first `s`) is
//!   faceted, `s 3` smooth within the group. A file without any `s` is smooth but for edges sharper than 40 degrees.
//! - **Names** run to the end of the line, blanks and `#` included; where no such material exists, ` #` begins a comment.
//! - **Text** is bytes: UTF-8 with or without a byte order mark, or any encoding that has ASCII in it. Lines end with LF,
//!   CR LF or CR, mixed at will; a backslash before the break joins lines.

mod corner;
mod cursor;
mod facing;
mod fans;
mod materials;
pub mod mtl;
pub mod normals;
mod number;
mod place;
mod reader;
mod text;
mod triangles;
pub mod triangulate;
mod weld;

use self::reader::Parsed;
use crate::budget::{Budget, OverBudget};
use crate::error::Result;
use crate::report::Report;
use luch_scene::MeshData;
use std::path::Path;

/// The most corners that a polygon may have.
pub const MAX_CORNERS: usize = 100_000;
/// The longest statement, continuation lines included, in bytes: 16 MiB.
pub const MAX_LINE: usize = 16 << 20;

/// Opens a material library by the name that the model writes.
pub type OpenLibrary<'a> = dyn FnMut(&str, &mut Budget) -> Result<Vec<u8>> + 'a;

/// Reads a model.
///
/// `bytes` is the whole file; its capacity was charged to `budget` and is given back when it is no longer needed, before
/// normals are computed. `file` is for messages. `open_library` opens what `mtllib` names; a library that cannot be
/// opened or understood is a warning, never an error.
///
/// The lists of the answer stay charged to the budget: [`Budget::release`] their size when the mesh is dropped.
///
/// # Errors
/// [`ErrorKind::Malformed`](crate::ErrorKind::Malformed) with line and column for text that is no model; [`Limit`](crate::ErrorKind::Limit) beyond the budget,
/// [`MAX_CORNERS`] or [`MAX_LINE`]; [`Cancelled`](crate::ErrorKind::Cancelled) within about a megabyte of the user's wish to stop.
pub fn read(
    bytes: Vec<u8>,
    file: &Path,
    open_library: &mut OpenLibrary<'_>,
    budget: &mut Budget,
    report: &mut Report,
) -> Result<MeshData> {
    let text = text::checked(&bytes, file)?;
    let Parsed { positions, mut normals, mut triangles, materials } = reader::parse(text, file, budget, report)?;
    let mut looks = materials::resolve(&materials, text, file, open_library, budget, report)?;
    drop(materials);
    budget.release_list(&bytes, bytes.capacity());
    drop(bytes);
    let over = |over: OverBudget| over.in_file(file);
    let triangle_materials = looks.of_triangles(&triangles, budget).map_err(over)?;
    normals::complete(&positions, &mut triangles, &mut normals, budget).map_err(over)?;
    let (triangles, normal_triangles) = triangles.into_lists();
    let materials = looks.list;
    budget.check_cancelled(file)?;
    Ok(MeshData { positions, normals, triangles, normal_triangles, materials, triangle_materials })
}
