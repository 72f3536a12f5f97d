//! Explains pixels on a thread, so that the window never waits for the rays of one.

use super::explained::Explained;
use super::plan::Plan;
use luch_render::explain::{ExplainError, explain_unless};
use luch_render::session::live::{Epoch, Snapshot};
use luch_render::{CompiledScene, RenderJob};
use luch_scene::Scene;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, sync_channel};
use std::thread;

/// A pixel of a picture to be explained.
#[derive(Debug, Clone)]
pub(crate) struct Question {
    pub(crate) pixel: [u32; 2],
    pub(crate) epoch: Epoch,
    scene: Arc<Scene>,
    compiled: Arc<CompiledScene>,
    job: RenderJob,
    /// A scene that was seen from above before.
    plan: Option<(Arc<Scene>, Arc<Plan>)>,
}

impl Question {
    /// Asks about a picture that is shown. Its pixels need not be kept for the answer; `before` is the account at hand.
    pub(crate) fn about(snapshot: &Snapshot, pixel: [u32; 2], before: Option<&Explained>) -> Self {
        Self {
            pixel,
            epoch: snapshot.epoch,
            scene: Arc::clone(&snapshot.scene),
            compiled: Arc::clone(&snapshot.compiled),
            job: snapshot.job.clone(),
            plan: before.map(|before| (Arc::clone(&before.scene), Arc::clone(&before.plan))),
        }
    }

    fn answer(self, stop: &AtomicBool) -> Result<Explained, Unexplained> {
        let stopped = || stop.load(Ordering::Relaxed);
        let explain = AssertUnwindSafe(|| {
            let account = explain_unless(&self.compiled, &self.job, self.pixel, &stopped)?;
            let known = self.plan.filter(|(scene, _)| Arc::ptr_eq(scene, &self.scene));
            let plan = known.map_or_else(|| Arc::new(Plan::of(&self.scene)), |(_, plan)| plan);
            Ok(Explained::new(account, self.scene, self.compiled, self.job.camera, self.epoch, plan))
        });
        match catch_unwind(explain) {
            Ok(answer) => answer.map_err(Unexplained::Refused),
            Err(panic) => Err(Unexplained::Internal(crate::panics::message(panic.as_ref()))),
        }
    }
}

/// Why there is no account.
#[derive(Debug, Clone)]
pub(crate) enum Unexplained {
    /// There is no such pixel, or it has too many rays.
    Refused(ExplainError),
    /// The renderer panicked: a bug, told with what it said.
    Internal(String),
}

/// What came of a question.
#[derive(Debug)]
pub(crate) struct Answer {
    pub(crate) pixel: [u32; 2],
    pub(crate) epoch: Epoch,
    pub(crate) account: Result<Explained, Unexplained>,
}

/// The questions under way: the newest alone is answered, and one thread at a time works.
#[derive(Debug, Default)]
pub(crate) struct Explainer {
    running: Option<Running>,
    /// What is asked once the thread at work has stopped.
    waiting: Option<Question>,
}

#[derive(Debug)]
struct Running {
    stop: Arc<AtomicBool>,
    answer: Receiver<Answer>,
}

impl Explainer {
    /// Asks; `wake` is called when [`Explainer::poll`] has something to answer.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn ask(&mut self, question: Question, wake: impl FnOnce() + Send + 'static) -> std::io::Result<()> {
        if let Some(running) = &self.running {
            running.stop.store(true, Ordering::Relaxed);
            self.waiting = Some(question);
            return Ok(());
        }
        let (send, answer) = sync_channel(1);
        let stop = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&stop);
        thread::Builder::new().name("luch-explain".into()).spawn(move || {
            let (pixel, epoch) = (question.pixel, question.epoch);
            let account = question.answer(&flag);
            // A studio that is gone has no use for it.
            let _ = send.send(Answer { pixel, epoch, account });
            wake();
        })?;
        self.running = Some(Running { stop, answer });
        Ok(())
    }

    /// Gives up what is under way.
    pub(crate) fn stop(&mut self) {
        self.waiting = None;
        if let Some(running) = &self.running {
            running.stop.store(true, Ordering::Relaxed);
        }
    }

    /// Whether something is under way.
    pub(crate) const fn is_busy(&self) -> bool {
        self.running.is_some()
    }

    /// What came of the newest question, once. Older ones start the next in their place; `wake` is as for asking.
    ///
    /// # Errors
    /// If the system gives no thread for the next question.
    pub(crate) fn poll(&mut self, wake: impl FnOnce() + Send + 'static) -> std::io::Result<Option<Answer>> {
        let Some(running) = &self.running else { return Ok(None) };
        let Ok(answer) = running.answer.try_recv() else { return Ok(None) };
        let stopped = running.stop.load(Ordering::Relaxed);
        self.running = None;
        if let Some(next) = self.waiting.take() {
            self.ask(next, wake)?;
            return Ok(None);
        }
        Ok((!stopped).then_some(answer))
    }
}

impl Drop for Explainer {
    fn drop(&mut self) {
        self.stop();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_render::session::live::{LiveRequest, LiveSession};
    use std::sync::mpsc::{SyncSender, sync_channel};

    /// A finished picture of the first scene, small.
    fn picture() -> Arc<Snapshot> {
        let mut no_models = |path: &str, _: &mut luch_io::Report| {
            Err(luch_io::Error::new(luch_io::ErrorKind::Forbidden, path, "no models"))
        };
        let scene = luch_io::builtin::load("two-spheres", &mut no_models, &mut luch_io::Report::default()).unwrap();
        let scene = Arc::new(scene);
        let job = RenderJob { size: luch_scene::ImageSize::new(32, 24).unwrap(), ..RenderJob::of_scene(&scene, 0) };
        let (done, wait) = sync_channel(64);
        let session = LiveSession::start(move || _ = done.try_send(())).unwrap();
        session.show(LiveRequest { scene, job });
        loop {
            wait.recv().unwrap();
            if let Some(snapshot) = session.latest().filter(|snapshot| snapshot.finished) {
                return snapshot;
            }
        }
    }

    /// The answer to the newest question, with how often a thread had something to say.
    fn answer(explainer: &mut Explainer, done: &SyncSender<()>, wait: &Receiver<()>) -> Answer {
        loop {
            wait.recv().unwrap();
            let done = done.clone();
            if let Some(answer) = explainer.poll(move || _ = done.send(())).unwrap() {
                return answer;
            }
        }
    }

    #[test]
    fn the_newest_question_is_the_one_that_is_answered() {
        let picture = picture();
        let mut explainer = Explainer::default();
        let (done, wait) = sync_channel(8);
        for x in 0..5 {
            let done = done.clone();
            let question = Question::about(&picture, [x, 7], None);
            explainer.ask(question, move || _ = done.send(())).unwrap();
        }
        let newest = answer(&mut explainer, &done, &wait);
        assert_eq!(newest.pixel, [4, 7]);
        let explained = newest.account.unwrap();
        assert_eq!(explained.account.pixel, explained.account.sum());
        assert!(!explainer.is_busy());
    }

    #[test]
    fn a_pixel_outside_the_picture_has_no_account() {
        let mut explainer = Explainer::default();
        let (done, wait) = sync_channel(8);
        let said = done.clone();
        explainer.ask(Question::about(&picture(), [32, 0], None), move || _ = said.send(())).unwrap();
        let refused = answer(&mut explainer, &done, &wait).account.unwrap_err();
        assert!(matches!(refused, Unexplained::Refused(ExplainError::OutsidePicture { .. })), "{refused:?}");
    }
}
