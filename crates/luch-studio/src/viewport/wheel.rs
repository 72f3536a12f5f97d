//! The wheel: nearer to what is under the pointer, or away from it.

use super::navigation::Sight;
use crate::state::Desk;
use crate::view::walls::Walls;
use egui::{Pos2, Response, Ui};
use glam::DVec3;
use std::sync::Arc;

/// The logarithm of how much shorter the way gets for one point of scrolling: a notch of 40 points takes a seventh.
const NEARER_A_POINT: f64 = 0.15 / 40.0;
/// A pointer that has moved by so many points is on something else.
const SAME: f32 = 3.0;

/// The wheel, and what it moves towards.
#[derive(Debug, Clone, Default)]
pub(super) struct Wheel {
    turning: Option<Turning>,
}

/// What is found out when the wheel begins to turn, once.
#[derive(Debug, Clone)]
struct Turning {
    /// Where the pointer was.
    at: Pos2,
    /// The point of the scene there. The same as long as the wheel turns: pictures lag behind it, and what they show
    /// under the pointer would wander.
    towards: DVec3,
    walls: Arc<Walls>,
}

impl Wheel {
    pub(super) fn take_input(&mut self, ui: &Ui, response: &Response, sight: &Sight<'_>, desk: &mut Desk<'_>) {
        let (delta, scrolling) = ui.input(|i| (i.smooth_scroll_delta().y, i.is_scrolling()));
        let Some(pointer) = response.hover_pos().filter(|_| scrolling) else {
            self.turning = None;
            return;
        };
        if delta == 0.0 {
            return;
        }
        if self.turning.as_ref().is_none_or(|turning| turning.at.distance(pointer) > SAME) {
            let (towards, walls) = (sight.ahead(pointer), Arc::new(Walls::of(desk.scene())));
            self.turning = Some(Turning { at: pointer, towards, walls });
        }
        let Some(turning) = &self.turning else { return };
        let eye = sight.eye.dolly(turning.towards, (-f64::from(delta) * NEARER_A_POINT).exp());
        // What one moves towards is seen: only the way back may lead through a wall.
        let eye = if delta < 0.0 { turning.walls.go(&sight.eye, eye) } else { eye };
        sight.show(eye, desk);
    }
}
