//! What stands in a field when somebody saves or closes is meant as well.

use crate::desk::{BALL, Folder, studio_with};
use egui::{Key, Modifiers, ViewportCommand, ViewportEvent};
use std::fs;

#[test]
fn a_number_that_is_still_typed_is_saved() {
    let folder = Folder::new();
    let file = folder.write("ball.toml", BALL);
    let mut desk = studio_with(&file);
    desk.begin_typing("Field of view", "33");
    desk.key(Modifiers::COMMAND, Key::S);
    assert!(desk.says("The scene is saved"));
    assert!(fs::read_to_string(&file).unwrap().contains("fov = 33.0"));
    // A name and a colour too, and letters that come in the same moment as the key.
    desk.select_in_list("Red");
    desk.begin_typing("Name", "Ball");
    desk.key(Modifiers::COMMAND, Key::S);
    assert!(fs::read_to_string(&file).unwrap().contains("\"Ball\""));
    desk.begin_typing("Color", "");
    desk.harness.event(egui::Event::Text("#00ff88".into()));
    desk.key(Modifiers::COMMAND, Key::S);
    assert!(fs::read_to_string(&file).unwrap().contains("#00ff88"));
}

#[test]
fn a_name_that_is_still_typed_is_in_what_is_saved_as_or_exported() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    for (modifiers, key, dialog, fov) in [
        (Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::S, "Save the scene as", 33.0),
        (Modifiers::COMMAND, Key::E, "Export the picture", 44.0),
        (Modifiers::COMMAND, Key::O, "Save them?", 55.0),
    ] {
        desk.begin_typing("Field of view", &fov.to_string());
        desk.key(modifiers, key);
        assert!(desk.says(dialog), "{dialog}");
        assert_eq!(desk.harness.state().scene().cameras[0].fov.get(), fov, "{dialog}");
        desk.press_top("Cancel");
    }
}

#[test]
fn a_window_that_is_closed_asks_about_what_is_still_typed() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    desk.begin_typing("Field of view", "33");
    let viewport = desk.harness.input_mut().viewports.entry(egui::ViewportId::ROOT).or_default();
    viewport.events.push(ViewportEvent::Close);
    desk.harness.step();
    assert!(desk.commands().any(|command| *command == ViewportCommand::CancelClose));
    desk.harness.input_mut().viewports.entry(egui::ViewportId::ROOT).or_default().events.clear();
    desk.settle();
    assert!(desk.says("Save them?") && !desk.is_closing());
    desk.press_top("Cancel");
    // By key it is the same.
    desk.begin_typing("Field of view", "44");
    desk.key(Modifiers::COMMAND, Key::Q);
    assert!(desk.says("Save them?") && !desk.is_closing());
    assert_eq!(desk.harness.state().scene().cameras[0].fov.get(), 44.0);
}

#[test]
fn a_field_without_changes_keeps_no_window_open() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    desk.begin_typing("Find by name", "re");
    let (key, modifiers) = (Key::Q, Modifiers::COMMAND);
    desk.harness.event(egui::Event::Key { key, modifiers, pressed: true, repeat: false, physical_key: None });
    desk.steps(2);
    assert!(desk.is_closing());
}
