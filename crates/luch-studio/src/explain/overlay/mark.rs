//! The cross that marks the pixel.

use crate::viewport::PictureFrame;
use egui::{Color32, Painter, Rect, Stroke, StrokeKind, Vec2, vec2};

/// Where the arms of the cross begin and end, in points from the pixel's edge.
const ARM: [f32; 2] = [5.0, 15.0];

pub(super) fn draw(painter: &Painter, frame: &PictureFrame, [x, y]: [u32; 2]) {
    let [x, y] = [x as f32, y as f32];
    let pixel = Rect::from_min_max(frame.point_of_pixel(x, y), frame.point_of_pixel(x + 1.0, y + 1.0));
    let center = pixel.center();
    let half = pixel.size() * 0.5;
    // Dark below light, so that it is seen on any ground.
    for (width, color) in [(4.0, Color32::from_black_alpha(170)), (1.6, Color32::WHITE)] {
        let stroke = Stroke::new(width, color);
        for way in [Vec2::RIGHT, Vec2::DOWN, Vec2::LEFT, Vec2::UP] {
            let edge = center + way * half;
            painter.line_segment([edge + way * ARM[0], edge + way * ARM[1]], stroke);
        }
        // A pixel that is large enough to be seen has its own border.
        if half.min_elem() > 3.0 {
            painter.rect_stroke(pixel.expand(1.0), 0.0, stroke, StrokeKind::Outside);
        } else {
            painter.rect_stroke(Rect::from_center_size(center, vec2(7.0, 7.0)), 0.0, stroke, StrokeKind::Middle);
        }
    }
}
