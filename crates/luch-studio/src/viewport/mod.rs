//! The picture: shown, enlarged, pointed at.

mod canvas;
mod explaining;
pub(crate) mod focus;
mod frame;
mod ghost;
mod gizmo;
mod label;
mod legend;
mod lights;
mod loading;
mod lookup;
mod navigation;
mod outline;
mod toolbar;
mod wheel;

use crate::command::Command;
use crate::explain;
use crate::panels::scene_name;
use crate::selection::Part;
use crate::state::Desk;
use canvas::Canvas;
use egui::{CentralPanel, Color32, Context, Frame, Id, Painter, Response, Sense, Stroke, StrokeKind, Ui};
pub(crate) use frame::PictureFrame;
use gizmo::Gizmo;
use luch_render::session::live::{Snapshot, pick};
use navigation::Navigation;
use std::sync::Arc;

pub(crate) use legend::name as view_name;

/// Shows the picture in what the panels have left of the window.
pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    CentralPanel::default().frame(Frame::central_panel(ui.style()).inner_margin(0)).show(ui, |ui| {
        toolbar::show(ui, desk);
        let area = ui.available_rect_before_wrap();
        // A name of its own, so that it keeps the focus when a panel opens beside it.
        let response = ui.interact(area, Id::unique("the picture"), Sense::click_and_drag());
        ui.advance_cursor_after_rect(area);
        name_for_readers(&response, desk);
        let painter = ui.painter_at(area);
        painter.rect_filled(area, 0.0, surround(ui));
        let mut canvas = Canvas::load(ui.ctx());
        // What is being dragged stays where it is.
        if !is_dragging(ui.ctx()) {
            canvas.take_input(ui, &response, desk);
        }
        if let Some((snapshot, texture)) = desk.render.picture() {
            let snapshot = Arc::clone(snapshot);
            let size = snapshot.job.size;
            let rect = canvas.picture_rect(area, size, desk.state.zoom, ui.pixels_per_point());
            texture.draw(&painter, rect);
            let frame = PictureFrame::new(rect, &snapshot.job.camera, size);
            work_in(ui, &painter, &response, &frame, &snapshot, desk);
        }
        loading::draw(&painter, area, desk);
        canvas.store(ui.ctx());
    });
}

/// Takes what mouse and keys do in the picture, and draws over it what belongs to it.
fn work_in(
    ui: &Ui,
    painter: &Painter,
    response: &Response,
    frame: &PictureFrame,
    snapshot: &Snapshot,
    desk: &mut Desk<'_>,
) {
    explaining::take_input(ui, response, frame, desk);
    let mut gizmo = Gizmo::load(ui.ctx());
    let mut navigation = Navigation::load(ui.ctx());
    if !navigation.is_dragging() {
        gizmo.take_input(ui, response, frame, desk);
    }
    if !gizmo.has_pointer() || navigation.is_dragging() {
        navigation.take_input(ui, response, frame, snapshot, desk);
    }
    // What lies under a handle, or passes under the pointer while the view moves, is not pointed at.
    let is_free = !gizmo.has_pointer() && !navigation.is_dragging();
    let under = response.hover_pos().filter(|_| is_free).and_then(|at| part_at(at, frame, snapshot, desk));
    set_under_pointer(ui.ctx(), under);
    // A key that presses what has the focus is no click on a place.
    let clicked = response.clicked() && response.interact_pointer_pos().is_some();
    // The keys belong to where one works.
    if clicked || response.drag_started() {
        response.request_focus();
    }
    if clicked && desk.state.tool.selects() && is_free {
        desk.send(Command::Select(under));
    }
    focus::show(painter, response, clicked, frame, snapshot, desk);
    ghost::draw(painter, frame.rect, snapshot, desk);
    draw_marks(painter, frame, snapshot, desk, under);
    gizmo.draw(painter, response, frame, desk);
    if response.has_focus() {
        let color = ui.visuals().selection.stroke.color.gamma_multiply(0.4);
        painter.rect_stroke(response.rect, 0.0, Stroke::new(1.0, color), StrokeKind::Inside);
    }
    navigation.store(ui.ctx());
    gizmo.store(ui.ctx());
}

/// Whether a drag in the picture is going on that Escape takes back.
pub(crate) fn is_dragging(ctx: &Context) -> bool {
    Navigation::load(ctx).is_dragging() || Gizmo::load(ctx).is_dragging()
}

/// Outlines of what is selected and pointed at, and the lamps.
fn draw_marks(painter: &Painter, frame: &PictureFrame, snapshot: &Snapshot, desk: &Desk<'_>, under: Option<Part>) {
    let selected = desk.state.selection;
    if let Some(part) = under.filter(|part| Some(*part) != selected) {
        outline::draw(painter, frame, snapshot, desk, part, outline::Strength::Faint);
    }
    if let Some(part) = selected {
        outline::draw(painter, frame, snapshot, desk, part, outline::Strength::Crisp);
    }
    lights::draw(painter, frame, desk, under);
    legend::draw(painter, frame.rect, snapshot.job.integrator, desk.texts);
    explain::draw_over_picture(painter, frame, &desk.state.explain, desk.texts);
}

/// The lamp or object that is drawn at a point of the window.
fn part_at(at: egui::Pos2, frame: &PictureFrame, snapshot: &Snapshot, desk: &Desk<'_>) -> Option<Part> {
    if let Some(lamp) = lights::at(at, frame, desk) {
        return Some(lamp);
    }
    let [x, y] = frame.pixel_at(at)?;
    let object = pick(&snapshot.compiled, &snapshot.job, x, y)?.object;
    lookup::same_object(&snapshot.scene, object, desk.scene()).map(Part::Object)
}

/// A neutral grey around the picture, so that no colour beside it deceives the eye.
fn surround(ui: &Ui) -> Color32 {
    if ui.visuals().dark_mode { Color32::from_gray(24) } else { Color32::from_gray(200) }
}

fn name_for_readers(response: &Response, desk: &Desk<'_>) {
    let texts = desk.texts;
    let scene = scene_name(&desk.state.document, texts);
    let camera = desk.state.camera().map(|camera| camera.name).unwrap_or_default();
    let description = match desk.state.selection.and_then(|part| part.name(desk.scene())) {
        Some(selected) => texts.picture_with_selection(scene, camera, selected),
        None => texts.picture_of(scene, camera),
    };
    let name = texts.picture();
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, &name));
    response.ctx.accesskit_node_builder(response.id, |node| node.set_description(description));
}

fn under_pointer_id() -> Id {
    Id::unique("part under the pointer")
}

/// The part of the scene that the pointer is on in the picture.
pub(crate) fn under_pointer(ctx: &Context) -> Option<Part> {
    ctx.data(|d| d.get_temp::<Option<Part>>(under_pointer_id())).flatten()
}

fn set_under_pointer(ctx: &Context, part: Option<Part>) {
    let changed = ctx.data_mut(|d| {
        let slot = d.get_temp_mut_or_default::<Option<Part>>(under_pointer_id());
        std::mem::replace(slot, part) != part
    });
    // The status line is drawn before the picture is.
    if changed {
        ctx.request_repaint();
    }
}
