//! The interactive session: a picture that follows the scene while people change it.
//!
//! Requests go in by one mailbox, of which only the newest counts; snapshots come out by one slot, which holds the
//! newest. A thread of the session's own compiles the scene, decides on the next pass, renders it together with a pool
//! of workers, and publishes what has come of it: first a coarse preview if a whole picture would take longer than a
//! frame of the screen, then the full resolution, then more and more rays of each pixel. The finished picture has the
//! bits that [`render`](crate::render) gives.
//!
//! No caller waits for rendering, and nothing runs while there is nothing to do.

mod canvas;
mod conductor;
mod depths;
mod mailbox;
mod objects;
mod pace;
mod pass;
mod pick;
mod pool;
mod snapshot;
#[cfg(test)]
mod tests;

pub use depths::{DepthMap, depths};
pub use mailbox::{Epoch, LiveEnd, LivePhase, LiveRequest, LiveStatus};
pub use objects::ObjectMap;
pub use pick::{Pick, pick};
pub use snapshot::Snapshot;

use conductor::Conductor;
use mailbox::Mailbox;
use std::fmt;
use std::io;
use std::sync::Arc;
use std::thread::{self, JoinHandle};

/// Renders what it was last asked for, over and over, on threads of its own.
///
/// All methods may be called from any thread, from within `wake` too, and wait at most for a short lock. Dropping the
/// session stops its threads and waits for them: a few milliseconds, or the rest of building the tree of a new mesh.
pub struct LiveSession {
    mailbox: Arc<Mailbox>,
    thread: Option<JoinHandle<()>>,
}

impl LiveSession {
    /// The largest picture, in pixels: 8192 x 8192. It takes up to 3 GiB while it is made; a request for more ends as
    /// [`LiveEnd::Failed`] before any memory is taken. [`render`](crate::render) makes larger ones.
    pub const MAX_PIXELS: u64 = 1 << 26;

    /// Starts the session's thread, which waits for the first request.
    ///
    /// `wake` is called, on that thread, whenever there is something new to see: a snapshot, an error, an end. It should
    /// be short, as nothing is rendered meanwhile; if it panics, the session goes on.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(wake: impl Fn() + Send + Sync + 'static) -> io::Result<Self> {
        Self::start_with(Conductor::new(Box::new(wake)))
    }

    fn start_with(mut conductor: Conductor) -> io::Result<Self> {
        let mailbox = Arc::clone(&conductor.mailbox);
        let thread = thread::Builder::new().name("luch-session".to_owned()).spawn(move || conductor.run())?;
        Ok(Self { mailbox, thread: Some(thread) })
    }

    /// Asks for a picture. The newest request wins: what is being made is given up, though a picture that has shown
    /// nothing yet is first given the time of two frames of the screen to do so. Otherwise requests that come faster
    /// than pictures can be made would never show any.
    pub fn show(&self, request: LiveRequest) -> Epoch {
        self.mailbox.show(request)
    }

    /// Cancels the picture asked for last, if it is not finished. No snapshot of it comes after this call; the last one
    /// stays.
    pub fn stop(&self) {
        self.mailbox.stop();
    }

    /// The newest snapshot. Its epoch is never below that of a snapshot seen before.
    #[must_use]
    pub fn latest(&self) -> Option<Arc<Snapshot>> {
        self.mailbox.latest()
    }

    /// How far the picture asked for last is. Cheap.
    #[must_use]
    pub fn status(&self) -> LiveStatus {
        self.mailbox.status()
    }
}

impl Drop for LiveSession {
    fn drop(&mut self) {
        self.mailbox.close();
        if let Some(thread) = self.thread.take()
            // The last owner may be `wake` itself: a thread cannot wait for its own end.
            && thread.thread().id() != thread::current().id()
        {
            // A panic of the thread has been told as `Failed` or is none of the owner's concern.
            drop(thread.join());
        }
    }
}

impl fmt::Debug for LiveSession {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("LiveSession").field("status", &self.status()).finish_non_exhaustive()
    }
}
