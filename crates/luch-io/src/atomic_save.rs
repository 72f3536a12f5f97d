//! Saves a file so that its name holds either the old content or the new, at every moment and after a power cut.
//!
//! The new content is written to a file of its own in the same folder, flushed to the disk, and then renamed over the
//! name: a rename within a folder happens whole or not at all. What goes wrong before the rename leaves the old file
//! as it was and the new one removed. Only `kill -9` can leave a file called `.name.tmp-<process>-<n>`.
//!
//! - A symbolic link is written through: the file that it points to is replaced, the link stays.
//! - A file keeps its permissions; it gets the user's ownership. A read-only file is refused, not replaced.
//! - A pipe or device (`/dev/null`, `/dev/stdout`) is written to directly, for it must not be replaced.
//! - The path `-` is the standard output.

use crate::error::{Error, ErrorKind, Result};
use std::ffi::{OsStr, OsString};
use std::fs::{self, File, OpenOptions, Permissions};
use std::io::{self, BufWriter, Cursor, Seek, Write};
use std::path::{Path, PathBuf};

/// Where content is written: some formats come back to fill in what they did not know before.
pub trait Sink: Write + Seek {}
impl<T: Write + Seek> Sink for T {}

/// The path that means the standard output.
pub const STDOUT: &str = "-";

/// Bytes gathered before they go to the file.
const BUFFER: usize = 256 << 10;

/// Puts what `write` writes into the file `path`, whole or not at all.
///
/// # Errors
/// `Output`, with the path and the reason, if the folder is missing or read-only, the disk full, or `write` fails; the
/// old file is then untouched.
pub fn save(path: &Path, write: impl FnOnce(&mut dyn Sink) -> io::Result<()>) -> Result<()> {
    match Target::of(path)? {
        Target::Stdout => stream(write, &mut io::stdout().lock()).map_err(|e| failed(path, &e)),
        Target::Stream => {
            let file = OpenOptions::new().write(true).open(path);
            file.and_then(|mut file| stream(write, &mut file)).map_err(|e| failed(path, &e))
        }
        Target::File { path: file, permissions } => replace(&file, permissions, write).map_err(|e| failed(path, &e)),
    }
}

/// What a path leads to.
enum Target {
    Stdout,
    /// A pipe or device.
    Stream,
    /// A file, or nothing yet.
    File {
        path: PathBuf,
        permissions: Option<Permissions>,
    },
}

impl Target {
    fn of(path: &Path) -> Result<Self> {
        if path.as_os_str() == STDOUT {
            return Ok(Self::Stdout);
        }
        let refused = |text: String| Err(Error::new(ErrorKind::Output, path, text));
        let file = followed(path).map_err(|e| failed(path, &e))?;
        let permissions = match fs::metadata(&file) {
            Ok(old) if old.is_dir() => return refused("is a folder, and cannot be written as a file".into()),
            Ok(old) if !old.is_file() => return Ok(Self::Stream),
            Ok(old) if old.permissions().readonly() => return refused("is read-only, and was left as it is".into()),
            Ok(old) => Some(old.permissions()),
            Err(e) if e.kind() == io::ErrorKind::NotFound => None,
            Err(e) => return Err(failed(path, &e)),
        };
        if file.file_name().is_none() {
            return refused("has no file name".into());
        }
        let folder = folder_of(&file);
        if !folder.is_dir() {
            let error = Error::new(ErrorKind::Output, path, format!("there is no folder {}", folder.display()));
            return Err(error.hint("make the folder first"));
        }
        Ok(Self::File { path: file, permissions })
    }
}

/// The path behind symbolic links, of which the last may point to nothing yet.
fn followed(path: &Path) -> io::Result<PathBuf> {
    // As many as Linux follows.
    const MOST: usize = 40;
    let mut path = path.to_owned();
    for _ in 0..MOST {
        match fs::read_link(&path) {
            // `join` of an absolute path is that path.
            Ok(to) => path = folder_of(&path).join(to),
            // Not a link, or nothing there.
            Err(_) => return Ok(path),
        }
    }
    Err(io::Error::other("a loop of symbolic links"))
}

fn folder_of(file: &Path) -> &Path {
    match file.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Writes to something that cannot be gone back in: all at once, from memory.
fn stream(write: impl FnOnce(&mut dyn Sink) -> io::Result<()>, to: &mut dyn Write) -> io::Result<()> {
    let mut content = Cursor::new(Vec::new());
    write(&mut content)?;
    to.write_all(content.get_ref())?;
    to.flush()
}

/// Writes the new content beside the old and renames it over.
fn replace(
    path: &Path,
    permissions: Option<Permissions>,
    write: impl FnOnce(&mut dyn Sink) -> io::Result<()>,
) -> io::Result<()> {
    let (temporary, file) = Temporary::create(path)?;
    let mut buffered = BufWriter::with_capacity(BUFFER, file);
    write(&mut buffered)?;
    let file = buffered.into_inner().map_err(io::IntoInnerError::into_error)?;
    if let Some(permissions) = permissions {
        file.set_permissions(permissions)?;
    }
    // Before the rename: a name that points to content still in memory is what a power cut makes an empty file of.
    file.sync_all()?;
    // Closed first: Windows does not rename open files.
    drop(file);
    temporary.rename_to(path)?;
    sync_folder(folder_of(path))
}

/// Makes the rename last. A file system that cannot do this for folders is taken as it is.
fn sync_folder(folder: &Path) -> io::Result<()> {
    if !cfg!(unix) {
        return Ok(());
    }
    match File::open(folder).and_then(|f| f.sync_all()) {
        // A folder that may be written but not read cannot be opened; the file itself is safe already.
        Err(e) if [io::ErrorKind::PermissionDenied, io::ErrorKind::InvalidInput].contains(&e.kind()) => Ok(()),
        Err(e) if e.kind() == io::ErrorKind::Unsupported => Ok(()),
        result => result,
    }
}

/// A file that is removed unless it gets its final name; also when `write` panics.
struct Temporary {
    path: Option<PathBuf>,
}

impl Temporary {
    /// Creates `.name.tmp-<process>-<n>` beside `path`, with the first n that is free.
    fn create(path: &Path) -> io::Result<(Self, File)> {
        const MOST: u32 = 1_000;
        let name = path.file_name().unwrap_or_default();
        for n in 0..MOST {
            let temporary = path.with_file_name(temporary_name(name, n));
            match OpenOptions::new().write(true).create_new(true).open(&temporary) {
                Ok(file) => return Ok((Self { path: Some(temporary) }, file)),
                Err(e) if e.kind() == io::ErrorKind::AlreadyExists => {}
                Err(e) => return Err(e),
            }
        }
        Err(io::Error::other("too many temporary files of an earlier save are in the folder"))
    }

    fn rename_to(mut self, path: &Path) -> io::Result<()> {
        if let Some(temporary) = &self.path {
            fs::rename(temporary, path)?;
        }
        self.path = None;
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if let Some(path) = &self.path {
            // There is nobody to tell, and the error that led here is the one that matters.
            let _ = fs::remove_file(path);
        }
    }
}

fn temporary_name(name: &OsStr, n: u32) -> OsString {
    // File systems take names of 255 bytes: a long one leaves no room for the rest, and need not be repeated.
    const LONG: usize = 200;
    let mut temporary = OsString::from(".");
    temporary.push(if name.len() > LONG { OsStr::new("luch") } else { name });
    temporary.push(format!(".tmp-{}-{n}", std::process::id()));
    temporary
}

fn failed(path: &Path, error: &io::Error) -> Error {
    use io::ErrorKind as Io;
    let (reason, hint) = match error.kind() {
        Io::StorageFull => ("the disk is full", Some("free some space, or write to another disk")),
        Io::QuotaExceeded => ("the disk quota is used up", None),
        Io::ReadOnlyFilesystem => ("the disk is read-only", Some("write to another folder")),
        Io::PermissionDenied => ("permission denied", Some("write to a folder that is yours")),
        Io::InvalidFilename => ("the name is too long", None),
        Io::NotADirectory => ("a part of the path is no folder", None),
        Io::BrokenPipe => ("nobody reads it any more", None),
        _ => ("", None),
    };
    let text =
        if reason.is_empty() { format!("cannot be written: {error}") } else { format!("cannot be written: {reason}") };
    let error = Error::new(ErrorKind::Output, path, text);
    match hint {
        Some(hint) => error.hint(hint),
        None => error,
    }
}
