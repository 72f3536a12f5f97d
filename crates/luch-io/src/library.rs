//! The meshes of a run: each file is read once and shared.

use crate::budget::Budget;
use crate::built_in_models::{BUILT_IN_MODELS, BuiltInModel};
use crate::error::{Error, ErrorKind, Result};
use crate::obj;
use crate::report::Report;
use crate::resolve::{Found, MAX_MESH_BYTES, MAX_TEXT_BYTES, SceneFile, SceneFolder};
use luch_scene::{Mesh, MeshData, MeshId};
use std::collections::HashMap;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};
use std::time::SystemTime;

/// Meshes by the file that they came from.
///
/// A file is read again when its size or its time of change is another. Models inside the program are read once in the
/// whole run, by the first scene that needs them. A clone shares the meshes.
#[derive(Debug, Clone, Default)]
pub struct MeshLibrary {
    meshes: HashMap<Key, Held>,
}

#[derive(Debug, Clone)]
struct Held {
    mesh: Arc<Mesh>,
    files: ModelFiles,
}

/// The files that a mesh was read from.
#[derive(Debug, Clone)]
pub struct ModelFiles {
    /// The model.
    pub model: SceneFile,
    /// The material libraries that it named and that could be read.
    pub libraries: Vec<SceneFile>,
}

#[derive(Debug, Clone, PartialEq, Eq, Hash)]
struct Key {
    path: PathBuf,
    bytes: u64,
    modified: Option<SystemTime>,
}

impl MeshLibrary {
    /// An empty library.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The mesh that a scene of `folder` names by `path`.
    ///
    /// The memory of the mesh stays charged to `budget`, once for each mesh however often it is asked for.
    ///
    /// # Errors
    /// As [`SceneFolder::find`] and [`obj::read`].
    pub fn mesh(
        &mut self,
        folder: &SceneFolder,
        path: &str,
        budget: &mut Budget,
        report: &mut Report,
    ) -> Result<Arc<Mesh>> {
        match folder.find(path)? {
            Found::BuiltIn(model) => built_in(model),
            Found::File(file) => self.mesh_of_file(folder, &file, budget, report),
        }
    }

    /// The mesh of a file that was found already, with its material libraries behind the fence of `folder`.
    ///
    /// # Errors
    /// As [`MeshLibrary::mesh`].
    pub fn mesh_of_file(
        &mut self,
        folder: &SceneFolder,
        file: &SceneFile,
        budget: &mut Budget,
        report: &mut Report,
    ) -> Result<Arc<Mesh>> {
        let key = Key::of(file);
        if let Some(held) = self.meshes.get(&key) {
            return Ok(Arc::clone(&held.mesh));
        }
        let bytes = file.read(MAX_MESH_BYTES, budget)?;
        let mut libraries: Vec<SceneFile> = Vec::new();
        let mut open = |name: &str, budget: &mut Budget| {
            let library = folder.find_beside(file, name)?;
            let text = library.read(MAX_TEXT_BYTES, budget)?;
            libraries.push(library);
            Ok(text)
        };
        let data = obj::read(bytes, file.shown(), &mut open, budget, report)?;
        let mesh = Arc::new(checked(data, file.shown())?);
        let files = ModelFiles { model: file.clone(), libraries };
        self.meshes.insert(key, Held { mesh: Arc::clone(&mesh), files });
        Ok(mesh)
    }

    /// The places on disk that a mesh was read from or copied to; none for a model inside the program.
    pub(crate) fn places_of(&self, mesh: MeshId) -> impl Iterator<Item = &ModelFiles> {
        self.meshes.values().filter(move |held| held.mesh.id() == mesh).map(|held| &held.files)
    }

    /// Notes that files hold the mesh, too.
    pub(crate) fn add_place(&mut self, mesh: &Arc<Mesh>, files: ModelFiles) {
        self.meshes.insert(Key::of(&files.model), Held { mesh: Arc::clone(mesh), files });
    }

    /// Takes over what another library knows. Of two meshes of one file, the own one stays.
    pub fn absorb(&mut self, other: Self) {
        for (key, held) in other.meshes {
            self.meshes.entry(key).or_insert(held);
        }
    }

    /// Forgets the meshes that no scene holds any more.
    pub fn forget_unused(&mut self) {
        // A mesh that was copied is held once for each of its files.
        let mut held: HashMap<MeshId, usize> = HashMap::new();
        for known in self.meshes.values() {
            let count = held.entry(known.mesh.id()).or_default();
            *count = count.saturating_add(1);
        }
        self.meshes
            .retain(|_, known| Arc::strong_count(&known.mesh) > held.get(&known.mesh.id()).copied().unwrap_or(0));
    }
}

impl Key {
    fn of(file: &SceneFile) -> Self {
        Self { path: file.path().to_owned(), bytes: file.bytes(), modified: file.modified() }
    }
}

/// The model inside the program that a mesh was read from.
pub(crate) fn built_in_of(mesh: MeshId) -> Option<&'static BuiltInModel> {
    let is_it = |read: &OnceLock<Result<Arc<Mesh>>>| matches!(read.get(), Some(Ok(known)) if known.id() == mesh);
    let place = MESHES.iter().position(is_it)?;
    BUILT_IN_MODELS.get(place)
}

/// The models inside the program, as far as they were read.
static MESHES: [OnceLock<Result<Arc<Mesh>>>; BUILT_IN_MODELS.len()] =
    [const { OnceLock::new() }; BUILT_IN_MODELS.len()];

/// A model inside the program: read at the first call, shared from then on.
fn built_in(model: &'static BuiltInModel) -> Result<Arc<Mesh>> {
    let file = Path::new(model.path);
    let read = || {
        let mut no_library = |name: &str, _: &mut Budget| Err(Error::new(ErrorKind::Forbidden, name, "no such file"));
        // Ours, and small: neither the user's limit nor the user's wish to stop applies.
        let mut budget = Budget::new(Budget::FALLBACK_LIMIT);
        let bytes = model.bytes.to_vec();
        let data = obj::read(bytes, file, &mut no_library, &mut budget, &mut Report::default())?;
        Ok(Arc::new(checked(data, file)?))
    };
    let place = BUILT_IN_MODELS.iter().position(|m| m.path == model.path);
    match place.and_then(|place| MESHES.get(place)) {
        Some(mesh) => mesh.get_or_init(read).clone(),
        None => read(),
    }
}

/// The mesh of what was read. The reader has checked everything that the mesh checks, so an error here is a fault of ours.
fn checked(data: MeshData, file: &Path) -> Result<Mesh> {
    Mesh::new(data).map_err(|e| Error::new(ErrorKind::Malformed, file, e.to_string()))
}
