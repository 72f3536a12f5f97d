//! A picture in the making: its tiles, and what the passes made of them so far.

use super::objects::ObjectMap;
use super::pass::Made;
use crate::film::Film;
use crate::math::ray::NO_OBJECT;
use crate::session::job::Crop;
use crate::session::scheduler::Scheduler;
use luch_scene::ImageSize;
use std::sync::Arc;

/// The tiles of a picture, or of its preview, with the sums of their samples.
pub(super) struct Canvas {
    size: ImageSize,
    shrink: u32,
    extent: Crop,
    plan: Scheduler,
    sums: Vec<Option<Arc<Vec<f32>>>>,
    samples: u32,
}

/// Side of the tiles, at most: small enough that a cancelled pass ends at once.
const TILE_SIZE: u32 = 32;
/// Side of the tiles of small pictures, so that every thread has some.
const SMALLEST_TILE: u32 = 8;
/// Tiles for each thread, at least, where the picture has the pixels for it.
const TILES_A_THREAD: u64 = 8;

impl Canvas {
    /// A canvas of one ray for each block of `shrink` times `shrink` pixels of a picture.
    pub(super) fn new(size: ImageSize, shrink: u32, threads: usize) -> Self {
        let (width, height) = (size.width().div_ceil(shrink), size.height().div_ceil(shrink));
        let extent = Crop { x: 0, y: 0, width, height };
        let tiles = (threads as u64).saturating_mul(TILES_A_THREAD);
        let fits = |side: &u32| u64::from(width) * u64::from(height) / u64::from(side * side) >= tiles;
        let side = [TILE_SIZE, TILE_SIZE / 2].into_iter().find(fits).unwrap_or(SMALLEST_TILE);
        let plan = Scheduler::new(extent, side, 1);
        let sums = vec![None; plan.len()];
        Self { size, shrink, extent, plan, sums, samples: 0 }
    }

    /// The tiles that a picture of this size has at most: more threads would find nothing to do.
    pub(super) fn most_tiles(size: ImageSize) -> usize {
        size.width().div_ceil(SMALLEST_TILE) as usize * size.height().div_ceil(SMALLEST_TILE) as usize
    }

    /// Pixels of the picture along the side of the block that each ray stands for.
    pub(super) const fn shrink(&self) -> u32 {
        self.shrink
    }

    pub(super) const fn width(&self) -> u32 {
        self.extent.width
    }

    pub(super) const fn height(&self) -> u32 {
        self.extent.height
    }

    /// Samples that every pixel has.
    pub(super) const fn samples(&self) -> u32 {
        self.samples
    }

    /// The next `samples` samples.
    pub(super) fn plan(&self, samples: u32) -> Scheduler {
        self.plan.pass(self.samples, samples)
    }

    /// The sums so far, by tile.
    pub(super) fn sums(&self) -> Vec<Option<Arc<Vec<f32>>>> {
        if self.samples == 0 { Vec::new() } else { self.sums.clone() }
    }

    /// Takes what a whole pass made.
    pub(super) fn take(&mut self, made: &[Made], samples: u32) {
        for made in made {
            self.sums[made.tile] = Some(Arc::clone(&made.sums));
        }
        self.samples += samples;
    }

    /// The film as it is now.
    pub(super) fn film(&self) -> Film {
        let mut film = Film::new(self.extent, self.samples);
        for (tile, sums) in self.plan.tiles().iter().zip(&self.sums) {
            if let Some(sums) = sums {
                film.put(*tile, Arc::clone(sums));
            }
        }
        film
    }

    /// Which object is where.
    pub(super) fn object_map(&self, made: &[Made]) -> ObjectMap {
        let objects = self.assemble(NO_OBJECT, made.iter().map(|made| (made.tile, made.objects.as_slice())));
        ObjectMap::new(self.size, self.shrink, objects)
    }

    /// Puts the parts of all tiles together, by rows of the whole.
    pub(super) fn assemble<'a, T: Copy + 'a>(&self, blank: T, parts: impl Iterator<Item = (usize, &'a [T])>) -> Vec<T> {
        let width = self.extent.width as usize;
        let mut whole = vec![blank; width * self.extent.height as usize];
        for (tile, part) in parts {
            let tile = self.plan.tiles()[tile];
            for (row, values) in part.chunks_exact(tile.width as usize).enumerate() {
                let start = (tile.y as usize + row) * width + tile.x as usize;
                whole[start..start + values.len()].copy_from_slice(values);
            }
        }
        whole
    }
}
