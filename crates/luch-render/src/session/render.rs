//! Renders a job to the end: threads that take tiles until none is left.

use super::crew;
use super::job::{Crop, RenderJob};
use super::progress::Progress;
use super::queue::{Queue, lock};
use super::scheduler::Scheduler;
use super::worker::{Task, View, Worker};
use crate::compiled::CompiledScene;
use crate::film::Film;
use std::fmt;
use std::sync::{Arc, Mutex};

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
/// Uses up to `job.threads` threads of its own and waits for them; `progress` may be watched and cancelled meanwhile.
///
/// # Errors
/// [`RenderError`]; the picture made so far is dropped.
pub fn render(scene: &CompiledScene, job: &RenderJob, progress: &Progress) -> Result<Film, RenderError> {
    let pixels = job.pixels().ok_or(RenderError::EmptyCrop)?;
    let samples = job.rays_per_pixel();
    let scheduler = Scheduler::new(pixels, job.tile_size, samples);
    let tiles = scheduler.len();
    progress.begin(u64::from(pixels.width) * u64::from(pixels.height) * u64::from(samples));
    let film = Mutex::new(Film::new(pixels, samples));
    let queue = Queue::new(scheduler);
    let view = View::of(job);
    let work = |between: &dyn Fn()| {
        let stop = || progress.is_cancelled() || queue.has_failed();
        let tally = |samples, rays| progress.add(samples, rays);
        let task = Task { scene, view: &view, stop: &stop, tally: &tally };
        let mut worker = Worker::default();
        queue.work_off(|_, work| {
            between();
            let sums = worker.tile(&task, work, None, None)?;
            lock(&film).put(work.tile, Arc::new(sums));
            Some(())
        });
    };
    progress.end(crew::run(job.threads.clamp(1, tiles.max(1)), &work));
    if let Some(error) = queue.take_failure() {
        return Err(error);
    }
    if progress.is_cancelled() {
        return Err(RenderError::Cancelled);
    }
    Ok(film.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner))
}
