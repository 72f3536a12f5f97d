//! Sample positions: every number comes from (pixel, sample, dimension) and nothing else.
//!
//! Each pixel has its own scrambling of the first two Sobol dimensions, shuffled anew for each pair of dimensions
//! (Burley, "Practical Hash-based Owen Scrambling", 2020). Any number of samples is well spread; powers of two best.

mod filter;
mod lens;

pub use filter::{TENT_RADIUS, invert_tent, sample_tent, tent_pdf};
pub use lens::{invert_disk, sample_disk, uniform_disk_pdf};

/// What a pair of numbers is for. Pairs of different use are independent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Use {
    /// Where in the pixel's filter the ray starts.
    Pixel = 0,
    /// Where on the lens the ray starts.
    Lens = 1,
}

/// Two numbers in [0, 1) for sample `sample` of the pixel (`x`, `y`) of the whole picture.
#[must_use]
pub fn sample_pair(x: u32, y: u32, sample: u32, usage: Use) -> [f32; 2] {
    let seed = hash(x ^ hash(y ^ hash(usage as u32 ^ 0x5bd1_e995)));
    let index = owen_scramble(sample, seed);
    [
        unit_float(owen_scramble(sobol_0(index), hash(seed ^ 0x68bc_21eb))),
        unit_float(owen_scramble(sobol_1(index), hash(seed ^ 0x02e5_be93))),
    ]
}

/// The first Sobol dimension: the van der Corput sequence.
const fn sobol_0(index: u32) -> u32 {
    index.reverse_bits()
}

/// The second Sobol dimension: Pascal's triangle modulo 2 applied to the bits of the index.
fn sobol_1(index: u32) -> u32 {
    let mut bits = index;
    let mut direction = 1_u32 << 31;
    let mut result = 0;
    while bits != 0 {
        if bits & 1 == 1 {
            result ^= direction;
        }
        direction ^= direction >> 1;
        bits >>= 1;
    }
    result
}

/// Owen's nested uniform scrambling by the hash of Laine and Karras (2011), with Vegdahl's better constants (2021).
const fn owen_scramble(value: u32, seed: u32) -> u32 {
    let mut v = value.reverse_bits();
    v ^= v.wrapping_mul(0x3d20_adea);
    v = v.wrapping_add(seed);
    v = v.wrapping_mul((seed >> 16) | 1);
    v ^= v.wrapping_mul(0x0552_6c56);
    v ^= v.wrapping_mul(0x53a2_2864);
    v.reverse_bits()
}

/// A 32-bit mixing function with low bias (Wellons, "hash-prospector", 2018).
const fn hash(value: u32) -> u32 {
    let mut v = value;
    v ^= v >> 16;
    v = v.wrapping_mul(0x21f0_aaad);
    v ^= v >> 15;
    v = v.wrapping_mul(0xd35a_2d97);
    v ^ (v >> 15)
}

/// The upper 24 bits as a float in [0, 1): every value is exact.
#[allow(clippy::cast_precision_loss, reason = "24 bits fit a float")]
fn unit_float(v: u32) -> f32 {
    (v >> 8) as f32 * (1.0 / 16_777_216.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Each elementary interval of a (0, 2)-sequence holds exactly one of the first 2^n points.
    #[test]
    fn the_first_sixty_four_samples_are_stratified_in_every_way() {
        for (x, y) in [(0, 0), (1, 0), (959, 719), (65_534, 3)] {
            for usage in [Use::Pixel, Use::Lens] {
                let points: Vec<[f32; 2]> = (0..64).map(|s| sample_pair(x, y, s, usage)).collect();
                for shift in 0..=6_u32 {
                    let (columns, rows) = (1_usize << shift, 64_usize >> shift);
                    let mut seen = [false; 64];
                    for [u, v] in &points {
                        let cell = (u * columns as f32) as usize * rows + (v * rows as f32) as usize;
                        assert!(!seen[cell], "pixel {x},{y}: two samples in one of {columns} x {rows} cells");
                        seen[cell] = true;
                    }
                }
            }
        }
    }

    #[test]
    fn pixels_uses_and_samples_differ() {
        let base = sample_pair(5, 7, 3, Use::Pixel);
        for other in [
            sample_pair(7, 5, 3, Use::Pixel),
            sample_pair(6, 7, 3, Use::Pixel),
            sample_pair(5, 7, 3, Use::Lens),
            sample_pair(5, 7, 4, Use::Pixel),
        ] {
            assert_ne!(base, other);
        }
    }

    #[test]
    fn the_mean_over_pixels_is_one_half() {
        let mut sum = [0.0_f64; 2];
        for y in 0..64 {
            for x in 0..64 {
                let [u, v] = sample_pair(x, y, 0, Use::Pixel);
                assert!((0.0..1.0).contains(&u) && (0.0..1.0).contains(&v));
                sum[0] += f64::from(u);
                sum[1] += f64::from(v);
            }
        }
        for s in sum {
            // 4096 independent uniform numbers: the standard error of the mean is 0.0045.
            assert!((s / 4096.0 - 0.5).abs() < 0.018, "{s}");
        }
    }
}
