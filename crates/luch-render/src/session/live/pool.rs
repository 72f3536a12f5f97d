//! Threads that wait for work, so that a pass need not start any.

use crate::session::queue::lock;
use crate::session::worker::Worker;
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread::{self, JoinHandle};

/// What all threads do together. Answers whether the worker's memory is whole.
type Work = dyn Fn(&mut Worker) -> bool + Send + Sync;

/// Helpers of the session's thread, which is the first worker itself.
pub(super) struct Pool {
    shared: Arc<Shared>,
    helpers: Vec<JoinHandle<()>>,
    own: Worker,
}

struct Shared {
    state: Mutex<State>,
    /// There is work, or there are too many helpers.
    go: Condvar,
    /// No helper is at work.
    done: Condvar,
}

#[derive(Default)]
struct State {
    work: Option<Arc<Work>>,
    /// Tells one piece of work from the next.
    number: u64,
    /// How many more may join in.
    seats: usize,
    active: usize,
    /// Helpers from this number on are to end.
    helpers: usize,
}

impl Pool {
    pub(super) fn new() -> Self {
        let shared = Shared { state: Mutex::default(), go: Condvar::new(), done: Condvar::new() };
        Self { shared: Arc::new(shared), helpers: Vec::new(), own: Worker::default() }
    }

    /// Does the work on at most `threads` threads of the pool, this one included, and waits for all.
    pub(super) fn run(&mut self, threads: usize, work: Arc<Work>) {
        let seats = self.helpers.len().min(threads.saturating_sub(1));
        if seats > 0 {
            let mut state = lock(&self.shared.state);
            state.work = Some(Arc::clone(&work));
            state.number += 1;
            state.seats = seats;
            drop(state);
            (0..seats).for_each(|_| self.shared.go.notify_one());
        }
        if !work(&mut self.own) {
            self.own = Worker::default();
        }
        self.own.shrink();
        drop(work);
        // Helpers that have not woken up by now find nothing to do; the others are waited for.
        let mut state = lock(&self.shared.state);
        state.work = None;
        while state.active > 0 {
            state = self.shared.done.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Makes it a pool of `threads` threads, the session's own included, or of as many as the system gives.
    pub(super) fn resize(&mut self, threads: usize) {
        let helpers = threads.saturating_sub(1);
        if helpers < self.helpers.len() {
            lock(&self.shared.state).helpers = helpers;
            self.shared.go.notify_all();
            for helper in self.helpers.drain(helpers..) {
                // It caught its panics.
                drop(helper.join());
            }
        }
        while self.helpers.len() < helpers {
            let (shared, number) = (Arc::clone(&self.shared), self.helpers.len());
            lock(&self.shared.state).helpers = number + 1;
            let name = format!("luch-live-{}", number + 1);
            let Ok(helper) = thread::Builder::new().name(name).spawn(move || help(&shared, number)) else { break };
            self.helpers.push(helper);
        }
    }
}

impl Drop for Pool {
    fn drop(&mut self) {
        self.resize(0);
    }
}

/// What a helper does all its life.
fn help(shared: &Shared, number: usize) {
    let mut worker = Worker::default();
    let mut last = 0;
    while let Some(work) = shared.next(number, &mut last) {
        if !work(&mut worker) {
            worker = Worker::default();
        }
        worker.shrink();
        // What the work holds is let go before anybody hears that it is done.
        drop(work);
        let mut state = lock(&shared.state);
        state.active -= 1;
        if state.active == 0 {
            shared.done.notify_one();
        }
    }
}

impl Shared {
    /// Waits for work that the helper has not done yet; `None` if it is to end.
    fn next(&self, number: usize, last: &mut u64) -> Option<Arc<Work>> {
        let mut state = lock(&self.state);
        loop {
            if number >= state.helpers {
                return None;
            }
            if state.number != *last
                && state.seats > 0
                && let Some(work) = state.work.clone()
            {
                *last = state.number;
                state.seats -= 1;
                state.active += 1;
                return Some(work);
            }
            state = self.go.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}
