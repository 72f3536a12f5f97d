//! One thread's part in a picture: the sums of a tile's pixels.

use super::job::{Crop, RenderJob};
use super::scheduler::RenderWork;
use crate::compiled::CompiledScene;
use crate::integrator::{Colors, Integrator, Lens, Orders, PixelList, Tracer};
use crate::math::ray::{Coherence, HitBatch, NO_OBJECT, RayBatch};
use crate::simd::SimdLevel;

/// How a scene is looked at: what the pixels of a picture depend on besides the scene.
#[derive(Debug, Clone, Copy)]
pub(super) struct View {
    lens: Lens,
    integrator: Integrator,
    depth: u32,
    simd: SimdLevel,
}

impl View {
    pub(super) fn of(job: &RenderJob) -> Self {
        Self {
            lens: Lens::new(&job.camera, job.size, job.antialiasing.on, job.depth_of_field.on),
            integrator: job.integrator,
            depth: job.depth,
            simd: job.simd,
        }
    }

    /// The same look with one ray through the centre of each block of `shrink` times `shrink` pixels, from a closed lens.
    pub(super) fn of_blocks(job: &RenderJob, shrink: u32) -> Self {
        let view = Self::of(job);
        Self { lens: view.lens.of_blocks(shrink), ..view }
    }
}

/// What a worker is to do with the pieces of a picture.
#[derive(Clone, Copy)]
pub(super) struct Task<'a> {
    pub(super) scene: &'a CompiledScene,
    pub(super) view: &'a View,
    /// Asked between the queries of a tile: whether to give it up.
    pub(super) stop: &'a dyn Fn() -> bool,
    /// Told after each sample of a tile: how many pixels it has, and how many rays were traced for them.
    pub(super) tally: &'a dyn Fn(u64, u64),
}

/// One thread's tracer and memory, used for tile after tile and picture after picture.
#[derive(Debug, Default)]
pub(super) struct Worker {
    tracer: Tracer,
    /// The size that the order of pixels is known for; for each ray the pixel within the tile, and its number by rows.
    ordered: [u32; 2],
    offsets: Vec<[u32; 2]>,
    places: Vec<usize>,
    /// The pixels of the tile at hand, in the order of their rays.
    pixels: PixelList,
    rays: RayBatch,
    colors: Colors,
    /// Sums of the samples in the order of the rays.
    totals: Colors,
    /// Objects that the rays of a sample met.
    objects: Vec<u32>,
    hits: HitBatch,
}

impl Worker {
    /// The sums of a tile's pixels, red, green, blue, by rows, on top of those of earlier samples in `before`. `objects`,
    /// if asked for, gets the object at the centre of each pixel, by rows. `None` if it was stopped.
    pub(super) fn tile(
        &mut self,
        task: &Task<'_>,
        work: &RenderWork,
        before: Option<&[f32]>,
        objects: Option<&mut Vec<u32>>,
    ) -> Option<Vec<f32>> {
        self.order_pixels(work.tile);
        if let Some(sums) = before {
            self.totals.resize(self.pixels.len());
            for (index, place) in self.places.iter().map(|place| place * 3).enumerate() {
                self.totals.set(index, [sums[place], sums[place + 1], sums[place + 2]]);
            }
        }
        let (view, level) = (task.view, task.view.simd.level_or_best());
        let Task { scene, stop, .. } = *task;
        let orders = Orders { scene, level, integrator: view.integrator, depth: view.depth, stop };
        self.objects.clear();
        for sample in work.first_sample..work.first_sample + work.samples {
            if stop() {
                return None;
            }
            // Through the centre go the rays of the picture itself, if nothing spreads them.
            let sink = (objects.is_some() && sample == work.first_sample && view.lens.is_centered())
                .then_some(&mut self.objects);
            view.lens.rays(level, &self.pixels, sample, &mut self.rays);
            let traced = self.tracer.trace(&orders, &mut self.rays, &mut self.colors, sink)?;
            if sample == work.first_sample && before.is_none() {
                std::mem::swap(&mut self.totals, &mut self.colors);
            } else {
                for (totals, values) in self.totals.0.iter_mut().zip(&self.colors.0) {
                    totals.iter_mut().zip(values).for_each(|(total, value)| *total += value);
                }
            }
            (task.tally)(self.pixels.len() as u64, traced);
        }
        if let Some(objects) = objects {
            if self.objects.is_empty() {
                let lens = view.lens.of_blocks(1);
                lens.rays(level, &self.pixels, 0, &mut self.rays);
                scene.tree.closest_hits(level, &self.rays, Coherence::Coherent, &mut self.hits);
                self.objects.clone_from(&self.hits.object);
                (task.tally)(0, self.rays.len() as u64);
            }
            objects.clear();
            objects.resize(self.pixels.len(), NO_OBJECT);
            for (&place, &object) in self.places.iter().zip(&self.objects) {
                objects[place] = object;
            }
        }
        let mut sums = vec![0.0; self.pixels.len() * 3];
        for (index, place) in self.places.iter().map(|place| place * 3).enumerate() {
            sums[place..place + 3].copy_from_slice(&self.totals.get(index));
        }
        Some(sums)
    }

    /// Gives back what only an uncommonly deep picture needs.
    pub(super) fn shrink(&mut self) {
        self.tracer.shrink();
    }

    /// Lists the tile's pixels in blocks of 8x8, each in blocks of 4x4, so that rays side by side lie side by side.
    fn order_pixels(&mut self, tile: Crop) {
        let extent = [tile.width, tile.height];
        // Nearly all tiles have one size, and with it one order.
        if self.ordered != extent {
            self.ordered = extent;
            self.offsets = blocked_order(extent);
            self.places = self.offsets.iter().map(|[x, y]| (y * tile.width + x) as usize).collect();
        }
        self.pixels.set(self.offsets.iter().map(|[x, y]| [tile.x + x, tile.y + y]));
    }
}

/// The pixels of a rectangle in blocks of 8x8, each in blocks of 4x4, those in rows.
fn blocked_order([width, height]: [u32; 2]) -> Vec<[u32; 2]> {
    let starts = |from: u32, to: u32, step: usize| (from..to).step_by(step);
    let mut order = Vec::with_capacity(width as usize * height as usize);
    for y8 in starts(0, height, 8) {
        for x8 in starts(0, width, 8) {
            for y4 in starts(y8, height.min(y8 + 8), 4) {
                for x4 in starts(x8, width.min(x8 + 8), 4) {
                    for y in y4..height.min(y4 + 4) {
                        order.extend((x4..width.min(x4 + 4)).map(|x| [x, y]));
                    }
                }
            }
        }
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_order_of_pixels_holds_each_once() {
        for extent in [[32, 32], [1, 1], [13, 5], [8, 9], [64, 3]] {
            let mut order = blocked_order(extent);
            assert_eq!(order.len(), (extent[0] * extent[1]) as usize);
            order.sort_unstable();
            order.dedup();
            assert_eq!(order.len(), (extent[0] * extent[1]) as usize, "{extent:?}");
        }
    }
}
