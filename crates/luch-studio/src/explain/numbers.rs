//! Numbers of an account as text: as many digits as a person reads, or all that the picture has.

/// Digits of a number that is not written out.
const DIGITS: usize = 5;

/// How numbers are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Digits {
    /// Every digit that tells the number from its neighbours, so that it reads back to the same bits.
    pub(crate) every: bool,
}

impl Digits {
    pub(crate) const EVERY: Self = Self { every: true };

    pub(crate) fn number(self, value: f32) -> String {
        let size = value.abs();
        let text = if !self.every && value.is_finite() && value != 0.0 {
            short(value)
        } else if value == 0.0 || (1e-4..1e9).contains(&size) {
            format!("{value}")
        } else {
            format!("{value:e}")
        };
        text.replace('-', "\u{2212}")
    }

    pub(crate) fn color(self, color: [f32; 3]) -> [String; 3] {
        color.map(|channel| self.number(channel))
    }

    pub(crate) fn triple(self, color: [f32; 3]) -> String {
        let [r, g, b] = self.color(color);
        format!("({r}, {g}, {b})")
    }
}

/// The number rounded to [`DIGITS`] digits, without zeros at the end.
fn short(value: f32) -> String {
    let scientific = format!("{value:.*e}", DIGITS - 1);
    let (digits, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if !(-4..=6).contains(&exponent) {
        let digits = if digits.contains('.') { digits.trim_end_matches('0').trim_end_matches('.') } else { digits };
        return format!("{digits}e{exponent}");
    }
    let decimals = usize::try_from(DIGITS as i32 - 1 - exponent).unwrap_or(0);
    let text = format!("{value:.decimals$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
}

/// A share as percent.
pub(crate) fn percent(share: f32) -> String {
    let percent = share * 100.0;
    if percent > 0.0 && percent < 0.01 { "<0.01 %".to_owned() } else { format!("{} %", trimmed(percent)) }
}

fn trimmed(percent: f32) -> String {
    let text = format!("{percent:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// The bytes of a colour as the picture has them.
pub(crate) fn srgb8(color: [f32; 3]) -> [u8; 3] {
    let bytes = luch_render::film::tonemap::srgb8(&color);
    [bytes[0], bytes[1], bytes[2]]
}

pub(crate) fn color32(color: [f32; 3]) -> egui::Color32 {
    let [r, g, b] = srgb8(color);
    egui::Color32::from_rgb(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_numbers_keep_five_digits_and_all_digits_read_back() {
        let short = Digits { every: false };
        for (value, text) in [
            (0.0, "0"),
            (1.0, "1"),
            (0.812_345_6, "0.81235"),
            (60.0, "60"),
            (123_456.78, "123457"),
            (0.001_234_567, "0.0012346"),
            (-0.5, "\u{2212}0.5"),
            (1.5e-9, "1.5e\u{2212}9"),
            (2e10, "2e10"),
            (0.999_999_9, "1"),
            (f32::INFINITY, "inf"),
        ] {
            assert_eq!(short.number(value), text);
        }
        for value in [0.1_f32, 1.0 / 3.0, 1e-30, 123_456_790.0, f32::MIN_POSITIVE, 3.4e38, 0.000_123_45] {
            let text = Digits::EVERY.number(value).replace('\u{2212}', "-");
            assert_eq!(text.parse::<f32>().unwrap().to_bits(), value.to_bits(), "{text}");
        }
    }

    #[test]
    fn shares_are_percent() {
        assert_eq!(percent(0.5), "50 %");
        assert_eq!(percent(0.015_625), "1.56 %");
        assert_eq!(percent(0.000_01), "<0.01 %");
        assert_eq!(percent(0.0), "0 %");
    }
}
