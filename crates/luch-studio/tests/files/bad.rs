//! Files that are wrong, vanish, or cannot be written: it is told what and where, and everything stays.

use crate::desk::{BALL, Folder, TENT, studio, studio_with};
use crate::support::{Desk, LANGUAGES};
use egui::{Key, Modifiers};
use std::fs;

#[test]
fn a_file_that_cannot_be_opened_is_told_in_the_dialog_and_changes_nothing() {
    let folder = Folder::new();
    let mut desk = studio();
    let before = desk.picture();
    desk.key(Modifiers::COMMAND, Key::O);
    for (path, told) in [
        (folder.path("nowhere.toml"), "no such file"),
        (folder.0.clone(), "is a folder"),
        (folder.write("broken.toml", "luch = 1\nnome = 3\n"), "did you mean `name`"),
        (folder.write("empty.obj", ""), "the file is empty"),
        (folder.write("picture.png", b"\x89PNG\r\n"), "neither a scene"),
        (folder.write("odd.toml", b"luch = 1\nname = \"\xff\"\n"), "UTF-8"),
    ] {
        desk.enter_path(&path);
        assert!(desk.says(told), "{}: {told}", path.display());
        assert!(desk.says(&path.display().to_string()), "says which file");
        assert_eq!(desk.harness.state().scene().name, "Two spheres");
    }
    assert_eq!(desk.picture(), before, "the last picture stays");
    desk.enter_path(&folder.write("ball.toml", BALL));
    assert_eq!(desk.harness.state().scene().name, "Ball");
}

#[test]
fn a_model_that_cannot_be_read_is_not_added() {
    let folder = Folder::new();
    let mut desk = studio();
    let objects = desk.harness.state().scene().objects.len();
    desk.open_menu("Add", "Model…");
    desk.enter_path(&folder.write("empty.obj", ""));
    assert!(desk.says("the file is empty"));
    assert_eq!(desk.harness.state().scene().objects.len(), objects);
    desk.enter_path(&folder.write("tent.obj", TENT));
    assert_eq!(desk.harness.state().scene().objects.len(), objects + 1);
}

#[test]
fn a_folder_that_vanishes_while_one_works_is_told_when_saving() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("deep/ball.toml", BALL));
    desk.alter();
    fs::remove_dir_all(folder.path("deep")).unwrap();
    desk.key(Modifiers::COMMAND, Key::S);
    assert!(desk.says("The scene was not saved") && desk.says("there is no folder"));
    desk.open_menu("File", "Save as…");
    desk.enter_path(&folder.path("ball.toml"));
    assert!(fs::read_to_string(folder.path("ball.toml")).unwrap().contains("fov = 33.0"));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told_and_what_was_there_stays() {
    let folder = Folder::new();
    // A link to the device that is always full: written to as it is.
    std::os::unix::fs::symlink("/dev/full", folder.path("full.toml")).unwrap();
    let mut desk = studio();
    desk.alter();
    desk.open_menu("File", "Save as…");
    desk.enter_path(&folder.path("full.toml"));
    desk.press_top("Replace");
    assert!(desk.says("the disk is full"), "told below the field");
    assert!(desk.path_field().ends_with("full.toml"));
    desk.press_top("Cancel");
    desk.open_menu("File", "New scene");
    assert!(desk.says("Save them?"), "it is not saved");
}

#[cfg(unix)]
#[test]
fn a_read_only_file_is_left_alone() {
    use std::os::unix::fs::PermissionsExt;
    let folder = Folder::new();
    let file = folder.write("ball.toml", BALL);
    let mut desk = studio_with(&file);
    fs::set_permissions(&file, fs::Permissions::from_mode(0o444)).unwrap();
    desk.alter();
    desk.key(Modifiers::COMMAND, Key::S);
    assert!(desk.says("read-only"));
    assert_eq!(fs::read_to_string(&file).unwrap(), BALL);
}

#[cfg(unix)]
#[test]
fn names_that_are_no_utf_8_are_opened_from_the_list() {
    use std::os::unix::ffi::OsStrExt;
    let folder = Folder::new();
    let odd = folder.0.join(std::ffi::OsStr::from_bytes(b"caf\xe9"));
    fs::create_dir(&odd).unwrap();
    fs::write(odd.join(std::ffi::OsStr::from_bytes(b"\xe9.toml")), BALL).unwrap();
    let mut desk = studio_with(&folder.write("ball.toml", BALL.replace("Ball", "Other")));
    desk.open_menu("File", "Open…");
    desk.press_top("caf?/");
    desk.press_top("?.toml");
    desk.press_top("Open");
    assert_eq!(desk.harness.state().scene().name, "Ball");
    desk.alter();
    desk.key(Modifiers::COMMAND, Key::S);
    assert!(desk.says("The scene is saved"));
}

#[test]
fn in_russian_it_is_said_what_the_details_are_about() {
    let folder = Folder::new();
    let mut desk = Desk::new(LANGUAGES[1]);
    desk.key(Modifiers::COMMAND, Key::O);
    for (path, about, detail) in [
        (folder.path("nowhere.toml"), "Файла нет, или его нельзя прочитать:", "no such file"),
        (folder.write("broken.toml", "luch = 1\nnome = 3\n"), "В файле ошибка:", "did you mean `name`"),
    ] {
        desk.type_into("Путь", &path.display().to_string());
        assert!(desk.says(about) && desk.says(detail), "{}", path.display());
    }
}

#[test]
fn a_picture_too_large_to_be_shown_says_what_to_do() {
    let folder = Folder::new();
    let huge = folder.write("huge.toml", BALL.replace("size = [64, 48]", "size = [65535, 65535]"));
    let mut desk = studio_with(&huge);
    assert!(desk.says("Choose a smaller size, or export the picture"));
    desk.resize(64, 48);
    assert_eq!(desk.picture().width, 64);
}
