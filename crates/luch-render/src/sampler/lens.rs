//! Points on the lens.

use std::f32::consts::{FRAC_PI_2, FRAC_PI_4, PI};

/// A point of the unit disk, area-preserving and with little distortion (Shirley and Chiu, "A Low Distortion Map
/// Between Disk and Square", 1997).
#[must_use]
pub fn sample_disk(u: [f32; 2]) -> [f32; 2] {
    let (a, b) = (2.0 * u[0] - 1.0, 2.0 * u[1] - 1.0);
    if a == 0.0 && b == 0.0 {
        return [0.0, 0.0];
    }
    let (r, phi) = if a.abs() > b.abs() { (a, FRAC_PI_4 * (b / a)) } else { (b, FRAC_PI_2 - FRAC_PI_4 * (a / b)) };
    let (sin, cos) = libm::sincosf(phi);
    [r * cos, r * sin]
}

/// Density of [`sample_disk`]: the same everywhere on the disk.
#[must_use]
pub fn uniform_disk_pdf() -> f32 {
    1.0 / PI
}

/// The numbers that [`sample_disk`] turns into this point of the unit disk.
#[must_use]
pub fn invert_disk(p: [f32; 2]) -> [f32; 2] {
    let [x, y] = p;
    let r = (x * x + y * y).sqrt();
    if r == 0.0 {
        return [0.5, 0.5];
    }
    // The signed radius of the square's own polar coordinates.
    let (a, b) = if x.abs() > y.abs() {
        let a = r.copysign(x);
        (a, a * libm::atanf(y / x) / FRAC_PI_4)
    } else {
        let b = r.copysign(y);
        (b * (libm::atanf(x / y) / FRAC_PI_4), b)
    };
    [0.5 * (a + 1.0), 0.5 * (b + 1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sampling_and_inversion_are_a_round_trip() {
        for i in 0..50_u8 {
            for j in 0..50_u8 {
                let u = [(f32::from(i) + 0.5) / 50.0, (f32::from(j) + 0.5) / 50.0];
                let p = sample_disk(u);
                assert!(p[0] * p[0] + p[1] * p[1] <= 1.000_001);
                let back = invert_disk(p);
                assert!((back[0] - u[0]).abs() < 1e-5 && (back[1] - u[1]).abs() < 1e-5, "{u:?} {p:?} {back:?}");
            }
        }
    }

    #[test]
    fn equal_areas_of_the_square_become_equal_areas_of_the_disk() {
        // A disk of half the radius has a quarter of the area.
        let n = 400_u16;
        let inside = (0..n).flat_map(|i| (0..n).map(move |j| [i, j])).filter(|&[i, j]| {
            let at = |k: u16| (f32::from(k) + 0.5) / f32::from(n);
            let [x, y] = sample_disk([at(i), at(j)]);
            x * x + y * y < 0.25
        });
        let share = inside.count() as f64 / f64::from(n).powi(2);
        assert!((share - 0.25).abs() < 0.002, "{share}");
        assert!((uniform_disk_pdf() * PI - 1.0).abs() < 1e-6);
    }
}
