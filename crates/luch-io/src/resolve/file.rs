//! A file that was found behind the fence: checked before it is opened and again after.

use crate::budget::{Budget, human_bytes};
use crate::error::{Error, ErrorKind, Result};
use std::fs::{File, Metadata};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// The largest model file: 4 GiB.
pub const MAX_MESH_BYTES: u64 = 4 << 30;
/// The largest text file (scene, material library): 256 MiB.
pub const MAX_TEXT_BYTES: u64 = 256 << 20;

/// A regular file, found but not yet read.
#[derive(Debug, Clone)]
pub struct SceneFile {
    path: PathBuf,
    shown: PathBuf,
    inside: Vec<String>,
    bytes: u64,
    modified: Option<SystemTime>,
}

impl SceneFile {
    /// A file that the user named, on the command line or in a dialog: it may lie anywhere.
    ///
    /// # Errors
    /// [`ErrorKind::Forbidden`] if there is no such file, or if it is a folder, a pipe or a device.
    pub fn of_user(shown: &Path) -> Result<Self> {
        let path = std::fs::canonicalize(shown).map_err(|e| Error::new(ErrorKind::Forbidden, shown, words_of(&e)))?;
        let name = shown.file_name().map(|name| name.to_string_lossy().into_owned());
        Self::in_folder(path, shown.to_owned(), name.into_iter().collect())
    }

    /// A file at a path without symbolic links, which the caller found to lie behind the fence.
    pub(super) fn in_folder(path: PathBuf, shown: PathBuf, inside: Vec<String>) -> Result<Self> {
        let metadata = std::fs::metadata(&path).map_err(|e| Error::new(ErrorKind::Forbidden, &shown, words_of(&e)))?;
        check_regular(&metadata, &shown)?;
        Ok(Self { path, shown, inside, bytes: metadata.len(), modified: metadata.modified().ok() })
    }

    /// The path without symbolic links: what tells one file from another.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The path as the user would write it: for messages.
    #[must_use]
    pub fn shown(&self) -> &Path {
        &self.shown
    }

    /// Size in bytes when it was found.
    #[must_use]
    pub const fn bytes(&self) -> u64 {
        self.bytes
    }

    /// When it was last changed, where the system knows.
    #[must_use]
    pub const fn modified(&self) -> Option<SystemTime> {
        self.modified
    }

    /// Folders and file name below the fence.
    pub(crate) fn inside(&self) -> &[String] {
        &self.inside
    }

    /// Reads it whole. The list's capacity is charged to the budget and stays charged.
    ///
    /// # Errors
    /// [`ErrorKind::Limit`] if it is larger than `cap` bytes or than the budget has left, [`ErrorKind::Forbidden`] if it
    /// cannot be read, [`ErrorKind::Cancelled`] if the user asked to stop.
    pub fn read(&self, cap: u64, budget: &mut Budget) -> Result<Vec<u8>> {
        self.check_size(self.bytes, cap)?;
        let forbidden = |e: &std::io::Error| Error::new(ErrorKind::Forbidden, &self.shown, words_of(e));
        let mut file = open_without_waiting(&self.path).map_err(|e| forbidden(&e))?;
        let metadata = file.metadata().map_err(|e| forbidden(&e))?;
        check_regular(&metadata, &self.shown)?;
        // One byte more, so that the last read finds the end and does not enlarge the list.
        let expected = usize::try_from(metadata.len().min(cap)).unwrap_or(usize::MAX).saturating_add(1);
        let mut bytes = Vec::new();
        budget.reserve(&mut bytes, expected, "the file").map_err(|over| over.in_file(&self.shown))?;
        loop {
            budget.check_cancelled(&self.shown)?;
            let read = file.by_ref().take(READ_BYTES).read_to_end(&mut bytes).map_err(|e| forbidden(&e))?;
            self.check_size(u64::try_from(bytes.len()).unwrap_or(u64::MAX), cap)?;
            if read == 0 {
                return Ok(bytes);
            }
            // Only a file that grew while it was read comes here without room.
            let room = usize::try_from(READ_BYTES).unwrap_or(usize::MAX);
            if bytes.len() == bytes.capacity() {
                budget.reserve(&mut bytes, room, "the file").map_err(|over| over.in_file(&self.shown))?;
            }
        }
    }

    fn check_size(&self, bytes: u64, cap: u64) -> Result<()> {
        if bytes <= cap {
            return Ok(());
        }
        let text = format!("has {}, the limit is {}", human_bytes(bytes), human_bytes(cap));
        Err(Error::new(ErrorKind::Limit, &self.shown, text))
    }
}

/// How much is read between two looks at the cancel flag.
const READ_BYTES: u64 = 16 << 20;

/// A pipe or a device would be waited for, or would never end: only regular files are opened.
fn check_regular(metadata: &Metadata, shown: &Path) -> Result<()> {
    if metadata.is_file() {
        return Ok(());
    }
    let what = if metadata.is_dir() { "is a folder, not a file" } else { "is a pipe or a device, not a regular file" };
    Err(Error::new(ErrorKind::Forbidden, shown, what))
}

/// Opens for reading. Should the file have become a pipe since it was looked at, the call does not wait for a writer.
fn open_without_waiting(path: &Path) -> std::io::Result<File> {
    let mut options = File::options();
    options.read(true);
    #[cfg(any(target_os = "linux", target_os = "android"))]
    {
        use std::os::unix::fs::OpenOptionsExt;
        const O_NONBLOCK: i32 = 0o4000;
        options.custom_flags(O_NONBLOCK);
    }
    options.open(path)
}

/// What the system says, in our words where they are clearer.
pub(super) fn words_of(error: &std::io::Error) -> String {
    use std::io::ErrorKind as Io;
    match error.kind() {
        Io::NotFound => "no such file".to_owned(),
        Io::PermissionDenied => "may not be read: permission denied".to_owned(),
        Io::NotADirectory => "no such file: a part of the path is no folder".to_owned(),
        Io::InvalidFilename => "no such file: the name is too long".to_owned(),
        _ if error.to_string().contains("symbolic link") => "a loop of symbolic links".to_owned(),
        _ => error.to_string(),
    }
}
