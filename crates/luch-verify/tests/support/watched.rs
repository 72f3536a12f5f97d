//! A live session with a bell, for tests: whoever waits is woken by the session, and gives up when it hangs.

use luch_render::{Epoch, LiveEnd, LiveRequest, LiveSession, Snapshot};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, sync_channel};
use std::time::{Duration, Instant};

/// Longer than any wait of a test, on the slowest machine.
pub(crate) const HUNG: Duration = Duration::from_secs(60);

/// A session that rings when there is something new.
pub(crate) struct Watched {
    pub(crate) session: LiveSession,
    bell: Receiver<()>,
}

impl Watched {
    pub(crate) fn start() -> Self {
        let (ring, bell) = sync_channel(1);
        let wake = move || {
            // A bell that is ringing already need not be rung.
            let _ = ring.try_send(());
        };
        Self { session: LiveSession::start(wake).expect("a thread"), bell }
    }

    /// Waits until `found` finds something.
    pub(crate) fn until<T>(&self, mut found: impl FnMut(&LiveSession) -> Option<T>) -> T {
        let start = Instant::now();
        loop {
            if let Some(found) = found(&self.session) {
                return found;
            }
            let left = HUNG.saturating_sub(start.elapsed());
            assert!(self.bell.recv_timeout(left).is_ok(), "the session hangs: {:?}", self.session.status());
        }
    }

    /// How the picture of the request ended.
    pub(crate) fn end_of(&self, epoch: Epoch) -> LiveEnd {
        self.until(|session| {
            let status = session.status();
            assert_eq!(status.epoch, epoch, "nobody asked for another");
            status.ended
        })
    }

    /// Asks for a picture and waits for the whole of it.
    pub(crate) fn finished(&self, request: &LiveRequest) -> Arc<Snapshot> {
        let epoch = self.session.show(request.clone());
        assert_eq!(self.end_of(epoch), LiveEnd::Finished);
        let snapshot = self.session.latest().expect("a finished picture is there");
        assert!(snapshot.epoch == epoch && snapshot.finished);
        snapshot
    }
}
