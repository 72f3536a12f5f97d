//! What was typed into a field, checked: a number of a range, or why not.

use crate::l10n::Texts;
use std::ops::RangeInclusive;

/// How a number is written and which numbers may be.
#[derive(Debug, Clone)]
pub(crate) struct NumberFormat {
    pub(crate) range: RangeInclusive<f64>,
    /// Digits after the point, at most.
    pub(crate) decimals: usize,
    /// What stands behind it: ` %`, `°`, or nothing.
    pub(crate) suffix: &'static str,
}

impl NumberFormat {
    /// The number as text: no more digits than it needs.
    pub(crate) fn write(&self, value: f64) -> String {
        format!("{}{}", plain(value, self.decimals), self.suffix)
    }

    /// The number that was typed.
    ///
    /// # Errors
    /// What is wrong, in the language of `texts`.
    pub(crate) fn read(&self, typed: &str, texts: &Texts) -> Result<f64, String> {
        let text = typed.trim().strip_suffix(self.suffix.trim()).unwrap_or(typed).trim();
        if text.is_empty() {
            return Err(texts.input_empty());
        }
        // `nan` and `inf` are numbers to Rust, not to people: the only letter in a number is that of its exponent.
        if text.contains(|c: char| c.is_alphabetic() && !matches!(c, 'e' | 'E')) {
            return Err(texts.input_no_number(text));
        }
        // A decimal comma is a point: `0,5` is typed where `0.5` is meant.
        let value: f64 =
            text.replace(',', ".").replace('\u{2212}', "-").parse().map_err(|_| texts.input_no_number(text))?;
        if self.decimals == 0 && value.is_finite() && value.fract() != 0.0 {
            return Err(texts.input_no_whole_number(text));
        }
        if self.range.contains(&value) {
            return Ok(value);
        }
        let (low, high) = (self.write(*self.range.start()), self.write(*self.range.end()));
        Err(texts.input_out_of_range(low, high))
    }
}

/// A number with at most so many digits after the point and no zeros at the end.
fn plain(value: f64, decimals: usize) -> String {
    // Very large and very small numbers keep their digits: 1e-7 is not 0.
    if value != 0.0 && (value.abs() >= 1e9 || value.abs() < 0.5 * 0.1_f64.powi(i32::try_from(decimals).unwrap_or(9))) {
        return format!("{value:e}");
    }
    let text = format!("{value:.decimals$}");
    if !text.contains('.') {
        return text;
    }
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::l10n::Language;

    fn percent() -> NumberFormat {
        NumberFormat { range: 0.0..=100.0, decimals: 1, suffix: " %" }
    }

    #[test]
    fn what_is_typed_is_read_as_people_write_it() {
        let texts = Language::En.load();
        for (typed, value) in [("80", 80.0), (" 80 % ", 80.0), ("80%", 80.0), ("12,5", 12.5), ("1e1", 10.0), ("0", 0.0)]
        {
            assert_eq!(percent().read(typed, &texts), Ok(value), "{typed}");
        }
    }

    #[test]
    fn wrong_input_is_told_why() {
        for &language in Language::iter() {
            let texts = language.load();
            for typed in ["", "  ", "%", "abc", "80x", "NaN", "inf", "-1", "100.5", "1e400", "8 0", "--3"] {
                assert!(percent().read(typed, &texts).is_err(), "{typed}");
            }
            let error = percent().read("101", &texts).unwrap_err();
            assert!(error.contains('0') && error.contains("100"), "{error}");
            assert!(percent().read("восемь", &texts).unwrap_err().contains("восемь"));
            let whole = NumberFormat { range: 1.0..=64.0, decimals: 0, suffix: "" };
            assert!(whole.read("2.5", &texts).is_err());
        }
    }

    #[test]
    fn numbers_are_written_short() {
        let format = NumberFormat { range: -1e9..=1e9, decimals: 3, suffix: "" };
        for (value, text) in
            [(0.5, "0.5"), (1.0, "1"), (-0.0001, "-1e-4"), (0.123_45, "0.123"), (0.0, "0"), (1e9, "1e9")]
        {
            assert_eq!(format.write(value), text);
        }
        assert_eq!(percent().write(50.0), "50 %");
    }
}
