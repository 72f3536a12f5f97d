//! The rays of a sample over the picture, as far as they are seen.

use crate::explain::Explained;
use crate::explain::looks::{Look, Pen, Stress};
use crate::l10n::Texts;
use crate::viewport::PictureFrame;
use egui::{Align2, Color32, FontId, Painter, Rect, pos2, vec2};

/// The most rays of one sample that are drawn; those that are looked at are always.
const MOST: usize = 1000;

/// Draws the sample of a ray, and the ray above the others.
pub(super) fn draw(painter: &Painter, frame: &PictureFrame, answer: &Explained, ray: u32) {
    let account = &answer.account;
    let Some(looked_at) = account.rays.get(ray as usize) else { return };
    let Some(sample) = account.samples.get(looked_at.sample as usize) else { return };
    let all = 1 + account.rays[sample.ray as usize].descendants as usize;
    for other in (sample.ray..).take(all.min(MOST)).filter(|&other| other != ray) {
        one(painter, frame, answer, other, Stress::Plain);
    }
    one(painter, frame, answer, ray, Stress::Strong);
}

fn one(painter: &Painter, frame: &PictureFrame, answer: &Explained, ray: u32, stress: Stress) {
    let segment = answer.account.segment(ray);
    let Some(seen) = frame.project_segment([segment.start, segment.end]) else { return };
    let look = Look::of(&answer.account, ray);
    let [from, to] = seen.points;
    // A ray from the eye itself is a point.
    if from.distance(to) < 1.5 {
        let radius = if stress == Stress::Strong { 5.0 } else { 3.0 };
        painter.circle_filled(to, radius + 1.0, Color32::from_black_alpha(160));
        painter.circle_filled(to, radius, look.color(true));
        return;
    }
    Pen::PICTURE.line(painter, [from, to], look, stress, !seen.cut[1]);
}

/// Says which line is which, in the lower left of the picture.
pub(super) fn legend(painter: &Painter, picture: Rect, texts: &Texts) {
    let (font, row, line) = (FontId::proportional(12.0), 16.0, 34.0);
    let names = Look::ALL.map(|look| painter.layout_no_wrap(look.name(texts), font.clone(), Color32::WHITE));
    let widest = names.iter().map(|name| name.size().x).fold(0.0, f32::max);
    let size = vec2(widest + line + 24.0, row * 4.0 + 10.0);
    let area = painter.clip_rect();
    if area.width() < size.x * 1.6 || area.height() < size.y * 1.6 {
        return;
    }
    let corner = Align2::LEFT_BOTTOM.align_size_within_rect(size, area.intersect(picture).shrink(8.0));
    painter.rect_filled(corner, 4.0, Color32::from_black_alpha(190));
    for ((look, name), place) in Look::ALL.into_iter().zip(names).zip(0_u8..) {
        let y = corner.top() + 5.0 + row * (f32::from(place) + 0.5);
        let x = corner.left() + 8.0;
        let pen = Pen { rim: false, on_dark: true };
        pen.line(painter, [pos2(x, y), pos2(x + line, y)], look, Stress::Plain, true);
        painter.galley(pos2(x + line + 8.0, y - name.size().y * 0.5), name, Color32::WHITE);
    }
}
