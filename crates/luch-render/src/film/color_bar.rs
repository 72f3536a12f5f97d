//! The scale of the views that show counts, drawn to the right of the picture.

use super::heat::{HEAT_END, HEAT_TICKS, heat_color, heat_place};

/// Sides of a letter, and from one to the next, in dots.
const LETTER: [usize; 2] = [5, 7];
const ADVANCE: usize = 6;
/// Columns of the margin, in dots: a gap, the bar, a gap, four digits; the longest title just fits.
const MARGIN: usize = 62;
/// Where the bar and the numbers begin, in dots, and how wide the bar is.
const BAR: [usize; 2] = [6, 20];
const NUMBERS: usize = 30;
/// The rows above the bar, for the title, and below it.
const TOP: usize = 19;
const BOTTOM: usize = 8;

/// The linear picture with the scale beside it, as linear light; answers with the new width in pixels. The picture itself
/// is not touched.
///
/// `linear` has red, green and blue of each pixel, rows from the top; `title` says what is counted, a word of an
/// [`Integrator`](crate::Integrator). A side of a dot of its letters is a 300th of the height.
#[must_use]
pub fn beside(linear: &[f32], [width, height]: [u32; 2], title: &str) -> (u32, Vec<f32>) {
    let (width, height) = (width as usize, height as usize);
    // Dots grow with the picture, so that the numbers can be read in a large one.
    let dot = (height / 300).max(1);
    let mut canvas = Canvas { width: width + MARGIN * dot, height, left: width, dot, linear: Vec::new() };
    canvas.linear.reserve_exact(canvas.width * height * 3);
    for row in linear.chunks_exact(width * 3) {
        canvas.linear.extend_from_slice(row);
        canvas.linear.extend(std::iter::repeat_n(0.0, MARGIN * dot * 3));
    }
    canvas.scale();
    canvas.write(BAR[0].min(MARGIN.saturating_sub(title.len() * ADVANCE) / 2), 6 * dot, title);
    #[allow(clippy::cast_possible_truncation, reason = "a picture's side and a margin of some hundred pixels")]
    let width = canvas.width as u32;
    (width, canvas.linear)
}

struct Canvas {
    width: usize,
    height: usize,
    /// The first column of the margin.
    left: usize,
    /// Pixels of a dot's side.
    dot: usize,
    linear: Vec<f32>,
}

impl Canvas {
    /// The bar, 0 at its foot, and the numbers beside it.
    fn scale(&mut self) {
        let (top, foot) = (TOP * self.dot, self.height.saturating_sub(BOTTOM * self.dot));
        if foot <= top + 1 {
            return;
        }
        let length = foot - top - 1;
        for row in top..foot {
            let color = heat_color((foot - 1 - row) as f32 / length as f32);
            for column in BAR[0] * self.dot..BAR[1] * self.dot {
                self.set(self.left + column, row, color);
            }
        }
        // Numbers that would run into each other are left out, those at the ends last.
        let room = (LETTER[1] + 3) * self.dot;
        let step = (1..HEAT_TICKS.len()).find(|step| length * step >= room * (HEAT_TICKS.len() - 1));
        for tick in HEAT_TICKS.into_iter().step_by(step.unwrap_or(HEAT_TICKS.len() - 1)) {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "within the bar")]
            let row = foot - 1 - (heat_place(tick) * length as f32).round() as usize;
            for column in BAR[1] * self.dot..(BAR[1] + 4) * self.dot {
                self.set(self.left + column, row, [1.0; 3]);
            }
            let more = if tick == HEAT_END { "+" } else { "" };
            self.write(NUMBERS, row.saturating_sub(LETTER[1] * self.dot / 2), &format!("{tick}{more}"));
        }
    }

    /// Writes a line whose upper left corner is at column `column` of the margin, in dots, and pixel row `row`.
    fn write(&mut self, column: usize, row: usize, text: &str) {
        for (number, letter) in text.chars().enumerate() {
            for (y, bits) in glyph(letter).into_iter().enumerate() {
                for x in (0..LETTER[0]).filter(|x| bits >> (LETTER[0] - 1 - x) & 1 != 0) {
                    self.dot_at(column + number * ADVANCE + x, row + y * self.dot);
                }
            }
        }
    }

    fn dot_at(&mut self, column: usize, row: usize) {
        for y in 0..self.dot {
            for x in 0..self.dot {
                self.set(self.left + column * self.dot + x, row + y, [1.0; 3]);
            }
        }
    }

    /// Sets a pixel of the margin; what lies outside is cut off.
    fn set(&mut self, column: usize, row: usize, color: [f32; 3]) {
        if (self.left..self.width).contains(&column) && row < self.height {
            let at = (row * self.width + column) * 3;
            self.linear[at..at + 3].copy_from_slice(&color);
        }
    }
}

/// The rows of a letter, the leftmost dot in the highest of five bits. Only what the scale writes is there.
const fn glyph(letter: char) -> [u8; 7] {
    match letter {
        '0' => [0b01110, 0b10001, 0b10011, 0b10101, 0b11001, 0b10001, 0b01110],
        '1' => [0b00100, 0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110],
        '2' => [0b01110, 0b10001, 0b00001, 0b00110, 0b01000, 0b10000, 0b11111],
        '3' => [0b01110, 0b10001, 0b00001, 0b00110, 0b00001, 0b10001, 0b01110],
        '5' => [0b11111, 0b10000, 0b11110, 0b00001, 0b00001, 0b10001, 0b01110],
        '6' => [0b00110, 0b01000, 0b10000, 0b11110, 0b10001, 0b10001, 0b01110],
        '7' => [0b11111, 0b00001, 0b00010, 0b00100, 0b01000, 0b01000, 0b01000],
        '+' => [0b00000, 0b00100, 0b00100, 0b11111, 0b00100, 0b00100, 0b00000],
        'a' => [0b00000, 0b00000, 0b01110, 0b00001, 0b01111, 0b10001, 0b01111],
        'd' => [0b00001, 0b00001, 0b01101, 0b10011, 0b10001, 0b10011, 0b01101],
        'e' => [0b00000, 0b00000, 0b01110, 0b10001, 0b11111, 0b10000, 0b01110],
        'g' => [0b00000, 0b01111, 0b10001, 0b10001, 0b01111, 0b00001, 0b01110],
        'i' => [0b00100, 0b00000, 0b01100, 0b00100, 0b00100, 0b00100, 0b01110],
        'l' => [0b01100, 0b00100, 0b00100, 0b00100, 0b00100, 0b00100, 0b01110],
        'n' => [0b00000, 0b00000, 0b10110, 0b11001, 0b10001, 0b10001, 0b10001],
        'o' => [0b00000, 0b00000, 0b01110, 0b10001, 0b10001, 0b10001, 0b01110],
        'r' => [0b00000, 0b00000, 0b10110, 0b11001, 0b10000, 0b10000, 0b10000],
        's' => [0b00000, 0b00000, 0b01111, 0b10000, 0b01110, 0b00001, 0b11110],
        't' => [0b01000, 0b01000, 0b11100, 0b01000, 0b01000, 0b01001, 0b00110],
        _ => [0; 7],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Integrator;

    #[test]
    fn every_letter_of_the_scale_can_be_written() {
        let mut letters: String = HEAT_TICKS.map(|tick| tick.to_string()).concat();
        letters += "+";
        letters += Integrator::Nodes.word();
        letters += Integrator::Triangles.word();
        for letter in letters.chars() {
            assert_ne!(glyph(letter), [0; 7], "{letter}");
        }
    }

    #[test]
    fn the_picture_stays_as_it_was_beside_the_scale_at_any_size() {
        for (width, height) in [(1_u32, 1_u32), (3, 30), (40, 64), (20, 700)] {
            let linear: Vec<f32> = (0..width * height * 3).map(|i| (i % 251) as f32 / 251.0).collect();
            let (wider, with_bar) = beside(&linear, [width, height], "triangles");
            assert_eq!(with_bar.len(), (wider * height * 3) as usize);
            for (before, after) in
                linear.chunks_exact(width as usize * 3).zip(with_bar.chunks_exact(wider as usize * 3))
            {
                assert_eq!(before, &after[..before.len()]);
            }
        }
    }

    #[test]
    fn the_bar_goes_from_the_darkest_at_its_foot_to_the_brightest() {
        let (wider, with_bar) = beside(&vec![0.0; 10 * 200 * 3], [10, 200], "nodes");
        let pixel = |row: usize| {
            let at = (row * wider as usize + 10 + BAR[0] + 2) * 3;
            [with_bar[at], with_bar[at + 1], with_bar[at + 2]]
        };
        assert_eq!(pixel(TOP), heat_color(1.0));
        assert_eq!(pixel(200 - BOTTOM - 1), heat_color(0.0));
    }
}
