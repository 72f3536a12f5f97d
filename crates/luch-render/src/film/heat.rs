//! Colours for counts: the scale of the views that show work.

use std::sync::OnceLock;

/// The count at which the scale ends; what is above looks the same.
pub const HEAT_END: u32 = 255;

/// The place of a count on the scale, 0 to 1: logarithmic, so that the few boxes of a plain wall and the hundreds of a
/// grazing ray can both be told from their neighbours. 0 is at 0, 15 in the middle, [`HEAT_END`] at 1.
#[must_use]
pub fn heat_place(count: u32) -> f32 {
    #[allow(clippy::cast_precision_loss, reason = "at most the end of the scale")]
    let [count, end] = [count.min(HEAT_END), HEAT_END].map(|count| (count + 1) as f32);
    libm::log2f(count) / libm::log2f(end)
}

/// The counts that a legend names.
pub const HEAT_TICKS: [u32; 9] = [0, 1, 3, 7, 15, 31, 63, 127, 255];

/// The linear colour of a place of the scale, from dark violet over blue and green to light yellow.
///
/// Lightness grows in even steps of Oklab (Ottosson, "A perceptual color space for image processing", 2020) while the
/// hue turns, so equal steps look equally far apart, to people who see no red or green too, and in grey.
#[must_use]
pub fn heat_color(place: f32) -> [f32; 3] {
    // Written so that NaN, which fails the comparison, is the start.
    let v = if place > 0.0 { place.min(1.0) } else { 0.0 };
    let lightness = 0.2 + 0.75 * v;
    let hue = (305.0 - 200.0 * v).to_radians();
    // As colourful as the hues in the middle allow, and more towards yellow.
    let chroma = 0.092 + 0.06 * (2.0 * v - 1.0).max(0.0);
    let (sin, cos) = libm::sincosf(hue);
    linear_from_oklab(lightness, chroma * cos, chroma * sin)
}

/// The linear colour of a count.
pub(crate) fn heat_of_count(count: u32) -> [f32; 3] {
    static TABLE: OnceLock<Vec<[f32; 3]>> = OnceLock::new();
    let table = TABLE.get_or_init(|| (0..=HEAT_END).map(|count| heat_color(heat_place(count))).collect());
    table[count.min(HEAT_END) as usize]
}

/// Ottosson's matrices. What rounding puts outside the colours of a screen is moved onto their border.
fn linear_from_oklab(lightness: f32, a: f32, b: f32) -> [f32; 3] {
    let cube = |v: f32| v * v * v;
    let l = cube(lightness + 0.396_337_78 * a + 0.215_803_76 * b);
    let m = cube(lightness - 0.105_561_346 * a - 0.063_854_17 * b);
    let s = cube(lightness - 0.089_484_18 * a - 1.291_485_5 * b);
    [
        4.076_741_7 * l - 3.307_711_6 * m + 0.230_969_94 * s,
        -1.268_438 * l + 2.609_757_4 * m - 0.341_319_4 * s,
        -0.004_196_086 * l - 0.703_418_6 * m + 1.707_614_7 * s,
    ]
    .map(|channel| channel.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_starts_at_none_ends_at_the_end_and_grows_in_between() {
        assert_eq!((heat_place(0), heat_place(15), heat_place(HEAT_END)), (0.0, 0.5, 1.0));
        assert_eq!(heat_place(u32::MAX), 1.0);
        assert!((1..=HEAT_END).all(|count| heat_place(count) > heat_place(count - 1)));
        assert_eq!(heat_of_count(1_000_000), heat_color(1.0));
    }

    #[test]
    fn the_legend_is_evenly_spaced() {
        for (k, tick) in HEAT_TICKS.into_iter().enumerate() {
            assert!((heat_place(tick) - k as f32 / 8.0).abs() < 1e-6, "{tick}");
        }
    }

    #[test]
    fn colours_grow_brighter_all_the_way_and_stay_on_the_screen() {
        let luminance = |c: [f32; 3]| 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
        for step in 0..=1000_u16 {
            let here = heat_color(f32::from(step) / 1000.0);
            assert!(here.iter().all(|c| (0.0..=1.0).contains(c)));
            if step > 0 {
                let before = heat_color(f32::from(step - 1) / 1000.0);
                assert!(luminance(here) > luminance(before), "{step}");
            }
        }
        assert_eq!(heat_color(f32::NAN), heat_color(0.0));
    }
}
