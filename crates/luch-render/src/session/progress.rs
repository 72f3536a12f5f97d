//! How far a render is, and whether it shall stop: looked at and set from any thread.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// Shared between the threads that render and those that watch them.
#[derive(Debug, Default)]
pub struct Progress {
    cancelled: AtomicBool,
    done: AtomicU64,
    total: AtomicU64,
    rays: AtomicU64,
    threads: AtomicU64,
}

impl Progress {
    /// Nothing done, nothing to do.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Asks the render to stop; it does within a few milliseconds.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// Whether somebody asked to stop.
    #[must_use]
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// Pixel samples finished.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.done.load(Ordering::Relaxed)
    }

    /// Pixel samples in all; 0 before the render began.
    #[must_use]
    pub fn total(&self) -> u64 {
        self.total.load(Ordering::Relaxed)
    }

    /// Rays traced: camera, shadow and mirror rays.
    #[must_use]
    pub fn rays(&self) -> u64 {
        self.rays.load(Ordering::Relaxed)
    }

    /// Threads that took part in a render that is over; 0 before.
    #[must_use]
    pub fn threads(&self) -> u64 {
        self.threads.load(Ordering::Relaxed)
    }

    pub(crate) fn begin(&self, total: u64) {
        self.done.store(0, Ordering::Relaxed);
        self.rays.store(0, Ordering::Relaxed);
        self.threads.store(0, Ordering::Relaxed);
        self.total.store(total, Ordering::Relaxed);
    }

    pub(crate) fn end(&self, threads: usize) {
        self.threads.store(threads as u64, Ordering::Relaxed);
    }

    pub(crate) fn add(&self, samples: u64, rays: u64) {
        self.done.fetch_add(samples, Ordering::Relaxed);
        self.rays.fetch_add(rays, Ordering::Relaxed);
    }
}
