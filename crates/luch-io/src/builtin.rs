//! The scenes inside the program, and what a person may mean by the name of a scene.

use crate::error::{Error, ErrorKind, Result};
use crate::report::Report;
use crate::scene_file::{LoadMesh, nearest, parse_scene};
use luch_scene::Scene;
use std::path::{Path, PathBuf};

/// The built-in scenes, the first of them shown at start: id and scene file.
const SCENES: [(&str, &str); 4] = [
    ("two-spheres", include_str!("../../../assets/scenes/two-spheres.toml")),
    ("one-sphere", include_str!("../../../assets/scenes/one-sphere.toml")),
    ("knight", include_str!("../../../assets/scenes/knight.toml")),
    ("chess", include_str!("../../../assets/scenes/chess.toml")),
];

/// What a scene is read from.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SceneSource {
    /// A scene inside the program, by its id.
    BuiltIn(&'static str),
    /// A scene file.
    File(PathBuf),
    /// A bare model, to be stood on a floor and lit.
    Model(PathBuf),
}

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
    let text = text(id).ok_or_else(|| unknown(Path::new(id)))?;
    parse_scene(text.as_bytes(), Path::new(&format!("{id}.toml")), load_mesh, report)
}

impl SceneSource {
    /// What a person means by a word: a built-in scene's id, or the path of a scene file (`.toml`) or model (`.obj`).
    ///
    /// An id wins over a file of the same name; `./chess` is never an id.
    ///
    /// # Errors
    /// `Forbidden` if there is no such file, with the built-in scene that may be meant; `Malformed` for a file of
    /// another kind.
    pub fn find(word: &Path) -> Result<Self> {
        if let Some(id) = word.to_str().and_then(|w| ids().find(|id| *id == w)) {
            return Ok(Self::BuiltIn(id));
        }
        if !word.exists() {
            return Err(unknown(word));
        }
        let extension = word.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        match extension.as_str() {
            "toml" => Ok(Self::File(word.to_owned())),
            "obj" => Ok(Self::Model(word.to_owned())),
            _ if word.is_dir() => Err(Error::new(ErrorKind::Forbidden, word, "is a folder, not a scene")),
            _ => Err(Error::new(ErrorKind::Malformed, word, "is neither a scene file (.toml) nor a model (.obj)")
                .hint(format!("the built-in scenes are: {}", list()))),
        }
    }
}

fn list() -> String {
    ids().collect::<Vec<_>>().join(", ")
}

/// There is no scene of that name.
fn unknown(word: &Path) -> Error {
    // `chess.toml` and `scenes/ches` mean the built-in scene as likely as `ches` does.
    let stem = word.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let error = Error::new(ErrorKind::Forbidden, word, "there is no such scene or file");
    match nearest(&stem, ids()) {
        Some(id) => error.hint(format!("did you mean the built-in scene `{id}`? The built-in scenes are: {}", list())),
        None => error.hint(format!("the built-in scenes are: {}", list())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_word_is_an_id_first_and_a_path_second() {
        assert_eq!(SceneSource::find(Path::new("chess")).unwrap(), SceneSource::BuiltIn("chess"));
        assert!(SceneSource::find(Path::new("./chess")).is_err());
        let error = SceneSource::find(Path::new("ches")).unwrap_err();
        assert_eq!(error.exit_code(), 4);
        assert_eq!(
            error.to_string(),
            "ches: there is no such scene or file\nhint: did you mean the built-in scene `chess`? \
             The built-in scenes are: two-spheres, one-sphere, knight, chess"
        );
        let error = SceneSource::find(Path::new("nowhere/castle.toml")).unwrap_err();
        assert!(error.hint.unwrap().starts_with("the built-in scenes are: two-spheres"));
        assert!(SceneSource::find(Path::new("Cargo.toml")).is_ok(), "the tests run in the crate's folder");
        assert_eq!(SceneSource::find(Path::new("src/lib.rs")).unwrap_err().exit_code(), 3);
        assert_eq!(SceneSource::find(Path::new("src")).unwrap_err().exit_code(), 4);
    }
}
