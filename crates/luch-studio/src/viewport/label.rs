//! A few words over the picture.

use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, vec2};

/// Writes text beside a point: to the lower right, or where there is room.
pub(super) fn beside(painter: &Painter, at: Pos2, text: &str) {
    let galley = painter.layout_no_wrap(text.to_owned(), FontId::proportional(13.0), Color32::WHITE);
    let mut place = Rect::from_min_size(at + vec2(18.0, 18.0), galley.size()).expand(5.0);
    let room = painter.clip_rect();
    if place.right() > room.right() {
        place = place.translate(vec2(-place.width() - 30.0, 0.0));
    }
    if place.bottom() > room.bottom() {
        place = place.translate(vec2(0.0, -place.height() - 30.0));
    }
    painter.rect_filled(place, 4.0, Color32::from_black_alpha(190));
    painter.galley(place.min + vec2(5.0, 5.0), galley, Color32::WHITE);
}

/// Writes text into the middle of the upper part of an area, more or less transparent.
pub(super) fn above(painter: &Painter, area: Rect, text: &str, strength: f32) {
    let white = Color32::WHITE.gamma_multiply(strength);
    let galley = painter.layout(text.to_owned(), FontId::proportional(15.0), white, area.width() * 0.8);
    let size = galley.size() + vec2(24.0, 16.0);
    let place = Align2::CENTER_TOP.align_size_within_rect(size, area.shrink(16.0));
    painter.rect_filled(place, 6.0, Color32::from_black_alpha(190).gamma_multiply(strength));
    painter.galley(place.min + vec2(12.0, 8.0), galley, white);
}
