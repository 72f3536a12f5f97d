//! How the handles look: colours that stay apart for every eye, letters besides, a dark rim before any picture.

use super::handles::{DISK, Handle, Handles};
use super::subject::Change;
use crate::command::Tool;
use egui::{Align2, Color32, FontId, Painter, Pos2, Rect, Shape, Stroke, Vec2, vec2};
use glam::DVec3;

/// Vermilion, bluish green, sky blue: those of Okabe and Ito (2008).
const COLORS: [Color32; 3] =
    [Color32::from_rgb(238, 108, 40), Color32::from_rgb(30, 190, 140), Color32::from_rgb(86, 180, 233)];
const LETTERS: [&str; 3] = ["X", "Y", "Z"];
const WHOLE: Color32 = Color32::from_rgb(240, 240, 240);
/// What is pointed at or held.
const LIT: Color32 = Color32::from_rgb(255, 236, 110);
const RIM: Color32 = Color32::from_black_alpha(150);

/// Draws the handles; `lit` is pointed at or held, and while one is held the others are faint.
pub(super) fn draw(painter: &Painter, handles: &Handles, lit: Option<Handle>, held: bool) {
    let color = |handle| match lit {
        Some(lit) if lit == handle => LIT,
        _ if held => color_of(handle).gamma_multiply(0.25),
        _ => color_of(handle),
    };
    // What is first in the list is in front.
    let list = handles.list();
    for &handle in list.iter().rev() {
        draw_handle(painter, handles, handle, color(handle), lit == Some(handle));
    }
    for (axis, at) in letters(handles, &list) {
        let handle = if handles.tool == Tool::Rotate { Handle::Ring(axis) } else { Handle::Axis(axis) };
        painter.circle_filled(at, 8.5, RIM);
        painter.text(at, Align2::CENTER_CENTER, LETTERS[axis], FontId::proportional(13.0), color(handle));
    }
}

/// Where the letters of the axes stand: at the tips of arrows; on rings as far from each other as can be.
fn letters(handles: &Handles, list: &[Handle]) -> Vec<(usize, Pos2)> {
    let mut letters: Vec<(usize, Pos2)> = Vec::new();
    let Some((center, _)) = handles.circle() else { return letters };
    for handle in list {
        let place = match handle {
            Handle::Axis(axis) => handles.arrow(*axis).map(|[from, to]| (*axis, to + (to - from).normalized() * 17.0)),
            Handle::Ring(axis) => {
                let room = |at: Pos2| letters.iter().map(|(_, other)| other.distance(at)).fold(60.0, f32::min);
                let score = |at: Pos2| room(at) + at.distance(center);
                let front = handles.ring(*axis).into_iter().filter(|(_, front)| *front).map(|(piece, _)| piece[0]);
                let best = front.max_by(|a, b| score(*a).total_cmp(&score(*b)));
                best.map(|at| (*axis, at + (at - center).normalized() * 12.0))
            }
            _ => None,
        };
        letters.extend(place);
    }
    letters
}

const fn color_of(handle: Handle) -> Color32 {
    match handle {
        Handle::Axis(axis) | Handle::Plane(axis) | Handle::Ring(axis) => COLORS[axis],
        Handle::Free | Handle::Whole => WHOLE,
    }
}

fn draw_handle(painter: &Painter, handles: &Handles, handle: Handle, color: Color32, is_lit: bool) {
    let width = if is_lit { 3.5 } else { 2.5 };
    match handle {
        Handle::Axis(axis) => {
            let Some([from, to]) = handles.arrow(axis) else { return };
            let way = (to - from).normalized();
            line(painter, [from, to], width, color);
            if handles.tool == Tool::Scale {
                let tip = Rect::from_center_size(to, Vec2::splat(11.0));
                painter.rect_filled(tip.expand(1.5), 2.0, RIM);
                painter.rect_filled(tip, 1.0, color);
            } else {
                arrow_head(painter, to, way, color);
            }
        }
        Handle::Plane(axis) => {
            let Some(square) = handles.square(axis) else { return };
            let fill = color.gamma_multiply(if is_lit { 0.6 } else { 0.35 });
            painter.add(Shape::convex_polygon(square.to_vec(), fill, Stroke::new(1.5, color)));
        }
        Handle::Free => {
            let Some((center, _)) = handles.circle() else { return };
            painter.circle_filled(center, DISK + 1.5, RIM);
            painter.circle_filled(center, DISK - 3.0, color);
            painter.circle_stroke(center, DISK, Stroke::new(1.5, color));
        }
        Handle::Ring(axis) => {
            let pieces = handles.ring(axis);
            for (piece, front) in &pieces {
                if *front {
                    painter.line_segment(*piece, Stroke::new(width + 2.5, RIM));
                } else {
                    painter.line_segment(*piece, Stroke::new(1.0, color.gamma_multiply(0.35)));
                }
            }
            for (piece, _) in pieces.iter().filter(|(_, front)| *front) {
                painter.line_segment(*piece, Stroke::new(width, color));
            }
        }
        Handle::Whole => {
            let Some((center, radius)) = handles.circle() else { return };
            painter.circle_stroke(center, radius, Stroke::new(width + 2.5, RIM));
            painter.circle_stroke(center, radius, Stroke::new(width, color));
        }
    }
}

fn line(painter: &Painter, ends: [Pos2; 2], width: f32, color: Color32) {
    painter.line_segment(ends, Stroke::new(width + 2.5, RIM));
    painter.line_segment(ends, Stroke::new(width, color));
}

fn arrow_head(painter: &Painter, tip: Pos2, way: Vec2, color: Color32) {
    let side = vec2(-way.y, way.x) * 6.0;
    let end = tip + way * 5.0;
    let base = tip - way * 9.0;
    painter.add(Shape::convex_polygon(vec![end, base + side, base - side], color, Stroke::new(1.0, RIM)));
}

/// What a drag comes to, in words of axes and numbers that are the same in every language.
pub(super) fn amount(handle: Handle, change: Change) -> String {
    let axes: Vec<usize> = match handle {
        Handle::Axis(axis) | Handle::Ring(axis) => vec![axis],
        Handle::Plane(but) => (0..3).filter(|axis| *axis != but).collect(),
        Handle::Free => vec![0, 1, 2],
        Handle::Whole => Vec::new(),
    };
    let each = |write: &dyn Fn(usize) -> String| {
        axes.iter().map(|axis| format!("{} {}", LETTERS[*axis], write(*axis))).collect::<Vec<_>>().join("   ")
    };
    let percent = |part: f64| format!("{} %", plain(part * 100.0, 1));
    match change {
        Change::Move(way) => each(&|axis| signed(way[axis], digits(way))),
        Change::Turn(_, degrees) => each(&|_| format!("{}°", signed(degrees, 1))),
        Change::Scale(by) if handle == Handle::Whole => percent(by.x),
        Change::Scale(by) => each(&|axis| percent(by[axis])),
    }
}

/// Digits behind the point that tell such a way apart.
fn digits(way: DVec3) -> usize {
    let length = way.abs().max_element();
    if length > 0.0 { (3.0 - length.log10().floor()).clamp(0.0, 9.0) as usize } else { 1 }
}

fn signed(value: f64, digits: usize) -> String {
    let text = plain(value.abs(), digits);
    let sign = if text == "0" {
        ""
    } else if value < 0.0 {
        "\u{2212}"
    } else {
        "+"
    };
    format!("{sign}{text}")
}

/// A number without zeros at its end.
fn plain(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn amounts_are_short_and_signed() {
        let moved = Change::Move(DVec3::new(0.25, 0.0, -1.5));
        assert_eq!(amount(Handle::Axis(0), moved), "X +0.25");
        assert_eq!(amount(Handle::Plane(1), moved), "X +0.25   Z \u{2212}1.5");
        assert_eq!(amount(Handle::Free, moved), "X +0.25   Y 0   Z \u{2212}1.5");
        assert_eq!(amount(Handle::Ring(1), Change::Turn(1, -15.0)), "Y \u{2212}15°");
        assert_eq!(amount(Handle::Whole, Change::Scale(DVec3::splat(1.1))), "110 %");
        assert_eq!(amount(Handle::Axis(2), Change::Scale(DVec3::new(1.0, 1.0, 0.255))), "Z 25.5 %");
        assert_eq!(amount(Handle::Axis(0), Change::Move(DVec3::X * 2e-4)), "X +0.0002");
    }
}
