//! The mouse in the picture, as a person moves it.

use crate::support::Desk;
use egui::{Event, Modifiers, MouseWheelUnit, PointerButton, Pos2, TouchPhase, Vec2};

/// Steps of a drag: each a frame of its own, so that pictures come and go meanwhile.
const STEPS: usize = 6;

/// A button that is held down in the picture.
pub(crate) struct Held {
    at: Pos2,
    button: PointerButton,
    modifiers: Modifiers,
}

/// Presses a button at a point of the window.
pub(crate) fn press(desk: &mut Desk, at: Pos2, button: PointerButton, modifiers: Modifiers) -> Held {
    desk.harness.event(Event::ModifiersChanged(modifiers));
    desk.harness.event(Event::PointerMoved(at));
    desk.harness.step();
    desk.harness.event(Event::PointerButton { pos: at, button, pressed: true, modifiers });
    desk.harness.step();
    Held { at, button, modifiers }
}

impl Held {
    /// Moves the pointer by a way, in points.
    pub(crate) fn drag(mut self, desk: &mut Desk, by: Vec2) -> Self {
        let from = self.at;
        for step in 1..=STEPS {
            self.at = from + by * (step as f32 / STEPS as f32);
            desk.harness.event(Event::PointerMoved(self.at));
            desk.harness.step();
        }
        self
    }

    /// Lets the button go and waits for the picture.
    pub(crate) fn release(self, desk: &mut Desk) {
        let Self { at: pos, button, modifiers } = self;
        desk.harness.event(Event::PointerButton { pos, button, pressed: false, modifiers });
        desk.harness.step();
        desk.harness.event(Event::ModifiersChanged(Modifiers::NONE));
        desk.settle();
    }
}

/// Drags with a button from a point of the window.
pub(crate) fn drag(desk: &mut Desk, from: Pos2, by: Vec2, button: PointerButton, modifiers: Modifiers) {
    press(desk, from, button, modifiers).drag(desk, by).release(desk);
}

/// Turns the wheel by notches at a point of the window and waits until all has come to rest.
pub(crate) fn scroll(desk: &mut Desk, at: Pos2, notches: f32) {
    desk.harness.event(Event::PointerMoved(at));
    desk.harness.step();
    desk.harness.event(Event::MouseWheel {
        unit: MouseWheelUnit::Line,
        delta: egui::vec2(0.0, notches),
        phase: TouchPhase::Move,
        source: egui::MouseWheelSource::Unknown,
        modifiers: Modifiers::NONE,
    });
    // The window spreads a notch over some frames.
    for _ in 0..30 {
        desk.harness.step();
    }
    desk.settle();
}

/// Presses a key and waits for the picture.
pub(crate) fn key(desk: &mut Desk, key: egui::Key) {
    desk.harness.key_press(key);
    desk.settle();
}
