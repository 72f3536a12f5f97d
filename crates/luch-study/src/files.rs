//! The files of a study: report, table, data and plots, written together.

use crate::chart::{Chart, charts, stems};
use crate::csv::csv;
use crate::draw;
use crate::findings::Findings;
use crate::json::to_json;
use crate::language::Language;
use crate::plan::Kind;
use crate::report::markdown;
use luch_io::atomic_save::save;
use luch_io::{Error, ErrorKind};
use std::io;
use std::path::{Path, PathBuf};

/// A file and what is to be in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StudyFile {
    /// Its name, without a folder.
    pub name: String,
    /// Its content.
    pub content: Vec<u8>,
}

/// The names of all files that a study of a kind may have.
#[must_use]
pub fn names(kind: Kind) -> Vec<String> {
    let plots = stems(kind).iter().flat_map(|stem| [format!("{stem}.svg"), format!("{stem}.png")]);
    ["study.md", "study.csv", "study.json"].map(str::to_owned).into_iter().chain(plots).collect()
}

/// The files of a study: `study.md`, `study.csv`, `study.json`, and each plot as SVG and PNG.
///
/// # Errors
/// None that is known of: what a drawing or JSON is made from is plain numbers.
pub fn files(findings: &Findings, language: Language) -> Result<Vec<StudyFile>, String> {
    let charts = charts(findings, language);
    let plots: Vec<(String, String)> = charts.iter().map(|c| (c.stem.to_owned(), c.title.clone())).collect();
    let file = |name: &str, content: Vec<u8>| StudyFile { name: name.to_owned(), content };
    let mut files = vec![
        file("study.md", markdown(findings, &plots, language).into_bytes()),
        file("study.csv", csv(findings).into_bytes()),
        file("study.json", to_json(findings).map_err(|e| e.to_string())?.into_bytes()),
    ];
    for chart @ Chart { stem, .. } in &charts {
        files.push(file(&format!("{stem}.svg"), draw::svg(chart).into_bytes()));
        files.push(file(&format!("{stem}.png"), draw::png(chart)?));
    }
    Ok(files)
}

/// Writes all files into a folder that exists. Each appears whole or not at all, and none does before the content of
/// all is on the disk: a full disk leaves the older files as they were.
///
/// # Errors
/// `Output`, with the path of the file that cannot be written.
pub fn write(folder: &Path, files: &[StudyFile]) -> luch_io::Result<()> {
    let Some((first, others)) = files.split_first() else { return Ok(()) };
    let path: PathBuf = folder.join(&first.name);
    let mut failure = None;
    let saved = save(&path, |file| {
        file.write_all(&first.content)?;
        file.flush()?;
        // The others are written before this one gets its name.
        write(folder, others).map_err(|error| {
            failure = Some(error);
            io::Error::other("another file cannot be written")
        })
    });
    match failure {
        Some(failure) => Err(failure),
        None => saved,
    }
}

/// Makes the folder that a study is to be written to; answers whether it was made now.
///
/// # Errors
/// `Output` if it is a file, or cannot be made.
pub fn make_folder(folder: &Path) -> luch_io::Result<bool> {
    let refused = |text: String| Error::new(ErrorKind::Output, folder, text);
    match std::fs::metadata(folder) {
        Ok(there) if there.is_dir() => Ok(false),
        Ok(_) => Err(refused("is a file, and a study is written to a folder".to_owned()).hint("name a folder")),
        Err(e) if e.kind() == io::ErrorKind::NotFound => {
            std::fs::create_dir_all(folder).map_err(|e| refused(format!("the folder cannot be made: {e}")))?;
            Ok(true)
        }
        Err(e) => Err(refused(format!("cannot be entered: {e}"))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    fn folder(name: &str) -> PathBuf {
        std::env::temp_dir().join(format!("luch-study-{}-{name}", std::process::id()))
    }

    #[test]
    fn a_study_is_written_whole() {
        let folder = folder("whole");
        assert!(make_folder(&folder.join("deep")).unwrap());
        assert!(!make_folder(&folder).unwrap());
        let files = files(&Findings::of(&samples::threads()), Language::Russian).unwrap();
        let written: Vec<&str> = files.iter().map(|f| f.name.as_str()).collect();
        assert_eq!(written, names(Kind::Threads));
        for name in [
            "study.md",
            "study.csv",
            "study.json",
            "threads-all.svg",
            "threads-all.png",
            "threads-from-2.svg",
            "threads-from-2.png",
        ] {
            assert!(written.contains(&name), "{name}");
        }
        write(&folder, &files).unwrap();
        for file in &files {
            assert_eq!(std::fs::read(folder.join(&file.name)).unwrap(), file.content, "{}", file.name);
        }
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn one_that_cannot_be_written_leaves_all_others_as_they_were() {
        let folder = folder("refused");
        std::fs::create_dir_all(folder.join("study.json")).unwrap();
        std::fs::write(folder.join("study.md"), "old").unwrap();
        let files = files(&Findings::of(&samples::tiles()), Language::English).unwrap();
        let error = write(&folder, &files).unwrap_err();
        assert!(error.to_string().contains("study.json"), "{error}");
        assert_eq!(std::fs::read(folder.join("study.md")).unwrap(), b"old");
        let names = std::fs::read_dir(&folder).unwrap().count();
        assert_eq!(names, 2, "nothing else is left");
        std::fs::remove_dir_all(&folder).unwrap();
    }

    #[test]
    fn a_file_is_no_folder() {
        let file = folder("file");
        std::fs::write(&file, "").unwrap();
        assert!(make_folder(&file).unwrap_err().to_string().contains("is a file"));
        std::fs::remove_file(&file).unwrap();
    }
}
