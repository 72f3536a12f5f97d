//! The camera by mouse and keys: around things, sideways, nearer. The camera of the scene stays where it is; only the
//! view's pose changes.
//!
//! A drag is worked out from where it began, so that its steps add no rounding and Escape leads back. What it turns
//! about is found in the picture that is shown, once: later pictures may lag behind the pointer.

use super::frame::PictureFrame;
use super::wheel::Wheel;
use crate::command::Command;
use crate::state::Desk;
use crate::view::extent::Extent;
use crate::view::eye::Eye;
use crate::view::walls::Walls;
use crate::view::{Pose, slope_of};
use egui::{Context, CursorIcon, EventFilter, Id, Key, Modifiers, PointerButton, Pos2, Response, Ui};
use glam::DVec3;
use luch_render::session::live::{Snapshot, pick};
use luch_scene::Camera;
use std::sync::Arc;

/// The turn for a drag of one point, in radians: half a turn in about the height of a picture.
const TURN_A_POINT: f64 = 0.4 * std::f64::consts::PI / 180.0;
/// The turn of an arrow key, in radians.
const TURN_A_KEY: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// The part of the picture's height that an arrow key with Shift moves by.
const PAN_A_KEY: f64 = 0.05;
/// How much of the way is left after plus.
const DOLLY_A_KEY: f64 = 0.9;
/// A point that is so many times farther than the scene reaches is of no use to turn about: it lies on the horizon.
const HORIZON: f64 = 4.0;

/// What a drag does.
#[derive(Debug, Clone, Copy)]
enum Grip {
    /// Turns about a point.
    Orbit(DVec3),
    /// Moves sideways, so that what lies at this depth stays under the pointer.
    Pan(f64),
}

/// A drag that is going on.
#[derive(Debug, Clone)]
struct Drag {
    grip: Grip,
    /// Where it began, in the window.
    from: Pos2,
    /// The eye then.
    start: Eye,
    /// The walls then.
    walls: Arc<Walls>,
    /// The view's pose then.
    before: Option<Pose>,
}

/// What is remembered from frame to frame.
#[derive(Debug, Clone, Default)]
pub(super) struct Navigation {
    drag: Option<Drag>,
    wheel: Wheel,
}

impl Navigation {
    fn id() -> Id {
        Id::unique("navigation")
    }

    pub(super) fn load(ctx: &Context) -> Self {
        ctx.data(|d| d.get_temp(Self::id())).unwrap_or_default()
    }

    pub(super) fn store(self, ctx: &Context) {
        ctx.data_mut(|d| d.insert_temp(Self::id(), self));
    }

    pub(super) const fn is_dragging(&self) -> bool {
        self.drag.is_some()
    }

    /// Moves the view as mouse and keys say.
    pub(super) fn take_input(
        &mut self,
        ui: &Ui,
        response: &Response,
        frame: &PictureFrame,
        snapshot: &Snapshot,
        desk: &mut Desk<'_>,
    ) {
        let Some(camera) = desk.state.camera() else { return };
        let sight = Sight { frame, snapshot, eye: Eye::of(&camera), camera: &camera };
        self.take_drag(ui, response, &sight, desk);
        if self.drag.is_none() {
            self.wheel.take_input(ui, response, &sight, desk);
            take_keys(ui, response, &sight, desk);
        }
    }

    fn take_drag(&mut self, ui: &Ui, response: &Response, sight: &Sight<'_>, desk: &mut Desk<'_>) {
        if let Some(drag) = &self.drag {
            if ui.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Escape)) {
                desk.send(Command::SetPose(drag.before));
                self.drag = None;
            } else if !response.dragged() {
                self.drag = None;
            }
        } else if let Some(grip) = begun(ui, response)
            && let Some(from) = ui.input(|i| i.pointer.press_origin())
        {
            let grip = if grip { Grip::Orbit(sight.pivot(from, desk)) } else { Grip::Pan(sight.depth_under(from)) };
            let walls = Arc::new(Walls::of(desk.scene()));
            self.drag = Some(Drag { grip, from, start: sight.eye, walls, before: desk.state.view.pose });
        }
        let Some(drag) = &self.drag else { return };
        let Some(at) = response.interact_pointer_pos() else { return };
        ui.set_cursor_icon(CursorIcon::Grabbing);
        let by = at - drag.from;
        let (dx, dy) = (f64::from(by.x), f64::from(by.y));
        let eye = match drag.grip {
            Grip::Orbit(pivot) => drag.walls.orbit(&drag.start, pivot, dx * TURN_A_POINT, -dy * TURN_A_POINT),
            Grip::Pan(depth) => {
                let [right, up] = sight.frame.slope_of_points(by);
                drag.walls.go(&drag.start, drag.start.pan(-right * depth, -up * depth))
            }
        };
        sight.show(eye, desk);
    }
}

/// Whether a drag begins, and whether it is an orbit or else a pan.
fn begun(ui: &Ui, response: &Response) -> Option<bool> {
    if response.drag_started_by(PointerButton::Secondary) {
        return Some(false);
    }
    // With Ctrl the wheel zooms pixels; a drag with it is nothing yet.
    let started = response.drag_started_by(PointerButton::Primary) && !ui.input(|i| i.modifiers.command);
    started.then(|| !ui.input(|i| i.modifiers.shift))
}

/// The keys of the picture: arrows turn, with Shift they move, plus and minus go nearer and away.
fn take_keys(ui: &Ui, response: &Response, sight: &Sight<'_>, desk: &mut Desk<'_>) {
    if !response.has_focus() {
        return;
    }
    let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
    // With Shift first: without it, Shift does not matter.
    let presses = |modifiers, key| ui.input_mut(|i| i.count_and_consume_key(modifiers, key)) as f64;
    let [moved, turned] = [Modifiers::SHIFT, Modifiers::NONE].map(|modifiers| {
        let right = presses(modifiers, Key::ArrowRight) - presses(modifiers, Key::ArrowLeft);
        (right, presses(modifiers, Key::ArrowUp) - presses(modifiers, Key::ArrowDown))
    });
    let plain = |key| presses(Modifiers::NONE, key);
    let nearer = plain(Key::Plus) + plain(Key::Equals) - plain(Key::Minus);
    let middle = sight.frame.rect.center();
    if moved == (0.0, 0.0) && turned == (0.0, 0.0) && nearer == 0.0 {
        return;
    }
    let walls = Walls::of(desk.scene());
    let mut eye = sight.eye;
    if moved != (0.0, 0.0) {
        let step = 2.0 * slope_of(sight.camera) * PAN_A_KEY * sight.depth_under(middle);
        eye = walls.go(&eye, eye.pan(moved.0 * step, moved.1 * step));
    }
    if turned != (0.0, 0.0) {
        // The camera goes where the arrow points.
        eye = walls.orbit(&eye, sight.pivot(middle, desk), -turned.0 * TURN_A_KEY, -turned.1 * TURN_A_KEY);
    }
    if nearer != 0.0 {
        eye = walls.go(&eye, eye.dolly(sight.ahead(middle), DOLLY_A_KEY.powf(nearer)));
    }
    sight.show(eye, desk);
}

/// What is seen, and from where: the picture that is shown, and the camera as it is now.
pub(super) struct Sight<'a> {
    frame: &'a PictureFrame,
    snapshot: &'a Snapshot,
    pub(super) eye: Eye,
    camera: &'a Camera,
}

impl Sight<'_> {
    pub(super) fn show(&self, eye: Eye, desk: &mut Desk<'_>) {
        if eye != self.eye {
            desk.send(Command::SetPose(Some(eye.pose())));
        }
    }

    /// The point of a surface that the picture shows there, unless it lies on the horizon.
    fn point_under(&self, at: Pos2) -> Option<DVec3> {
        let [x, y] = self.frame.pixel_at(at)?;
        let point = pick(&self.snapshot.compiled, &self.snapshot.job, x, y)?.point.as_dvec3();
        let depth = self.eye.depth_of(point);
        let near = self.far_side().is_none_or(|far| (point - self.eye.position).length() <= far * HORIZON);
        // A picture that lags behind may show what the eye has passed.
        (depth > 0.0 && near).then_some(point)
    }

    /// The distance of the farthest corner of the box around all that is bounded.
    fn far_side(&self) -> Option<f64> {
        let bounds = self.snapshot.compiled.bounds();
        if bounds.is_empty() {
            return None;
        }
        bounds.corners().into_iter().map(|corner| (corner.as_dvec3() - self.eye.position).length()).reduce(f64::max)
    }

    /// How far the point looked at is; where there is none, the middle of the scene.
    fn depth_looked_at(&self) -> f64 {
        if let Some(reach) = self.eye.reach() {
            return reach;
        }
        let bounds = self.snapshot.compiled.bounds();
        let middle = self.eye.depth_of(bounds.center().as_dvec3());
        if !bounds.is_empty() && middle > 0.0 { middle } else { f64::from(self.camera.focus()) }
    }

    /// How far along the view lies what is seen there, or what is looked at.
    fn depth_under(&self, at: Pos2) -> f64 {
        self.point_under(at).map_or_else(|| self.depth_looked_at(), |point| self.eye.depth_of(point))
    }

    /// What to turn about: what is selected, or what is seen there, or what is looked at.
    fn pivot(&self, at: Pos2, desk: &Desk<'_>) -> DVec3 {
        let selected = desk.state.selection.and_then(|part| Extent::of(part, desk.scene()));
        let selected = selected.map(|extent| extent.center);
        selected.or_else(|| self.point_under(at)).unwrap_or_else(|| self.eye.point_at([0.0; 2], self.depth_looked_at()))
    }

    /// What to move towards: what is seen there; where nothing is, a point beyond the scene, so that the way into it
    /// does not end in empty space.
    pub(super) fn ahead(&self, at: Pos2) -> DVec3 {
        self.point_under(at).unwrap_or_else(|| {
            let looked_at = self.depth_looked_at();
            let depth = self.far_side().map_or(looked_at, |far| far.max(looked_at));
            self.eye.point_at(self.frame.slope_at(at), depth)
        })
    }
}
