//! From linear light to what a screen shows: the sRGB curve, rounded to 8 or 16 bits.

use luch_scene::color::srgb_from_linear;
use std::sync::OnceLock;

/// Steps of the table that finds an 8-bit value: fine enough that a step holds at most one border between values.
const STEPS: usize = 1 << 13;

/// Finds the sRGB byte of a linear value in two looks; small enough to stay in the nearest cache.
struct Bytes {
    /// The byte at the start of each step of linear light.
    below: [u8; STEPS + 1],
    /// The smallest value that has a byte above this one.
    next: [f32; 256],
}

/// sRGB bytes of linear values; what is below 0 or above 1 is moved to the nearer end, NaN to 0.
#[must_use]
pub fn srgb8(linear: &[f32]) -> Vec<u8> {
    let bytes = Bytes::get();
    linear.iter().map(|&value| bytes.of(value)).collect()
}

/// sRGB bytes and opacity of pixels whose linear red, green, blue are the sums of `samples` values: those of [`srgb8`] of
/// the means.
pub(crate) fn opaque_srgb8(sums: &[f32], samples: u32) -> Vec<[u8; 4]> {
    let (bytes, count) = (Bytes::get(), divisor(samples));
    sums.chunks_exact(3)
        .map(|sum| [bytes.of(sum[0] / count), bytes.of(sum[1] / count), bytes.of(sum[2] / count), 255])
        .collect()
}

/// What a sum of that many samples is divided by to give their mean.
#[allow(clippy::cast_precision_loss, reason = "at most 4096 samples")]
pub(crate) fn divisor(samples: u32) -> f32 {
    samples.max(1) as f32
}

impl Bytes {
    fn get() -> &'static Self {
        static BYTES: OnceLock<Box<Bytes>> = OnceLock::new();
        BYTES.get_or_init(|| Box::new(Self::new()))
    }

    fn new() -> Self {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 0..=255")]
        let byte = |value: f32| (srgb_from_linear(value) * 255.0 + 0.5) as u8;
        let below = std::array::from_fn(|step| byte(step as f32 / STEPS as f32));
        let next = std::array::from_fn(|at| {
            if at == 255 {
                return f32::INFINITY;
            }
            // The smallest float that has a larger byte, by bisection over the bits.
            let (mut low, mut high) = (0.0_f32.to_bits(), 1.0_f32.to_bits());
            while high - low > 1 {
                let middle = low + (high - low) / 2;
                if usize::from(byte(f32::from_bits(middle))) <= at { low = middle } else { high = middle }
            }
            f32::from_bits(high)
        });
        Self { below, next }
    }

    #[inline]
    fn of(&self, value: f32) -> u8 {
        // Written so that NaN, which fails the comparison, becomes 0.
        let value = if value > 0.0 { value.min(1.0) } else { 0.0 };
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 0..=STEPS")]
        let below = self.below[(value * STEPS as f32) as usize];
        below + u8::from(value >= self.next[usize::from(below)])
    }
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
