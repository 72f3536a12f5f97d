//! Sets mathematics by a few rules: letters with small ones below and above, fractions with a bar, colours as columns.
//!
//! Everything hangs on the axis of the line, the height of a fraction's bar and a minus sign: parts are centred on it.

use egui::epaint::CubicBezierShape;
use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, FontId, Galley, Painter, Pos2, Rect, Shape, Stroke, Vec2, pos2, vec2};
use std::sync::Arc;

/// Small letters and numbers in columns, as parts of the size of the text.
const SMALL: f32 = 0.74;
const IN_COLUMN: f32 = 0.88;

/// How mathematics is set: where, how large, in which colour.
#[derive(Clone, Copy)]
pub(super) struct Setter<'a> {
    pub(super) painter: &'a Painter,
    pub(super) size: f32,
    pub(super) color: Color32,
}

/// Mathematics that is set: marks around an origin at its left end, on the axis.
#[derive(Clone, Default)]
pub(super) struct Set {
    pub(super) width: f32,
    /// How far it reaches above and below the axis.
    pub(super) up: f32,
    pub(super) down: f32,
    marks: Vec<Mark>,
    /// What is said of a part when the pointer rests on it.
    tips: Vec<(Rect, String)>,
}

#[derive(Clone)]
enum Mark {
    Text(Pos2, Arc<Galley>),
    Line([Pos2; 2]),
    Curve([Pos2; 4]),
}

impl Set {
    /// Adds another, its origin moved.
    fn put(&mut self, other: Self, by: Vec2) {
        let moved = |mark| match mark {
            Mark::Text(at, galley) => Mark::Text(at + by, galley),
            Mark::Line(ends) => Mark::Line(ends.map(|end| end + by)),
            Mark::Curve(points) => Mark::Curve(points.map(|point| point + by)),
        };
        self.marks.extend(other.marks.into_iter().map(moved));
        self.tips.extend(other.tips.into_iter().map(|(rect, tip)| (rect.translate(by), tip)));
        self.width = self.width.max(by.x + other.width);
        self.up = self.up.max(other.up - by.y);
        self.down = self.down.max(other.down + by.y);
    }

    /// Puts another behind it, after a gap.
    pub(super) fn then(mut self, other: Self, gap: f32) -> Self {
        let at = self.width + gap;
        self.put(other, vec2(at, 0.0));
        self
    }

    /// Says something of all of it.
    pub(super) fn tip(mut self, tip: Option<String>) -> Self {
        if let Some(tip) = tip {
            let rect = Rect::from_min_max(pos2(0.0, -self.up), pos2(self.width, self.down));
            self.tips = vec![(rect, tip)];
        }
        self
    }

    pub(super) fn height(&self) -> f32 {
        self.up + self.down
    }

    /// Draws it with its origin at a point, and answers with what is said of which part.
    pub(super) fn paint(&self, setter: &Setter<'_>, origin: Pos2) -> impl Iterator<Item = (Rect, &str)> {
        let by = origin.to_vec2();
        let stroke = Stroke::new(setter.size / 13.0, setter.color);
        for mark in &self.marks {
            match mark {
                Mark::Text(at, galley) => setter.painter.galley(*at + by, Arc::clone(galley), setter.color),
                Mark::Line(ends) => {
                    setter.painter.line_segment(ends.map(|end| end + by), stroke);
                }
                Mark::Curve(points) => {
                    let points = points.map(|point| point + by);
                    setter.painter.add(Shape::CubicBezier(CubicBezierShape::from_points_stroke(
                        points,
                        false,
                        Color32::TRANSPARENT,
                        stroke,
                    )));
                }
            }
        }
        self.tips.iter().map(move |(rect, tip)| (rect.translate(by), tip.as_str()))
    }
}

impl Setter<'_> {
    /// The gap around a sign like + or =.
    pub(super) fn gap(&self) -> f32 {
        self.size * 0.28
    }

    /// A setter of another size.
    pub(super) fn scaled(&self, by: f32) -> Self {
        Self { size: self.size * by, ..*self }
    }

    /// Upright text: numbers, signs, functions.
    pub(super) fn upright(&self, text: &str) -> Set {
        self.text(text, false)
    }

    /// A letter that stands for something.
    pub(super) fn letter(&self, text: &str) -> Set {
        self.text(text, true)
    }

    fn text(&self, text: &str, italics: bool) -> Set {
        let font_id = FontId::proportional(self.size);
        let format = TextFormat { font_id, color: self.color, italics, ..Default::default() };
        let galley = self.painter.layout_job(LayoutJob::single_section(text.to_owned(), format));
        let size = galley.size();
        let half = size.y * 0.5;
        Set { width: size.x, up: half, down: half, marks: vec![Mark::Text(pos2(0.0, -half), galley)], tips: Vec::new() }
    }

    /// Small text behind a base: below it, above it, or one over the other.
    pub(super) fn scripted(&self, base: Set, below: Option<Set>, above: Option<Set>) -> Set {
        let at = base.width + self.size * 0.04;
        let mut set = base;
        if let Some(below) = below {
            set.put(below, vec2(at, self.size * 0.32));
        }
        if let Some(above) = above {
            set.put(above, vec2(at, -self.size * 0.42));
        }
        set
    }

    /// A setter of small letters.
    pub(super) fn small(&self) -> Self {
        self.scaled(SMALL)
    }

    /// Small text under a sign.
    pub(super) fn over(&self, sign: Set, below: Set) -> Set {
        let width = sign.width.max(below.width);
        let (left, under) = ((width - sign.width) * 0.5, (width - below.width) * 0.5);
        let mut set = Set { width, ..Set::default() };
        let down = sign.down * 0.72 + below.up;
        set.put(sign, vec2(left, 0.0));
        set.put(below, vec2(under, down));
        set
    }

    pub(super) fn fraction(&self, above: Set, below: Set) -> Set {
        let (pad, lift) = (self.size * 0.22, self.size * 0.08);
        let width = above.width.max(below.width) + 2.0 * pad;
        let mut set = Set { width, ..Set::default() };
        let middle = |part: &Set| (width - part.width) * 0.5;
        let (x, y) = (middle(&above), -lift - above.down);
        set.put(above, vec2(x, y));
        let (x, y) = (middle(&below), lift + below.up);
        set.put(below, vec2(x, y));
        set.marks.push(Mark::Line([pos2(pad * 0.3, 0.0), pos2(width - pad * 0.3, 0.0)]));
        set
    }

    /// Three numbers one below the other in brackets: a colour's red, green, blue, or a vector's x, y, z.
    pub(super) fn column(&self, numbers: [String; 3]) -> Set {
        let setter = self.scaled(IN_COLUMN);
        let whole = numbers.clone().map(|number| {
            let point = number.find(['.', 'e']).unwrap_or(number.len());
            setter.upright(&number[..point]).width
        });
        let before = whole.into_iter().fold(0.0, f32::max);
        let rows = numbers.map(|number| setter.number(&number));
        let pitch = rows.iter().map(Set::height).fold(0.0, f32::max) * 0.94;
        let mut set = Set::default();
        // Decimal points stand one below the other.
        for ((row, whole), place) in rows.into_iter().zip(whole).zip([-1.0, 0.0, 1.0]) {
            set.put(row, vec2(before - whole, place * pitch));
        }
        self.brackets(set)
    }

    /// Brackets as tall as what they hold.
    pub(super) fn brackets(&self, inner: Set) -> Set {
        let (bow, pad) = (self.size * 0.30, self.size * 0.10);
        let (up, down) = (inner.up - self.size * 0.08, inner.down - self.size * 0.08);
        let height = up + down;
        let left = |x: f32, side: f32| {
            Mark::Curve([
                pos2(x, -up),
                pos2(x - side * bow * 0.9, -up + height * 0.28),
                pos2(x - side * bow * 0.9, down - height * 0.28),
                pos2(x, down),
            ])
        };
        let mut set = Set { width: bow + pad, ..Set::default() };
        let close = bow + pad + inner.width + pad;
        set.put(inner, vec2(bow + pad, 0.0));
        set.marks.push(left(bow, 1.0));
        set.marks.push(left(close, -1.0));
        set.width = close + bow;
        set
    }

    /// A number; `1.5e-7` is set as 1.5 · 10 with a small −7.
    pub(super) fn number(&self, text: &str) -> Set {
        let Some((digits, exponent)) = text.split_once('e') else { return self.upright(text) };
        let ten = self.scripted(self.upright("10"), None, Some(self.small().upright(exponent)));
        self.upright(digits).then(self.upright("·"), self.size * 0.1).then(ten, self.size * 0.1)
    }
}

/// Breaks mathematics into lines no wider than `width`, where its parts allow; later lines are moved in.
pub(super) fn lines(parts: Vec<Set>, gap: f32, width: f32, indent: f32) -> Vec<Set> {
    let mut lines: Vec<Set> = Vec::new();
    for part in parts {
        match lines.last_mut() {
            Some(line) if line.width + gap + part.width <= width => *line = std::mem::take(line).then(part, gap),
            Some(_) => lines.push(Set { width: indent, ..Set::default() }.then(part, 0.0)),
            None => lines.push(part),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Calls something that sets, with fonts at hand.
    fn setting(check: impl Fn(&Setter<'_>)) {
        let context = egui::Context::default();
        let mut output = context.run_ui(egui::RawInput::default(), |ui| {
            let painter = ui.painter();
            check(&Setter { painter, size: 14.0, color: Color32::WHITE });
        });
        // Nobody shows them.
        output.textures_delta.clear();
    }

    #[test]
    fn fractions_and_columns_are_as_large_as_their_parts() {
        setting(|setter| {
            let (above, below) = (setter.upright("60"), setter.upright("5.1669 + 60"));
            let widest = below.width;
            let fraction = setter.fraction(above, below);
            assert!(fraction.width > widest && fraction.up > 14.0 && fraction.down > 14.0);
            let column = setter.column(["0.5".into(), "10".into(), "1e-7".into()]);
            assert!(column.height() > 36.0 && column.width > setter.number("1e-7").width * 0.8);
            let scripted = setter.scripted(setter.letter("k"), Some(setter.small().letter("d")), None);
            assert!(scripted.down > scripted.up);
        });
    }

    #[test]
    fn lines_break_between_parts_and_never_inside_one() {
        setting(|setter| {
            let parts = || vec![setter.upright("one two"), setter.upright("three four"), setter.upright("five")];
            assert_eq!(lines(parts(), 4.0, 1000.0, 10.0).len(), 1);
            let broken = lines(parts(), 4.0, 60.0, 10.0);
            assert_eq!(broken.len(), 3);
            assert!(broken[1].width > setter.upright("three four").width);
            assert_eq!(lines(parts(), 4.0, 0.0, 10.0).len(), 3);
        });
    }
}
