//! Powers for the highlight: the same bits on every machine, sixteen at a time.

use super::lanes::{Lanes, greater};
use fearless_simd::prelude::*;
use fearless_simd::{i32x16, u32x16};

/// `base ^ exponent` for bases from 0 to 1 and positive exponents; 0 for a base of 0.
///
/// 2 ^ (exponent * log2 base), the logarithm from the series of artanh, the power from a polynomial of degree 6 (both
/// in the form of Cody and Waite, "Software Manual for the Elementary Functions", 1980). The relative error is below
/// 3e-7 * (1 + exponent * |log2 base|); results below 2^-126 become 0.
#[inline(always)]
pub(crate) fn pow<S: Simd>(simd: S, base: Lanes<S>, exponent: Lanes<S>) -> Lanes<S> {
    // A base of 0 is moved to the smallest normal number, whose power vanishes unless the exponent is tiny.
    let positive = base.simd_gt(Lanes::splat(simd, 0.0));
    let y = exponent * log2(simd, greater(base, Lanes::splat(simd, f32::MIN_POSITIVE)));
    positive.select(exp2(simd, y), Lanes::splat(simd, 0.0))
}

/// log2 of positive normal numbers.
#[inline(always)]
fn log2<S: Simd>(simd: S, x: Lanes<S>) -> Lanes<S> {
    // x = 2^e * m with m from sqrt(1/2) to sqrt(2): the bits of sqrt(1/2) are taken off, so that the exponent rounds there.
    let offset = u32x16::splat(simd, 0x3f35_04f3);
    let bits: u32x16<S> = x.bitcast();
    let shifted = bits - offset;
    let e: i32x16<S> = (shifted & u32x16::splat(simd, 0xff80_0000)).bitcast();
    let m: Lanes<S> = ((shifted & u32x16::splat(simd, 0x007f_ffff)) + offset).bitcast();
    let exponent: Lanes<S> = (e >> 23).to_float();
    // log2 m = 2/ln 2 * artanh f, f = (m - 1) / (m + 1), |f| < 0.172.
    let f = (m - 1.0) / (m + 1.0);
    let s = f * f;
    let series = Lanes::splat(simd, 1.0)
        + s * (Lanes::splat(simd, 1.0 / 3.0)
            + s * (Lanes::splat(simd, 0.2) + s * (Lanes::splat(simd, 1.0 / 7.0) + s * (1.0 / 9.0))));
    exponent + f * series * (2.0 * std::f32::consts::LOG2_E)
}

/// 2^y for y up to 127; 0 below -126.
#[inline(always)]
fn exp2<S: Simd>(simd: S, y: Lanes<S>) -> Lanes<S> {
    let lowest = Lanes::splat(simd, -126.0);
    let normal = y.simd_ge(lowest);
    let clamped = normal.select(y, lowest);
    let whole = (clamped + 0.5).floor();
    let f = clamped - whole;
    // Taylor's polynomial of 2^f on -1/2..1/2: its next term is below 1.2e-8.
    let p = Lanes::splat(simd, 1.0)
        + f * (Lanes::splat(simd, std::f32::consts::LN_2)
            + f * (Lanes::splat(simd, 0.240_226_5)
                + f * (Lanes::splat(simd, 0.055_504_11)
                    + f * (Lanes::splat(simd, 0.009_618_129)
                        + f * (Lanes::splat(simd, 0.001_333_355_8) + f * 0.000_154_035_3)))));
    let exponent: i32x16<S> = whole.to_int();
    let scale: Lanes<S> = ((exponent + i32x16::splat(simd, 127)) << 23).bitcast();
    normal.select(p * scale, Lanes::splat(simd, 0.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::SimdLevel;
    use crate::simd::shade_at;

    fn pow16(level: SimdLevel, base: [f32; 16], exponent: f32) -> [f32; 16] {
        shade_at!(level.level_or_best(), simd => {
            pow(simd, Lanes::load_array(simd, base), Lanes::splat(simd, exponent)).to_array()
        })
    }

    #[test]
    fn agrees_with_f64_within_the_stated_error() {
        for exponent in [1.0_f32, 4.0, 37.5, 256.0] {
            for i in 0..4096_u16 {
                let base: [f32; 16] = std::array::from_fn(|j| (f32::from(i) * 16.0 + j as f32) / 65_535.0);
                let got = pow16(SimdLevel::Auto, base, exponent);
                for (b, g) in base.into_iter().zip(got) {
                    let want = f64::from(b).powf(f64::from(exponent));
                    let log = if b > 0.0 { f64::from(b).log2().abs() } else { 0.0 };
                    let bound = 3e-7 * (1.0 + f64::from(exponent) * log);
                    assert!((f64::from(g) - want).abs() <= want * bound + 1.2e-38, "{b}^{exponent}: {g}, not {want}");
                }
            }
        }
    }

    #[test]
    fn the_ends_are_exact() {
        let got = pow16(SimdLevel::Scalar, [1.0; 16], 200.0);
        assert_eq!(got, [1.0; 16]);
        assert_eq!(pow16(SimdLevel::Scalar, [0.0; 16], 4.0), [0.0; 16]);
    }

    #[test]
    fn every_level_gives_the_same_bits() {
        let base: [f32; 16] = std::array::from_fn(|i| 0.06 * (i as f32 + 0.7));
        let truth = pow16(SimdLevel::Scalar, base, 48.5).map(f32::to_bits);
        for level in SimdLevel::available() {
            assert_eq!(pow16(level, base, 48.5).map(f32::to_bits), truth, "{}", level.word());
        }
    }
}
