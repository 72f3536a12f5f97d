//! Pictures of the window, compared with stored ones in `tests/snapshots`. After a change that is meant:
//! `UPDATE_SNAPSHOTS=1 cargo test -p luch-studio --test window snapshots`, and look at them.
//!
//! Times, speeds and what the machine is are fixed by `Start::still`, so that nothing in them depends on it. Without a
//! driver that draws, such as lavapipe, the tests fail. Drivers differ in the rounding of a few pixels; a changed letter
//! is more than that.

use crate::support::{Desk, LANGUAGES, Words};
use egui::{Key, Modifiers};
use egui_kittest::SnapshotOptions;
use luch_studio::Start;

/// What is not in [`Words`], in each language: how to choose the light theme, and how to open the study.
const LIGHT: [[&str; 3]; 2] = [["View", "Theme", "Light"], ["Вид", "Оформление", "Светлое"]];
const STUDY: [[&str; 2]; 2] = [["View", "Study…"], ["Вид", "Исследование…"]];

const ENGLISH: usize = 0;
const RUSSIAN: usize = 1;

/// A window of 1280 x 720 points, the picture pixel for pixel in it and small.
struct Sitting {
    desk: Desk,
    words: Words,
}

impl Sitting {
    fn new(language: usize, is_light: bool, start: Start) -> Self {
        Self::at(language, is_light, 1.0, start)
    }

    fn at(language: usize, is_light: bool, pixels_per_point: f32, start: Start) -> Self {
        let words = LANGUAGES[language];
        let start = Start { still: true, ..start };
        let mut desk = Desk::in_window(words, start, [1280.0, 720.0], pixels_per_point);
        desk.harness.set_render_cursor(false);
        if is_light {
            desk.menu(&LIGHT[language]);
        }
        desk.resize(240, 180);
        desk.press("1:1");
        Self { desk, words }
    }

    /// The knight, selected.
    fn with_knight(mut self) -> Self {
        self.desk.choose(self.words.scene, self.words.knight);
        self.desk.resize(240, 135);
        self.desk.select_in_list("Knight");
        self
    }

    /// A click on the left of the two spheres, explained.
    fn with_explained_pixel(mut self) -> Self {
        self.desk.key(Modifiers::NONE, Key::X);
        let at = self.desk.middle_of_picture();
        self.desk.click_at(at + egui::vec2(-34.0, 0.0));
        self
    }

    /// Compares the window as it is with the stored picture of that name.
    fn compare(mut self, name: &str) {
        self.desk.harness.remove_cursor();
        self.desk.settle();
        // A letter is some dozen pixels.
        let options = SnapshotOptions::new().threshold(0.6).max_failed_pixels(8);
        self.desk.harness.snapshot_options(name, &options);
    }
}

#[test]
fn english_in_the_dark_theme() {
    Sitting::new(ENGLISH, false, Start::default()).with_knight().compare("english_dark");
}

#[test]
fn english_in_the_light_theme() {
    Sitting::new(ENGLISH, true, Start::default()).with_knight().compare("english_light");
}

#[test]
fn russian_in_the_dark_theme() {
    Sitting::new(RUSSIAN, false, Start::default()).with_knight().compare("russian_dark");
}

#[test]
fn russian_in_the_light_theme() {
    Sitting::new(RUSSIAN, true, Start::default()).with_knight().compare("russian_light");
}

#[test]
fn english_in_the_light_theme_at_150_percent() {
    Sitting::at(ENGLISH, true, 1.5, Start::default()).with_knight().compare("english_light_150");
}

#[test]
fn russian_in_the_dark_theme_at_150_percent() {
    Sitting::at(RUSSIAN, false, 1.5, Start::default()).with_knight().compare("russian_dark_150");
}

#[test]
fn an_explained_pixel_in_english() {
    Sitting::new(ENGLISH, false, Start::default()).with_explained_pixel().compare("explained_english_dark");
}

#[test]
fn an_explained_pixel_in_russian() {
    Sitting::new(RUSSIAN, true, Start::default()).with_explained_pixel().compare("explained_russian_light");
}

#[test]
fn the_hints_of_the_first_run() {
    Sitting::new(RUSSIAN, false, Start { hints: true, ..Start::default() }).compare("hints_russian_dark");
}

#[test]
fn the_question_before_changes_are_lost() {
    let mut sitting = Sitting::new(RUSSIAN, true, Start::default());
    sitting.desk.type_into(sitting.words.field_of_view, "33");
    sitting.desk.key(Modifiers::COMMAND, Key::N);
    assert!(sitting.desk.says("Сохранить их?"));
    sitting.compare("unsaved_russian_light");
}

#[test]
fn the_study_before_it_begins() {
    let mut sitting = Sitting::new(ENGLISH, false, Start::default());
    sitting.desk.menu(&STUDY[ENGLISH]);
    sitting.compare("study_english_dark");
}
