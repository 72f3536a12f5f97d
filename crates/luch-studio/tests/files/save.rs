//! Save, save as, and what is asked before a file is replaced.

use crate::desk::{BALL, Folder, TENT, studio, studio_with};
use egui::{Key, Modifiers};
use std::fs;

const CTRL_SHIFT: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

#[test]
fn a_scene_is_saved_to_its_file() {
    let folder = Folder::new();
    let file = folder.write("ball.toml", BALL);
    let mut desk = studio_with(&file);
    desk.type_into("Field of view", "33");
    desk.key(Modifiers::COMMAND, Key::S);
    assert!(desk.says("The scene is saved"));
    assert!(fs::read_to_string(&file).unwrap().contains("fov = 33.0"));
    assert_eq!(folder.names(), ["ball.toml"]);
}

#[test]
fn a_built_in_scene_asks_for_a_file_and_keeps_it() {
    let folder = Folder::new();
    let mut desk = studio();
    desk.type_into("Field of view", "33");
    desk.open_menu("File", "Save");
    assert!(desk.path_field().ends_with("Two spheres.toml"), "{}", desk.path_field());
    // The ending is added.
    desk.enter_path(&folder.path("mine"));
    assert!(desk.says("The scene is saved"));
    assert_eq!(folder.names(), ["mine.toml"]);
    desk.type_into("Field of view", "44");
    desk.key(Modifiers::COMMAND, Key::S);
    assert!(fs::read_to_string(folder.path("mine.toml")).unwrap().contains("fov = 44.0"));
}

#[test]
fn another_file_is_replaced_only_when_somebody_says_so() {
    let folder = Folder::new();
    let file = folder.write("ball.toml", BALL);
    let other = folder.write("other.toml", "precious");
    let mut desk = studio_with(&file);
    desk.key(CTRL_SHIFT, Key::S);
    desk.enter_path(&other);
    assert!(desk.says("exists already"));
    desk.press_top("Another name…");
    // What was typed is still there.
    assert_eq!(desk.path_field(), other.display().to_string());
    desk.press_top("Cancel");
    assert_eq!(fs::read_to_string(&other).unwrap(), "precious");
    desk.open_menu("File", "Save as…");
    desk.enter_path(&other);
    desk.press_top("Replace");
    assert!(desk.says("The scene is saved"));
    assert!(fs::read_to_string(&other).unwrap().starts_with("# A scene of Luch"));
    // Its own file is saved without a question.
    desk.open_menu("File", "Save as…");
    desk.enter_path(&other);
    assert!(!desk.says("exists already"));
}

#[test]
fn models_come_along() {
    let (from, to) = (Folder::new(), Folder::new());
    let model = from.write("tent.obj", TENT);
    let mut desk = studio();
    desk.open_menu("Add", "Model…");
    desk.enter_path(&model);
    assert_eq!(desk.harness.state().selected(), Some("tent"));
    desk.open_menu("File", "Save as…");
    desk.enter_path(&to.path("s.toml"));
    assert_eq!(to.names(), ["models", "s.toml"]);
    fs::remove_file(&model).unwrap();
    let again = studio_with(&to.path("s.toml"));
    assert!(again.harness.state().scene().object_named("tent").is_some());
    assert_eq!(again.harness.state().scene().objects.len(), desk.harness.state().scene().objects.len());
}

#[test]
fn undo_after_saving_is_a_change_again() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    desk.type_into("Field of view", "33");
    desk.key(Modifiers::COMMAND, Key::S);
    desk.key(Modifiers::COMMAND, Key::Z);
    desk.open_menu("File", "New scene");
    assert!(desk.says("Save them?"));
    desk.press_top("Cancel");
    desk.key(CTRL_SHIFT, Key::Z);
    desk.open_menu("File", "New scene");
    assert_eq!(desk.harness.state().scene().name, "New scene");
}
