//! Runs a test's command at a small size, also with changes and as views of what is seen.

use crate::commands::{COMMANDS, words};
use crate::picture::Picture;
use crate::support::Folder;
use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::{Report, SceneSource, load_scene};
use luch_scene::Scene;
use std::collections::HashMap;
use std::sync::OnceLock;

/// A folder to render in, and a size.
pub(crate) struct Lab {
    folder: Folder,
    size: String,
}

impl Lab {
    pub(crate) fn new(size: [usize; 2]) -> Self {
        Self { folder: Folder::new(), size: format!("{}x{}", size[0], size[1]) }
    }

    /// The picture that the command of a test makes.
    pub(crate) fn png(&self, test: usize) -> Picture {
        let mut command = words(COMMANDS[test - 1]);
        command.extend(["--size", &self.size, "--bits", "16", "--quiet"].map(str::to_owned));
        self.run(&command)
    }

    /// The same in linear light, with more arguments.
    pub(crate) fn linear(&self, test: usize, more: &str) -> Picture {
        let line = COMMANDS[test - 1].replace(".png", ".exr");
        self.run(&words(&format!("{line} --size {} --quiet {more}", self.size)))
    }

    /// What is seen at each pixel, through the middle of the pixel.
    pub(crate) fn objects(&self, test: usize) -> Objects {
        let line = COMMANDS[test - 1].replace(".png", ".exr");
        let line = line.replace(" --antialiasing 64", "").replace(" --depth-of-field 64", "");
        let command = words(&format!("{line} --size {} --quiet --integrator objects", self.size));
        let view = self.run(&command);
        let palette = palette();
        let seen = view.pixels.iter().map(|p| palette.get(&p.map(f32::to_bits)).copied()).collect();
        Objects { width: view.width, seen, names: object_names(&self.folder, &command[2]) }
    }

    /// Runs `luch render SCENE -o FILE ...` and reads FILE.
    fn run(&self, command: &[String]) -> Picture {
        let args: Vec<&str> = command[1..].iter().map(String::as_str).collect();
        self.folder.ok(&args);
        Picture::read(&self.folder, args[3])
    }
}

/// Which object is seen at each pixel.
pub(crate) struct Objects {
    pub(crate) width: usize,
    pub(crate) seen: Vec<Option<usize>>,
    names: Vec<String>,
}

impl Objects {
    /// The name of the object at a pixel.
    pub(crate) fn name_at(&self, pixel: usize) -> &str {
        self.seen[pixel].map_or("", |k| &self.names[k])
    }

    /// The pixels of objects.
    pub(crate) fn pixels(&self, of: impl Fn(&str) -> bool) -> Vec<usize> {
        (0..self.seen.len()).filter(|&i| of(self.name_at(i))).collect()
    }

    /// The pixels of one object.
    pub(crate) fn of(&self, name: &str) -> Vec<usize> {
        assert!(self.names.iter().any(|n| n == name), "the scene has no {name}");
        self.pixels(|n| n == name)
    }

    /// The share of the picture that an object takes.
    pub(crate) fn share(&self, name: &str) -> f64 {
        self.of(name).len() as f64 / self.seen.len() as f64
    }

    /// The mean column and row of an object, from the upper left corner of the picture.
    pub(crate) fn middle(&self, name: &str) -> [f64; 2] {
        let pixels = self.of(name);
        let mean =
            |at: &dyn Fn(usize) -> usize| pixels.iter().map(|&i| at(i) as f64 + 0.5).sum::<f64>() / pixels.len() as f64;
        [mean(&|i| i % self.width), mean(&|i| i / self.width)]
    }

    /// Whether an object reaches the edge of the picture.
    pub(crate) fn is_cut_off(&self, name: &str) -> bool {
        let (right, bottom) = (self.width - 1, self.seen.len() / self.width - 1);
        let at_edge = |i: usize| [0, right].contains(&(i % self.width)) || [0, bottom].contains(&(i / self.width));
        self.of(name).into_iter().any(at_edge)
    }
}

/// A built-in scene as the library reads it: where things stand.
pub(crate) fn scene(id: &'static str) -> Scene {
    let source = SceneSource::BuiltIn(id);
    load_scene(&source, &mut MeshLibrary::new(), &mut Budget::default(), &mut Report::default()).unwrap()
}

fn object_names(folder: &Folder, id: &str) -> Vec<String> {
    let scenes = folder.ok(&["scenes", "--json"]).json();
    let scene = scenes.as_array().unwrap().iter().find(|s| s["id"] == id).unwrap();
    scene["objects"].as_array().unwrap().iter().map(|o| o["name"].as_str().unwrap().to_owned()).collect()
}

/// More objects than any scene here has.
const PALETTE: usize = 128;

/// The colours of the `objects` view: object k of this scene is a ball seen at column k of a picture one pixel high.
fn palette() -> &'static HashMap<[u32; 3], usize> {
    static COLORS: OnceLock<HashMap<[u32; 3], usize>> = OnceLock::new();
    COLORS.get_or_init(|| {
        let (middle, distance) = ((PALETTE - 1) as f64 / 2.0, 100.0);
        let fov = 2.0 * (0.5_f64 / distance).atan().to_degrees();
        let mut text = format!(
            "luch = 1\nname = \"Palette\"\nbackground = \"#000000\"\n\
             [[camera]]\nname = \"C\"\nposition = [{middle:?}, 0.0, {distance:?}]\ndirection = [0.0, 0.0, -1.0]\n\
             fov = {fov:?}\n[[light]]\nname = \"L\"\nposition = [0.0, 9.0, 9.0]\n"
        );
        for k in 0..PALETTE {
            text += &format!("[[object]]\nname = \"{k}\"\nsphere = {{ center = [{k}.0, 0.0, 0.0], radius = 0.4 }}\n");
        }
        let folder = Folder::new();
        folder.write("palette.toml", text);
        let size = format!("{PALETTE}x1");
        folder.ok(&["render", "palette.toml", "-o", "p.exr", "--integrator", "objects", "--size", &size, "--quiet"]);
        let view = Picture::read(&folder, "p.exr");
        let colors: HashMap<_, _> = view.pixels.iter().map(|p| p.map(f32::to_bits)).zip(0..).collect();
        assert_eq!(colors.len(), PALETTE, "every object has a colour of its own");
        assert!(!colors.contains_key(&[0; 3]), "a ball is not where it should be");
        colors
    })
}
