//! A saved scene is read back from where it lies, with its models, whatever folder they came from.

use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::{Error, ErrorKind, Report, Saved, SceneSource, load_model, load_scene, save_scene, write_scene};
use luch_scene::{MeshInstance, Object, Point, Rotation, Scene, Shape, Size};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// A folder of its own for a test, removed at its end.
struct Folder(PathBuf);

impl Folder {
    fn new() -> Self {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let n = NEXT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("luch-save-scene-{}-{n}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(fs::canonicalize(path).unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    fn write(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, content).unwrap();
        path
    }

    /// Every file below, with its path from here.
    fn files(&self) -> Vec<String> {
        fn walk(folder: &Path, root: &Path, found: &mut Vec<String>) {
            for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
                match entry.path() {
                    folder if folder.is_dir() => walk(&folder, root, found),
                    file => found.push(file.strip_prefix(root).unwrap().to_string_lossy().into_owned()),
                }
            }
        }
        let mut found = Vec::new();
        walk(&self.0, &self.0, &mut found);
        found.sort();
        found
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// A triangle of that height.
fn triangle(height: f32) -> String {
    format!("v 0 0 0\nv 1 0 0\nv 0 {height} 0\nf 1 2 3\n")
}

fn load(source: &SceneSource, library: &mut MeshLibrary) -> Result<Scene, Error> {
    load_scene(source, library, &mut Budget::new(1 << 30), &mut Report::default())
}

fn open(path: &Path) -> Scene {
    load(&SceneSource::File(path.to_owned()), &mut MeshLibrary::new()).unwrap_or_else(|e| panic!("{e}"))
}

fn save(scene: &Scene, path: &Path, library: &mut MeshLibrary) -> Result<Saved, Error> {
    save_scene(scene, path, library, &mut Budget::new(1 << 30))
}

/// Puts the model of a file into the scene.
fn add(scene: &mut Scene, path: &Path, library: &mut MeshLibrary) {
    let model = load_model(path, library, &mut Budget::new(1 << 30), &mut Report::default()).unwrap();
    let (position, rotation, scale) = (Point::ORIGIN, Rotation::NONE, Size::ONE);
    let shape = Shape::Mesh(MeshInstance { mesh: model.mesh, path: model.path, position, rotation, scale });
    scene.objects.push(Object { material: model.material, ..Object::new(scene.free_name(&model.name), shape) });
}

fn instances(scene: &Scene) -> impl Iterator<Item = &MeshInstance> {
    scene.objects.iter().filter_map(|object| if let Shape::Mesh(mesh) = &object.shape { Some(mesh) } else { None })
}

fn paths(scene: &Scene) -> Vec<&str> {
    instances(scene).map(|instance| instance.path.as_str()).collect()
}

/// The heights of the models, which tell them apart.
fn heights(scene: &Scene) -> Vec<f32> {
    instances(scene).map(|instance| instance.mesh.bounds()[1].y).collect()
}

#[test]
fn a_model_from_elsewhere_is_copied_beside_the_scene() {
    let (from, to) = (Folder::new(), Folder::new());
    let model = from.write("100%/ель №1.obj", triangle(2.0));
    let mut library = MeshLibrary::new();
    let mut scene = load(&SceneSource::Model(model), &mut library).unwrap();
    let file = to.path("s.toml");
    let saved = save(&scene, &file, &mut library).unwrap();
    assert_eq!(saved.copied, [to.path("models/ель №1.obj")]);
    assert_eq!(to.files(), ["models/ель №1.obj", "s.toml"]);
    saved.rename(&mut scene);
    assert_eq!(paths(&scene), ["models/ель №1.obj"]);
    // The first file may go now, and saving again copies nothing.
    fs::remove_dir_all(from.path("100%")).unwrap();
    assert_eq!(save(&scene, &file, &mut library).unwrap(), Saved::default());
    // With the same library the mesh itself is found again: the scenes are equal.
    assert_eq!(load(&SceneSource::File(file.clone()), &mut library).unwrap(), scene);
    assert_eq!(heights(&open(&file)), [2.0]);
}

#[test]
fn a_model_that_lies_below_the_scene_is_named_where_it_lies() {
    let folder = Folder::new();
    let model = folder.write("parts/50%.obj", triangle(1.0));
    let mut library = MeshLibrary::new();
    let mut scene = Scene::new("s");
    add(&mut scene, &model, &mut library);
    let saved = save(&scene, &folder.path("s.toml"), &mut library).unwrap();
    saved.rename(&mut scene);
    assert_eq!((paths(&scene), saved.copied.len()), (vec!["parts/50%25.obj"], 0));
    assert_eq!(heights(&open(&folder.path("s.toml"))), [1.0]);
    // A person's own spelling is kept.
    folder.write("s.toml", write_scene(&scene).replace("parts/50%25", "./parts/../parts/50%25"));
    let scene = load(&SceneSource::File(folder.path("s.toml")), &mut library).unwrap();
    assert_eq!(save(&scene, &folder.path("s.toml"), &mut library).unwrap(), Saved::default());
}

#[test]
fn another_file_of_the_name_is_never_overwritten() {
    let (from, to) = (Folder::new(), Folder::new());
    let models = [from.write("a/tree.obj", triangle(1.0)), from.write("b/tree.obj", triangle(2.0))];
    to.write("models/tree.obj", triangle(3.0));
    let mut library = MeshLibrary::new();
    let mut scene = Scene::new("s");
    for model in &models {
        add(&mut scene, model, &mut library);
    }
    let saved = save(&scene, &to.path("s.toml"), &mut library).unwrap();
    assert_eq!(to.files(), ["models/tree 2/tree.obj", "models/tree 3/tree.obj", "models/tree.obj", "s.toml"]);
    assert_eq!(fs::read_to_string(to.path("models/tree.obj")).unwrap(), triangle(3.0));
    assert_eq!(heights(&open(&to.path("s.toml"))), [1.0, 2.0]);
    assert_eq!(saved.copied.len(), 2);
    // A copy that is there already serves again.
    let mut fresh = MeshLibrary::new();
    let mut again = Scene::new("again");
    add(&mut again, &models[0], &mut fresh);
    assert_eq!(save(&again, &to.path("again.toml"), &mut fresh).unwrap().renamed[0].to, "models/tree 2/tree.obj");
}

#[test]
fn libraries_come_along_and_keep_their_place_beside_the_model() {
    let (from, to) = (Folder::new(), Folder::new());
    let body = triangle(1.0).replace("f ", "usemtl red\nf ");
    from.write("kit/obj/tree.obj", format!("mtllib ../looks/my looks.mtl\n{body}"));
    from.write("kit/looks/my looks.mtl", "newmtl red\nKd 1 0 0\n");
    from.write("s.toml", "luch = 1\n[[object]]\nname = \"Tree\"\nmesh = \"kit/obj/tree.obj\"\n");
    let mut library = MeshLibrary::new();
    let scene = load(&SceneSource::File(from.path("s.toml")), &mut library).unwrap();
    save(&scene, &to.path("s.toml"), &mut library).unwrap();
    assert_eq!(to.files(), ["models/looks/my looks.mtl", "models/obj/tree.obj", "s.toml"]);
    let again = open(&to.path("s.toml"));
    let red = |scene: &Scene| instances(scene).next().unwrap().mesh.materials()[0].color;
    assert_eq!(red(&again), red(&scene));
}

#[test]
fn models_of_the_program_keep_their_names_in_any_folder() {
    let folder = Folder::new();
    let mut library = MeshLibrary::new();
    let scene = load(&SceneSource::BuiltIn("chess"), &mut library).unwrap();
    assert_eq!(save(&scene, &folder.path("s.toml"), &mut library).unwrap(), Saved::default());
    assert_eq!(folder.files(), ["s.toml"]);
    assert_eq!(open(&folder.path("s.toml")), scene);
}

#[test]
fn a_save_that_fails_leaves_no_copy() {
    let (from, to) = (Folder::new(), Folder::new());
    let models = [from.write("a.obj", triangle(1.0)), from.write("b.obj", triangle(2.0))];
    let mut library = MeshLibrary::new();
    let mut scene = Scene::new("s");
    for model in &models {
        add(&mut scene, model, &mut library);
    }
    // Where the scene is to be, there is a folder.
    fs::create_dir(to.path("s.toml")).unwrap();
    let error = save(&scene, &to.path("s.toml"), &mut library).unwrap_err();
    assert_eq!((error.kind, error.file.clone()), (ErrorKind::Output, to.path("s.toml")));
    assert!(!to.path("models").exists());
    // A model has vanished.
    fs::remove_file(&models[1]).unwrap();
    let error = save(&scene, &to.path("t.toml"), &mut library).unwrap_err();
    assert_eq!((error.kind, error.file.clone()), (ErrorKind::Forbidden, models[1].clone()));
    assert!(error.hint.unwrap().contains("no longer"));
    assert!(to.files().is_empty() && !to.path("models").exists());
    // There is no such folder, or the folder for models is a file.
    let error = save(&scene, &to.path("nowhere/s.toml"), &mut library).unwrap_err();
    assert_eq!(error.kind, ErrorKind::Output);
    scene.objects.pop();
    to.write("models", "not a folder");
    let error = save(&scene, &to.path("t.toml"), &mut library).unwrap_err();
    assert_eq!((error.kind, error.file), (ErrorKind::Output, to.path("models")));
    assert_eq!(to.files(), ["models"]);
    // In its own folder a scene is saved although its models are gone: it names them as before.
    fs::remove_file(&models[0]).unwrap();
    save(&scene, &from.path("s.toml"), &mut library).unwrap();
    assert_eq!(from.files(), ["s.toml"]);
}

#[cfg(unix)]
#[test]
fn links_do_not_lead_out() {
    let (from, to, elsewhere) = (Folder::new(), Folder::new(), Folder::new());
    let model = from.write("a.obj", triangle(1.0));
    std::os::unix::fs::symlink(&elsewhere.0, to.path("models")).unwrap();
    let mut library = MeshLibrary::new();
    let mut scene = Scene::new("s");
    add(&mut scene, &model, &mut library);
    let error = save(&scene, &to.path("s.toml"), &mut library).unwrap_err();
    assert!(error.to_string().contains("outside"), "{error}");
    assert!(elsewhere.files().is_empty() && !to.path("s.toml").exists());
}

#[cfg(unix)]
#[test]
fn names_that_are_no_utf_8_are_copied_under_names_that_are() {
    use std::os::unix::ffi::OsStrExt;
    let folder = Folder::new();
    let path = folder.0.join(std::ffi::OsStr::from_bytes(b"caf\xe9\\1.obj"));
    fs::write(&path, triangle(1.0)).unwrap();
    let mut library = MeshLibrary::new();
    let mut scene = Scene::new("s");
    add(&mut scene, &path, &mut library);
    save(&scene, &folder.path("s.toml"), &mut library).unwrap();
    assert_eq!(paths(&open(&folder.path("s.toml"))), ["models/caf\u{fffd}_1.obj"]);
}
