//! Decides what is rendered next. It knows nothing of threads and renders nothing itself.

use super::job::Crop;
use std::sync::Arc;

/// A piece of work: some samples of some pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct RenderWork {
    /// The pixels.
    pub tile: Crop,
    /// The first sample of each.
    pub first_sample: u32,
    /// How many samples of each.
    pub samples: u32,
}

/// Cuts a picture into tiles and hands them out from the middle outwards, where people look first.
#[derive(Debug, Clone)]
pub struct Scheduler {
    tiles: Arc<[Crop]>,
    first_sample: u32,
    samples: u32,
}

impl Scheduler {
    /// Plans `samples` samples for each of the pixels, in square tiles of side `tile_size` (at least 1).
    #[must_use]
    pub fn new(pixels: Crop, tile_size: u32, samples: u32) -> Self {
        let side = tile_size.max(1);
        let starts = |from: u32, length: u32| (0..length.div_ceil(side)).map(move |i| from + i * side);
        let mut tiles: Vec<Crop> = starts(pixels.y, pixels.height)
            .flat_map(|y| starts(pixels.x, pixels.width).map(move |x| [x, y]))
            .map(|[x, y]| Crop {
                x,
                y,
                width: side.min(pixels.x + pixels.width - x),
                height: side.min(pixels.y + pixels.height - y),
            })
            .collect();
        let middle = [pixels.x + pixels.width / 2, pixels.y + pixels.height / 2];
        tiles.sort_by_key(|tile| {
            let away = |start: u32, length: u32, middle: u32| u64::from((start + length / 2).abs_diff(middle));
            let (dx, dy) = (away(tile.x, tile.width, middle[0]), away(tile.y, tile.height, middle[1]));
            // A stable sort: tiles at the same distance keep their order, so that every run is the same.
            dx * dx + dy * dy
        });
        Self { tiles: tiles.into(), first_sample: 0, samples }
    }

    /// The same tiles in the same order, for other samples. Cheap.
    #[must_use]
    pub fn pass(&self, first_sample: u32, samples: u32) -> Self {
        Self { tiles: Arc::clone(&self.tiles), first_sample, samples }
    }

    /// How many pieces of work there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.tiles.len()
    }

    /// Whether there is nothing to do.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.tiles.is_empty()
    }

    /// Piece of work number `index`; `None` beyond the last.
    #[must_use]
    pub fn work(&self, index: usize) -> Option<RenderWork> {
        let tile = *self.tiles.get(index)?;
        Some(RenderWork { tile, first_sample: self.first_sample, samples: self.samples })
    }

    /// The tiles, in the order in which they are handed out.
    #[must_use]
    pub fn tiles(&self) -> &[Crop] {
        &self.tiles
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tiles_cover_every_pixel_once() {
        let pixels = Crop { x: 5, y: 3, width: 101, height: 67 };
        for side in [1, 8, 13, 32, 64, 500] {
            let scheduler = Scheduler::new(pixels, side, 4);
            let mut seen = vec![0; 101 * 67];
            for index in 0..scheduler.len() {
                let work = scheduler.work(index).unwrap();
                assert_eq!((work.first_sample, work.samples), (0, 4));
                for y in work.tile.y..work.tile.y + work.tile.height {
                    for x in work.tile.x..work.tile.x + work.tile.width {
                        seen[((y - 3) * 101 + (x - 5)) as usize] += 1;
                    }
                }
            }
            assert!(seen.iter().all(|&n| n == 1), "tiles of {side}");
            assert_eq!(scheduler.work(scheduler.len()), None);
        }
    }

    #[test]
    fn the_middle_comes_first() {
        let scheduler = Scheduler::new(Crop { x: 0, y: 0, width: 320, height: 320 }, 32, 1);
        let first = scheduler.work(0).unwrap().tile;
        assert!(first.x.abs_diff(160) <= 32 && first.y.abs_diff(160) <= 32);
        let last = scheduler.work(scheduler.len() - 1).unwrap().tile;
        assert!(last.x == 0 || last.x == 288);
    }
}
