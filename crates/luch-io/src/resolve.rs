//! The one door to files that other files name: models, material libraries, textures.
//!
//! A name in a file from a stranger opens only what lies in the scene's own folder: it is relative, has no scheme and
//! no drive, is percent-decoded once, and after all symbolic links are followed it still lies under the folder. Only
//! regular files are opened, and only up to a size. Nothing else is even looked at, so that a refusal does not tell
//! whether a file outside exists.
//!
//! One name leads out, and not to the disk: `../models/king.obj` and its five siblings, as the built-in scenes write
//! them, mean the models inside the program ([`crate::built_in_models`]). So a saved copy of a built-in scene loads
//! from any folder.

mod file;
mod name;

pub use file::{MAX_MESH_BYTES, MAX_TEXT_BYTES, SceneFile};
pub use name::{NameFault, components_of, encode_name};

use crate::budget::Budget;
use crate::built_in_models::{self, BuiltInModel};
use crate::error::{Error, ErrorKind, Result};
use std::path::{Path, PathBuf};

/// The folder that a scene may read from.
#[derive(Debug, Clone)]
pub struct SceneFolder {
    /// As the user named it: for messages.
    shown: PathBuf,
    /// Without symbolic links; `None` for the scenes inside the program, which have no folder.
    root: Option<PathBuf>,
}

/// What a name led to.
#[derive(Debug, Clone)]
pub enum Found {
    /// A regular file in the folder.
    File(SceneFile),
    /// A model inside the program.
    BuiltIn(&'static BuiltInModel),
}

impl SceneFolder {
    /// The fence is `dir` itself; an empty path is the current folder.
    ///
    /// # Errors
    /// [`ErrorKind::Forbidden`] if there is no such folder.
    pub fn new(dir: &Path) -> Result<Self> {
        let here = if dir.as_os_str().is_empty() { Path::new(".") } else { dir };
        let forbidden = |text: String| Error::new(ErrorKind::Forbidden, dir, text);
        let root = std::fs::canonicalize(here).map_err(|e| forbidden(file::words_of(&e)))?;
        if !root.is_dir() {
            return Err(forbidden("is no folder".to_owned()));
        }
        Ok(Self { shown: dir.to_owned(), root: Some(root) })
    }

    /// The folder that `file` lies in, as its path is written: a link is not followed.
    ///
    /// # Errors
    /// As [`SceneFolder::new`].
    pub fn of_file(file: &Path) -> Result<Self> {
        Self::new(file.parent().unwrap_or_else(|| Path::new("")))
    }

    /// The folder of the scenes inside the program: it holds the built-in models and nothing else.
    #[must_use]
    pub fn built_in() -> Self {
        Self { shown: PathBuf::new(), root: None }
    }

    /// The folder as the user named it.
    #[must_use]
    pub fn shown(&self) -> &Path {
        &self.shown
    }

    /// The folder without symbolic links; `None` for that of the scenes inside the program.
    pub(crate) fn root(&self) -> Option<&Path> {
        self.root.as_deref()
    }

    /// The name by which a scene of this folder names the file at `path`, which has no symbolic links. `None` if the file
    /// does not lie in the folder, or if its name is none that a scene may write.
    pub(crate) fn name_of(&self, path: &Path) -> Option<String> {
        let inside = path.strip_prefix(self.root.as_ref()?).ok()?;
        let parts: Vec<String> = inside.iter().map(|part| part.to_str().map(str::to_owned)).collect::<Option<_>>()?;
        let name = encode_name(&parts.join("/"));
        (components_of(&[], &name) == Ok(parts)).then_some(name)
    }

    /// Where a name leads to, whether or not there is a file.
    pub(crate) fn place_of(&self, name: &str) -> Option<PathBuf> {
        let inside = components_of(&[], name).ok()?;
        let path = self.root.as_ref()?.join(inside.iter().collect::<PathBuf>());
        Some(std::fs::canonicalize(&path).unwrap_or(path))
    }

    /// Looks up a name that the scene file writes.
    ///
    /// # Errors
    /// [`ErrorKind::Forbidden`] if the name leads out of the folder, or to nothing, or to no regular file.
    pub fn find(&self, name: &str) -> Result<Found> {
        if let Some(model) = built_in_models::find(name) {
            return Ok(Found::BuiltIn(model));
        }
        self.find_under(&[], name).map(Found::File)
    }

    /// Looks up a name that a file of this folder writes: relative to that file, behind the same fence.
    ///
    /// # Errors
    /// As [`SceneFolder::find`].
    pub fn find_beside(&self, naming: &SceneFile, name: &str) -> Result<SceneFile> {
        let folder = naming.inside().split_last().map_or(&[][..], |(_, folder)| folder);
        self.find_under(folder, name)
    }

    /// Reads the whole of a file that the scene names, at most `cap` bytes of it.
    ///
    /// # Errors
    /// As [`SceneFolder::find`]; [`ErrorKind::Limit`] if it is larger than `cap` or than the budget has left.
    pub fn open(&self, name: &str, cap: u64, budget: &mut Budget) -> Result<Vec<u8>> {
        match self.find(name)? {
            Found::File(file) => file.read(cap, budget),
            Found::BuiltIn(model) => Ok(model.bytes.to_vec()),
        }
    }

    fn find_under(&self, folder: &[String], name: &str) -> Result<SceneFile> {
        let refuse = |fault: NameFault| {
            Error::new(ErrorKind::Forbidden, self.shown.join(name.replace('\0', "\u{fffd}")), fault.text(name))
                .hint(fault.hint())
        };
        let inside = components_of(folder, name).map_err(refuse)?;
        let relative: PathBuf = inside.iter().collect();
        let shown = self.shown.join(&relative);
        let Some(root) = &self.root else {
            return Err(Error::new(ErrorKind::Forbidden, shown, "no such file")
                .hint("the scenes inside the program have only the built-in models"));
        };
        let path = std::fs::canonicalize(root.join(&relative)).map_err(|e| {
            Error::new(ErrorKind::Forbidden, shown.clone(), file::words_of(&e))
                .hint("paths are relative to the file that names them")
        })?;
        // The words were checked above; this catches symbolic links that lead out.
        if !path.starts_with(root) {
            return Err(refuse(NameFault::Outside));
        }
        SceneFile::in_folder(path, shown, inside)
    }
}
