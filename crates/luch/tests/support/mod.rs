//! Runs the real program in a fresh folder.

#![allow(dead_code, reason = "every test program uses its own part of this")]

#[cfg(unix)]
pub(crate) mod terminal;

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};

/// A folder of its own, removed in the end.
pub(crate) struct Folder(PathBuf);

/// What a run of the program left.
#[derive(Debug)]
pub(crate) struct Outcome {
    pub(crate) code: i32,
    pub(crate) stdout: String,
    pub(crate) stderr: String,
}

/// The program with its arguments, not yet run, with nothing of this machine's settings.
pub(crate) fn program(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_luch"));
    command.args(args).current_dir(folder).stdin(Stdio::null());
    command.env_remove("NO_COLOR").env_remove("CLICOLOR_FORCE").env_remove("COLUMNS").env_remove("RUST_BACKTRACE");
    command
}

impl Folder {
    pub(crate) fn new() -> Self {
        static NUMBER: AtomicU32 = AtomicU32::new(0);
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("luch-cli-{}-{number}", std::process::id()));
        std::fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) -> &Self {
        let path = self.0.join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, content).unwrap();
        self
    }

    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        std::fs::read(self.0.join(name)).unwrap_or_else(|e| panic!("{name}: {e}"))
    }

    /// The names in the folder, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(&self.0).unwrap();
        let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// Runs the program here.
    pub(crate) fn luch(&self, args: &[&str]) -> Outcome {
        Outcome::of(&program(&self.0, args).output().unwrap())
    }

    /// Runs the program here and expects success.
    pub(crate) fn ok(&self, args: &[&str]) -> Outcome {
        let outcome = self.luch(args);
        assert_eq!(outcome.code, 0, "{args:?}: {}", outcome.stderr);
        outcome
    }

    /// Renders a small picture and answers with its figures.
    pub(crate) fn figures(&self, args: &[&str]) -> serde_json::Value {
        let fixed = ["-o", "figures.png", "--stats", "-", "--quiet"];
        let mut all = vec!["render"];
        all.extend(args.iter().chain(&fixed));
        if !args.contains(&"--size") {
            all.extend(["--size", "40x30"]);
        }
        self.ok(&all).json()
    }

    /// Renders a small picture and answers with its hash.
    pub(crate) fn hash(&self, args: &[&str]) -> String {
        self.figures(args)["hash"].as_str().unwrap().to_owned()
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

impl Outcome {
    pub(crate) fn of(output: &Output) -> Self {
        Self {
            code: output.status.code().unwrap_or(-1),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }

    pub(crate) fn json(&self) -> serde_json::Value {
        serde_json::from_str(&self.stdout).unwrap_or_else(|e| panic!("{e}: {}", self.stdout))
    }
}

/// A PNG file, decoded.
pub(crate) struct Png {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) bits: u8,
    pub(crate) bytes: Vec<u8>,
    /// Everything that its text chunks say.
    pub(crate) texts: String,
}

impl Png {
    pub(crate) fn decode(bytes: &[u8]) -> Self {
        let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap();
        let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
        let frame = reader.next_frame(&mut pixels).unwrap();
        let texts = reader.info().uncompressed_latin1_text.iter().map(|t| format!("{}: {}\n", t.keyword, t.text));
        Self {
            width: frame.width as usize,
            height: frame.height as usize,
            bits: frame.bit_depth as u8,
            texts: texts.collect(),
            bytes: pixels,
        }
    }

    /// The part at x, y of that size, as bytes.
    pub(crate) fn part(&self, x: usize, y: usize, width: usize, height: usize) -> Vec<u8> {
        let pixel = 3 * usize::from(self.bits) / 8;
        let row = |y: usize| &self.bytes[(y * self.width + x) * pixel..][..width * pixel];
        (y..y + height).flat_map(row).copied().collect()
    }
}

/// A scene that is loaded and rendered in no time: a ball, a cube, a floor and a two-triangle model.
pub(crate) const SMALL_SCENE: &str = r##"
luch = 1
name = "Small"
background = "#102030"
[render]
size = [40, 30]
[[light]]
name = "Lamp"
position = [3.0, 6.0, 4.0]
[[camera]]
name = "Front"
position = [0.0, 2.0, 7.0]
look_at = [0.0, 1.0, 0.0]
[[camera]]
name = "Above"
position = [0.0, 9.0, 0.5]
look_at = [0.0, 0.0, 0.0]
lens_radius = 0.2
[[object]]
name = "Ball"
sphere = { center = [-1.5, 1.0, 0.0], radius = 1.0 }
color = "#c83232"
reflection = 0.5
[[object]]
name = "Cube"
cube = { center = [1.5, 0.5, 0.0], side = 1.0 }
color = "#3264c8"
[[object]]
name = "No. 1 = best"
sphere = { center = [0.0, 0.4, 2.0], radius = 0.4 }
[[object]]
name = "Floor"
wall = { point = [0.0, 0.0, 0.0], normal = [0.0, 1.0, 0.0] }
[[object]]
name = "Roof"
mesh = "roof.obj"
position = [0.0, 2.0, 0.0]
"##;

/// The model of [`SMALL_SCENE`]: two slopes that share smooth normals on the ridge.
pub(crate) const SMALL_MODEL: &str = "\
v -1 0 0.5\nv 1 0 0.5\nv 0.5 0.5 0\nv -0.5 0.5 0\nv 1 0 -0.5\nv -1 0 -0.5
vn -0.3 0.5 0.8\nvn 0.3 0.5 0.8\nvn 0 1 0\nvn 0.3 0.5 -0.8\nvn -0.3 0.5 -0.8
f 1//1 2//2 3//3 4//3\nf 5//4 6//5 4//3 3//3\n";

impl Folder {
    /// A folder that holds [`SMALL_SCENE`] as `small.toml`.
    pub(crate) fn with_small_scene() -> Self {
        let folder = Self::new();
        folder.write("small.toml", SMALL_SCENE).write("roof.obj", SMALL_MODEL);
        folder
    }
}
