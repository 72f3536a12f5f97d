//! Scenes and meshes as the commands get them: within the memory limit, until the user asks to stop.

use crate::exit::Failure;
use crate::signals::Watch;
use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::resolve::{SceneFile, SceneFolder};
use luch_io::{Report, SceneSource, load_scene};
use luch_scene::{Mesh, Scene};
use std::path::Path;
use std::sync::Arc;

/// A scene and what the reader thought of it.
#[derive(Debug)]
pub(crate) struct Loaded {
    pub(crate) scene: Scene,
    pub(crate) warnings: Vec<String>,
    /// What the scene took of the memory, and what is left of it.
    pub(crate) budget: Budget,
}

/// The memory that may be used, and the wish to stop.
fn budget(memory: Option<u64>, watch: &Watch) -> Budget {
    memory.map_or_else(Budget::default, Budget::new).cancelled_by(watch.flag())
}

/// Loads a built-in scene, a scene file or a bare model.
///
/// # Errors
/// Those of the files.
pub(crate) fn load(name: &Path, memory: Option<u64>, watch: &Watch) -> Result<Loaded, Failure> {
    let mut budget = budget(memory, watch);
    let mut report = Report::default();
    let scene = load_scene(&SceneSource::find(name)?, &mut MeshLibrary::new(), &mut budget, &mut report)?;
    let warnings = report.lines();
    Ok(Loaded { scene, warnings, budget })
}

/// Loads the mesh of a model file.
///
/// # Errors
/// Those of the file.
pub(crate) fn mesh(path: &Path, watch: &Watch) -> Result<Arc<Mesh>, Failure> {
    let (folder, file) = (SceneFolder::of_file(path)?, SceneFile::of_user(path)?);
    let mut budget = budget(None, watch);
    Ok(MeshLibrary::new().mesh_of_file(&folder, &file, &mut budget, &mut Report::default())?)
}
