//! Scene files, format 1: TOML with a place for every error. The format itself is described in `docs/scene-file.md`.
//!
//! `text` (bytes to text) -> `sections` (one header at a time) -> `fields` (typed access) -> `raw` and `objects` (what
//! the file says) -> `parse` (meshes, names, cameras) -> [`luch_scene::Scene`] -> `write` (text again).

mod fields;
mod framing;
mod objects;
mod parse;
mod raw;
mod sections;
mod suggest;
mod syntax;
mod text;
mod write;

pub use framing::three_cameras;
pub use parse::{LoadMesh, parse_scene, read_scene};
pub use suggest::nearest;
pub use write::write_scene;
