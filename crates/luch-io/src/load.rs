//! Loads a scene by what a person calls it: a built-in scene, a scene file, or a bare model.

use crate::budget::{Budget, OverBudget};
use crate::builtin;
use crate::error::{Error, ErrorKind, Result};
use crate::library::MeshLibrary;
use crate::model_scene::scene_of_model;
use crate::report::Report;
use crate::resolve::{MAX_TEXT_BYTES, SceneFile, SceneFolder};
use crate::scene_file::{nearest, parse_scene};
use luch_scene::Scene;
use std::path::{Path, PathBuf};

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

impl SceneSource {
    /// What a person means by a word: a built-in scene's id, or the path of a scene file (`.toml`) or model (`.obj`).
    ///
    /// An id wins over a file of the same name; `./chess` is never an id.
    ///
    /// # Errors
    /// `Forbidden` if there is no such file, with the built-in scene that may be meant; `Malformed` for a file of
    /// another kind.
    pub fn find(word: &Path) -> Result<Self> {
        if let Some(id) = word.to_str().and_then(|w| builtin::ids().find(|id| *id == w)) {
            return Ok(Self::BuiltIn(id));
        }
        if !word.exists() {
            return Err(unknown(word));
        }
        if word.is_dir() {
            return Err(Error::new(ErrorKind::Forbidden, word, "is a folder, not a scene"));
        }
        Self::of_path(word).ok_or_else(|| neither(word).hint(format!("the built-in scenes are: {}", list())))
    }

    /// What a path names by its ending, `.toml` or `.obj`, in capital or small letters. The disk is not looked at.
    #[must_use]
    pub fn of_path(path: &Path) -> Option<Self> {
        match path.extension()?.to_string_lossy().to_lowercase().as_str() {
            "toml" => Some(Self::File(path.to_owned())),
            "obj" => Some(Self::Model(path.to_owned())),
            _ => None,
        }
    }

    /// The file that is read; `None` for a scene inside the program.
    #[must_use]
    pub fn path(&self) -> Option<&Path> {
        match self {
            Self::BuiltIn(_) => None,
            Self::File(path) | Self::Model(path) => Some(path),
        }
    }
}

fn neither(path: &Path) -> Error {
    Error::new(ErrorKind::Malformed, path, "is neither a scene file (.toml) nor a model (.obj)")
}

/// Loads the scene, its meshes from `library` or into it.
///
/// The memory of meshes stays charged to `budget`; that of the text and the objects is given back.
///
/// # Errors
/// `Forbidden` for files that are missing or lie outside the scene's folder, `Malformed` with a place for what is wrong
/// in one, `Limit` for one that is too large, `Cancelled` if the user asked to stop.
pub fn load_scene(
    source: &SceneSource,
    library: &mut MeshLibrary,
    budget: &mut Budget,
    report: &mut Report,
) -> Result<Scene> {
    match source {
        SceneSource::BuiltIn(id) => {
            let folder = SceneFolder::built_in();
            builtin::load(id, &mut |path, report| library.mesh(&folder, path, budget, report), report)
        }
        SceneSource::File(path) => load_file(path, library, budget, report),
        SceneSource::Model(path) => scene_of_model(path, library, budget, report),
    }
}

fn load_file(path: &Path, library: &mut MeshLibrary, budget: &mut Budget, report: &mut Report) -> Result<Scene> {
    // Measured: while a text is read, its objects and names take up to ten times its bytes.
    const GROWTH: u64 = 10;
    let file = SceneFile::of_user(path)?;
    if SceneSource::of_path(path).is_none() {
        return Err(neither(path));
    }
    let folder = SceneFolder::of_file(path)?;
    let bytes = file.read(MAX_TEXT_BYTES, budget)?;
    let objects = u64::try_from(bytes.len()).unwrap_or(u64::MAX).saturating_mul(GROWTH);
    budget.charge("the objects of the scene", objects).map_err(|over: OverBudget| over.in_file(path))?;
    let scene = parse_scene(&bytes, path, &mut |path, report| library.mesh(&folder, path, budget, report), report);
    budget.release(objects);
    budget.release_list(&bytes, bytes.capacity());
    scene
}

fn list() -> String {
    builtin::ids().collect::<Vec<_>>().join(", ")
}

/// There is no scene of that name.
fn unknown(word: &Path) -> Error {
    // `chess.toml` and `scenes/ches` mean the built-in scene as likely as `ches` does.
    let stem = word.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let error = Error::new(ErrorKind::Forbidden, word, "there is no such scene or file");
    match nearest(&stem, builtin::ids()) {
        Some(id) => error.hint(format!("did you mean the built-in scene `{id}`? The built-in scenes are: {}", list())),
        None => error.hint(format!("the built-in scenes are: {}", list())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn load(word: &str) -> Result<Scene> {
        let source = SceneSource::find(Path::new(word))?;
        load_scene(&source, &mut MeshLibrary::new(), &mut Budget::new(1 << 30), &mut Report::default())
    }

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
        assert_eq!(SceneSource::find(Path::new("src/lib.rs")).unwrap_err().exit_code(), 3);
        assert_eq!(SceneSource::find(Path::new("src")).unwrap_err().exit_code(), 4);
        assert_eq!(SceneSource::find(Path::new("")).unwrap_err().exit_code(), 4);
    }

    #[test]
    fn every_built_in_scene_is_loaded_with_its_models() {
        for id in builtin::ids() {
            let scene = load(id).unwrap_or_else(|e| panic!("{e}"));
            assert_eq!(scene.triangle_count() > 1_000, matches!(id, "knight" | "chess"), "{id}");
        }
    }

    #[test]
    fn a_built_in_scene_saved_to_any_folder_is_loaded_again() {
        let path = std::env::temp_dir().join(format!("luch-load-{}.toml", std::process::id()));
        let scene = load("chess").unwrap();
        std::fs::write(&path, crate::write_scene(&scene)).unwrap();
        let again = load(path.to_str().unwrap());
        std::fs::remove_file(&path).unwrap();
        assert_eq!(again.unwrap(), scene);
    }

    #[test]
    fn the_memory_of_a_text_is_charged_and_given_back() {
        let path = std::env::temp_dir().join(format!("luch-load-budget-{}.toml", std::process::id()));
        std::fs::write(&path, format!("luch = 1\n{}", "#\n".repeat(50_000))).unwrap();
        let source = SceneSource::find(&path).unwrap();
        let load = |limit| {
            let mut budget = Budget::new(limit);
            let scene = load_scene(&source, &mut MeshLibrary::new(), &mut budget, &mut Report::default());
            (scene, budget)
        };
        let (scene, budget) = load(2 << 20);
        assert!(scene.is_ok());
        assert_eq!(budget.used(), 0);
        let (scene, _) = load(1 << 20);
        std::fs::remove_file(&path).unwrap();
        assert_eq!(scene.unwrap_err().exit_code(), 5);
    }
}
