//! The focus: set by a click, shown over the picture.

mod blur;
mod overlay;

use super::frame::PictureFrame;
use crate::command::{Command, Tool};
use crate::state::Desk;
use blur::Blur;
use egui::{Color32, Context, CursorIcon, Id, Painter, Pos2, Response, Stroke};
use luch_render::RenderJob;
use luch_render::session::live::{Snapshot, pick};
use luch_scene::{Positive, Sampling};

/// Asks for the focus to be shown in this frame: a control of the lens is being used.
pub(crate) fn show_while_used(ctx: &Context) {
    ctx.data_mut(|d| d.insert_temp(id(), true));
}

fn id() -> Id {
    Id::unique("focus is shown")
}

/// Shows what is in focus, if that is asked for, and takes a click with the tool for it.
pub(super) fn show(
    painter: &Painter,
    response: &Response,
    clicked: bool,
    frame: &PictureFrame,
    snapshot: &Snapshot,
    desk: &mut Desk<'_>,
) {
    let with_tool = desk.state.tool == Tool::Focus;
    let wanted = painter.ctx().data_mut(|d| d.remove_temp::<bool>(id())).is_some();
    let Some(camera) = desk.state.camera().filter(|_| with_tool || wanted) else {
        overlay::forget(painter.ctx());
        return;
    };
    // The lens as it is set at this moment, and as if depth of field were on: one looks before one switches it on.
    let blur = Blur::of(&camera, snapshot.job.size);
    overlay::draw(painter, frame, snapshot, blur);
    if !with_tool {
        return;
    }
    let Some(at) = response.hover_pos().filter(|_| !response.dragged()) else { return };
    painter.ctx().set_cursor_icon(CursorIcon::Crosshair);
    let depth = depth_at(at, frame, snapshot);
    if clicked {
        desk.send(Command::FocusAt(depth));
    }
    tell(painter, at, frame, snapshot, depth, blur, desk);
}

/// How far along the view what is seen there lies: through the middle of the pixel and of the lens, whatever the picture
/// does to its rays.
fn depth_at(at: Pos2, frame: &PictureFrame, snapshot: &Snapshot) -> Option<Positive> {
    let [x, y] = frame.pixel_at(at)?;
    let off = |sampling: Sampling| Sampling { on: false, ..sampling };
    let job = &snapshot.job;
    let (antialiasing, depth_of_field) = (off(job.antialiasing), off(job.depth_of_field));
    let job = RenderJob { antialiasing, depth_of_field, ..job.clone() };
    let point = pick(&snapshot.compiled, &job, x, y)?.point;
    let way = point.as_dvec3() - job.camera.position.get().as_dvec3();
    Positive::try_from(way.dot(job.camera.frame()[2].as_dvec3())).ok()
}

/// Says beside the pointer how far away what is under it is and how blurred, and draws the circle of confusion.
fn tell(
    painter: &Painter,
    at: Pos2,
    frame: &PictureFrame,
    snapshot: &Snapshot,
    depth: Option<Positive>,
    blur: Blur,
    desk: &Desk<'_>,
) {
    let texts = desk.texts;
    let depth_in_units = depth.map_or(f64::INFINITY, |depth| f64::from(depth.get()));
    let diameter = blur.diameter(depth_in_units);
    let pixel = frame.rect.height() / snapshot.job.size.height() as f32;
    let radius = (diameter * 0.5) as f32 * pixel;
    if radius > 1.0 {
        painter.circle_stroke(at, radius, Stroke::new(3.0, Color32::from_black_alpha(120)));
        painter.circle_stroke(at, radius, Stroke::new(1.5, Color32::WHITE));
    }
    let distance = match depth {
        Some(depth) => texts.focus_distance(rounded(f64::from(depth.get()))),
        None => texts.focus_nothing(),
    };
    let pixels = format!("{diameter:.1}");
    let blurred = match desk.scene().settings.depth_of_field.on {
        _ if blur.is_closed() => texts.focus_closed(),
        true => texts.focus_blur(pixels),
        false => texts.focus_blur_if_on(pixels),
    };
    super::label::beside(painter, at, &format!("{distance}\n{blurred}"));
}

/// A length with as many digits as a person can use.
fn rounded(length: f64) -> String {
    if (0.01..1e6).contains(&length) { format!("{length:.3}") } else { format!("{length:.3e}") }
}
