//! The lamps: lights have no size and are in no picture, so they are drawn over it.

use super::frame::PictureFrame;
use crate::selection::Part;
use crate::state::Desk;
use crate::widgets::icon::Icon;
use egui::{Color32, Painter, Pos2, Rect, Stroke, vec2};

/// How near to a lamp the pointer must be, in points.
const REACH: f32 = 11.0;

/// The lamp at a point of the window: the nearest of those in reach.
pub(super) fn at(point: Pos2, frame: &PictureFrame, desk: &Desk<'_>) -> Option<Part> {
    let near = marks(frame, desk).map(|(index, at)| (index, at.distance(point))).filter(|(_, away)| *away <= REACH);
    near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| Part::Light(index))
}

pub(super) fn draw(painter: &Painter, frame: &PictureFrame, desk: &Desk<'_>, under: Option<Part>) {
    for (index, at) in marks(frame, desk) {
        let part = Part::Light(index);
        let light = &desk.scene().lights[index];
        let [r, g, b] = light.color.to_srgb8();
        let color = if light.hidden { Color32::GRAY } else { Color32::from_rgb(r, g, b) };
        let selected = desk.state.selection == Some(part);
        // A dark disk below, so that a lamp is seen before a white wall as well.
        painter.circle_filled(at, 11.0, Color32::from_black_alpha(if selected { 220 } else { 130 }));
        if selected || under == Some(part) {
            painter.circle_stroke(at, 11.0, Stroke::new(2.0, super::outline::COLOR));
        }
        Icon::Lamp.paint(painter, Rect::from_center_size(at, vec2(16.0, 16.0)), color);
    }
}

/// The lamps that lie in the picture: their numbers and where they are seen.
fn marks<'a>(frame: &'a PictureFrame, desk: &'a Desk<'_>) -> impl Iterator<Item = (usize, Pos2)> + 'a {
    let lights = desk.state.scene().lights.iter().enumerate();
    let seen = lights.filter_map(|(index, light)| Some((index, frame.project(light.position.get().as_dvec3())?)));
    seen.filter(|(_, at)| frame.rect.contains(*at))
}
