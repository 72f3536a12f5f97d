//! The fourteen functional tests of the window: what a person does, and what the picture is to show.
//!
//! Each runs in both languages, with live update and without. The picture in the window must have the very bytes that
//! the renderer gives for the same scene, which are those of the command line; and it must show what the test is about.

#[path = "../support/mod.rs"]
mod support;

mod cameras;
mod effects;
mod light;
mod objects;
mod scenes;

use support::{Desk, LANGUAGES};

/// Does a test in both languages, and both where changes show by themselves and where they wait for the button.
fn everywhere(test: impl Fn(&mut Desk)) {
    for words in LANGUAGES {
        for live in [true, false] {
            let mut desk = Desk::new(words);
            desk.set_live(live);
            test(&mut desk);
        }
    }
}
