//! Open: the path field, its list, and the dialog of the system.

use crate::desk::{BALL, Folder, TENT, studio, studio_with};
use crate::support::{Desk, LANGUAGES};
use egui::{Key, Modifiers};
use luch_studio::Start;

#[test]
fn a_typed_path_is_opened() {
    let folder = Folder::new();
    let file = folder.write("ball.toml", BALL);
    let mut desk = studio();
    desk.key(Modifiers::COMMAND, Key::O);
    desk.enter_path(&file);
    assert_eq!(desk.harness.state().scene().name, "Ball");
    assert!(!desk.offers("Browse…"), "the dialog is closed");
    assert_eq!(desk.render().width, 64);
}

#[test]
fn a_bare_model_is_a_scene() {
    let folder = Folder::new();
    let mut desk = studio();
    desk.open_menu("File", "Open…");
    desk.enter_path(&folder.write("tent.OBJ", TENT));
    assert_eq!(desk.harness.state().scene().name, "tent");
}

#[test]
fn the_list_has_folders_and_files_that_can_be_opened() {
    let folder = Folder::new();
    folder.write("ball.toml", BALL);
    folder.write("deep/knot/tent.obj", TENT);
    folder.write("deep/notes.txt", "");
    let mut desk = studio_with(&folder.path("ball.toml"));
    desk.open_menu("File", "Open…");
    assert!(desk.offers("ball.toml") && desk.offers("deep/"));
    desk.press_top("deep/");
    assert!(desk.offers("knot/") && !desk.offers("notes.txt"));
    assert_eq!(desk.path_field(), format!("{}/", folder.path("deep").display()));
    desk.press_top("Folder above");
    assert!(desk.offers("ball.toml"));
    // A click on a file puts it into the field.
    desk.press_top("ball.toml");
    assert_eq!(desk.path_field(), folder.path("ball.toml").display().to_string());
}

#[test]
fn the_keyboard_alone_finds_a_file() {
    let folder = Folder::new();
    folder.write("ball.toml", BALL);
    folder.write("deep/knot/tent.obj", TENT);
    let mut desk = studio_with(&folder.path("ball.toml"));
    desk.key(Modifiers::COMMAND, Key::O);
    // ball.toml comes behind the folder.
    desk.key(Modifiers::NONE, Key::ArrowDown);
    desk.key(Modifiers::NONE, Key::Enter);
    assert_eq!(desk.path_field(), format!("{}/", folder.path("deep").display()));
    desk.key(Modifiers::NONE, Key::ArrowDown);
    desk.key(Modifiers::NONE, Key::Enter);
    desk.harness.event(egui::Event::Text("te".into()));
    desk.settle();
    assert!(desk.offers("tent.obj"));
    desk.key(Modifiers::NONE, Key::ArrowDown);
    desk.key(Modifiers::NONE, Key::Enter);
    assert_eq!(desk.harness.state().scene().name, "tent");
    // Escape closes a dialog and nothing else.
    desk.key(Modifiers::COMMAND, Key::O);
    desk.key(Modifiers::NONE, Key::Escape);
    assert!(!desk.offers("Browse…"));
    assert_eq!(desk.harness.state().scene().name, "tent");
}

#[test]
fn where_the_system_has_no_dialog_the_field_remains() {
    let start = Start { choose_file: Some(|_| None), ..Start::default() };
    let mut desk = Desk::start(LANGUAGES[0], start);
    desk.open_menu("File", "Open…");
    desk.press_top("Browse…");
    assert!(desk.says("Type the path"));
    desk.press_top("Cancel");
    desk.open_menu("File", "Open…");
    assert!(!desk.says("Type the path"), "it is told once");
}

#[test]
fn a_file_of_the_system_s_dialog_is_opened_at_once() {
    let start = Start {
        choose_file: Some(|question| {
            assert!(question.endings.contains(&"obj") && !question.writes && question.folder.is_absolute());
            let path = std::env::temp_dir().join(format!("luch-chosen-{}.toml", std::process::id()));
            std::fs::write(&path, BALL).ok()?;
            Some(path)
        }),
        ..Start::default()
    };
    let mut desk = Desk::start(LANGUAGES[0], start);
    desk.open_menu("File", "Open…");
    desk.press_top("Browse…");
    assert_eq!(desk.harness.state().scene().name, "Ball");
    let _ = std::fs::remove_file(std::env::temp_dir().join(format!("luch-chosen-{}.toml", std::process::id())));
}
