//! Without live update changes wait for the button, and the window says so. Work that is under way can be stopped.

use crate::support::{Desk, LANGUAGES};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};

const WAITING: [&str; 2] = ["Changes wait for the button", "Изменения ждут кнопки"];
const CANCEL: [&str; 2] = ["Cancel", "Прервать"];

#[test]
fn without_live_update_changes_wait_and_are_marked() {
    for (words, waiting) in LANGUAGES.into_iter().zip(WAITING) {
        let mut desk = Desk::new(words);
        desk.resize(80, 60);
        desk.set_live(false);
        let first = desk.moment();
        assert!(!desk.says(waiting), "nothing waits yet");

        desk.type_into(words.field_of_view, "60");
        assert!(desk.moment().scene != first.scene, "the scene changes at once");
        assert!(desk.picture() == first.picture, "the picture does not");
        assert!(desk.says(waiting), "nothing is said about it");
        // More changes, and one that is taken back, wait as well.
        desk.tick(words.antialiasing);
        desk.key(Modifiers::COMMAND, Key::Z);
        desk.choose(words.camera, "Camera 2");
        assert!(desk.picture() == first.picture);
        assert!(desk.says(waiting));

        let after = desk.render();
        assert!(after != first.picture);
        assert!(!desk.says(waiting), "nothing waits any more");

        // Switched on again, live update shows what waited.
        desk.choose(words.camera, "Camera 3");
        assert!(desk.picture() == after && desk.says(waiting));
        desk.set_live(true);
        assert!(desk.picture() != after && !desk.says(waiting));
        let with_camera_3 = desk.picture();
        desk.type_into(words.field_of_view, "70");
        assert!(desk.picture() != with_camera_3, "a change shows by itself");
    }
}

#[test]
fn the_button_makes_the_same_picture_again() {
    for words in LANGUAGES {
        let mut desk = Desk::new(words);
        desk.resize(80, 60);
        let before = desk.moment();
        desk.render();
        assert!(desk.moment() == before);
    }
}

#[test]
fn a_picture_under_way_can_be_stopped_and_the_window_goes_on() {
    for (words, cancel) in LANGUAGES.into_iter().zip(CANCEL) {
        let mut desk = Desk::new(words);
        let is_busy =
            |desk: &Desk| !desk.harness.get_by_role_and_label(Role::Button, cancel).accesskit_node().is_disabled();
        assert!(!is_busy(&desk), "there is nothing to stop");
        // So many rays that they take minutes.
        desk.set_live(false);
        desk.tick(words.antialiasing);
        desk.type_into(words.rays_per_pixel, "4096");
        desk.harness.get_by_role_and_label(Role::Button, words.render).click();
        for _ in 0..4 {
            desk.harness.step();
        }
        assert!(is_busy(&desk), "the picture is under way");
        desk.press(cancel);
        assert!(!is_busy(&desk));
        // Whatever came of it, the next picture is whole.
        desk.tick(words.antialiasing);
        desk.resize(80, 60);
        desk.render();
        let whole = desk.picture();
        assert_eq!((whole.width, whole.height), (80, 60));
        assert!(desk.render() == whole);
    }
}
