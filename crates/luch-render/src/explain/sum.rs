//! Adds an account up again, from nothing but its numbers.

use super::account::{PixelAccount, RayEnd, Spread};
use super::light::Visibility;
use super::surface::SurfaceAccount;
use crate::shading::terms::BRIGHTEST;

impl PixelAccount {
    /// The pixel's colour, worked out from the numbers of the account by plain arithmetic: the lighting sum of every
    /// surface, the mix with what it mirrors, the mean of the samples. The same bits as [`PixelAccount::pixel`].
    #[must_use]
    pub fn sum(&self) -> [f32; 3] {
        // Rays lie behind those that caused them.
        let mut colors = vec![[0.0; 3]; self.rays.len()];
        for (index, ray) in self.rays.iter().enumerate().rev() {
            colors[index] = match ray.end {
                RayEnd::Surface(place) => {
                    let surface = &self.surfaces[place as usize];
                    let local = self.local_sum(place, surface);
                    surface.mirror.map_or(local, |mirror| mix(surface.reflection, local, colors[mirror as usize]))
                }
                RayEnd::Nothing | RayEnd::DepthUsedUp => self.setting.background,
                RayEnd::Light(_) | RayEnd::Blocked { .. } => continue,
            };
        }
        mean(self.samples.iter().map(|sample| colors[sample.ray as usize]))
    }

    /// The lighting sum of a surface.
    fn local_sum(&self, place: u32, surface: &SurfaceAccount) -> [f32; 3] {
        let mut sum = surface.base.map(|base| limited(base * self.setting.ambient));
        for (light, source) in self.lights_of(place).iter().zip(&self.setting.lights) {
            if light.visibility == Visibility::Visible {
                let share = |c: usize| (surface.base[c] * light.diffuse + light.specular) * source.color[c];
                sum = std::array::from_fn(|c| limited(sum[c] + share(c)));
            }
        }
        sum
    }
}

fn limited(value: f32) -> f32 {
    if value < BRIGHTEST { value } else { BRIGHTEST }
}

/// What a mirror of share `r` shows.
fn mix(r: f32, local: [f32; 3], mirrored: [f32; 3]) -> [f32; 3] {
    std::array::from_fn(|c| (1.0 - r) * local[c] + r * mirrored[c])
}

/// The mean of the samples, added in order as the film does it.
pub(super) fn mean(samples: impl ExactSizeIterator<Item = [f32; 3]>) -> [f32; 3] {
    #[allow(clippy::cast_precision_loss, reason = "at most 4096 samples")]
    let count = samples.len().max(1) as f32;
    let add = |sum: [f32; 3], color: [f32; 3]| std::array::from_fn(|c| sum[c] + color[c]);
    samples.reduce(add).map_or([0.0; 3], |sum| sum.map(|channel| channel / count))
}

/// How the samples differ.
pub(super) fn spread(samples: &[[f32; 3]]) -> Spread {
    let channel = |c: usize| samples.iter().map(move |color| color[c]);
    let [mut min, mut max, mut std_dev] = [[0.0; 3]; 3];
    for c in 0..3 {
        min[c] = channel(c).fold(f32::INFINITY, f32::min);
        max[c] = channel(c).fold(0.0, f32::max);
        // Two passes, so that nothing cancels.
        let count = samples.len().max(1) as f64;
        let mean = channel(c).map(f64::from).sum::<f64>() / count;
        let square = channel(c).map(|v| (f64::from(v) - mean).powi(2)).sum::<f64>() / count;
        #[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
        let root = square.sqrt() as f32;
        std_dev[c] = root;
    }
    Spread { min, max, std_dev }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spread_of_one_sample_is_none_and_of_two_half_their_distance() {
        let one = spread(&[[0.25, 0.5, 0.0]]);
        assert_eq!((one.min, one.max, one.std_dev), ([0.25, 0.5, 0.0], [0.25, 0.5, 0.0], [0.0; 3]));
        let two = spread(&[[0.25, 0.5, 0.0], [0.75, 0.5, 1.0]]);
        assert_eq!((two.min, two.max, two.std_dev), ([0.25, 0.5, 0.0], [0.75, 0.5, 1.0], [0.25, 0.0, 0.5]));
    }

    #[test]
    fn the_mean_adds_in_order_from_the_first() {
        assert_eq!(mean([[1.0, 2.0, 4.0], [3.0, 2.0, 0.0]].into_iter()), [2.0, 2.0, 2.0]);
        assert_eq!(mean(std::iter::empty::<[f32; 3]>().collect::<Vec<_>>().into_iter()), [0.0; 3]);
    }
}
