//! Changes are kept safe, and offered again when the program has died.

use crate::desk::{BALL, Folder};
use crate::support::{Desk, LANGUAGES};
use egui::{Key, Modifiers};
use luch_studio::Start;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::Duration;

/// A studio that keeps changes safe at once.
fn careful(data: &Path, scene: Option<&Path>) -> Desk {
    let scene = scene.and_then(luch_io::SceneSource::of_path);
    let data_dir = Some(data.to_owned());
    Desk::start(LANGUAGES[0], Start { scene, data_dir, keep_every: Some(Duration::ZERO), ..Start::default() })
}

/// The scenes that are kept at the moment.
fn kept(data: &Path) -> Vec<String> {
    let folders = fs::read_dir(data.join("recovery")).into_iter().flatten().map(|folder| folder.unwrap().path());
    folders.filter_map(|folder| fs::read_to_string(folder.join("scene.toml")).ok()).collect()
}

/// The studio ends by a panic; its scene was changed.
fn die(desk: Desk) {
    let died = catch_unwind(AssertUnwindSafe(|| {
        let _desk = desk;
        std::panic::panic_any("as planned");
    }));
    assert!(died.is_err());
}

#[test]
fn a_change_is_kept_until_it_is_saved_or_taken_back() {
    let folder = Folder::new();
    let mut desk = careful(&folder.0, Some(&folder.write("ball.toml", BALL)));
    assert!(kept(&folder.0).is_empty(), "nothing has changed");
    desk.type_into("Field of view", "33");
    assert!(kept(&folder.0)[0].contains("fov = 33.0"));
    desk.key(Modifiers::COMMAND, Key::Z);
    assert!(kept(&folder.0).is_empty(), "taken back");
    desk.type_into("Field of view", "44");
    desk.key(Modifiers::COMMAND, Key::S);
    assert!(kept(&folder.0).is_empty(), "saved");
    desk.type_into("Field of view", "55");
    assert_eq!(kept(&folder.0).len(), 1);
    drop(desk);
    assert_eq!(fs::read_dir(folder.path("recovery")).unwrap().count(), 0, "who closes it has decided");
}

#[test]
fn after_a_crash_the_scene_is_offered_and_recovered() {
    let folder = Folder::new();
    let file = folder.write("ball.toml", BALL);
    let mut desk = careful(&folder.0, Some(&file));
    desk.type_into("Field of view", "33");
    desk.open_menu("Add", "Sphere");
    die(desk);
    let mut desk = careful(&folder.0, None);
    assert!(desk.says("Luch ended without saving") && desk.says("Ball") && desk.says("less than a minute ago"));
    assert!(desk.says(&file.display().to_string()));
    desk.press_top("Recover");
    let scene = desk.harness.state().scene();
    assert_eq!((scene.name.as_str(), scene.cameras[0].fov.get()), ("Ball", 33.0));
    assert!(scene.object_named("Sphere").is_some());
    assert_eq!(kept(&folder.0).len(), 1, "it is this program's now");
    // It is a change of its file, and is saved there.
    desk.key(Modifiers::COMMAND, Key::S);
    assert!(fs::read_to_string(&file).unwrap().contains("fov = 33.0"));
    assert!(kept(&folder.0).is_empty());
    drop(desk);
    assert!(!careful(&folder.0, None).says("Luch ended without saving"));
}

#[test]
fn what_is_discarded_is_gone_and_what_is_left_is_offered_again() {
    let folder = Folder::new();
    let mut desk = careful(&folder.0, None);
    desk.type_into("Field of view", "33");
    die(desk);
    let mut desk = careful(&folder.0, None);
    desk.press_top("Later");
    drop(desk);
    let mut desk = careful(&folder.0, None);
    desk.press_top("Discard");
    assert!(!desk.offers("Discard") && kept(&folder.0).is_empty());
    assert_eq!(desk.harness.state().scene().name, "Two spheres");
}

#[test]
fn two_studios_keep_their_own_scenes() {
    let folder = Folder::new();
    let mut first = careful(&folder.0, Some(&folder.write("ball.toml", BALL)));
    first.type_into("Field of view", "33");
    let mut second = careful(&folder.0, None);
    assert!(!second.offers("Discard"), "the first one lives");
    second.type_into("Field of view", "44");
    assert_eq!(kept(&folder.0).len(), 2);
    drop(second);
    assert_eq!(kept(&folder.0).len(), 1);
    assert!(kept(&folder.0)[0].contains("fov = 33.0"));
}

#[test]
fn a_folder_that_cannot_be_written_is_told_and_the_work_goes_on() {
    let folder = Folder::new();
    let mut desk = careful(&folder.write("no folder", ""), None);
    desk.type_into("Field of view", "33");
    desk.wait(|desk| desk.says("Autosave failed"));
    desk.type_into("Field of view", "44");
    assert_eq!(desk.harness.state().scene().cameras[0].fov.get(), 44.0);
    // As soon as it can be written, it is, without another change.
    fs::remove_file(folder.path("no folder")).unwrap();
    desk.wait(|_| !kept(&folder.path("no folder")).is_empty());
    assert!(kept(&folder.path("no folder"))[0].contains("fov = 44.0"));
}
