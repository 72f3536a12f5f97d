//! Handles over the picture that move, turn and scale what is selected. All that they do can be typed in the panel too.
//!
//! They are drawn through the camera of the picture that is shown, so that they lie on what is seen even while a newer
//! picture is on its way; but around the place where the thing *is*, not where the picture still shows it. So a handle
//! never leaves the pointer that drags it, however long pictures take, and the picture and its outline come after. The
//! drag itself is measured through the camera of the moment when it began, and from there: which pictures come meanwhile
//! changes nothing in it.

mod euler;
mod grip;
mod handles;
mod math;
mod paint;
mod subject;

use super::frame::PictureFrame;
use super::label;
use crate::command::{Command, Tool};
use crate::state::Desk;
use crate::undo::Gesture;
use egui::{Context, CursorIcon, Id, Key, Modifiers, Painter, PointerButton, Response, Ui};
use grip::Grip;
use handles::{Handle, Handles};
use subject::{Change, Subject};

/// What is remembered from frame to frame.
#[derive(Debug, Clone, Default)]
pub(super) struct Gizmo {
    grip: Option<Grip>,
    /// The change that was sent last.
    sent: Option<Change>,
    /// The handle under the pointer.
    under: Option<Handle>,
}

impl Gizmo {
    fn id() -> Id {
        Id::unique("gizmo")
    }

    pub(super) fn load(ctx: &Context) -> Self {
        ctx.data(|d| d.get_temp(Self::id())).unwrap_or_default()
    }

    pub(super) fn store(self, ctx: &Context) {
        ctx.data_mut(|d| d.insert_temp(Self::id(), self));
    }

    pub(super) const fn is_dragging(&self) -> bool {
        self.grip.is_some()
    }

    /// Whether the pointer is on a handle or drags one, so that it is nobody else's.
    pub(super) const fn has_pointer(&self) -> bool {
        self.grip.is_some() || self.under.is_some()
    }

    pub(super) fn take_input(&mut self, ui: &Ui, response: &Response, frame: &PictureFrame, desk: &mut Desk<'_>) {
        self.under = None;
        if self.grip.is_some() {
            self.go_on(ui, response, desk);
            return;
        }
        let Some((subject, handles)) = of_selection(frame, desk) else { return };
        if response.drag_started_by(PointerButton::Primary)
            && let Some(from) = ui.input(|i| i.pointer.press_origin())
            && let Some(handle) = handles.at(from)
        {
            self.grip = Grip::new(handle, &handles, subject, from);
            self.sent = None;
            // A handle from which nothing can be told is still no place to turn the view by.
            self.under = Some(handle);
            self.go_on(ui, response, desk);
        } else if !response.dragged() {
            self.under = response.hover_pos().and_then(|at| handles.at(at));
        }
        if self.under.is_some() {
            ui.set_cursor_icon(CursorIcon::Grab);
        }
    }

    /// Goes on with a drag, or ends it.
    fn go_on(&mut self, ui: &Ui, response: &Response, desk: &mut Desk<'_>) {
        let Some(grip) = &mut self.grip else { return };
        let part = grip.subject.part;
        if desk.state.selection != Some(part) || !grip.subject.is_still_in(desk.scene()) {
            // It was deleted, or another scene came: what is there now is not what was grasped.
            self.grip = None;
            return;
        }
        if ui.input_mut(|i| i.consume_key(Modifiers::NONE, Key::Escape)) {
            desk.send(Command::TakeBack(Self::id()));
            self.grip = None;
            return;
        }
        if let Some(at) = response.interact_pointer_pos() {
            ui.set_cursor_icon(CursorIcon::Grabbing);
            let change = grip.drag_to(at, ui.input(|i| i.modifiers.command));
            // A drag that comes back to where it began is a change too, once there was one.
            let is_news = self.sent.map_or(!change.is_nothing(), |sent| sent != change);
            if is_news && let Some(edit) = grip.subject.edit(change) {
                desk.send(Command::Edit(edit, Gesture::Ongoing(Self::id())));
                self.sent = Some(change);
            }
        }
        if !response.dragged() {
            self.grip = None;
        }
    }

    pub(super) fn draw(&self, painter: &Painter, response: &Response, frame: &PictureFrame, desk: &Desk<'_>) {
        let Some((_, handles)) = of_selection(frame, desk) else { return };
        if handles.abilities.is_none() {
            let texts = desk.texts;
            let nothing = if desk.state.tool == Tool::Rotate { texts.gizmo_no_turn() } else { texts.gizmo_no_scale() };
            if let Some(center) = frame.project(handles.center) {
                label::beside(painter, center, &nothing);
            }
            return;
        }
        let held = self.grip.as_ref().map(|grip| grip.handle);
        paint::draw(painter, &handles, held.or(self.under), held.is_some());
        if let (Some(grip), Some(at)) = (&self.grip, response.interact_pointer_pos()) {
            label::beside(painter, at, &paint::amount(grip.handle, grip.change));
        }
    }
}

/// What is selected, with its handles, if the tool has any.
fn of_selection(frame: &PictureFrame, desk: &Desk<'_>) -> Option<(Subject, Handles)> {
    let tool = desk.state.tool;
    if !matches!(tool, Tool::Move | Tool::Rotate | Tool::Scale) {
        return None;
    }
    let subject = Subject::of(desk.state.selection?, desk.scene())?;
    let handles = Handles::of(&subject, tool, frame)?;
    Some((subject, handles))
}
