//! What an account adds to the picture: the pixel, and the ways of its rays.

mod boxes;
mod mark;
mod path;

pub(super) use boxes::box_color;

use super::panel::hovered_ray;
use super::{Explain, Page};
use crate::l10n::Texts;
use crate::viewport::PictureFrame;
use egui::Painter;

/// Draws over the picture.
pub(crate) fn draw(painter: &Painter, frame: &PictureFrame, explain: &Explain, texts: &Texts) {
    let Some(pixel) = explain.pixel else { return };
    let painter = painter.with_clip_rect(painter.clip_rect().intersect(frame.rect));
    if let Some(answer) = &explain.answer {
        let ray = hovered_ray(painter.ctx()).unwrap_or(explain.ray);
        if explain.page == Page::Boxes {
            boxes::draw(&painter, frame, explain, answer);
        }
        path::draw(&painter, frame, answer, ray);
        path::legend(&painter, frame.rect, texts);
    }
    mark::draw(&painter, frame, pixel);
}
