//! The comments at the head of a scene that was kept safe: what the scene file itself cannot say.
//!
//! ```text
//! # luch-recovery name Two%20spheres
//! # luch-recovery file /home/ann/scene.toml
//! # luch-recovery model ../models/tree.obj 2 /home/ann/models/tree.obj
//! ```

use crate::builtin;
use crate::load::SceneSource;
use crate::path_text::{decode_path, encode_path};
use std::fmt;
use std::path::{Path, PathBuf};

const MARK: &str = "# luch-recovery ";

/// What the head of the file says.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub(super) struct Header {
    pub(super) name: String,
    pub(super) source: Option<SceneSource>,
    pub(super) models: Vec<ModelPlace>,
}

/// Where a model of the scene lies.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct ModelPlace {
    /// The path by which the scene names it.
    pub(super) name: String,
    /// Its file.
    pub(super) file: PathBuf,
    /// How many names of the file's path lie in the folder that its libraries may lie in, its own included.
    pub(super) depth: usize,
}

impl fmt::Display for Header {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let word = |text: &str| encode_path(Path::new(text));
        writeln!(f, "{MARK}name {}", word(&self.name))?;
        match &self.source {
            None => {}
            Some(SceneSource::BuiltIn(id)) => writeln!(f, "{MARK}built-in {id}")?,
            Some(SceneSource::File(path)) => writeln!(f, "{MARK}file {}", encode_path(path))?,
            Some(SceneSource::Model(path)) => writeln!(f, "{MARK}bare-model {}", encode_path(path))?,
        }
        for ModelPlace { name, file, depth } in &self.models {
            writeln!(f, "{MARK}model {} {depth} {}", word(name), encode_path(file))?;
        }
        Ok(())
    }
}

impl Header {
    /// Reads the comments at the head of a text. What is not understood is left out: the scene itself is what counts.
    pub(super) fn of(text: &str) -> Self {
        let mut header = Self::default();
        for line in text.lines().map_while(|line| line.strip_prefix(MARK)) {
            let words: Vec<&str> = line.split(' ').collect();
            let word = |text: &str| decode_path(text).and_then(|path| path.to_str().map(str::to_owned));
            match words.as_slice() {
                ["name", name] => header.name = word(name).unwrap_or_default(),
                ["built-in", id] => header.source = builtin::ids().find(|known| known == id).map(SceneSource::BuiltIn),
                ["file", path] => header.source = decode_path(path).map(SceneSource::File),
                ["bare-model", path] => header.source = decode_path(path).map(SceneSource::Model),
                ["model", name, depth, file] => {
                    if let (Some(name), Ok(depth), Some(file)) = (word(name), depth.parse(), decode_path(file)) {
                        header.models.push(ModelPlace { name, file, depth });
                    }
                }
                _ => {}
            }
        }
        header
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_header_is_read_back() {
        let place = |name: &str| ModelPlace { name: name.into(), file: "/ä b/c.obj".into(), depth: 2 };
        let sources = [
            None,
            Some(SceneSource::BuiltIn("chess")),
            Some(SceneSource::File("a b\n.toml".into())),
            Some(SceneSource::Model("%.obj".into())),
        ];
        for source in sources {
            let header = Header { name: "Конь, куб".into(), source, models: vec![place("a b.obj"), place("x")] };
            assert_eq!(Header::of(&format!("{header}luch = 1\n{MARK}name other\n")), header);
        }
        assert_eq!(Header::of("luch = 1"), Header::default());
        assert_eq!(Header::of(&format!("{MARK}name %\n{MARK}built-in none\n{MARK}model a\n")), Header::default());
    }
}
