//! The picture while it is made.

pub mod tonemap;

use crate::session::Crop;

/// A picture of linear light: for each pixel the sum of its samples, in the order of the samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Film {
    crop: Crop,
    /// Red, green, blue; rows from the top.
    sums: Vec<f32>,
    samples: u32,
}

impl Film {
    /// A black picture of a part of the whole, with room for sums of `samples` samples.
    pub(crate) fn new(crop: Crop, samples: u32) -> Self {
        let pixels = crop.width as usize * crop.height as usize;
        Self { crop, sums: vec![0.0; pixels * 3], samples }
    }

    /// Pixels in a row.
    #[must_use]
    pub const fn width(&self) -> u32 {
        self.crop.width
    }

    /// Rows.
    #[must_use]
    pub const fn height(&self) -> u32 {
        self.crop.height
    }

    /// Samples of each pixel.
    #[must_use]
    pub const fn samples(&self) -> u32 {
        self.samples
    }

    /// Linear red, green, blue of each pixel, rows from the top: the mean of the samples.
    #[must_use]
    pub fn linear(&self) -> Vec<f32> {
        #[allow(clippy::cast_precision_loss, reason = "at most 4096 samples")]
        let count = self.samples.max(1) as f32;
        self.sums.iter().map(|sum| sum / count).collect()
    }

    /// Puts the sums of a part of the picture in their place; `sums` has the rows of `part` one after another.
    pub(crate) fn put(&mut self, part: Crop, sums: &[f32]) {
        let (width, left) = (self.crop.width as usize, (part.x - self.crop.x) as usize);
        let row_len = part.width as usize * 3;
        for (row, values) in sums.chunks_exact(row_len).enumerate() {
            let y = (part.y - self.crop.y) as usize + row;
            let start = (y * width + left) * 3;
            self.sums[start..start + row_len].copy_from_slice(values);
        }
    }
}
