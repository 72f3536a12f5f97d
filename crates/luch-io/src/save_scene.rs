//! Saves a scene together with the models that it shows, so that the file is read back from where it lies.
//!
//! A scene names its models by paths that end below its own folder ([`crate::resolve`]). So a model that lies elsewhere
//! is copied into a folder `models` beside the scene, with its material libraries, and the scene names the copy. Models
//! inside the program are named as the built-in scenes name them.

mod copies;

use self::copies::Copies;
use crate::atomic_save::save;
use crate::budget::Budget;
use crate::error::{Error, ErrorKind, Result};
use crate::library::{MeshLibrary, built_in_of};
use crate::resolve::SceneFolder;
use crate::scene_file::write_scene;
use luch_scene::{MeshId, MeshInstance, Scene, Shape};
use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// What saving a scene has done besides writing its file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Saved {
    /// The models that the file names otherwise than the scene did.
    pub renamed: Vec<Renamed>,
    /// The files that were put beside the scene.
    pub copied: Vec<PathBuf>,
}

/// A model with a new name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Renamed {
    /// Its mesh.
    pub mesh: MeshId,
    /// [`MeshInstance::path`] as it was.
    pub from: String,
    /// The path from the saved file.
    pub to: String,
}

impl Saved {
    /// Gives the models of a scene their new names. It may have changed since it was saved.
    pub fn rename(&self, scene: &mut Scene) {
        for instance in scene.objects.iter_mut().filter_map(|object| instance_of(&mut object.shape)) {
            let renamed = self.renamed.iter().find(|r| r.mesh == instance.mesh.id() && r.from == instance.path);
            if let Some(Renamed { to, .. }) = renamed {
                instance.path.clone_from(to);
            }
        }
    }
}

/// Writes `scene` to the file `path`, whole or not at all, and copies models into its folder where it must.
///
/// `library` has read the meshes of the scene, so it knows their files; it learns of the copies. A file that is there
/// already is never replaced, except `path` itself. If anything fails, the copies made are removed again.
///
/// # Errors
/// `Output` if the file or a copy cannot be written, with its path; `Forbidden` if a model that must be copied is no
/// longer there; `Limit` and `Cancelled` as the budget says.
pub fn save_scene(scene: &Scene, path: &Path, library: &mut MeshLibrary, budget: &mut Budget) -> Result<Saved> {
    let folder = SceneFolder::of_file(path).map_err(|_| no_folder(path))?;
    let mut written = scene.clone();
    let mut names: HashMap<(MeshId, String), String> = HashMap::new();
    let mut copies = Copies::new(&folder);
    for instance in written.objects.iter_mut().filter_map(|object| instance_of(&mut object.shape)) {
        let key = (instance.mesh.id(), instance.path.clone());
        let name = match names.get(&key) {
            Some(name) => name.clone(),
            None => name_of(instance, &folder, library, &mut copies, budget)?,
        };
        instance.path.clone_from(&name);
        names.insert(key, name);
    }
    let text = write_scene(&written);
    save(path, |file| file.write_all(text.as_bytes()))?;
    let copied = copies.keep(library);
    let renamed = names.into_iter().filter(|((_, from), to)| from != to);
    let renamed = renamed.map(|((mesh, from), to)| Renamed { mesh, from, to }).collect();
    Ok(Saved { renamed, copied })
}

/// The name by which the scene in `folder` names a model, which may have to be copied for that.
fn name_of(
    instance: &MeshInstance,
    folder: &SceneFolder,
    library: &MeshLibrary,
    copies: &mut Copies<'_>,
    budget: &mut Budget,
) -> Result<String> {
    let mesh = instance.mesh.id();
    if let Some(model) = built_in_of(mesh) {
        return Ok(model.path.to_owned());
    }
    let mut places: Vec<_> = library.places_of(mesh).collect();
    if places.is_empty() {
        // A mesh that no file holds has the name that whoever made it gave it.
        return Ok(instance.path.clone());
    }
    // A person's spelling of the path is kept where it is right.
    let named = folder.place_of(&instance.path);
    if places.iter().any(|files| Some(files.model.path()) == named.as_deref()) {
        return Ok(instance.path.clone());
    }
    // The library knows them in no order.
    places.sort_by(|a, b| a.model.path().cmp(b.model.path()));
    if let Some(name) = places.iter().find_map(|files| folder.name_of(files.model.path())) {
        return Ok(name);
    }
    // One of the places may be gone: the first that can be read serves.
    let mut failure = None;
    for files in places {
        match copies.copy(&instance.mesh, files, budget) {
            Ok(name) => return Ok(name),
            Err(error) => failure = failure.or(Some(error)),
        }
    }
    Err(failure.unwrap_or_else(|| Error::new(ErrorKind::Forbidden, &instance.path, "no such file")))
}

fn instance_of(shape: &mut Shape) -> Option<&mut MeshInstance> {
    match shape {
        Shape::Mesh(instance) => Some(instance),
        _ => None,
    }
}

fn no_folder(path: &Path) -> Error {
    let folder = path.parent().unwrap_or(Path::new("")).display();
    let text = format!("there is no folder {folder} that can be entered");
    Error::new(ErrorKind::Output, path, text).hint("make the folder first")
}
