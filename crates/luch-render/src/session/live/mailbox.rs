//! Between the session's owner and its thread: a mailbox one way, a slot the other, each for the newest alone.

use super::snapshot::Snapshot;
use crate::session::job::RenderJob;
use crate::session::progress::Progress;
use crate::session::queue::lock;
use luch_scene::Scene;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// A picture to be shown.
#[derive(Debug, Clone)]
pub struct LiveRequest {
    /// What is to be seen. A request with the same `Arc` as the one before is not compiled again.
    pub scene: Arc<Scene>,
    /// How. The whole picture is made, whatever `crop` says.
    pub job: RenderJob,
}

/// The number of a request within its session, from 1; 0 before the first.
#[derive(Copy, Clone, PartialEq, Eq, PartialOrd, Ord, Debug, Default, Hash)]
pub struct Epoch(u64);

impl Epoch {
    /// The number.
    #[must_use]
    pub const fn get(self) -> u64 {
        self.0
    }
}

/// What the session is doing.
#[derive(Copy, Clone, PartialEq, Eq, Debug, Default)]
pub enum LivePhase {
    /// Nothing.
    #[default]
    Idle,
    /// It makes the scene ready for rays, or is about to.
    Compiling,
    /// It traces rays.
    Rendering,
}

/// How a picture ended.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum LiveEnd {
    /// All rays are in.
    Finished,
    /// [`LiveSession::stop`](super::LiveSession::stop) was called before.
    Cancelled,
    /// There is no picture, and why. The session goes on with the next request.
    Failed(String),
}

/// How far the picture asked for last is.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct LiveStatus {
    /// The request that was made last.
    pub epoch: Epoch,
    /// What the session is doing. [`LivePhase::Idle`] only when no thread is at work.
    pub phase: LivePhase,
    /// Pixel samples made; previews do not count.
    pub done: u64,
    /// Pixel samples of the whole progressive picture.
    pub total: u64,
    /// Time since the request, or, if the picture ended, until it did.
    pub elapsed: Duration,
    /// Rays traced, those of previews included.
    pub rays: u64,
    /// How the picture ended; `None` while it is awaited or made.
    pub ended: Option<LiveEnd>,
}

/// A request on its way, with what goes along.
#[derive(Debug)]
pub(super) struct Asked {
    pub(super) epoch: Epoch,
    pub(super) request: LiveRequest,
    pub(super) at: Instant,
    pub(super) progress: Arc<Progress>,
}

/// What the session's thread finds when it looks.
#[derive(Debug)]
pub(super) enum Mail {
    Show(Asked),
    Close,
}

#[derive(Debug)]
struct State {
    asked: Epoch,
    pending: Option<Asked>,
    closing: bool,
    /// Requests up to this one were stopped: nothing of them is shown any more.
    stopped: Epoch,
    phase: LivePhase,
    at: Instant,
    took: Duration,
    total: u64,
    progress: Arc<Progress>,
    ended: Option<LiveEnd>,
}

/// What the session and its owner share. Each lock is held for a few moves; where both are, the state's comes first.
#[derive(Debug)]
pub(super) struct Mailbox {
    state: Mutex<State>,
    bell: Condvar,
    /// A newer request is waiting.
    newer: AtomicBool,
    /// What is being made is not wanted any more.
    halt: AtomicBool,
    slot: Mutex<Option<Arc<Snapshot>>>,
}

impl Mailbox {
    pub(super) fn new() -> Self {
        let state = State {
            asked: Epoch::default(),
            pending: None,
            closing: false,
            stopped: Epoch::default(),
            phase: LivePhase::Idle,
            at: Instant::now(),
            took: Duration::ZERO,
            total: 0,
            progress: Arc::default(),
            ended: None,
        };
        Self {
            state: Mutex::new(state),
            bell: Condvar::new(),
            newer: AtomicBool::new(false),
            halt: AtomicBool::new(false),
            slot: Mutex::new(None),
        }
    }

    // The owner's side.

    pub(super) fn show(&self, mut request: LiveRequest) -> Epoch {
        request.job.crop = None;
        let total = request.job.size.pixels() * u64::from(request.job.rays_per_pixel());
        let (at, progress) = (Instant::now(), Arc::<Progress>::default());
        let mut state = lock(&self.state);
        let epoch = Epoch(state.asked.0 + 1);
        state.asked = epoch;
        (state.at, state.total, state.progress) = (at, total, Arc::clone(&progress));
        state.ended = None;
        if state.phase == LivePhase::Idle {
            state.phase = LivePhase::Compiling;
        }
        let old = state.pending.replace(Asked { epoch, request, at, progress });
        self.newer.store(true, Ordering::Relaxed);
        drop(state);
        self.bell.notify_one();
        // A scene may be large: it is let go without the lock.
        drop(old);
        epoch
    }

    pub(super) fn stop(&self) {
        let mut state = lock(&self.state);
        state.stopped = state.asked;
        let old = state.pending.take();
        let running = state.ended.is_none() && state.asked > Epoch::default();
        if running {
            self.halt.store(true, Ordering::Relaxed);
        }
        drop(state);
        self.bell.notify_one();
        drop(old);
    }

    pub(super) fn close(&self) {
        let mut state = lock(&self.state);
        state.closing = true;
        self.halt.store(true, Ordering::Relaxed);
        drop(state);
        self.bell.notify_one();
    }

    pub(super) fn latest(&self) -> Option<Arc<Snapshot>> {
        lock(&self.slot).clone()
    }

    pub(super) fn status(&self) -> LiveStatus {
        let state = lock(&self.state);
        LiveStatus {
            epoch: state.asked,
            phase: state.phase,
            done: state.progress.done(),
            total: state.total,
            elapsed: if state.ended.is_some() { state.took } else { state.at.elapsed() },
            rays: state.progress.rays(),
            ended: state.ended.clone(),
        }
    }

    // The session's side.

    /// Waits for a request, or for the end. `told` is called, without a lock, where the wait itself ends a picture.
    pub(super) fn wait(&self, told: &dyn Fn()) -> Mail {
        let mut state = lock(&self.state);
        loop {
            if state.closing {
                return Mail::Close;
            }
            if let Some(asked) = state.pending.take() {
                state.phase = LivePhase::Compiling;
                self.newer.store(false, Ordering::Relaxed);
                self.halt.store(false, Ordering::Relaxed);
                return Mail::Show(asked);
            }
            if self.halt.swap(false, Ordering::Relaxed) && state.ended.is_none() {
                // Stopped before it was begun, or while it was made.
                state.end(LiveEnd::Cancelled);
                drop(state);
                told();
                state = lock(&self.state);
                continue;
            }
            state.phase = LivePhase::Idle;
            state = self.bell.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }

    /// Whether a newer request or none at all is wanted instead of what is being made. `patient`: newer requests wait.
    pub(super) fn is_unwanted(&self, patient: &dyn Fn() -> bool) -> bool {
        self.halt.load(Ordering::Relaxed) || (self.newer.load(Ordering::Relaxed) && !patient())
    }

    pub(super) fn rendering(&self) {
        lock(&self.state).phase = LivePhase::Rendering;
    }

    /// Puts a snapshot into the slot, unless it was stopped. Answers whether it did.
    pub(super) fn publish(&self, snapshot: Snapshot) -> bool {
        let mut state = lock(&self.state);
        if snapshot.epoch <= state.stopped {
            drop(state);
            return false;
        }
        let finished = snapshot.finished && snapshot.epoch == state.asked;
        let old = lock(&self.slot).replace(Arc::new(snapshot));
        if finished {
            state.end(LiveEnd::Finished);
        }
        drop(state);
        // A picture is large: it is let go without the locks.
        drop(old);
        true
    }

    /// Says that there is no picture of this epoch.
    pub(super) fn fail(&self, epoch: Epoch, message: String) {
        let mut state = lock(&self.state);
        if state.asked == epoch && state.ended.is_none() {
            let end = if epoch <= state.stopped { LiveEnd::Cancelled } else { LiveEnd::Failed(message) };
            state.end(end);
        }
    }
}

impl State {
    fn end(&mut self, end: LiveEnd) {
        self.ended = Some(end);
        self.took = self.at.elapsed();
        self.phase = LivePhase::Idle;
    }
}
