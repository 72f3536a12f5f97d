//! OBJ models: what is read, against what was written.

mod forms;
mod materials;
mod normals;
mod polygons;
mod round_trip;

use luch_io::budget::Budget;
use luch_io::{Error, Report, Result, obj};
use luch_scene::{Mesh, MeshData};
use std::path::Path;

/// Reads a model without libraries.
fn read(text: &str) -> Result<(MeshData, Report)> {
    read_with(text, &[])
}

/// Reads a model beside libraries of the given names.
fn read_with(text: &str, libraries: &[(&str, &str)]) -> Result<(MeshData, Report)> {
    let mut report = Report::default();
    let mut open = |name: &str, _: &mut Budget| {
        let found = libraries.iter().find(|(known, _)| *known == name);
        let missing = || Error::new(luch_io::ErrorKind::Forbidden, name, "no such file");
        found.map(|(_, text)| text.as_bytes().to_vec()).ok_or_else(missing)
    };
    let mut budget = Budget::new(1 << 30);
    let data = obj::read(text.as_bytes().to_vec(), Path::new("m.obj"), &mut open, &mut budget, &mut report)?;
    Ok((data, report))
}

/// Reads a model that must be right.
fn good(text: &str) -> (Mesh, Report) {
    let (data, report) = read(text).unwrap_or_else(|e| panic!("{e}"));
    (Mesh::new(data).expect("the reader checks what the mesh checks"), report)
}

/// The error of a model.
fn bad(text: &str) -> String {
    read(text).map(|_| ()).expect_err("must not be read").to_string()
}

const CUBE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\n";
const CUBE_FACES: &str = "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";
