//! Nothing that was made is lost without a question.

use crate::desk::{BALL, Folder, studio, studio_with};
use crate::support::Desk;
use egui::{Key, Modifiers, ViewportCommand, ViewportEvent};
use egui_kittest::kittest::Queryable;
use std::fs;

#[test]
fn changes_are_asked_about_before_another_scene_takes_their_place() {
    let mut desk = studio();
    desk.alter();
    for ask in [
        |desk: &mut Desk| desk.open_menu("File", "New scene"),
        |desk: &mut Desk| desk.key(Modifiers::COMMAND, Key::O),
        |desk: &mut Desk| desk.choose("Scene", "Chess"),
        |desk: &mut Desk| desk.key(Modifiers::COMMAND, Key::Q),
    ] {
        ask(&mut desk);
        assert!(desk.says("Save them?"));
        desk.press_top("Cancel");
        assert_eq!(desk.harness.state().scene().name, "Two spheres");
        assert!(!desk.is_closing());
    }
    desk.open_menu("File", "New scene");
    desk.press_top("Do not save");
    assert_eq!(desk.harness.state().scene().name, "New scene");
    desk.choose("Scene", "Chess");
    assert_eq!(desk.harness.state().scene().name, "Chess", "nothing changed, nothing asked");
}

#[test]
fn save_saves_first() {
    let folder = Folder::new();
    let file = folder.write("ball.toml", BALL);
    let mut desk = studio_with(&file);
    desk.alter();
    desk.open_menu("File", "New scene");
    desk.press_top("Save");
    assert_eq!(desk.harness.state().scene().name, "New scene");
    assert!(fs::read_to_string(&file).unwrap().contains("fov = 33.0"));
    // A scene without a file asks for one, and goes on when it is written.
    desk.alter();
    desk.choose("Scene", "Chess");
    desk.press_top("Save");
    assert_eq!(desk.harness.state().scene().name, "New scene");
    desk.enter_path(&folder.path("new.toml"));
    assert_eq!(desk.harness.state().scene().name, "Chess");
    assert_eq!(folder.names(), ["ball.toml", "new.toml"]);
}

#[test]
fn a_save_that_fails_loses_nothing() {
    let folder = Folder::new();
    let mut desk = studio();
    desk.alter();
    desk.open_menu("File", "New scene");
    desk.press_top("Save");
    desk.enter_path(&folder.path("nowhere/s.toml"));
    assert!(desk.says("there is no folder"), "told below the field");
    assert_eq!(desk.harness.state().scene().name, "Two spheres");
    desk.enter_path(&folder.path("s.toml"));
    assert_eq!(desk.harness.state().scene().name, "New scene");
}

#[test]
fn the_window_closes_only_when_the_changes_are_decided_about() {
    let close = |desk: &mut Desk| {
        let viewport = desk.harness.input_mut().viewports.entry(egui::ViewportId::ROOT).or_default();
        viewport.events.push(ViewportEvent::Close);
        desk.harness.step();
    };
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    close(&mut desk);
    assert!(!desk.commands().any(|command| *command == ViewportCommand::CancelClose));
    desk.alter();
    close(&mut desk);
    assert!(desk.commands().any(|command| *command == ViewportCommand::CancelClose));
    desk.steps(2);
    assert!(desk.says("Save them?"));
    desk.harness.get_by_role_and_label(egui::accesskit::Role::Button, "Do not save").click();
    desk.harness.step();
    assert!(desk.is_closing());
    close(&mut desk);
    assert!(!desk.commands().any(|command| *command == ViewportCommand::CancelClose), "once is enough");
}
