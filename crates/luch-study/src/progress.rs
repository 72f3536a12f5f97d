//! How far a study is, and whether it shall stop: looked at and set from any thread.

use luch_render::Progress;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// Shared between the thread that measures and those that watch it.
#[derive(Debug, Default)]
pub struct StudyProgress {
    cancelled: AtomicBool,
    done: AtomicU64,
    total: AtomicU64,
    rays: AtomicU64,
    /// The render that is going on.
    current: Mutex<Option<Arc<Progress>>>,
}

impl StudyProgress {
    /// Nothing done, nothing to do.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Asks the study to stop, the render that is going on included; it does within a few milliseconds, unless it builds
    /// the tree of a large mesh just then.
    pub fn cancel(&self) {
        // Under the lock: either the next render sees the wish before it begins, or it is here to be told.
        let current = self.current();
        self.cancelled.store(true, Ordering::Relaxed);
        if let Some(render) = &*current {
            render.cancel();
        }
    }

    /// Whether somebody asked to stop.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// Samples of pixels made so far, in all runs.
    #[must_use]
    pub fn done(&self) -> u64 {
        let current = self.current();
        self.done.load(Ordering::Relaxed) + current.as_ref().map_or(0, |render| render.done())
    }

    /// Samples of pixels to make in all; 0 before the study began.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.total.load(Ordering::Relaxed)
    }

    /// Rays traced so far, in all runs.
    #[must_use]
    pub fn rays(&self) -> u64 {
        let current = self.current();
        self.rays.load(Ordering::Relaxed) + current.as_ref().map_or(0, |render| render.rays())
    }

    pub(crate) fn begin(&self, total: u64) {
        self.done.store(0, Ordering::Relaxed);
        self.rays.store(0, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }

    /// Begins a render; `None` if the study shall stop.
    pub(crate) fn begin_render(&self) -> Option<Arc<Progress>> {
        let mut current = self.current();
        if self.is_cancelled() {
            return None;
        }
        let render = Arc::new(Progress::new());
        *current = Some(Arc::clone(&render));
        Some(render)
    }

    /// Counts the render that was begun last and forgets it.
    pub(crate) fn end_render(&self) {
        let mut current = self.current();
        if let Some(render) = current.take() {
            self.done.fetch_add(render.done(), Ordering::Relaxed);
            self.rays.fetch_add(render.rays(), Ordering::Relaxed);
        }
    }

    fn current(&self) -> MutexGuard<'_, Option<Arc<Progress>>> {
        self.current.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wish_to_stop_reaches_the_render_that_is_going_on_and_lets_none_begin() {
        let progress = StudyProgress::new();
        let render = progress.begin_render().unwrap();
        assert!(!render.is_cancelled());
        progress.cancel();
        assert!(render.is_cancelled() && progress.is_cancelled());
        progress.end_render();
        assert!(progress.begin_render().is_none());
    }
}
