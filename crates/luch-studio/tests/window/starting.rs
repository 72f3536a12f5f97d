//! Who measures how soon the window is there is told once of each step, in order.

use crate::support::{Desk, LANGUAGES};
use luch_studio::{Milestone, Start};
use std::sync::Mutex;

static TOLD: Mutex<Vec<Milestone>> = Mutex::new(Vec::new());

#[test]
fn each_step_of_the_start_is_told_once_and_in_order() {
    let tell = |milestone| TOLD.lock().unwrap().push(milestone);
    let mut desk = Desk::start(LANGUAGES[0], Start { milestone: Some(tell), ..Start::default() });
    // What a frame has drawn is told at the beginning of the next.
    desk.harness.step();
    assert_eq!(*TOLD.lock().unwrap(), Milestone::ALL);
    desk.resize(80, 60);
    assert_eq!(TOLD.lock().unwrap().len(), Milestone::ALL.len(), "a later picture is no start");
}
