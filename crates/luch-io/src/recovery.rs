//! Changed scenes kept safe while they are worked on, and found again after the program has died.
//!
//! Each running program has a folder of its own below `recovery` in the data folder, with two files: `lock`, which it
//! holds locked as long as it lives, and `scene.toml`. The system lets go of a lock when a process ends in any way: so a
//! folder whose lock can be taken belongs to nobody any more, and whoever takes it alone deals with it.
//!
//! The scene is an ordinary scene file. Where it came from and where its models lie is written in comments at its head,
//! since a scene may name models only below its own folder.

mod header;

use self::header::{Header, ModelPlace};
use crate::atomic_save::save;
use crate::budget::Budget;
use crate::error::{Error, ErrorKind, Result};
use crate::library::{MeshLibrary, built_in_of};
use crate::load::SceneSource;
use crate::report::Report;
use crate::resolve::{Found, MAX_TEXT_BYTES, SceneFile, SceneFolder, encode_name};
use crate::scene_file::{parse_scene, write_scene};
use luch_scene::{MeshId, Scene, Shape};
use std::ffi::OsString;
use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Where the folders are, below the data folder.
const FOLDER: &str = "recovery";
const LOCK: &str = "lock";
const SCENE: &str = "scene.toml";
/// An empty folder that is older than this is nobody's: a program locks its folder at once.
const NEW: Duration = Duration::from_secs(60);

/// The folder of this program.
#[derive(Debug)]
pub struct RecoveryFolder {
    path: PathBuf,
    /// Held for its lock.
    _lock: File,
}

impl RecoveryFolder {
    /// Makes a folder for this program below `data`.
    ///
    /// # Errors
    /// `Output` if it cannot be made.
    pub fn create(data: &Path) -> Result<Self> {
        let failed = |path: &Path, e: &std::io::Error| {
            Error::new(ErrorKind::Output, path, format!("the folder cannot be made: {e}"))
        };
        let all = data.join(FOLDER);
        fs::create_dir_all(&all).map_err(|e| failed(&all, &e))?;
        let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).unwrap_or_default().as_millis();
        let mut number = 0_u32;
        let path = loop {
            let path = all.join(format!("{}-{now}-{number}", std::process::id()));
            match fs::create_dir(&path) {
                Ok(()) => break path,
                Err(e) if e.kind() == std::io::ErrorKind::AlreadyExists && number < 1_000 => {
                    number = number.saturating_add(1);
                }
                Err(e) => return Err(failed(&path, &e)),
            }
        };
        let lock = File::create(path.join(LOCK)).map_err(|e| failed(&path, &e))?;
        hold(&lock);
        Ok(Self { path, _lock: lock })
    }

    /// Keeps a scene safe, in place of the one before. `library` has read its meshes, so it knows their files.
    ///
    /// # Errors
    /// `Output` if it cannot be written; the one before is then still there.
    pub fn save(&self, scene: &Scene, source: Option<&SceneSource>, library: &MeshLibrary) -> Result<()> {
        let mut scene = scene.clone();
        let models = places(&mut scene, library);
        let header = Header { name: scene.name.clone(), source: source.map(absolute), models };
        let text = format!("{header}{}", write_scene(&scene));
        save(&self.path.join(SCENE), |file| file.write_all(text.as_bytes()))
    }

    /// Forgets the scene: it is saved elsewhere, or not wanted.
    pub fn clear(&self) {
        // One that is not there is forgotten.
        let _ = fs::remove_file(self.path.join(SCENE));
    }

    /// Removes the folder: the program ends as it should.
    pub fn remove(&self) {
        remove(&self.path);
    }
}

/// Locks the file of a folder that is new.
fn hold(lock: &File) {
    // Where the file system has no locks, nobody else can take it either. Who looks for dead programs at this moment holds
    // it no longer than it takes to see that there is no scene.
    if let Err(fs::TryLockError::WouldBlock) = lock.try_lock() {
        let _ = lock.lock();
    }
}

/// The same source, wherever the next program is started.
fn absolute(source: &SceneSource) -> SceneSource {
    let absolute = |path: &Path| std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
    match source {
        SceneSource::BuiltIn(id) => SceneSource::BuiltIn(id),
        SceneSource::File(path) => SceneSource::File(absolute(path)),
        SceneSource::Model(path) => SceneSource::Model(absolute(path)),
    }
}

/// Where the models of a scene lie. Two models of one name, as they may be until a scene is saved, get two names.
fn places(scene: &mut Scene, library: &MeshLibrary) -> Vec<ModelPlace> {
    let mut places: Vec<(MeshId, ModelPlace)> = Vec::new();
    for object in &mut scene.objects {
        let Shape::Mesh(instance) = &mut object.shape else { continue };
        let mesh = instance.mesh.id();
        let files = library.places_of(mesh).min_by(|a, b| a.model.path().cmp(b.model.path()));
        let Some(files) = files.filter(|_| built_in_of(mesh).is_none()) else { continue };
        let mut number = 2_u32;
        let wanted = instance.path.clone();
        while places.iter().any(|(other, place)| place.name == instance.path && *other != mesh) {
            instance.path = format!("{wanted} {number}");
            number = number.saturating_add(1);
        }
        if !places.iter().any(|(_, place)| place.name == instance.path) {
            let (file, depth) = (files.model.path().to_owned(), files.model.inside().len());
            places.push((mesh, ModelPlace { name: instance.path.clone(), file, depth }));
        }
    }
    places.into_iter().map(|(_, place)| place).collect()
}

/// A scene that a program which is no more had not saved.
#[derive(Debug)]
pub struct Recoverable {
    folder: PathBuf,
    /// Held, so that no other program offers the same.
    _lock: File,
    header: Header,
    saved: SystemTime,
}

/// The scenes below `data` that belong to no running program, the newest first. They are locked until they are dropped.
#[must_use]
pub fn recoverable(data: &Path) -> Vec<Recoverable> {
    let folders = fs::read_dir(data.join(FOLDER)).into_iter().flatten().filter_map(std::result::Result::ok);
    let mut found: Vec<_> = folders.filter_map(|folder| take(folder.path())).collect();
    found.sort_by_key(|scene| std::cmp::Reverse(scene.saved));
    found
}

/// Takes over the folder of a dead program, if it is one.
fn take(folder: PathBuf) -> Option<Recoverable> {
    let lock = File::options().write(true).open(folder.join(LOCK));
    let lock = match lock {
        Ok(lock) => lock.try_lock().is_ok().then_some(lock)?,
        // Its program died before it had made the file, or is about to.
        Err(_) => {
            remove_if_old(&folder);
            return None;
        }
    };
    let scene = folder.join(SCENE);
    let Ok(saved) = fs::metadata(&scene).and_then(|file| file.modified()) else {
        remove_if_old(&folder);
        return None;
    };
    let file = SceneFile::of_user(&scene).ok()?;
    let text = file.read(MAX_TEXT_BYTES, &mut Budget::default()).ok()?;
    let header = Header::of(&String::from_utf8_lossy(&text));
    Some(Recoverable { folder, _lock: lock, header, saved })
}

fn remove_if_old(folder: &Path) {
    let made = fs::metadata(folder).and_then(|folder| folder.modified()).ok();
    if made.and_then(|made| made.elapsed().ok()).is_some_and(|age| age > NEW) {
        remove(folder);
    }
}

/// Removes the files that are ours, then the folder. Whatever else lies there stays.
fn remove(folder: &Path) {
    let half_written = format!(".{SCENE}.tmp-");
    let names = fs::read_dir(folder).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.file_name()));
    let is_ours = |name: &OsString| {
        name == SCENE || name == LOCK || name.to_str().is_some_and(|name| name.starts_with(&half_written))
    };
    for name in names.filter(is_ours) {
        let _ = fs::remove_file(folder.join(name));
    }
    let _ = fs::remove_dir(folder);
}

impl Recoverable {
    /// The scene's name.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.header.name
    }

    /// Where the scene came from; `None` for a new one.
    #[must_use]
    pub const fn source(&self) -> Option<&SceneSource> {
        self.header.source.as_ref()
    }

    /// When it was kept safe.
    #[must_use]
    pub const fn saved(&self) -> SystemTime {
        self.saved
    }

    /// Reads the scene; it stays where it is.
    ///
    /// # Errors
    /// As [`crate::load_scene`].
    pub fn load(&self, library: &mut MeshLibrary, budget: &mut Budget, report: &mut Report) -> Result<Scene> {
        let path = self.folder.join(SCENE);
        let bytes = SceneFile::of_user(&path)?.read(MAX_TEXT_BYTES, budget)?;
        let mut mesh = |name: &str, report: &mut Report| {
            let place = self.header.models.iter().find(|model| model.name == name);
            match place {
                Some(place) => {
                    let (folder, file) = place.find()?;
                    library.mesh_of_file(&folder, &file, budget, report)
                }
                None => library.mesh(&SceneFolder::built_in(), name, budget, report),
            }
        };
        parse_scene(&bytes, &path, &mut mesh, report)
    }

    /// Removes it.
    pub fn discard(&self) {
        remove(&self.folder);
    }
}

impl ModelPlace {
    /// The model, and the folder that its libraries are looked for in.
    fn find(&self) -> Result<(SceneFolder, SceneFile)> {
        let fence = self.file.ancestors().nth(self.depth);
        let inside = fence.and_then(|fence| self.file.strip_prefix(fence).ok());
        if let (Some(fence), Some(inside)) = (fence, inside.and_then(Path::to_str)) {
            let folder = SceneFolder::new(fence)?;
            let name = encode_name(&inside.replace(std::path::MAIN_SEPARATOR, "/"));
            if let Ok(Found::File(file)) = folder.find(&name) {
                return Ok((folder, file));
            }
        }
        Ok((SceneFolder::of_file(&self.file)?, SceneFile::of_user(&self.file)?))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::{MeshInstance, Object, Point, Rotation, Size};

    fn data(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("luch-recovery-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        fs::canonicalize(path).unwrap()
    }

    /// What `kill -9` leaves of a program: its files, without the lock.
    fn die(folder: RecoveryFolder) -> PathBuf {
        folder.path
    }

    fn load(found: &Recoverable) -> Result<Scene> {
        found.load(&mut MeshLibrary::new(), &mut Budget::new(1 << 30), &mut Report::default())
    }

    #[test]
    fn what_died_while_it_wrote_is_removed_with_all_that_is_ours_and_nothing_else() {
        let data = data("half");
        for strange in [None, Some("notes.txt")] {
            let folder = RecoveryFolder::create(&data).unwrap();
            folder.save(&Scene::new("half"), None, &MeshLibrary::new()).unwrap();
            let path = die(folder);
            fs::write(path.join(".scene.toml.tmp-1-0"), "luch =").unwrap();
            if let Some(strange) = strange {
                fs::write(path.join(strange), "").unwrap();
            }
            recoverable(&data)[0].discard();
            let left: Vec<_> =
                fs::read_dir(&path).into_iter().flatten().map(|file| file.unwrap().file_name()).collect();
            assert_eq!(left, strange.map(OsString::from).into_iter().collect::<Vec<_>>());
        }
        fs::remove_dir_all(&data).unwrap();
    }

    #[test]
    fn a_new_folder_that_another_program_looks_at_is_locked_all_the_same() {
        let data = data("looked at");
        let path = data.join(LOCK);
        for _ in 0..50 {
            let (own, other) = (File::create(&path).unwrap(), File::open(&path).unwrap());
            other.lock().unwrap();
            let (begin, begins) = std::sync::mpsc::sync_channel(0);
            std::thread::scope(|threads| {
                let hold = || {
                    begin.send(()).unwrap();
                    hold(&own);
                };
                std::thread::Builder::new().spawn_scoped(threads, hold).unwrap();
                begins.recv().unwrap();
                other.unlock().unwrap();
            });
            assert!(other.try_lock().is_err(), "it is not held");
        }
        fs::remove_dir_all(&data).unwrap();
    }

    #[test]
    fn a_dead_program_s_scene_is_found_and_a_living_one_s_is_not() {
        let data = data("dead");
        let folders = ["a", "b"].map(|name| {
            let folder = RecoveryFolder::create(&data).unwrap();
            folder.save(&Scene::new(name), Some(&SceneSource::BuiltIn("chess")), &MeshLibrary::new()).unwrap();
            folder
        });
        assert!(recoverable(&data).is_empty(), "both live");
        let [dead, living] = folders;
        die(dead);
        let found = recoverable(&data);
        assert_eq!(found.len(), 1);
        assert_eq!((found[0].name(), found[0].source()), ("a", Some(&SceneSource::BuiltIn("chess"))));
        assert!(found[0].saved().elapsed().unwrap() < Duration::from_secs(600));
        assert_eq!(load(&found[0]).unwrap().name, "a");
        assert!(recoverable(&data).is_empty(), "whoever found it first deals with it");
        drop(found);
        recoverable(&data).pop().unwrap().discard();
        assert!(recoverable(&data).is_empty());
        living.remove();
        assert_eq!(fs::read_dir(data.join(FOLDER)).unwrap().count(), 0);
        fs::remove_dir_all(data).unwrap();
    }

    #[test]
    fn models_are_found_where_they_lie() {
        let data = data("models");
        fs::create_dir_all(data.join("kit/50%/looks")).unwrap();
        let model = data.join("kit/50%/tree.obj");
        fs::write(&model, "mtllib looks/a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl red\nf 1 2 3\n").unwrap();
        fs::write(data.join("kit/50%/looks/a.mtl"), "newmtl red\nKd 1 0 0\n").unwrap();
        let mut library = MeshLibrary::new();
        let budget = &mut Budget::new(1 << 30);
        let read = crate::load_model(&model, &mut library, budget, &mut Report::default()).unwrap();
        let mut scene = Scene::new("s");
        let mut chess = crate::load_scene(&SceneSource::BuiltIn("chess"), &mut library, budget, &mut Report::default());
        scene.objects.append(&mut chess.as_mut().unwrap().objects);
        let (position, rotation, scale) = (Point::ORIGIN, Rotation::NONE, Size::ONE);
        fs::create_dir_all(data.join("other")).unwrap();
        let other = data.join("other/tree.obj");
        fs::write(&other, "v 0 0 0\nv 1 0 0\nv 0 7 0\nf 1 2 3\n").unwrap();
        let other = crate::load_model(&other, &mut library, budget, &mut Report::default()).unwrap();
        for (name, model) in [("other", other), ("tree", read)] {
            let shape = Shape::Mesh(MeshInstance { mesh: model.mesh, path: model.path, position, rotation, scale });
            scene.objects.push(Object::new(name, shape));
        }
        let folder = RecoveryFolder::create(&data).unwrap();
        folder.save(&scene, None, &library).unwrap();
        die(folder);
        let found = recoverable(&data).pop().unwrap();
        let again = load(&found).unwrap();
        let Shape::Mesh(tree) = &again.objects.last().unwrap().shape else { panic!("a mesh") };
        assert_eq!((tree.mesh.materials().len(), again.objects.len()), (1, scene.objects.len()));
        let heights = |scene: &Scene| scene.objects.iter().map(|o| o.shape.bounds()).collect::<Vec<_>>();
        assert_eq!(heights(&again), heights(&scene), "each is read from its own file");
        fs::remove_file(&model).unwrap();
        let error = load(&found).unwrap_err();
        assert_eq!(error.kind, ErrorKind::Forbidden);
        assert!(error.text.contains("tree.obj"), "{error}");
        fs::remove_dir_all(data).unwrap();
    }

    #[test]
    fn what_was_cleared_is_not_found_and_the_disk_s_errors_are_told() {
        let data = data("clear");
        let folder = RecoveryFolder::create(&data).unwrap();
        folder.save(&Scene::new("a"), None, &MeshLibrary::new()).unwrap();
        folder.clear();
        folder.clear();
        let path = die(folder);
        assert!(recoverable(&data).is_empty());
        assert!(path.exists(), "a folder so young may be about to be used");
        fs::remove_dir_all(&data).unwrap();
        fs::write(&data, "a file").unwrap();
        assert_eq!(RecoveryFolder::create(&data).unwrap_err().kind, ErrorKind::Output);
        assert!(recoverable(&data).is_empty());
        fs::remove_file(data).unwrap();
    }
}
