//! Pictures in linear light, read back from their files.

use crate::support::{Folder, Png};
use exr::prelude::read_first_rgba_layer_from_file;
use luch_scene::color::linear_from_srgb;

/// A picture: rows from the top, linear light.
pub(crate) struct Picture {
    pub(crate) width: usize,
    pub(crate) pixels: Vec<[f32; 3]>,
}

impl Picture {
    /// Reads a .png (16 bits for each colour, what is brighter than 1 is 1) or an .exr (exact).
    pub(crate) fn read(folder: &Folder, name: &str) -> Self {
        let picture = if name.ends_with(".png") { Self::png(&folder.read(name)) } else { Self::exr(folder, name) };
        assert!(
            picture.pixels.iter().flatten().all(|v| v.is_finite() && *v >= 0.0),
            "{name}: numbers that are no light"
        );
        picture
    }

    fn png(bytes: &[u8]) -> Self {
        let Png { width, bits, bytes, .. } = Png::decode(bytes);
        assert_eq!(bits, 16);
        let value = |b: &[u8]| linear_from_srgb(f32::from(u16::from_be_bytes([b[0], b[1]])) / 65_535.0);
        let pixels = bytes.chunks_exact(6).map(|p| [0, 2, 4].map(|at| value(&p[at..at + 2]))).collect();
        Self { width, pixels }
    }

    fn exr(folder: &Folder, name: &str) -> Self {
        let image = read_first_rgba_layer_from_file(
            folder.path().join(name),
            |size, _| Self { width: size.0, pixels: vec![[0.0; 3]; size.0 * size.1] },
            |picture: &mut Self, at, (r, g, b, _): (f32, f32, f32, f32)| {
                picture.pixels[at.1 * picture.width + at.0] = [r, g, b];
            },
        );
        image.unwrap_or_else(|e| panic!("{name}: {e}")).layer_data.channel_data.pixels
    }

    /// The mean colour of some pixels.
    pub(crate) fn mean(&self, pixels: &[usize]) -> [f64; 3] {
        let sum = |channel: usize| pixels.iter().map(|&i| f64::from(self.pixels[i][channel])).sum::<f64>();
        [0, 1, 2].map(|channel| sum(channel) / pixels.len() as f64)
    }

    /// The luminance (Rec. 709) of a pixel.
    pub(crate) fn luminance(&self, pixel: usize) -> f64 {
        let [r, g, b] = self.pixels[pixel].map(f64::from);
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    /// Standard deviation of the luminance over its mean.
    pub(crate) fn contrast(&self, pixels: &[usize]) -> f64 {
        let count = pixels.len() as f64;
        let mean = pixels.iter().map(|&i| self.luminance(i)).sum::<f64>() / count;
        let variance = pixels.iter().map(|&i| (self.luminance(i) - mean).powi(2)).sum::<f64>() / count;
        variance.sqrt() / mean
    }

    /// The luminance that a share of the pixels stays below.
    pub(crate) fn quantile(&self, pixels: &[usize], share: f64) -> f64 {
        let mut values: Vec<f64> = pixels.iter().map(|&i| self.luminance(i)).collect();
        values.sort_by(f64::total_cmp);
        values[((values.len() - 1) as f64 * share) as usize]
    }

    /// The largest difference of a channel of a pixel between two pictures.
    pub(crate) fn difference(&self, other: &Self, pixel: usize) -> f32 {
        let (a, b) = (self.pixels[pixel], other.pixels[pixel]);
        (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f32::max)
    }

    /// Those of the pixels that differ by more than `least` between two pictures.
    pub(crate) fn changed(&self, other: &Self, pixels: &[usize], least: f32) -> Vec<usize> {
        pixels.iter().copied().filter(|&i| self.difference(other, i) > least).collect()
    }

    /// Every pixel.
    pub(crate) fn all(&self) -> Vec<usize> {
        (0..self.pixels.len()).collect()
    }
}
