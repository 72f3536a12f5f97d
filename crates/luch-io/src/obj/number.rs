//! Numbers in text, correctly rounded and fast: nearly all take a path of a few nanoseconds.

/// Reads a decimal number at the beginning of `text`; answers with it and what follows.
///
/// `None` where no number begins: words such as `nan` and `inf` are none. A number too large for f32 is infinite, for
/// the caller to refuse. The result is the nearest f32, ties to even, for any number of digits.
///
/// Few digits and small powers of ten are exact in f64, so one division or multiplication rounds once
/// (Clinger, "How to read floating point numbers accurately", 1990); the second rounding, to f32, errs only
/// where the f64 lies exactly between two f32. Those, and all longer numbers, go to the standard library.
#[inline]
pub(super) fn float(text: &[u8]) -> Option<(f32, &[u8])> {
    let (negative, unsigned) = match text {
        [b'-', tail @ ..] => (true, tail),
        [b'+', tail @ ..] => (false, tail),
        _ => (false, text),
    };
    let (mantissa, mut rest) = digits(unsigned, 0);
    let mut count = unsigned.len().wrapping_sub(rest.len());
    let mut mantissa = mantissa;
    let mut power = 0_i64;
    if let [b'.', tail @ ..] = rest {
        (mantissa, rest) = digits(tail, mantissa);
        let decimals = tail.len().wrapping_sub(rest.len());
        count = count.wrapping_add(decimals);
        power = 0_i64.wrapping_sub_unsigned(u64::try_from(decimals).unwrap_or(u64::MAX));
    }
    if count == 0 {
        return None;
    }
    if let [b'e' | b'E', tail @ ..] = rest {
        let (exponent, after) = exponent(tail)?;
        power = power.saturating_add(exponent);
        rest = after;
    }
    // 19 digits cannot have wrapped a u64.
    let exact = count <= 19 && mantissa <= 1 << 53;
    let ten = usize::try_from(power.unsigned_abs()).ok().and_then(|p| POWERS_OF_TEN.get(p));
    if let (true, Some(ten)) = (exact, ten) {
        #[allow(clippy::cast_precision_loss, reason = "at most 2^53: exact")]
        let whole = mantissa as f64;
        let value = if power < 0 { whole / ten } else { whole * ten };
        if value.to_bits() & 0x1fff_ffff != 0x1000_0000 {
            #[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
            let value = value as f32;
            return Some((if negative { -value } else { value }, rest));
        }
    }
    slow(text, rest)
}

/// The standard library's reading of the number between the two.
#[cold]
fn slow<'a>(text: &[u8], rest: &'a [u8]) -> Option<(f32, &'a [u8])> {
    let number = text.get(..text.len().saturating_sub(rest.len()))?;
    let value = std::str::from_utf8(number).ok()?.parse().ok()?;
    Some((value, rest))
}

const POWERS_OF_TEN: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// Continues a whole number with the digits at the beginning of `text`; wraps after 19 of them.
#[inline]
fn digits(mut text: &[u8], mut value: u64) -> (u64, &[u8]) {
    while let [digit @ b'0'..=b'9', tail @ ..] = text {
        value = value.wrapping_mul(10).wrapping_add(u64::from(digit & 15));
        text = tail;
    }
    (value, text)
}

/// The exponent behind an `e`: a sign and digits; `None` without digits.
fn exponent(text: &[u8]) -> Option<(i64, &[u8])> {
    let (negative, digits) = match text {
        [b'-', tail @ ..] => (true, tail),
        [b'+', tail @ ..] => (false, tail),
        _ => (false, text),
    };
    let mut rest = digits;
    let mut value = 0_i64;
    while let [digit @ b'0'..=b'9', tail @ ..] = rest {
        value = value.saturating_mul(10).saturating_add(i64::from(digit & 15));
        rest = tail;
    }
    // Beyond any digits that a file can have before it, and far from the ends of i64.
    let value = value.min(1 << 40);
    (rest.len() < digits.len()).then_some((if negative { value.wrapping_neg() } else { value }, rest))
}

/// Reads a whole number with an optional sign; answers with it and what follows. Saturates at the ends of i64.
#[inline]
pub(super) fn integer(text: &[u8]) -> Option<(i64, &[u8])> {
    let (negative, unsigned) = match text {
        [b'-', tail @ ..] => (true, tail),
        [b'+', tail @ ..] => (false, tail),
        _ => (false, text),
    };
    let (value, rest) = digits(unsigned, 0);
    let count = unsigned.len().wrapping_sub(rest.len());
    if count == 0 {
        return None;
    }
    let value = if count <= 18 { i64::try_from(value).unwrap_or(i64::MAX) } else { saturated(unsigned, count) };
    Some((if negative { value.wrapping_neg() } else { value }, rest))
}

#[cold]
fn saturated(text: &[u8], count: usize) -> i64 {
    let digits = text.get(..count).and_then(|d| std::str::from_utf8(d).ok());
    digits.and_then(|d| d.parse().ok()).unwrap_or(i64::MAX)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn read(text: &str) -> Option<(f32, &str)> {
        float(text.as_bytes()).map(|(v, rest)| (v, std::str::from_utf8(rest).unwrap()))
    }

    #[test]
    fn every_way_to_write_a_number() {
        assert_eq!(read("1.e5 "), Some((1e5, " ")));
        assert_eq!(read(".5"), Some((0.5, "")));
        assert_eq!(read("+3"), Some((3.0, "")));
        assert_eq!(read("-0"), Some((-0.0, "")));
        assert!(read("-0").unwrap().0.is_sign_negative());
        assert_eq!(read("1E+2x"), Some((100.0, "x")));
        assert_eq!(read("1,5"), Some((1.0, ",5")));
        assert_eq!(read("0x10"), Some((0.0, "x10")));
        assert_eq!(read("1e400"), Some((f32::INFINITY, "")));
        assert_eq!(read("1e-400"), Some((0.0, "")));
        assert_eq!(read("1e99999999999999999999999"), Some((f32::INFINITY, "")));
        for none in ["", "-", ".", "+.", "e5", "nan", "NaN", "inf", "-infinity", "1e", "1e+", "--1", "#"] {
            assert_eq!(read(none), None, "{none}");
        }
    }

    #[test]
    fn whole_numbers_saturate() {
        let read = |t: &str| integer(t.as_bytes()).map(|(v, rest)| (v, rest.len()));
        assert_eq!(read("12/3"), Some((12, 2)));
        assert_eq!(read("-7"), Some((-7, 0)));
        assert_eq!(read("99999999999999999999"), Some((i64::MAX, 0)));
        assert_eq!(read("-99999999999999999999"), Some((-i64::MAX, 0)));
        assert_eq!(read("00000000000000000000000000012"), Some((12, 0)));
        assert_eq!(read("1.5"), Some((1, 2)));
        assert_eq!(read("x"), None);
    }

    #[test]
    fn numbers_between_two_floats_round_once() {
        // 1 + 2^-24 lies exactly between 1 and its successor; a little more must round up, though f64 cannot tell.
        for text in ["1.000000059604644775390625", "1.0000000596046448", "1.00000005960464477539062500001", "16777217"]
        {
            assert_eq!(read(text).unwrap().0, text.parse::<f32>().unwrap(), "{text}");
        }
    }

    proptest! {
        #[test]
        fn reads_what_the_standard_library_reads(
            sign in "[+-]?", whole in "[0-9]{0,12}", decimals in "[0-9]{0,12}", e in proptest::option::of(-60..60),
        ) {
            prop_assume!(!whole.is_empty() || !decimals.is_empty());
            let exponent = e.map_or(String::new(), |e| format!("e{e}"));
            let text = format!("{sign}{whole}.{decimals}{exponent}");
            prop_assert_eq!(read(&text).unwrap().0.to_bits(), text.parse::<f32>().unwrap().to_bits());
        }

        #[test]
        fn every_float_survives_being_written(bits in any::<u32>()) {
            let value = f32::from_bits(bits);
            prop_assume!(value.is_finite());
            prop_assert_eq!(read(&format!("{value}")).unwrap().0.to_bits(), bits);
            prop_assert_eq!(read(&format!("{value:e}")).unwrap().0.to_bits(), bits);
        }
    }
}
