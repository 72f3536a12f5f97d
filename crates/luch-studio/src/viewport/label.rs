//! A few words beside the pointer.

use egui::{Color32, FontId, Painter, Pos2, Rect, vec2};

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
