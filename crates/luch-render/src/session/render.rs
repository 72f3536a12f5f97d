//! Renders a job to the end: threads that take tiles until none is left.

use super::job::{Crop, RenderJob};
use super::progress::Progress;
use super::scheduler::{RenderWork, Scheduler};
use crate::compiled::CompiledScene;
use crate::film::Film;
use crate::integrator::{Colors, Lens, PixelList, Tracer};
use crate::math::ray::RayBatch;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// Why there is no picture.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum RenderError {
    /// Somebody asked to stop.
    Cancelled,
    /// The crop lies outside the picture.
    EmptyCrop,
    /// A bug of the renderer: a thread panicked while it made this tile.
    Internal {
        /// The tile.
        tile: Crop,
        /// What the panic said.
        message: String,
    },
}

impl fmt::Display for RenderError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Cancelled => write!(f, "stopped"),
            Self::EmptyCrop => write!(f, "the crop lies outside the picture"),
            Self::Internal { tile: Crop { x, y, width, height }, message } => {
                write!(f, "internal error in the tile of {width}x{height} pixels at {x},{y}: {message}")
            }
        }
    }
}

impl std::error::Error for RenderError {}

/// Renders the job and answers with the finished picture.
///
/// Uses `job.threads` threads of its own and waits for them; `progress` may be watched and cancelled meanwhile.
///
/// # Errors
/// [`RenderError`]; the picture made so far is dropped.
pub fn render(scene: &CompiledScene, job: &RenderJob, progress: &Progress) -> Result<Film, RenderError> {
    let pixels = job.pixels().ok_or(RenderError::EmptyCrop)?;
    let samples = job.rays_per_pixel();
    let scheduler = Scheduler::new(pixels, job.tile_size, samples);
    progress.begin(u64::from(pixels.width) * u64::from(pixels.height) * u64::from(samples));
    let film = Mutex::new(Film::new(pixels, samples));
    let failure = Mutex::new(None);
    let next = AtomicUsize::new(0);
    let work = || {
        let mut worker = Worker::new(scene, job);
        while let Some(work) = scheduler.work(next.fetch_add(1, Ordering::Relaxed)) {
            match catch_unwind(AssertUnwindSafe(|| worker.tile(&work, progress))) {
                Ok(Some(sums)) => lock(&film).put(work.tile, sums),
                Ok(None) => return,
                Err(panic) => {
                    // The other threads stop at their next sample; the first failure is the one told.
                    let message = message_of(panic.as_ref());
                    lock(&failure).get_or_insert(RenderError::Internal { tile: work.tile, message });
                    progress.cancel();
                    return;
                }
            }
        }
    };
    run_on_threads(job.threads.clamp(1, scheduler.len().max(1)), &work);
    if let Some(error) = lock(&failure).take() {
        return Err(error);
    }
    if progress.is_cancelled() {
        return Err(RenderError::Cancelled);
    }
    Ok(film.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner))
}

/// Runs the same work on some named threads and waits for them. If the system gives fewer, those do it, and if it gives
/// none, the caller does.
fn run_on_threads(threads: usize, work: &(impl Fn() + Sync)) {
    thread::scope(|scope| {
        let spawn =
            |number| thread::Builder::new().name(format!("luch-render-{number}")).spawn_scoped(scope, work).is_ok();
        let started = (0..threads).filter(|&number| spawn(number)).count();
        if started == 0 {
            work();
        }
    });
}

/// The lock, whether or not a thread panicked while it held it: what it guards is replaced whole.
fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
}

fn message_of(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|s| (*s).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "no message".to_owned())
}

/// One thread's tracer and memory.
struct Worker<'a> {
    lens: Lens,
    tracer: Tracer<'a>,
    level: fearless_simd::Level,
    /// The size that the order of pixels is known for; for each ray the pixel within the tile, and its place in the sums.
    ordered: [u32; 2],
    offsets: Vec<[u32; 2]>,
    places: Vec<usize>,
    /// The pixels of the tile at hand, in the order of their rays.
    pixels: PixelList,
    rays: RayBatch,
    colors: Colors,
    /// Sums of the samples in the order of the rays.
    totals: Colors,
}

impl<'a> Worker<'a> {
    fn new(scene: &'a CompiledScene, job: &RenderJob) -> Self {
        let level = job.simd.level_or_best();
        Self {
            lens: Lens::new(&job.camera, job.size, job.antialiasing.on, job.depth_of_field.on),
            tracer: Tracer::new(scene, level, job.integrator, job.depth),
            level,
            ordered: [0, 0],
            offsets: Vec::new(),
            places: Vec::new(),
            pixels: PixelList::default(),
            rays: RayBatch::new(),
            colors: Colors::default(),
            totals: Colors::default(),
        }
    }

    /// The sums of a tile's pixels in rows; `None` if it was cancelled.
    fn tile(&mut self, work: &RenderWork, progress: &Progress) -> Option<Vec<f32>> {
        self.order_pixels(work.tile);
        for sample in work.first_sample..work.first_sample + work.samples {
            if progress.is_cancelled() {
                return None;
            }
            self.lens.rays(self.level, &self.pixels, sample, &mut self.rays);
            let traced = self.tracer.trace(&mut self.rays, &mut self.colors);
            if sample == work.first_sample {
                std::mem::swap(&mut self.totals, &mut self.colors);
            } else {
                for (totals, values) in self.totals.0.iter_mut().zip(&self.colors.0) {
                    totals.iter_mut().zip(values).for_each(|(total, value)| *total += value);
                }
            }
            progress.add(self.pixels.len() as u64, traced);
        }
        let mut sums = vec![0.0; self.pixels.len() * 3];
        for (index, &place) in self.places.iter().enumerate() {
            sums[place..place + 3].copy_from_slice(&self.totals.get(index));
        }
        Some(sums)
    }

    /// Lists the tile's pixels in blocks of 8x8, each in blocks of 4x4, so that rays side by side lie side by side.
    fn order_pixels(&mut self, tile: Crop) {
        let extent = [tile.width, tile.height];
        // Nearly all tiles have one size, and with it one order.
        if self.ordered != extent {
            self.ordered = extent;
            self.offsets = blocked_order(extent);
            self.places = self.offsets.iter().map(|[x, y]| (y * tile.width + x) as usize * 3).collect();
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
