//! Work on a thread of its own, so that the window never waits for a disk or another program.

use crate::panics;
use egui::Context;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{Receiver, sync_channel};
use std::thread::{self, JoinHandle};

/// Work under way.
#[derive(Debug)]
pub(crate) struct Task<T> {
    answer: Receiver<Result<T, String>>,
    thread: JoinHandle<()>,
}

impl<T: Send + 'static> Task<T> {
    /// Starts `work`; the window draws again when it is done.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn start(name: &str, ctx: &Context, work: impl FnOnce() -> T + Send + 'static) -> std::io::Result<Self> {
        let (send, answer) = sync_channel(1);
        let ctx = ctx.clone();
        let thread = thread::Builder::new().name(name.to_owned()).spawn(move || {
            let result = catch_unwind(AssertUnwindSafe(work)).map_err(|panic| panics::message(panic.as_ref()));
            // Nobody may wait for it any more.
            let _ = send.send(result);
            ctx.request_repaint();
        })?;
        Ok(Self { answer, thread })
    }

    /// What came of the work, once: its result, or what a panic said. `None` while it is under way.
    pub(crate) fn poll(&self) -> Option<Result<T, String>> {
        self.answer.try_recv().ok()
    }

    /// Waits until the work is done.
    pub(crate) fn wait(self) {
        // A panic was caught and is told by the answer.
        let _ = self.thread.join();
    }

    /// Whether the thread has ended.
    pub(crate) fn is_done(&self) -> bool {
        self.thread.is_finished()
    }

    /// Waits until the work is done and answers as [`Task::poll`] would have.
    pub(crate) fn finish(self) -> Result<T, String> {
        let Self { answer, thread } = self;
        let _ = thread.join();
        answer.try_recv().unwrap_or_else(|_| Err("the answer was taken already".to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_an_answer() {
        let ctx = Context::default();
        for (work, expected) in [(true, Ok(7)), (false, Err("as planned".to_owned()))] {
            let task = Task::start("test", &ctx, move || if work { 7 } else { panic!("as planned") }).unwrap();
            let answer = task.answer.recv().unwrap();
            assert_eq!(answer, expected);
            assert!(task.poll().is_none(), "an answer is given once");
            task.wait();
        }
    }
}
