//! Pieces of work that several threads take one after the other, and what went wrong with them.

use super::render::RenderError;
use super::scheduler::{RenderWork, Scheduler};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// The pieces of a picture, each taken by one thread.
#[derive(Debug)]
pub(super) struct Queue {
    scheduler: Scheduler,
    next: AtomicUsize,
    failed: AtomicBool,
    failure: Mutex<Option<RenderError>>,
}

impl Queue {
    pub(super) const fn new(scheduler: Scheduler) -> Self {
        Self { scheduler, next: AtomicUsize::new(0), failed: AtomicBool::new(false), failure: Mutex::new(None) }
    }

    /// Takes pieces until none is left, or `make` answers that it was stopped, or panics. Answers whether the thread's
    /// memory is whole: after a panic it is not.
    pub(super) fn work_off(&self, mut make: impl FnMut(usize, &RenderWork) -> Option<()>) -> bool {
        loop {
            let index = self.next.fetch_add(1, Ordering::Relaxed);
            let Some(work) = self.scheduler.work(index) else { return true };
            match catch_unwind(AssertUnwindSafe(|| make(index, &work))) {
                Ok(Some(())) => {}
                Ok(None) => return true,
                Err(panic) => {
                    // The other threads stop at their next query; the first failure is the one told.
                    let message = message_of(panic.as_ref());
                    lock(&self.failure).get_or_insert(RenderError::Internal { tile: work.tile, message });
                    self.failed.store(true, Ordering::Relaxed);
                    return false;
                }
            }
        }
    }

    /// Whether a thread panicked: the others need not go on.
    pub(super) fn has_failed(&self) -> bool {
        self.failed.load(Ordering::Relaxed)
    }

    /// The first failure.
    pub(super) fn take_failure(&self) -> Option<RenderError> {
        lock(&self.failure).take()
    }
}

/// The lock, whether or not a thread panicked while it held it: what these locks guard is replaced whole.
pub(super) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What a panic said.
pub(super) fn message_of(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<&str>().map(|s| (*s).to_owned());
    text.or_else(|| panic.downcast_ref::<String>().cloned()).unwrap_or_else(|| "no message".to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::Crop;

    #[test]
    fn a_panic_is_told_with_its_tile_and_stops_the_others() {
        let pixels = Crop { x: 0, y: 0, width: 64, height: 64 };
        let queue = Queue::new(Scheduler::new(pixels, 16, 1));
        let whole = queue.work_off(|index, _| {
            assert!(index < 3, "number {index}");
            Some(())
        });
        assert!(!whole && queue.has_failed());
        let Some(RenderError::Internal { tile, message }) = queue.take_failure() else { panic!("no failure") };
        assert_eq!((tile.width, message.as_str()), (16, "number 3"));
    }
}
