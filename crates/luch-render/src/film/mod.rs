//! The picture while it is made.

pub mod color_bar;
pub mod heat;
pub mod tonemap;

use crate::session::Crop;
use std::sync::Arc;

/// A picture of linear light: for each pixel the sum of its samples, in the order of the samples.
///
/// It is kept in the tiles that it was made in: a thread hands its tile over without a copy, and the fresh memory of one
/// tile is not waited for by the others. Tiles are shared, never changed: to copy a film is cheap.
#[derive(Debug, Clone, PartialEq)]
pub struct Film {
    crop: Crop,
    tiles: Vec<Tile>,
    samples: u32,
}

/// A part of the picture: red, green, blue of each pixel, rows from the top.
#[derive(Debug, Clone, PartialEq)]
struct Tile {
    place: Crop,
    sums: Arc<Vec<f32>>,
}

impl Film {
    /// A black picture of a part of the whole, for sums of `samples` samples.
    pub(crate) const fn new(crop: Crop, samples: u32) -> Self {
        Self { crop, tiles: Vec::new(), samples }
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
        let count = tonemap::divisor(self.samples);
        let width = self.crop.width as usize;
        let mut linear = vec![0.0; width * self.crop.height as usize * 3];
        for Tile { place, sums } in &self.tiles {
            let (left, top) = ((place.x - self.crop.x) as usize, (place.y - self.crop.y) as usize);
            let row_len = place.width as usize * 3;
            for (row, sums) in sums.chunks_exact(row_len).enumerate() {
                let start = ((top + row) * width + left) * 3;
                for (mean, sum) in linear[start..start + row_len].iter_mut().zip(sums) {
                    *mean = sum / count;
                }
            }
        }
        linear
    }

    /// Takes the sums of a part of the picture; `sums` has the rows of `place` one after another.
    pub(crate) fn put(&mut self, place: Crop, sums: Arc<Vec<f32>>) {
        debug_assert_eq!(sums.len(), place.width as usize * place.height as usize * 3, "a tile is whole");
        self.tiles.push(Tile { place, sums });
    }
}
