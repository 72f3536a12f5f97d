//! Whether a file will be writable, asked before the work that would be lost if it is not.

use crate::atomic_save::STDOUT;
use crate::error::{Error, ErrorKind, Result};
use std::fs::{self, OpenOptions};
use std::io;
use std::path::Path;

/// Tries what can be tried without touching the file itself.
///
/// # Errors
/// `Output`, with the path and what to do.
pub fn check_writable(path: &Path) -> Result<()> {
    if path.as_os_str() == STDOUT {
        return Ok(());
    }
    let refused = |text: String| Error::new(ErrorKind::Output, path, text);
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    match fs::metadata(folder) {
        Ok(folder) if folder.is_dir() => {}
        Ok(_) => return Err(refused(format!("{} is a file, not a folder", folder.display()))),
        Err(e) if e.kind() == io::ErrorKind::NotFound => {
            let text = format!("there is no folder {}", folder.display());
            return Err(refused(text).hint(format!("make it first: mkdir -p {}", folder.display())));
        }
        Err(e) => return Err(refused(format!("{} cannot be entered: {e}", folder.display()))),
    }
    match fs::metadata(path) {
        Ok(old) if old.is_dir() => return Err(refused("is a folder".to_owned()).hint("name a file in it")),
        Ok(old) if old.permissions().readonly() => return Err(refused("is read-only".to_owned())),
        // Written to directly: there is nothing to try beforehand.
        Ok(old) if !old.is_file() => return Ok(()),
        Ok(_) => {}
        Err(e) if e.kind() == io::ErrorKind::NotFound => {}
        Err(e) => return Err(refused(format!("cannot be written: {e}"))),
    }
    probe(folder).map_err(|e| refused(format!("cannot be written: {e}")).hint("write to a folder that is yours"))
}

/// Makes a file in the folder and removes it again: permissions, a full table, a read-only disk all show.
fn probe(folder: &Path) -> io::Result<()> {
    let path = folder.join(format!(".luch.tmp-{}-probe", std::process::id()));
    OpenOptions::new().write(true).create_new(true).open(&path)?;
    fs::remove_file(&path)
}
