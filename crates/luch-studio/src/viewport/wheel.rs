//! The wheel: nearer to what is under the pointer, or away from it.

use super::navigation::Sight;
use crate::state::Desk;
use crate::view::walls::Walls;
use egui::{Pos2, Response, Ui};
use glam::DVec3;

/// The logarithm of how much shorter the way gets for one point of scrolling: a notch of 40 points takes a seventh.
const NEARER_A_POINT: f64 = 0.15 / 40.0;
/// A pointer that has moved by so many points is on something else.
const SAME: f32 = 3.0;

/// What the wheel moves towards.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Wheel {
    /// Where the pointer was, and the point of the scene there.
    towards: Option<(Pos2, DVec3)>,
}

impl Wheel {
    pub(super) fn take_input(&mut self, ui: &Ui, response: &Response, sight: &Sight<'_>, desk: &mut Desk<'_>) {
        let (delta, scrolling) = ui.input(|i| (i.smooth_scroll_delta().y, i.is_scrolling()));
        let Some(pointer) = response.hover_pos().filter(|_| scrolling) else {
            self.towards = None;
            return;
        };
        if delta == 0.0 {
            return;
        }
        // The same point as long as the wheel turns: pictures lag behind it, and what they show under the pointer would
        // wander.
        let known = self.towards.filter(|(at, _)| at.distance(pointer) < SAME);
        let (at, towards) = known.unwrap_or_else(|| (pointer, sight.ahead(pointer)));
        self.towards = Some((at, towards));
        let eye = sight.eye.dolly(towards, (-f64::from(delta) * NEARER_A_POINT).exp());
        // What one moves towards is seen: only the way back may lead through a wall.
        let eye = if delta < 0.0 { Walls::of(desk.scene()).go(&sight.eye, eye) } else { eye };
        sight.show(eye, desk);
    }
}
