//! From linear light to what a screen shows: the sRGB curve, rounded to 8 or 16 bits.

use luch_scene::color::srgb_from_linear;
use std::sync::OnceLock;

/// Steps of the table that finds an 8-bit value: fine enough that a step holds at most one border between values.
const STEPS: usize = 1 << 13;

/// sRGB bytes of linear values; what is below 0 or above 1 is moved to the nearer end, NaN to 0.
#[must_use]
pub fn srgb8(linear: &[f32]) -> Vec<u8> {
    static TABLE: OnceLock<Vec<(u8, f32)>> = OnceLock::new();
    let table = TABLE.get_or_init(table_8);
    linear
        .iter()
        .map(|&value| {
            // Written so that NaN, which fails the comparison, becomes 0.
            let value = if value > 0.0 { value.min(1.0) } else { 0.0 };
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 0..=STEPS")]
            let (below, border) = table[(value * STEPS as f32) as usize];
            if value >= border { below + 1 } else { below }
        })
        .collect()
}

/// For each step of linear light the byte at its start, and the value at which the next byte begins (2 if it does not
/// begin within the step).
fn table_8() -> Vec<(u8, f32)> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 0..=255")]
    let byte = |value: f32| (srgb_from_linear(value) * 255.0 + 0.5) as u8;
    (0..=STEPS)
        .map(|step| {
            let (start, end) = (step as f32 / STEPS as f32, (step + 1) as f32 / STEPS as f32);
            let below = byte(start);
            if byte(end.min(1.0)) == below {
                return (below, 2.0);
            }
            // The smallest float of the step that has the next byte, by bisection over the bits.
            let (mut low, mut high) = (start.to_bits(), end.min(1.0).to_bits());
            while high - low > 1 {
                let middle = low + (high - low) / 2;
                if byte(f32::from_bits(middle)) == below { low = middle } else { high = middle }
            }
            (below, f32::from_bits(high))
        })
        .collect()
}

/// sRGB values of 16 bits of linear values; what is below 0 or above 1 is moved to the nearer end, NaN to 0.
#[must_use]
pub fn srgb16(linear: &[f32]) -> Vec<u16> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 0..=65535")]
    linear.iter().map(|&value| (srgb_from_linear(value) * 65_535.0 + 0.5) as u16).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_gives_what_the_curve_gives() {
        let direct = |v: f32| (srgb_from_linear(v) * 255.0 + 0.5) as u8;
        let values: Vec<f32> = (0..400_000).map(|i| i as f32 / 399_000.0).collect();
        for (value, byte) in values.iter().zip(srgb8(&values)) {
            assert_eq!(byte, direct(*value), "{value}");
        }
    }

    #[test]
    fn no_step_holds_two_borders() {
        let direct = |v: f32| (srgb_from_linear(v) * 255.0 + 0.5) as u8;
        for step in 0..STEPS {
            let (a, b) = (step as f32 / STEPS as f32, (step + 1) as f32 / STEPS as f32);
            assert!(direct(b) - direct(a) <= 1, "step {step}");
        }
    }

    #[test]
    fn what_is_no_colour_is_black_or_white() {
        assert_eq!(srgb8(&[f32::NAN, -1.0, 2.0, f32::INFINITY, 1.0]), [0, 0, 255, 255, 255]);
        assert_eq!(srgb16(&[f32::NAN, -1.0, 2.0, f32::INFINITY, 1.0]), [0, 0, 65_535, 65_535, 65_535]);
    }
}
