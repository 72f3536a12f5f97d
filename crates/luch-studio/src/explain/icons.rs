//! Small drawings of the kinds of rays.

use super::looks::Look;
use egui::{Color32, Painter, Rect, Shape, Stroke, pos2, vec2};

/// Draws the kind of a ray into a square of side 16.
pub(super) fn paint(painter: &Painter, rect: Rect, look: Look, color: Color32) {
    let center = rect.center();
    let at = |x: f32, y: f32| center + vec2(x, y);
    let stroke = Stroke::new(1.4, color);
    let line = |points: &[(f32, f32)]| {
        painter.add(Shape::line(points.iter().map(|&(x, y)| at(x, y)).collect(), stroke));
    };
    match look {
        // An eye.
        Look::Camera => {
            let lid = |bend: f32| {
                let point = move |x: i8| (f32::from(x), bend * (1.0 - f32::from(x * x) / 36.0));
                (-6..=6).map(point).collect::<Vec<_>>()
            };
            line(&lid(4.2));
            line(&lid(-4.2));
            painter.circle_filled(center, 1.9, color);
        }
        // A ray that comes down on a mirror and goes up again.
        Look::Mirror => {
            line(&[(-6.5, 5.5), (6.5, 5.5)]);
            line(&[(-5.5, -4.5), (0.0, 4.5), (5.0, -4.0)]);
            line(&[(1.6, -2.2), (5.2, -4.6), (5.6, -0.4)]);
        }
        // The sun, and the sun behind a bar.
        Look::Lit | Look::Blocked => {
            painter.circle_stroke(center, 2.8, stroke);
            let rays: [(f32, f32); 8] =
                [(1.0, 0.0), (0.7, 0.7), (0.0, 1.0), (-0.7, 0.7), (-1.0, 0.0), (-0.7, -0.7), (0.0, -1.0), (0.7, -0.7)];
            for (x, y) in rays {
                line(&[(x * 4.6, y * 4.6), (x * 6.6, y * 6.6)]);
            }
            if look == Look::Blocked {
                let ends = [pos2(center.x - 6.5, center.y + 6.5), pos2(center.x + 6.5, center.y - 6.5)];
                painter.line_segment(ends, Stroke::new(2.0, color));
            }
        }
    }
}
