//! From what the file says to a scene: meshes are loaded, names given, and what is missing made up.

use super::framing::three_cameras;
use super::objects::{RawObject, RawShape};
use super::raw::{self, RawScene};
use super::text::{SceneText, decode};
use crate::budget::Budget;
use crate::error::{Error, Place, Result};
use crate::report::Report;
use crate::resolve::{MAX_TEXT_BYTES, SceneFile};
use luch_scene::{Aim, Camera, Light, Mesh, MeshInstance, Object, Scene, Shape};
use std::collections::HashMap;
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

/// Loads the mesh of a path as the scene file writes it, with its warnings. It is asked once for each path.
pub type LoadMesh<'a> = dyn FnMut(&str, &mut Report) -> Result<Arc<Mesh>> + 'a;

/// Reads a scene file.
///
/// # Errors
/// `Forbidden` if the file cannot be read, `Limit` if it is larger than 256 MiB, `Malformed` with line and column for
/// what is wrong in it; and what `load_mesh` answers.
pub fn read_scene(path: &Path, load_mesh: &mut LoadMesh<'_>, report: &mut Report) -> Result<Scene> {
    let bytes = SceneFile::of_user(path)?.read(MAX_TEXT_BYTES, &mut Budget::default())?;
    parse_scene(&bytes, path, load_mesh, report)
}

/// Reads the bytes of a scene file; `file` is the name for errors, and for a scene that has none.
///
/// # Errors
/// As [`read_scene`].
pub fn parse_scene(bytes: &[u8], file: &Path, load_mesh: &mut LoadMesh<'_>, report: &mut Report) -> Result<Scene> {
    let text = SceneText { file, text: decode(file, bytes)? };
    // All of the text is checked before the first mesh is opened: a slip of the pen is told at once.
    let raw = raw::read(text)?;
    finish(raw, text, load_mesh, report)
}

fn finish(raw: RawScene, text: SceneText<'_>, load_mesh: &mut LoadMesh<'_>, report: &mut Report) -> Result<Scene> {
    let mut meshes = Meshes { loaded: HashMap::new(), load_mesh };
    let mut scene = Scene::new(raw.name.unwrap_or_else(|| name_of(text.file)));
    scene.background = raw.background;
    scene.ambient = raw.ambient;
    scene.attenuation = raw.attenuation;
    scene.settings = raw.settings;
    scene.lights = raw.lights;
    scene.cameras = raw.cameras;
    scene.objects.reserve_exact(raw.objects.len());
    for object in raw.objects {
        scene.objects.push(meshes.finish(object, text, report)?);
    }
    name_the_nameless(&mut scene, raw.names, raw.camera_names);
    supplement(&mut scene, text, report);
    Ok(scene)
}

/// What a scene without a name is called: the name of its file.
fn name_of(file: &Path) -> String {
    let stem = file.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    if Scene::new("").check_new_name(&stem).is_ok() { stem } else { "Scene".to_owned() }
}

struct Meshes<'a, 'b> {
    loaded: HashMap<String, Arc<Mesh>>,
    load_mesh: &'a mut LoadMesh<'b>,
}

impl Meshes<'_, '_> {
    fn finish(&mut self, raw: RawObject, text: SceneText<'_>, report: &mut Report) -> Result<Object> {
        let RawObject { name, shape, material, shading, hidden, place } = raw;
        let shape = match shape {
            RawShape::Ready(shape) => shape,
            RawShape::Mesh { path, span, position, rotation, scale } => {
                let mesh = self.mesh(&path, &span, text, report)?;
                Shape::Mesh(MeshInstance { mesh, path, position, rotation, scale })
            }
        };
        if shading.is_some() && !matches!(shape, Shape::Mesh(_)) {
            let kind = shape.kind();
            report.warn("a shading model has no effect here", || {
                format!("{}:{}: a {kind} is exact", text.file.display(), text.line(place.start))
            });
        }
        let object = Object { name, shape, material, shading, hidden };
        if !object.is_within_limits() {
            return Err(text
                .error(&place, "the object reaches beyond 2e9 units from the origin")
                .hint("make it smaller or bring it nearer; mind the scale"));
        }
        Ok(object)
    }

    fn mesh(&mut self, path: &str, span: &Range<usize>, text: SceneText<'_>, report: &mut Report) -> Result<Arc<Mesh>> {
        if let Some(mesh) = self.loaded.get(path) {
            return Ok(Arc::clone(mesh));
        }
        let mesh = (self.load_mesh)(path, report).map_err(|e| told_in_the_scene(e, span, text))?;
        self.loaded.insert(path.to_owned(), Arc::clone(&mesh));
        Ok(mesh)
    }
}

/// An error about a model as a whole (missing, forbidden) is shown where the scene names the model; one that has a
/// place in the model keeps it.
fn told_in_the_scene(error: Error, span: &Range<usize>, text: SceneText<'_>) -> Error {
    if error.place != Place::File {
        return error;
    }
    let message = if error.file.as_os_str().is_empty() || error.file == text.file {
        error.text
    } else {
        format!("{}: {}", error.file.display(), error.text)
    };
    Error { file: text.file.to_owned(), place: text.place(span), text: message, ..error }
}

/// Gives lights, cameras and objects without a name a free one: `Sphere 1`, `Light 2`.
///
/// This comes last, so that a name that the file does give is never taken by one that it does not.
fn name_the_nameless(scene: &mut Scene, names: HashMap<String, usize>, camera_names: HashMap<String, usize>) {
    let mut names = Names { taken: names, last: HashMap::new() };
    for Light { name, .. } in scene.lights.iter_mut().filter(|l| l.name.is_empty()) {
        *name = names.free("Light");
    }
    for Object { name, shape, .. } in scene.objects.iter_mut().filter(|o| o.name.is_empty()) {
        *name = names.free(match shape.kind() {
            "sphere" => "Sphere",
            "cube" => "Cube",
            "box" => "Box",
            "wall" => "Wall",
            _ => "Mesh",
        });
    }
    let mut names = Names { taken: camera_names, last: HashMap::new() };
    for Camera { name, .. } in scene.cameras.iter_mut().filter(|c| c.name.is_empty()) {
        *name = names.free("Camera");
    }
}

struct Names {
    taken: HashMap<String, usize>,
    /// The last number tried for each word, so that a million nameless spheres do not count from 1 each.
    last: HashMap<&'static str, u64>,
}

impl Names {
    fn free(&mut self, word: &'static str) -> String {
        let last = self.last.entry(word).or_default();
        loop {
            *last = last.saturating_add(1);
            let name = format!("{word} {last}");
            if !self.taken.contains_key(&name) {
                return name;
            }
        }
    }
}

/// Adds cameras where there are none, and warns of what gives no good picture.
fn supplement(scene: &mut Scene, text: SceneText<'_>, report: &mut Report) {
    let file = text.file.display();
    if scene.cameras.is_empty() {
        scene.cameras = three_cameras(scene.bounds()).into();
        report.warn("the scene has no camera", || format!("{file}: three are placed around it"));
    }
    if scene.lights.is_empty() {
        report.warn("the scene has no light", || format!("{file}: only ambient light shows its objects"));
    }
    if scene.objects.is_empty() {
        report.warn("the scene has no object", || format!("{file}: the picture shows the background only"));
    }
    for camera in &scene.cameras {
        if camera.aim == Aim::At(camera.position) {
            report.warn("a camera looks at its own place", || {
                format!("{file}: \"{}\" looks along -z instead", camera.name)
            });
        }
    }
}
