//! The pixel filter, as a distribution to draw from: a sample then counts for its own pixel only, with weight one
//! (Ernst, Stamminger, Greiner, "Filter Importance Sampling", 2006).

/// Half the width of the filter, in pixels.
pub const TENT_RADIUS: f32 = 1.0;

/// Offset from the pixel's centre, in -1..=1, by the inverse of the tent's distribution.
#[must_use]
pub fn sample_tent(u: f32) -> f32 {
    if u < 0.5 { (2.0 * u).sqrt() - 1.0 } else { 1.0 - (2.0 - 2.0 * u).sqrt() }
}

/// Density of the tent at an offset from the centre.
#[must_use]
pub fn tent_pdf(x: f32) -> f32 {
    if x.abs() < TENT_RADIUS { 1.0 - x.abs() } else { 0.0 }
}

/// The number that [`sample_tent`] turns into this offset.
#[must_use]
pub fn invert_tent(x: f32) -> f32 {
    if x < 0.0 { 0.5 * (1.0 + x) * (1.0 + x) } else { 1.0 - 0.5 * (1.0 - x) * (1.0 - x) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sampling_and_inversion_are_a_round_trip() {
        for i in 0..=1000_u16 {
            let u = f32::from(i) / 1000.0;
            assert!((invert_tent(sample_tent(u)) - u).abs() < 2e-6, "{u}");
        }
    }

    #[test]
    fn the_density_is_the_slope_of_the_distribution() {
        for i in -95..=95_i16 {
            let x = f32::from(i) / 100.0;
            let slope = (invert_tent(x + 0.005) - invert_tent(x - 0.005)) / 0.01;
            assert!((slope - tent_pdf(x)).abs() < 5e-3, "{x}");
        }
    }
}
