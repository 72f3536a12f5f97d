//! The scenes inside the program: the files of assets/scenes.

use crate::error::{Error, ErrorKind, Result};
use crate::report::Report;
use crate::scene_file::{LoadMesh, parse_scene};
use luch_scene::Scene;
use std::path::Path;

/// The built-in scenes, the first of them shown at start: id and scene file.
const SCENES: [(&str, &str); 4] = [
    ("two-spheres", include_str!("../../../assets/scenes/two-spheres.toml")),
    ("one-sphere", include_str!("../../../assets/scenes/one-sphere.toml")),
    ("knight", include_str!("../../../assets/scenes/knight.toml")),
    ("chess", include_str!("../../../assets/scenes/chess.toml")),
];

/// The ids of the built-in scenes, in the order in which they are shown.
pub fn ids() -> impl ExactSizeIterator<Item = &'static str> {
    SCENES.iter().map(|(id, _)| *id)
}

/// The scene file of a built-in scene.
#[must_use]
pub fn text(id: &str) -> Option<&'static str> {
    SCENES.iter().find(|(known, _)| *known == id).map(|(_, text)| *text)
}

/// Builds a built-in scene; `load_mesh` gets paths like `../models/knight.obj`.
///
/// # Errors
/// `Forbidden` for an id that is none of [`ids`]; what `load_mesh` answers.
pub fn load(id: &str, load_mesh: &mut LoadMesh<'_>, report: &mut Report) -> Result<Scene> {
    let text = text(id).ok_or_else(|| Error::new(ErrorKind::Forbidden, id, "there is no such built-in scene"))?;
    parse_scene(text.as_bytes(), Path::new(&format!("{id}.toml")), load_mesh, report)
}
