//! Numbers as people read them.

/// Digits that are shown of a number that has more.
const DIGITS: i32 = 5;

/// A number with five significant digits, or fewer where it has fewer; very large and small ones as `1.2346e-7`.
#[must_use]
pub fn short(value: f32) -> String {
    if value == 0.0 {
        return "0".to_owned();
    }
    if !value.is_finite() {
        return if value > 0.0 { "∞".to_owned() } else { "-∞".to_owned() };
    }
    let scientific = format!("{value:.*e}", DIGITS as usize - 1);
    // The exponent after rounding to five digits: 9.99999 is 10.
    let exponent = scientific.split_once('e').and_then(|(_, e)| e.parse::<i32>().ok()).unwrap_or(0);
    if !(-4..7).contains(&exponent) {
        return match scientific.split_once('e') {
            Some((mantissa, exponent)) => format!("{}e{exponent}", trimmed(mantissa)),
            None => scientific,
        };
    }
    #[allow(clippy::cast_sign_loss, reason = "not negative")]
    let decimals = (DIGITS - 1 - exponent).max(0) as usize;
    trimmed(&format!("{value:.decimals$}")).to_owned()
}

/// Without zeros at the end of the decimals.
fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// Three numbers in brackets.
#[must_use]
pub fn triple(values: [f32; 3]) -> String {
    let [a, b, c] = values.map(short);
    format!("({a}, {b}, {c})")
}

/// Two numbers in brackets.
pub(crate) fn pair(values: [f32; 2]) -> String {
    let [a, b] = values.map(short);
    format!("({a}, {b})")
}

/// `#rrggbb` of a linear colour, as a screen shows it.
#[must_use]
pub fn hex(linear: [f32; 3]) -> String {
    let [r, g, b] = luch_render::film::tonemap::srgb8(&linear)[..] else { return String::new() };
    format!("#{r:02x}{g:02x}{b:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_say_what_they_are() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (0.5, "0.5"),
            (1.0, "1"),
            (-1.25, "-1.25"),
            (0.371_634_7, "0.37163"),
            (0.000_123_456, "0.00012346"),
            (0.000_012_345_6, "1.2346e-5"),
            (60.0, "60"),
            (123_456.7, "123457"),
            (9.999_999, "10"),
            (1e30, "1e30"),
            (12_345_678.0, "1.2346e7"),
            (f32::INFINITY, "∞"),
        ] {
            assert_eq!(short(value), text, "{value}");
        }
        assert_eq!(triple([0.0, 1.0, -0.5]), "(0, 1, -0.5)");
        assert_eq!(hex([1.0, 0.0, 0.214_041_14]), "#ff0080");
    }
}
