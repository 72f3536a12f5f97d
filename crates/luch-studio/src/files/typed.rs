//! A path as it is typed: what it means, which folder it looks into, what it may become.
//!
//! A field holds text, and a path need not be text. So the folder that was last chosen is kept as the system has it,
//! and what is typed behind it is added to that.

use crate::notices::drawable;
use luch_io::folder::Entry;
use std::ffi::OsStr;
use std::path::{MAIN_SEPARATOR, Path, PathBuf};

/// What stands in a path field.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(crate) struct TypedPath {
    /// What is seen.
    pub(crate) text: String,
    /// The folder whose name the text begins with, unless somebody has typed over it.
    base: PathBuf,
    /// The last part as the system has it, as long as the text is this.
    whole: Option<(String, PathBuf)>,
    /// Whether something was typed since the folder was chosen.
    pub(crate) edited: bool,
}

impl TypedPath {
    /// A file of a folder; without a name, the folder itself.
    pub(crate) fn new(folder: &Path, name: &str) -> Self {
        let text = format!("{}{name}", shown_folder(folder));
        Self { text, base: folder.to_owned(), whole: None, edited: false }
    }

    /// What the text means; `home` stands for a `~` at its head.
    pub(crate) fn path(&self, home: Option<&Path>) -> PathBuf {
        if let Some((text, path)) = &self.whole
            && *text == self.text
        {
            return path.clone();
        }
        let base = shown_folder(&self.base);
        if let Some(rest) = self.text.strip_prefix(&base)
            && !base.is_empty()
        {
            return self.base.join(rest);
        }
        match (self.text.strip_prefix('~'), home) {
            (Some(""), Some(home)) => home.to_owned(),
            (Some(rest), Some(home)) if rest.starts_with(is_separator) => {
                home.join(rest.trim_start_matches(is_separator))
            }
            _ => PathBuf::from(&self.text),
        }
    }

    /// The folder that the text looks into.
    pub(crate) fn folder(&self, home: Option<&Path>) -> PathBuf {
        let path = self.path(home);
        if self.text.is_empty() || self.text.ends_with(is_separator) || self.text == "~" {
            return path;
        }
        path.parent().map(Path::to_owned).unwrap_or(path)
    }

    /// What is typed behind the folder.
    fn beginning(&self) -> &str {
        self.text.rsplit(is_separator).next().unwrap_or_default()
    }

    /// The entries that the text may become: all of the folder until something is typed, then those that begin so, then
    /// those that have it in their name.
    pub(crate) fn matches<'a>(&self, entries: &'a [Entry]) -> Vec<&'a Entry> {
        let typed = self.beginning().to_lowercase();
        if !self.edited || typed.is_empty() || self.text == "~" {
            return entries.iter().collect();
        }
        let name = |entry: &Entry| shown(&entry.name).to_lowercase();
        let (begin, rest): (Vec<_>, Vec<_>) = entries.iter().partition(|entry| name(entry).starts_with(&typed));
        begin.into_iter().chain(rest.into_iter().filter(|entry| name(entry).contains(&typed))).collect()
    }

    /// Takes an entry of the folder. A folder is entered.
    pub(crate) fn take(&mut self, name: &OsStr, is_folder: bool, home: Option<&Path>) {
        let folder = self.folder(home);
        let path = folder.join(name);
        if is_folder {
            *self = Self::new(&path, "");
        } else {
            *self = Self::of_file(&path);
        }
    }

    /// The path of a file as the system has it.
    pub(crate) fn of_file(path: &Path) -> Self {
        let folder = path.parent().unwrap_or(Path::new(""));
        let name = shown(path.file_name().unwrap_or_default());
        let typed = Self::new(folder, &name);
        Self { whole: Some((typed.text.clone(), path.to_owned())), ..typed }
    }

    /// Gives the file another ending.
    pub(crate) fn set_ending(&mut self, ending: &str) {
        let name = self.text.rsplit(is_separator).next().unwrap_or_default();
        let stem = name.rfind('.').filter(|&at| at > 0).and_then(|at| name.get(..at)).unwrap_or(name);
        if !stem.is_empty() {
            let folder = self.text.get(..self.text.len() - name.len()).unwrap_or_default();
            self.text = format!("{folder}{stem}.{ending}");
        }
    }

    /// Goes to the folder above.
    pub(crate) fn leave(&mut self, home: Option<&Path>) {
        let folder = self.folder(home);
        if let Some(above) = folder.parent().filter(|above| !above.as_os_str().is_empty()) {
            *self = Self::new(above, "");
        }
    }
}

/// The folder as text, with a separator at its end.
fn shown_folder(folder: &Path) -> String {
    let mut text = shown(folder.as_os_str());
    if !text.is_empty() && !text.ends_with(is_separator) {
        text.push(MAIN_SEPARATOR);
    }
    text
}

/// A name as it can be drawn.
pub(crate) fn shown(name: &OsStr) -> String {
    drawable(&name.to_string_lossy())
}

fn is_separator(c: char) -> bool {
    std::path::is_separator(c)
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::os::unix::ffi::OsStrExt;

    fn entry(name: &str, is_folder: bool) -> Entry {
        Entry { name: name.into(), is_folder }
    }

    fn typed(text: &str) -> TypedPath {
        TypedPath { text: text.to_owned(), edited: true, ..TypedPath::default() }
    }

    #[test]
    fn a_text_means_a_path_and_looks_into_a_folder() {
        let home = Some(Path::new("/home/ann"));
        for (text, path, folder) in [
            ("/a/b.toml", "/a/b.toml", "/a"),
            ("/a/", "/a/", "/a/"),
            ("~", "/home/ann", "/home/ann"),
            ("~/s.toml", "/home/ann/s.toml", "/home/ann"),
            ("~ann/s", "~ann/s", "~ann"),
            ("s.toml", "s.toml", ""),
            ("", "", ""),
            ("/", "/", "/"),
        ] {
            assert_eq!(typed(text).path(home), Path::new(path), "{text}");
            assert_eq!(typed(text).folder(home), Path::new(folder), "{text}");
        }
    }

    #[test]
    fn folders_whose_names_are_no_text_can_be_entered_and_typed_in() {
        let odd = OsStr::from_bytes(b"caf\xe9");
        let mut path = TypedPath::new(Path::new("/a"), "");
        path.take(odd, true, None);
        assert_eq!(path.text, "/a/caf?/");
        path.text.push_str("s.toml");
        path.edited = true;
        assert_eq!(path.path(None), Path::new("/a").join(odd).join("s.toml"));
        assert_eq!(path.folder(None), Path::new("/a").join(odd));
        path.take(odd, false, None);
        assert_eq!(path.path(None), Path::new("/a").join(odd).join(odd));
        path.leave(None);
        assert_eq!(path.path(None), Path::new("/a"));
        path.leave(None);
        path.leave(None);
        assert_eq!(path.text, "/");
    }

    #[test]
    fn a_file_gets_another_ending() {
        for (text, other) in [("/a.b/c.png", "/a.b/c.exr"), ("/a.b/c", "/a.b/c.exr"), ("/a.b/", "/a.b/"), ("", "")] {
            let mut path = typed(text);
            path.set_ending("exr");
            assert_eq!(path.text, other);
        }
    }

    #[test]
    fn what_begins_so_comes_before_what_has_it_in_its_name() {
        let entries = [entry("Models", true), entry("a knight.toml", false), entry("knight.toml", false)];
        let names = |path: &TypedPath| path.matches(&entries).iter().map(|e| e.name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&typed("/a/KNI")), ["knight.toml", "a knight.toml"]);
        assert_eq!(names(&typed("/a/m")), ["Models", "a knight.toml", "knight.toml"]);
        assert!(names(&typed("/a/x")).is_empty());
        assert_eq!(names(&TypedPath::new(Path::new("/a"), "Scene.toml")).len(), 3);
    }
}
