//! Models copied beside a scene. Files keep their names and how they lie to each other, since models name their
//! libraries by them; where a name is taken by something else, a folder of their own is found.

use crate::atomic_save::save;
use crate::budget::Budget;
use crate::error::{Error, ErrorKind, Result};
use crate::library::{MeshLibrary, ModelFiles};
use crate::resolve::{MAX_MESH_BYTES, SceneFile, SceneFolder};
use luch_scene::Mesh;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The folder beside a scene that models are copied to.
const FOLDER: &str = "models";
/// How many folders of a name are looked at for a free one.
const MOST: u32 = 1_000;

/// The copies made for one scene; they are removed again unless they are [kept](Copies::keep).
pub(super) struct Copies<'a> {
    folder: &'a SceneFolder,
    made: Vec<PathBuf>,
    folders: Vec<PathBuf>,
    places: Vec<(Arc<Mesh>, ModelFiles)>,
}

impl<'a> Copies<'a> {
    pub(super) const fn new(folder: &'a SceneFolder) -> Self {
        Self { folder, made: Vec::new(), folders: Vec::new(), places: Vec::new() }
    }

    /// Copies a model and its libraries and answers with the name of the copy.
    pub(super) fn copy(&mut self, mesh: &Arc<Mesh>, files: &ModelFiles, budget: &mut Budget) -> Result<String> {
        let sources: Vec<&SceneFile> = std::iter::once(&files.model).chain(&files.libraries).collect();
        let layout = layout(&sources);
        let contents = sources.iter().map(|file| file.read(MAX_MESH_BYTES, budget)).collect::<Result<Vec<_>>>();
        let result = contents.and_then(|contents| {
            let result = self.place(mesh, &layout, &contents);
            contents.iter().for_each(|bytes| budget.release_list(bytes, bytes.capacity()));
            result
        });
        result.map_err(|error| match error.kind {
            ErrorKind::Forbidden => {
                error.hint("the model is no longer where it was read from; the scene needs a copy of it")
            }
            _ => error,
        })
    }

    /// Finds a folder where each file has its name free, or is there already, and puts them there.
    fn place(&mut self, mesh: &Arc<Mesh>, layout: &[PathBuf], contents: &[Vec<u8>]) -> Result<String> {
        let root = self.folder.root().unwrap_or(Path::new("")).join(FOLDER);
        let model = layout.first().cloned().unwrap_or_default();
        let stem = model.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        for number in 1..MOST {
            let base = if number == 1 { root.clone() } else { root.join(format!("{stem} {number}")) };
            let targets: Vec<PathBuf> = layout.iter().map(|file| base.join(file)).collect();
            let all_free = targets.iter().zip(contents).all(|(target, bytes)| state(target, bytes) != State::Taken);
            if !all_free {
                continue;
            }
            for (target, bytes) in targets.iter().zip(contents) {
                self.write(target, bytes)?;
            }
            return self.found(mesh, &targets);
        }
        let text = "every name is taken by another file";
        Err(Error::new(ErrorKind::Output, root.join(model), text).hint("tidy up the folder, or save to another one"))
    }

    fn write(&mut self, target: &Path, bytes: &[u8]) -> Result<()> {
        if state(target, bytes) == State::Same {
            return Ok(());
        }
        if let Some(folder) = target.parent() {
            self.make_folder(folder)
                .map_err(|e| Error::new(ErrorKind::Output, folder, format!("the folder cannot be made: {e}")))?;
        }
        save(target, |out| out.write_all(bytes))?;
        self.made.push(target.to_owned());
        Ok(())
    }

    /// Makes a folder and those above it, and remembers which were not there.
    fn make_folder(&mut self, folder: &Path) -> io::Result<()> {
        if folder.is_dir() {
            return Ok(());
        }
        if let Some(above) = folder.parent() {
            self.make_folder(above)?;
        }
        fs::create_dir(folder)?;
        self.folders.push(folder.to_owned());
        Ok(())
    }

    /// The copies as files that a scene may name, and the name of the model.
    fn found(&mut self, mesh: &Arc<Mesh>, targets: &[PathBuf]) -> Result<String> {
        let outside = |path: &Path| {
            Error::new(ErrorKind::Output, path, "lies outside of the scene's folder, where the scene cannot read it")
        };
        let mut files = Vec::new();
        for target in targets {
            // A folder `models` that is a link to elsewhere would be refused when the scene is read.
            let name = fs::canonicalize(target).ok().and_then(|path| self.folder.name_of(&path));
            let name = name.ok_or_else(|| outside(target))?;
            let crate::resolve::Found::File(file) = self.folder.find(&name)? else { return Err(outside(target)) };
            files.push((name, file));
        }
        let mut files = files.into_iter();
        let (name, model) = files.next().ok_or_else(|| outside(self.folder.shown()))?;
        let libraries = files.map(|(_, file)| file).collect();
        self.places.push((Arc::clone(mesh), ModelFiles { model, libraries }));
        Ok(name)
    }

    /// Keeps the copies, tells the library of them, and answers with their paths.
    pub(super) fn keep(mut self, library: &mut MeshLibrary) -> Vec<PathBuf> {
        self.folders.clear();
        for (mesh, files) in self.places.drain(..) {
            library.add_place(&mesh, files);
        }
        std::mem::take(&mut self.made)
    }
}

impl Drop for Copies<'_> {
    fn drop(&mut self) {
        // There is nobody to tell, and the error that led here is the one that matters.
        for file in &self.made {
            let _ = fs::remove_file(file);
        }
        for folder in self.folders.iter().rev() {
            let _ = fs::remove_dir(folder);
        }
    }
}

/// Where each file lies below the folder that all of them lie in.
fn layout(files: &[&SceneFile]) -> Vec<PathBuf> {
    let folders = || files.iter().map(|file| file.inside().split_last().map_or(&[][..], |(_, folder)| folder));
    let first = folders().next().unwrap_or(&[]);
    let common = folders().map(|other| first.iter().zip(other).take_while(|(a, b)| a == b).count()).min().unwrap_or(0);
    files.iter().map(|file| file.inside().iter().skip(common).map(|part| speakable(part)).collect()).collect()
}

/// A file's name without what no scene may write in a path.
fn speakable(part: &str) -> String {
    let name: String = part.chars().map(|c| if c == '\\' || c.is_control() { '_' } else { c }).collect();
    if name.trim().is_empty() { "model.obj".to_owned() } else { name }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Free,
    /// The file is there with the same content.
    Same,
    /// Something else has the name.
    Taken,
}

fn state(target: &Path, bytes: &[u8]) -> State {
    match fs::symlink_metadata(target) {
        // Where it cannot even be looked at, writing will say why.
        Err(_) => State::Free,
        Ok(known) if known.is_file() && u64::try_from(bytes.len()) == Ok(known.len()) => {
            if fs::read(target).is_ok_and(|there| there == bytes) { State::Same } else { State::Taken }
        }
        // A link, a folder, another file.
        Ok(_) => State::Taken,
    }
}
