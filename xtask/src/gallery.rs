//! `cargo xtask gallery`: the pictures of docs/gallery, rendered by the program itself.
//!
//! A sheet for each chess piece shows it from the front, three-quarters and the side; each built-in scene is shown from each of
//! its three cameras, two of them also with depth of field.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::models::Piece;

/// Where the pictures go, whatever the current folder.
pub const GALLERY_DIR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/gallery");

/// The built-in scenes of the gallery.
const SCENES: [&str; 3] = ["two-spheres", "knight", "chess"];
/// Cameras of a built-in scene.
const CAMERAS: u32 = 3;
/// Scenes and cameras that are also shown through an open lens.
const FOCUSED: [(&str, u32); 2] = [("knight", 1), ("chess", 2)];

/// What to make and how.
#[derive(Clone, Debug)]
pub struct Gallery {
    /// The program.
    pub luch: PathBuf,
    /// The folder for the pictures.
    pub out: PathBuf,
    /// A folder for the sheets' scene files.
    pub scratch: PathBuf,
    /// Only pictures whose name contains this.
    pub only: Option<String>,
    /// Rays per pixel.
    pub rays: u32,
}

impl Gallery {
    /// Renders every picture that was asked for; `report` hears of each.
    ///
    /// # Errors
    /// When a file cannot be written or the program fails.
    pub fn render(&self, mut report: impl FnMut(&Path)) -> Result<(), String> {
        let made = |path: &Path, e: std::io::Error| format!("{}: {e}", path.display());
        for folder in [&self.out, &self.scratch] {
            std::fs::create_dir_all(folder).map_err(|e| made(folder, e))?;
        }
        for piece in Piece::ALL {
            let name = piece.name();
            if !self.is_wanted(name) {
                continue;
            }
            let model = self.scratch.join(format!("{name}.obj"));
            let source = Path::new(crate::MODELS_DIR).join(format!("{name}.obj"));
            std::fs::copy(&source, &model).map_err(|e| made(&source, e))?;
            let scene = self.scratch.join(format!("sheet-{name}.toml"));
            std::fs::write(&scene, sheet(name)).map_err(|e| made(&scene, e))?;
            let picture = self.out.join(format!("piece-{name}.png"));
            self.run(&scene, 1, &["--size", "1600x900"], &picture)?;
            report(&picture);
        }
        for scene in SCENES {
            for camera in 1..=CAMERAS {
                let name = format!("scene-{scene}-{camera}");
                if !self.is_wanted(&name) {
                    continue;
                }
                let picture = self.out.join(format!("{name}.png"));
                self.run(Path::new(scene), camera, &["--size", "1920x1080"], &picture)?;
                report(&picture);
            }
        }
        for (scene, camera) in FOCUSED {
            let name = format!("scene-{scene}-{camera}-focus");
            if self.is_wanted(&name) {
                let picture = self.out.join(format!("{name}.png"));
                let rays = self.rays.to_string();
                self.run(Path::new(scene), camera, &["--size", "1920x1080", "--depth-of-field", &rays], &picture)?;
                report(&picture);
            }
        }
        Ok(())
    }

    fn is_wanted(&self, name: &str) -> bool {
        self.only.as_ref().is_none_or(|only| name.contains(only.as_str()))
    }

    /// Renders one picture.
    fn run(&self, scene: &Path, camera: u32, options: &[&str], picture: &Path) -> Result<(), String> {
        let status = Command::new(&self.luch)
            .arg("render")
            .arg(scene)
            .arg("-o")
            .arg(picture)
            .args(["--camera", &camera.to_string(), "--antialiasing", &self.rays.to_string(), "--quiet"])
            .args(options)
            .status()
            .map_err(|e| format!("{}: {e}", self.luch.display()))?;
        if status.success() { Ok(()) } else { Err(format!("{}: {status}", scene.display())) }
    }
}

/// The scene of a piece's sheet: three of it in a row on a plain ground, turned to the front, three-quarters and the side, a
/// tall and a low piece at the same scale.
fn sheet(name: &str) -> String {
    let mut text = String::from(
        r##"luch = 1
name = "Sheet"
background = "#59636e"
ambient = 0.14
attenuation = 24.0

[[light]]
name = "Window"
position = [-4.0, 6.0, 5.0]
intensity = 1.0
color = "#fff6e8"

[[light]]
name = "Lamp"
position = [6.0, 3.0, 3.0]
intensity = 0.22
color = "#dfe9ff"

[[camera]]
name = "Front"
position = [0.0, 2.6, 6.8]
look_at = [0.0, 0.74, 0.0]
fov = 15.5

[[object]]
name = "Ground"
wall = { point = [0.0, 0.0, 0.0], normal = [0.0, 1.0, 0.0] }
color = "#8e969e"
gloss = 0.0
"##,
    );
    // The knight looks to the right, the bishop's cut to the viewer.
    let way = if name == "bishop" { -1.0 } else { 1.0 };
    for (view, x, turn) in [("Front", -1.15, 0.0), ("Three-quarters", 0.0, 42.0 * way), ("Side", 1.15, 90.0 * way)] {
        text.push_str(&format!(
            r##"
[[object]]
name = "{view}"
mesh = "{name}.obj"
position = [{x:.2}, 0.0, 0.0]
rotation = [0.0, {turn:.1}, 0.0]
color = "#ecdcb6"
reflection = 0.04
gloss = 0.7
"##
        ));
    }
    text
}
