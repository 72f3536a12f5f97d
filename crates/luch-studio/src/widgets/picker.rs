//! A patch of a colour that opens a picker: a square of saturation and brightness, and a strip of hues. Both are dragged
//! with the mouse or moved with the arrow keys.

use crate::l10n::Texts;
use crate::undo::Gesture;
use egui::ecolor::{hsv_from_rgb, rgb_from_hsv};
use egui::{
    Color32, Key, Mesh, Popup, PopupCloseBehavior, Pos2, Rect, Response, Role, Sense, Shape, Stroke, Ui, Vec2,
    WidgetInfo, pos2, remap_clamp, vec2,
};

/// The side of the square and the height of the strip, in points.
const SQUARE: f32 = 196.0;
const STRIP: f32 = 18.0;
/// How far an arrow key moves, as a part of the whole way.
const STEP: f32 = 0.01;
/// Parts of the square along each side: colours are blended within each, which is true only for small ones.
const CELLS: u32 = 14;

/// Hue, saturation and brightness, each from 0 to 1.
type Hsv = [f32; 3];

/// Shows the patch, and the picker while it is open. Answers with a new colour in sRGB bytes.
pub(crate) fn button(ui: &mut Ui, texts: &Texts, name: &str, rgb: [u8; 3]) -> (Response, Option<([u8; 3], Gesture)>) {
    let (rect, response) = ui.allocate_exact_size(vec2(40.0, ui.spacing().interact_size.y), Sense::click());
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::ColorWell, ui.is_enabled(), name);
        info.current_text_value = Some(hex(rgb));
        info
    });
    let visuals = *ui.style().interact(&response);
    let fill = Color32::from_rgb(rgb[0], rgb[1], rgb[2]);
    ui.painter().rect(rect.shrink(1.0), 3.0, fill, visuals.bg_stroke, egui::StrokeKind::Inside);
    if response.has_focus() {
        ui.painter().rect_stroke(rect, 3.0, ui.visuals().selection.stroke, egui::StrokeKind::Outside);
    }
    let popup = Popup::menu(&response).close_behavior(PopupCloseBehavior::CloseOnClickOutside).accessible_name(name);
    let picked = popup.show(|ui| picker(ui, texts, rgb)).and_then(|shown| shown.inner);
    (response, picked)
}

fn picker(ui: &mut Ui, texts: &Texts, rgb: [u8; 3]) -> Option<([u8; 3], Gesture)> {
    let memory = ui.scope_id().with("hue, saturation, brightness");
    // Greys have no hue and black has no saturation: those that were chosen last are kept for them.
    let kept: Option<Hsv> = ui.data(|d| d.get_temp(memory)).filter(|hsv| bytes(*hsv) == rgb);
    let mut hsv = kept.unwrap_or_else(|| {
        let (h, s, v) = hsv_from_rgb(rgb.map(|byte| f32::from(byte) / 255.0));
        [h, s, v]
    });
    let square = square(ui, &texts.color_shade(), &mut hsv);
    ui.add_space(4.0);
    let strip = strip(ui, &texts.color_hue(), &mut hsv);
    ui.data_mut(|d| d.insert_temp(memory, hsv));
    let id = if square.changed() { square.id } else { strip.id };
    (bytes(hsv) != rgb && (square.changed() || strip.changed())).then(|| (bytes(hsv), Gesture::Ongoing(id)))
}

/// Saturation to the right, brightness upwards.
fn square(ui: &mut Ui, name: &str, hsv: &mut Hsv) -> Response {
    let [hue, saturation, brightness] = *hsv;
    let place = vec2(saturation, 1.0 - brightness);
    let (rect, response, moved) = area(ui, vec2(SQUARE, SQUARE), place);
    if let Some(to) = moved {
        *hsv = [hue, to.x, 1.0 - to.y];
    }
    describe(ui, &response, name, hsv);
    let mut mesh = Mesh::default();
    for y in 0..=CELLS {
        for x in 0..=CELLS {
            let part = vec2(x as f32, y as f32) / CELLS as f32;
            mesh.colored_vertex(rect.lerp_inside(part), color([hue, part.x, 1.0 - part.y]));
        }
    }
    let row = CELLS + 1;
    for corner in (0..CELLS).flat_map(|y| (0..CELLS).map(move |x| y * row + x)) {
        mesh.add_triangle(corner, corner + 1, corner + row);
        mesh.add_triangle(corner + 1, corner + row + 1, corner + row);
    }
    ui.painter().add(Shape::mesh(mesh));
    let at = rect.lerp_inside(vec2(hsv[1], 1.0 - hsv[2]));
    mark(ui, &response, rect, at, color(*hsv));
    response
}

/// All hues from red over green and blue to red.
fn strip(ui: &mut Ui, name: &str, hsv: &mut Hsv) -> Response {
    let (rect, response, moved) = area(ui, vec2(SQUARE, STRIP), vec2(hsv[0], 0.5));
    if let Some(to) = moved {
        hsv[0] = to.x;
    }
    describe(ui, &response, name, hsv);
    // Between these six hues the bytes change in proportion, so that blending is true.
    let mut mesh = Mesh::default();
    for sixth in 0..=6_u32 {
        let part = sixth as f32 / 6.0;
        let hue = color([part, 1.0, 1.0]);
        mesh.colored_vertex(rect.lerp_inside(vec2(part, 0.0)), hue);
        mesh.colored_vertex(rect.lerp_inside(vec2(part, 1.0)), hue);
        if sixth > 0 {
            let corner = 2 * (sixth - 1);
            mesh.add_triangle(corner, corner + 1, corner + 2);
            mesh.add_triangle(corner + 1, corner + 3, corner + 2);
        }
    }
    ui.painter().add(Shape::mesh(mesh));
    mark(ui, &response, rect, rect.lerp_inside(vec2(hsv[0], 0.5)), color([hsv[0], 1.0, 1.0]));
    response
}

/// A place to drag in, and where in it one has gone from `place`: parts of its width and height.
fn area(ui: &mut Ui, size: Vec2, place: Vec2) -> (Rect, Response, Option<Vec2>) {
    let (rect, mut response) = ui.allocate_exact_size(size, Sense::click_and_drag());
    let mut to = place;
    if let Some(at) = response.interact_pointer_pos() {
        let part = |at: f32, from: f32, till: f32| remap_clamp(at, from..=till, 0.0..=1.0);
        to = vec2(part(at.x, rect.left(), rect.right()), part(at.y, rect.top(), rect.bottom()));
    }
    if response.has_focus() {
        let filter = egui::EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
        ui.memory_mut(|m| m.set_focus_lock_filter(response.id, filter));
        let pressed = |key: Key| ui.input(|i| i.num_presses(key)) as f32 * STEP;
        to.x += pressed(Key::ArrowRight) - pressed(Key::ArrowLeft);
        to.y += pressed(Key::ArrowDown) - pressed(Key::ArrowUp);
        to = to.clamp(Vec2::ZERO, Vec2::splat(1.0));
    }
    let moved = (to != place).then_some(to);
    if moved.is_some() {
        response.mark_changed();
    }
    (rect, response, moved)
}

fn describe(ui: &Ui, response: &Response, name: &str, hsv: &Hsv) {
    response.widget_info(|| {
        let mut info = WidgetInfo::labeled(Role::Slider, ui.is_enabled(), name);
        info.current_text_value = Some(hex(bytes(*hsv)));
        info
    });
}

/// A ring where the colour is, told apart from any colour.
fn mark(ui: &Ui, response: &Response, rect: Rect, at: Pos2, fill: Color32) {
    let radius = if response.has_focus() { 8.0 } else { 6.0 };
    let inside = rect.shrink(1.0);
    let at = pos2(at.x.clamp(inside.left(), inside.right()), at.y.clamp(inside.top(), inside.bottom()));
    ui.painter().circle(at, radius, fill, Stroke::new(3.0, Color32::BLACK));
    ui.painter().circle_stroke(at, radius, Stroke::new(1.5, Color32::WHITE));
}

fn color(hsv: Hsv) -> Color32 {
    let [r, g, b] = bytes(hsv);
    Color32::from_rgb(r, g, b)
}

fn bytes([h, s, v]: Hsv) -> [u8; 3] {
    rgb_from_hsv((h, s, v)).map(|part| (part * 255.0).round().clamp(0.0, 255.0) as u8)
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_byte_survives_hue_saturation_and_brightness() {
        for r in (0..=255).step_by(15) {
            for g in (0..=255).step_by(17) {
                for b in (0..=255).step_by(5) {
                    let (h, s, v) = hsv_from_rgb([r, g, b].map(|byte: u8| f32::from(byte) / 255.0));
                    assert_eq!(bytes([h, s, v]), [r, g, b]);
                }
            }
        }
    }
}
