//! Pictures of the window, compared with stored ones. After a change that is meant: UPDATE_SNAPSHOTS=1, and look at them.
//!
//! Times, speeds and the number of cores are fixed by [`Start::still`], so that nothing in them depends on the machine.
//! The drivers that draw without a screen differ in the rounding of a few pixels; a changed letter is more than that.

use crate::support::{Desk, LANGUAGES};
use egui_kittest::SnapshotOptions;
use luch_studio::Start;

/// How to choose the light theme, in each language.
const LIGHT: [[&str; 3]; 2] = [["View", "Theme", "Light"], ["Вид", "Оформление", "Светлое"]];

/// A window of 1280 x 720 points with the knight selected, its picture pixel for pixel.
fn desk(language: usize, light: bool, pixels_per_point: f32) -> Desk {
    let words = LANGUAGES[language];
    let start = Start { still: true, ..Start::default() };
    let mut desk = Desk::in_window(words, start, [1280.0, 720.0], pixels_per_point);
    desk.harness.set_render_cursor(false);
    if light {
        desk.menu(&LIGHT[language]);
    }
    desk.choose(words.scene, words.knight);
    desk.resize(480, 270);
    desk.press("1:1");
    desk.select_in_list("Knight");
    desk.harness.remove_cursor();
    desk.settle();
    desk
}

fn compare(desk: &mut Desk, name: &str) {
    // A letter is some dozen pixels; drivers differ in a few of the edges of the outline and of icons.
    let options = SnapshotOptions::new().threshold(0.6).max_failed_pixels(8);
    desk.harness.snapshot_options(name, &options);
}

#[test]
fn english_in_the_dark_theme() {
    compare(&mut desk(0, false, 1.0), "english_dark");
}

#[test]
fn english_in_the_light_theme() {
    compare(&mut desk(0, true, 1.0), "english_light");
}

#[test]
fn russian_in_the_dark_theme() {
    compare(&mut desk(1, false, 1.0), "russian_dark");
}

#[test]
fn russian_in_the_light_theme() {
    compare(&mut desk(1, true, 1.0), "russian_light");
}

#[test]
fn russian_in_the_dark_theme_at_150_percent() {
    compare(&mut desk(1, false, 1.5), "russian_dark_150");
}

#[test]
fn english_in_the_light_theme_at_150_percent() {
    compare(&mut desk(0, true, 1.5), "english_light_150");
}
