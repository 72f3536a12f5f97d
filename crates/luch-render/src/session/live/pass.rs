//! One pass over a picture: some samples of every pixel, made by all threads together.

use super::mailbox::Mailbox;
use super::pool::Pool;
use crate::compiled::CompiledScene;
use crate::film::tonemap::opaque_srgb8;
use crate::session::progress::Progress;
use crate::session::queue::{Queue, lock};
use crate::session::render::RenderError;
use crate::session::scheduler::Scheduler;
use crate::session::worker::{Task, View, Worker};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

/// What a pass is to make.
pub(super) struct Pass {
    pub(super) scene: Arc<CompiledScene>,
    pub(super) view: View,
    /// The tiles and the samples.
    pub(super) plan: Scheduler,
    /// The sums of the samples before, by tile.
    pub(super) before: Vec<Option<Arc<Vec<f32>>>>,
    /// Whether to say which object is where.
    pub(super) objects: bool,
    pub(super) progress: Arc<Progress>,
    /// Whether the samples count as progress.
    pub(super) counts: bool,
    pub(super) mailbox: Arc<Mailbox>,
    /// Until then a newer request is no reason to stop.
    pub(super) patience: Instant,
}

/// What a pass made of a tile.
pub(super) struct Made {
    /// Its number in the plan.
    pub(super) tile: usize,
    pub(super) sums: Arc<Vec<f32>>,
    pub(super) pixels: Vec<[u8; 4]>,
    /// Empty if nobody asked.
    pub(super) objects: Vec<u32>,
}

/// What came of a pass.
pub(super) struct Outcome {
    pub(super) made: Vec<Made>,
    /// Whether every tile is there.
    pub(super) whole: bool,
    pub(super) took: Duration,
}

impl Pass {
    /// Makes the pass.
    pub(super) fn run(self, pool: &mut Pool, threads: usize) -> Result<Outcome, RenderError> {
        let start = Instant::now();
        let tiles = self.plan.len();
        let queue = Queue::new(self.plan.clone());
        let made = Mutex::new(Vec::with_capacity(tiles));
        let shared = Arc::new((self, queue, made));
        let work = Arc::clone(&shared);
        pool.run(threads.clamp(1, tiles.max(1)), Arc::new(move |worker| work.0.work(&work.1, &work.2, worker)));
        let (_, queue, made) = &*shared;
        if let Some(error) = queue.take_failure() {
            return Err(error);
        }
        let made = std::mem::take(&mut *lock(made));
        Ok(Outcome { whole: made.len() == tiles, made, took: start.elapsed() })
    }

    /// What each thread does.
    fn work(&self, queue: &Queue, made: &Mutex<Vec<Made>>, worker: &mut Worker) -> bool {
        let patient = || Instant::now() < self.patience;
        let stop = || queue.has_failed() || self.mailbox.is_unwanted(&patient);
        let tally = |samples, rays| self.progress.add(if self.counts { samples } else { 0 }, rays);
        let task = Task { scene: &self.scene, view: &self.view, stop: &stop, tally: &tally };
        queue.work_off(|tile, work| {
            let mut objects = Vec::new();
            let before = self.before.get(tile).and_then(Option::as_deref).map(Vec::as_slice);
            let sums = worker.tile(&task, work, before, self.objects.then_some(&mut objects))?;
            let pixels = opaque_srgb8(&sums, work.first_sample + work.samples);
            lock(made).push(Made { tile, sums: Arc::new(sums), pixels, objects });
            Some(())
        })
    }
}
