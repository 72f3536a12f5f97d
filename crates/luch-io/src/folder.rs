//! What lies in a folder, for people who look for a file.

use crate::error::{Error, ErrorKind, Result};
use std::ffi::{OsStr, OsString};
use std::fs::DirEntry;
use std::path::Path;

/// A file or folder of a folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// Its name as the system has it: it need not be UTF-8.
    pub name: OsString,
    /// Whether it is a folder, or a link to one.
    pub is_folder: bool,
}

/// The most entries that are answered: more than anybody reads through.
const MOST: usize = 20_000;

/// The folders in `folder`, and its files with one of these endings (in small letters, without the dot): folders first,
/// each sorted by name. Hidden ones are left out, and so is what comes after very many.
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
    let listed = std::fs::read_dir(shown).map_err(|e| refused(&e))?;
    // One that vanished meanwhile is not there. What is left out does not count: it may be all that comes first.
    let mut found: Vec<_> = listed.filter_map(|entry| entry_of(&entry.ok()?, endings)).take(MOST).collect();
    found.sort_by_cached_key(|entry| {
        (!entry.is_folder, entry.name.to_string_lossy().to_lowercase(), entry.name.clone())
    });
    Ok(found)
}

/// What is shown of an entry, if anything is.
fn entry_of(entry: &DirEntry, endings: &[&str]) -> Option<Entry> {
    let name = entry.file_name();
    if name.as_encoded_bytes().starts_with(b".") {
        return None;
    }
    let fits = has_ending(&name, endings);
    // Only a link must be followed, which takes the system far longer than to name the kind of an entry.
    let is_folder = match entry.file_type() {
        Ok(kind) if !kind.is_symlink() => kind.is_dir(),
        _ => entry.path().is_dir(),
    };
    (is_folder || fits).then_some(Entry { name, is_folder })
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
    fn scenes_are_found_among_more_files_than_are_answered() {
        let folder = std::env::temp_dir().join(format!("luch-io-folder-{}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        // In which order the system lists them is its own business: of many scenes some come late.
        let scenes: Vec<_> = (0..200).map(|number| OsString::from(format!("scene-{number:03}.toml"))).collect();
        for (number, scene) in scenes.iter().enumerate() {
            for file in 0..=MOST / 200 {
                std::fs::write(folder.join(format!("{number}-{file}.txt")), "").unwrap();
            }
            std::fs::write(folder.join(scene), "").unwrap();
        }
        let found = entries(&folder, &["toml"]);
        std::fs::remove_dir_all(&folder).unwrap();
        let found: Vec<_> = found.unwrap().into_iter().map(|entry| entry.name).collect();
        assert!(found == scenes, "{} of {} scenes", found.len(), scenes.len());
    }

    #[test]
    fn what_is_no_folder_is_told() {
        for (folder, told) in [("nowhere", "there is no such folder"), ("Cargo.toml", "is no folder")] {
            let error = entries(Path::new(folder), &[]).unwrap_err();
            assert_eq!((error.text.as_str(), error.exit_code()), (told, 4));
        }
    }
}
