//! While a scene is read, the one at hand is shown and changed.

use crate::desk::{Folder, studio};
use crate::support::{Desk, LANGUAGES};
use egui::{Key, Modifiers};
use luch_studio::Start;
use std::fmt::Write;
use std::fs;
use std::path::PathBuf;

const LOADING: &str = "Loading the scene…";

/// A sheet of two triangles for each of so many squares in a row and rows of them.
fn sheet(side: usize) -> String {
    let mut text = String::new();
    for (x, y) in (0..side).flat_map(|y| (0..side).map(move |x| (x, y))) {
        writeln!(text, "v {x} {} {y}", (x * y) % 7).unwrap();
    }
    for corner in (0..side - 1).flat_map(|y| (1..side).map(move |x| y * side + x)) {
        writeln!(text, "f {corner} {} {}", corner + 1, corner + side).unwrap();
        writeln!(text, "f {} {} {}", corner + 1, corner + side + 1, corner + side).unwrap();
    }
    text
}

/// A scene that takes minutes to read, in little room on the disk: a large model under many names.
fn large_scene(folder: &Folder) -> PathBuf {
    let model = folder.write("large.obj", sheet(500));
    let mut scene = String::from("luch = 1\nname = \"Large\"\n");
    for number in 0..100 {
        let name = format!("large-{number}.obj");
        fs::hard_link(&model, folder.path(&name)).unwrap();
        writeln!(scene, "[[object]]\nname = \"{number}\"\nmesh = \"{name}\"").unwrap();
    }
    folder.write("large.toml", scene)
}

#[test]
fn what_is_changed_while_a_scene_is_read_is_seen() {
    let folder = Folder::new();
    let large = large_scene(&folder);
    let mut desk = studio();
    desk.resize(80, 60);
    let before = desk.picture();
    desk.let_go_of(&[&large], Modifiers::NONE);
    assert!(desk.says(LOADING));
    desk.harness.key_press(Key::Num2);
    desk.wait(|desk| desk.picture() != before);
    assert!(desk.says(LOADING), "the picture came only with the other scene");
    assert_eq!(desk.harness.state().camera().unwrap().name, "Camera 2");
    desk.press("Cancel");
    assert_eq!(desk.harness.state().scene().name, "Two spheres");
}

#[test]
fn a_window_opened_with_a_large_scene_is_not_blank_for_long() {
    let folder = Folder::new();
    let large = large_scene(&folder);
    let start = Start { scene: luch_io::SceneSource::of_path(&large), ..Start::default() };
    let mut desk = Desk::opening(LANGUAGES[0], start, [1280.0, 800.0], 1.0);
    desk.wait(|desk| desk.harness.state().picture().is_some());
    assert!(desk.says(LOADING));
    desk.press("Cancel");
}

#[test]
fn who_closes_the_dialog_wants_no_scene_of_it() {
    let folder = Folder::new();
    let large = large_scene(&folder);
    let mut desk = studio();
    desk.key(Modifiers::COMMAND, Key::O);
    desk.begin_typing("Path", &large.display().to_string());
    desk.harness.key_press(Key::Enter);
    desk.steps(2);
    assert!(desk.says(LOADING));
    desk.press_top("Cancel");
    assert_eq!(desk.harness.state().scene().name, "Two spheres");
    let large = folder.write("sheet.obj", sheet(1000));
    desk.open_menu("Add", "Model…");
    desk.begin_typing("Path", &large.display().to_string());
    desk.harness.key_press(Key::Enter);
    desk.steps(2);
    assert!(desk.says("Reading…"));
    desk.press_top("Cancel");
    assert!(desk.harness.state().scene().object_named("sheet").is_none());
}

#[test]
fn a_new_scene_is_not_replaced_by_one_that_was_asked_for_before() {
    let folder = Folder::new();
    let large = large_scene(&folder);
    let mut desk = studio();
    desk.let_go_of(&[&large], Modifiers::NONE);
    assert!(desk.says(LOADING));
    desk.open_menu("File", "New scene");
    assert_eq!(desk.harness.state().scene().name, "New scene");
}
