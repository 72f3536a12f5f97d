//! While a scene is read, the one at hand is shown and changed.

use crate::desk::{Folder, studio};
use crate::support::{Desk, LANGUAGES};
use egui::{Key, Modifiers};
use luch_studio::Start;
use std::fmt::Write;
use std::path::PathBuf;

const LOADING: &str = "Loading the scene…";

/// A model that takes long to read: by far longer than a small picture takes.
fn large_model(folder: &Folder) -> PathBuf {
    let side = 700;
    let mut text = String::new();
    for (x, y) in (0..side).flat_map(|y| (0..side).map(move |x| (x, y))) {
        writeln!(text, "v {x} {} {y}", (x * y) % 7).unwrap();
    }
    for corner in (0..side - 1).flat_map(|y| (1..side).map(move |x| y * side + x)) {
        writeln!(text, "f {corner} {} {}", corner + 1, corner + side).unwrap();
        writeln!(text, "f {} {} {}", corner + 1, corner + side + 1, corner + side).unwrap();
    }
    folder.write("large.obj", text)
}

#[test]
fn what_is_changed_while_a_scene_is_read_is_seen() {
    let folder = Folder::new();
    let model = large_model(&folder);
    let mut desk = studio();
    desk.resize(80, 60);
    let before = desk.picture();
    desk.key(Modifiers::COMMAND, Key::O);
    desk.begin_typing("Path", &model.display().to_string());
    desk.harness.key_press(Key::Enter);
    desk.steps(2);
    desk.harness.key_press(Key::Escape);
    desk.steps(2);
    assert!(desk.says(LOADING));
    desk.harness.key_press(Key::Num2);
    desk.wait(|desk| desk.picture() != before);
    assert!(desk.says(LOADING), "the picture came only with the other scene");
    assert_eq!(desk.harness.state().camera().unwrap().name, "Camera 2");
    desk.press("Cancel");
    assert_eq!(desk.harness.state().scene().name, "Two spheres");
}

#[test]
fn a_window_opened_with_a_large_model_is_not_blank_for_long() {
    let folder = Folder::new();
    let model = large_model(&folder);
    let start = Start { scene: luch_io::SceneSource::of_path(&model), ..Start::default() };
    let mut desk = Desk::opening(LANGUAGES[0], start, [1280.0, 800.0], 1.0);
    desk.wait(|desk| desk.harness.state().picture().is_some());
    assert!(desk.says(LOADING));
    desk.press("Cancel");
}
