//! Pictures for files: made in the background, the same as the program's own.

use crate::desk::{BALL, Folder, studio_with};
use crate::support::Desk;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use luch_io::{Metadata, PictureSettings, Pixels, linear_hash};
use luch_render::film::color_bar;
use luch_render::film::tonemap::{srgb8, srgb16};
use luch_render::{Integrator, MeshTrees, Progress, RenderJob, compile, render};
use luch_scene::{ImageSize, RayCount, Sampling};
use std::fs;
use std::path::Path;

impl Desk {
    /// Exports to a path that is typed, and waits.
    fn export(&mut self, path: &Path) {
        self.enter_path(path);
        self.wait(|desk| desk.says("The picture is exported"));
    }
}

/// The picture of a scene's first camera as a file of that kind.
fn expected(scene: &luch_scene::Scene, job: &RenderJob, path: &Path, bits: u32) -> Vec<u8> {
    let film = render(&compile(scene, &mut MeshTrees::new(), 1), job, &Progress::new()).unwrap();
    let linear = film.linear();
    let settings = PictureSettings {
        camera: &job.camera.name,
        size: [job.size.width(), job.size.height()],
        crop: None,
        rays_per_pixel: job.rays_per_pixel(),
        antialiasing: job.antialiasing.on,
        depth_of_field: job.depth_of_field.on,
        depth: job.depth,
        integrator: job.integrator.word(),
        color_bar: job.integrator == Integrator::Nodes && bits < 32,
    };
    let metadata: Metadata = settings.metadata(&scene.name, &linear_hash(&linear));
    let (mut width, height) = (film.width(), film.height());
    let mut shown = linear.clone();
    if settings.color_bar {
        (width, shown) = color_bar::beside(&linear, [width, height], "nodes");
    }
    match bits {
        8 => luch_io::write_png(path, width, height, Pixels::Rgb8(&srgb8(&shown)), &metadata),
        16 => luch_io::write_png(path, width, height, Pixels::Rgb16(&srgb16(&shown)), &metadata),
        _ => luch_io::write_exr(path, width, height, &linear, &metadata),
    }
    .unwrap();
    fs::read(path).unwrap()
}

#[test]
fn each_kind_of_file_is_what_a_render_of_the_scene_writes() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    desk.type_into("Field of view", "33");
    for (kind, file, bits) in
        [("PNG, 8 bits", "a.png", 8), ("PNG, 16 bits", "b.png", 16), ("EXR, 32-bit linear light", "c.exr", 32)]
    {
        desk.key(Modifiers::COMMAND, Key::E);
        desk.choose_kind(kind);
        desk.export(&folder.path(file));
        let scene = desk.harness.state().scene();
        let job = RenderJob::of_scene(scene, 0);
        let expected = expected(scene, &job, &folder.path(&format!("expected.{file}")), bits);
        assert!(fs::read(folder.path(file)).unwrap() == expected, "{file}");
        desk.press_top("Dismiss");
    }
}

impl Desk {
    fn choose_kind(&mut self, kind: &str) {
        self.harness.get_by_role_and_label(egui::accesskit::Role::RadioButton, kind).click();
        self.settle();
    }

    /// Types into the last field of that name: the dialog's.
    fn type_last(&mut self, name: &str, text: &str) {
        let role = egui::accesskit::Role::TextInput;
        self.harness.query_all_by_role_and_label(role, name).last().unwrap().click();
        self.steps(2);
        self.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        self.steps(2);
        self.harness.query_all_by_role_and_label(role, name).last().unwrap().type_text(text);
        self.steps(2);
        self.key(Modifiers::NONE, Key::Tab);
    }

    /// Starts a picture that takes minutes.
    fn begin_long_export(&mut self, path: &Path) {
        self.open_menu("File", "Export picture…");
        for (name, value) in [("Picture width", "3000"), ("Picture height", "3000")] {
            self.type_last(name, value);
        }
        self.tick_last("Antialiasing");
        self.type_last("Rays per pixel", "4096");
        self.enter_path(path);
        self.wait(|desk| !desk.offers("Browse…"));
    }

    fn tick_last(&mut self, name: &str) {
        self.harness.query_all_by_role_and_label(egui::accesskit::Role::CheckBox, name).last().unwrap().click();
        self.settle();
    }
}

#[test]
fn the_size_and_the_rays_are_the_dialog_s_and_the_scene_stays_as_it_is() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    desk.open_menu("File", "Export picture…");
    assert!(desk.path_field().ends_with("ball.png"), "{}", desk.path_field());
    desk.type_last("Picture width", "100");
    desk.type_last("Picture height", "30");
    desk.tick_last("Antialiasing");
    desk.type_last("Rays per pixel", "4");
    desk.export(&folder.path("a.png"));
    let scene = desk.harness.state().scene();
    assert_eq!(scene.settings.size, ImageSize::new(64, 48).unwrap());
    let antialiasing = Sampling { on: true, rays: RayCount::new(4).unwrap() };
    let job = RenderJob { size: ImageSize::new(100, 30).unwrap(), antialiasing, ..RenderJob::of_scene(scene, 0) };
    assert!(fs::read(folder.path("a.png")).unwrap() == expected(scene, &job, &folder.path("e.png"), 8));
    // The ending is added, and a file that is there is asked about.
    desk.open_menu("File", "Export picture…");
    desk.enter_path(&folder.path("a"));
    desk.wait(|desk| desk.says("exists already"));
    desk.press_top("Another name…");
    assert!(desk.path_field().ends_with("/a"));
    desk.enter_path(&folder.path("a.png"));
    desk.wait(|desk| desk.offers("Replace"));
}

#[test]
fn a_view_of_counts_is_exported_with_its_scale() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    desk.menu(&["View", "Picture shows", "Heat map: boxes"]);
    for file in ["a.png", "a.exr"] {
        desk.key(Modifiers::COMMAND, Key::E);
        desk.export(&folder.path(file));
        desk.press_top("Dismiss");
    }
    let scene = desk.harness.state().scene();
    let job = RenderJob { integrator: Integrator::Nodes, ..RenderJob::of_scene(scene, 0) };
    for (file, bits) in [("a.png", 8), ("a.exr", 32)] {
        let expected = expected(scene, &job, &folder.path(&format!("expected.{file}")), bits);
        assert!(fs::read(folder.path(file)).unwrap() == expected, "{file}");
    }
}

#[test]
fn one_goes_on_working_and_can_cancel() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    desk.begin_long_export(&folder.path("a.png"));
    desk.type_into("Field of view", "33");
    assert_eq!(desk.harness.state().scene().cameras[0].fov.get(), 33.0);
    assert!(desk.says("Export: a.png"));
    // A second one waits for the first; the window asks before it closes.
    desk.open_menu("File", "Export picture…");
    assert!(desk.says("Another picture is on its way"));
    desk.press_top("Cancel");
    desk.open_menu("File", "Save");
    desk.key(Modifiers::COMMAND, Key::Q);
    assert!(desk.says("Quit without it?"));
    desk.press_top("Cancel");
    assert!(!desk.is_closing());
    desk.press_top("Cancel the export");
    desk.wait(|desk| desk.says("The export was cancelled"));
    assert!(!folder.path("a.png").exists());
}

#[test]
fn who_drops_changes_is_still_asked_about_the_picture_on_its_way() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    desk.begin_long_export(&folder.path("a.png"));
    desk.alter();
    desk.key(Modifiers::COMMAND, Key::Q);
    desk.press_top("Do not save");
    assert!(desk.says("Quit without it?") && !desk.is_closing());
    desk.harness.get_by_role_and_label(egui::accesskit::Role::Button, "Quit").click();
    desk.harness.step();
    assert!(desk.is_closing());
}

#[test]
fn what_cannot_be_made_or_written_is_told_before_the_work() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    desk.open_menu("File", "Export picture…");
    desk.enter_path(&folder.path("nowhere/a.png"));
    desk.wait(|desk| desk.says("there is no folder"));
    fs::create_dir(folder.path("b.png")).unwrap();
    desk.enter_path(&folder.path("b.png"));
    desk.wait(|desk| desk.offers("Replace"));
    desk.press_top("Replace");
    desk.wait(|desk| desk.says("is a folder"));
    for side in ["Picture width", "Picture height"] {
        desk.type_last(side, "65535");
    }
    desk.choose_kind("EXR, 32-bit linear light");
    assert!(desk.says("GiB of memory"), "it is told at once");
    desk.enter_path(&folder.path("huge.exr"));
    assert!(desk.offers("Browse…") && !folder.path("huge.exr").exists(), "and not begun");
}
