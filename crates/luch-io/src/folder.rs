//! What lies in a folder, for people who look for a file.

use crate::error::{Error, ErrorKind, Result};
use std::ffi::{OsStr, OsString};
use std::path::Path;

/// A file or folder of a folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// Its name as the system has it: it need not be UTF-8.
    pub name: OsString,
    /// Whether it is a folder, or a link to one.
    pub is_folder: bool,
}

/// The most entries that are looked at: more than anybody reads through.
const MOST: usize = 20_000;

/// The folders in `folder`, and its files with one of these endings (in small letters, without the dot): folders first,
/// each sorted by name. Hidden ones are left out.
///
/// # Errors
/// `Forbidden` if there is no such folder or it may not be read.
pub fn entries(folder: &Path, endings: &[&str]) -> Result<Vec<Entry>> {
    let shown = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let refused = |error: &std::io::Error| {
        use std::io::ErrorKind as Io;
        let text = match error.kind() {
            Io::NotFound => "there is no such folder".to_owned(),
            Io::PermissionDenied => "the folder may not be read".to_owned(),
            Io::NotADirectory => "is no folder".to_owned(),
            _ => error.to_string(),
        };
        Error::new(ErrorKind::Forbidden, shown, text)
    };
    let mut found = Vec::new();
    for entry in std::fs::read_dir(shown).map_err(|e| refused(&e))?.take(MOST) {
        // One that vanished meanwhile is not there.
        let Ok(entry) = entry else { continue };
        let name = entry.file_name();
        if name.as_encoded_bytes().starts_with(b".") {
            continue;
        }
        let is_folder = entry.path().is_dir();
        if is_folder || has_ending(&name, endings) {
            found.push(Entry { name, is_folder });
        }
    }
    found.sort_by_cached_key(|entry| {
        (!entry.is_folder, entry.name.to_string_lossy().to_lowercase(), entry.name.clone())
    });
    Ok(found)
}

fn has_ending(name: &OsStr, endings: &[&str]) -> bool {
    let ending = Path::new(name).extension().map(|e| e.to_string_lossy().to_lowercase());
    ending.is_some_and(|ending| endings.contains(&ending.as_str()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_come_first_and_files_have_the_ending() {
        let all = entries(Path::new("src"), &["rs"]).unwrap();
        let first_file = all.iter().position(|entry| !entry.is_folder).unwrap();
        assert!(all[..first_file].iter().any(|entry| entry.name == "obj"));
        assert!(
            all[first_file..].iter().all(|entry| !entry.is_folder && entry.name.to_string_lossy().ends_with(".rs"))
        );
        assert!(entries(Path::new("src"), &["toml"]).unwrap().iter().all(|entry| entry.is_folder));
        assert!(entries(Path::new(""), &["toml"]).unwrap().iter().any(|entry| entry.name == "Cargo.toml"));
    }

    #[test]
    fn what_is_no_folder_is_told() {
        for (folder, told) in [("nowhere", "there is no such folder"), ("Cargo.toml", "is no folder")] {
            let error = entries(Path::new(folder), &[]).unwrap_err();
            assert_eq!((error.text.as_str(), error.exit_code()), (told, 4));
        }
    }
}
