//! Measuring and writing, each on a thread of its own.

use super::{Outcome, form};
use luch_study::run::Record;
use luch_study::{Findings, Plan, StudyProgress, files, run};
use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Instant;

/// A study that is measured.
#[derive(Debug)]
pub(super) struct Running {
    pub(super) progress: Arc<StudyProgress>,
    pub(super) began: Instant,
    /// `None` until the scenes are read.
    record: Arc<Mutex<Option<Record>>>,
    /// Measurements that the findings shown were made of.
    seen: usize,
    end: Receiver<Result<(), String>>,
}

impl Running {
    pub(super) fn start(plan: Plan, wake: impl Fn() + Send + 'static) -> io::Result<Self> {
        let progress = Arc::new(StudyProgress::new());
        let record = Arc::new(Mutex::new(None));
        let (send, end) = sync_channel(1);
        let (watched, kept) = (Arc::clone(&progress), Arc::clone(&record));
        thread::Builder::new().name("luch-study".into()).spawn(move || {
            let measure = AssertUnwindSafe(|| {
                let study = form::resolve(plan)?;
                *lock(&kept) = Some(Record::begin(&study));
                let whole = run(&study, &watched, &mut |measurement| {
                    if let Some(record) = &mut *lock(&kept) {
                        record.measurements.push(*measurement);
                    }
                    wake();
                });
                let whole = whole.map_err(|error| error.to_string())?;
                if let Some(record) = &mut *lock(&kept) {
                    record.partial = whole.partial;
                }
                Ok(())
            });
            let outcome = catch_unwind(measure).unwrap_or_else(|panic| Err(crate::panics::message(panic.as_ref())));
            // The window may be gone.
            let _ = send.send(outcome);
            wake();
        })?;
        Ok(Self { progress, began: Instant::now(), record, seen: 0, end })
    }

    pub(super) fn cancel(&self) {
        self.progress.cancel();
    }

    /// All that follows from the measurements, if there are new ones.
    pub(super) fn news(&mut self) -> Option<Findings> {
        let record = lock(&self.record);
        let record = record.as_ref()?;
        if record.measurements.len() == self.seen {
            return None;
        }
        self.seen = record.measurements.len();
        Some(Findings::of(record))
    }

    /// How it ended, once. What was measured before is known by then.
    pub(super) fn end(&mut self) -> Option<Result<(), String>> {
        self.end.try_recv().ok()
    }

    /// The findings after the end, which alone know whether all was measured.
    pub(super) fn last(&self) -> Option<Findings> {
        lock(&self.record).as_ref().map(Findings::of)
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        self.cancel();
    }
}

fn lock(record: &Mutex<Option<Record>>) -> std::sync::MutexGuard<'_, Option<Record>> {
    record.lock().unwrap_or_else(PoisonError::into_inner)
}

/// A study that is written.
#[derive(Debug)]
pub(super) struct Saving {
    answer: Receiver<Outcome>,
}

impl Saving {
    pub(super) fn start(
        findings: Arc<Findings>,
        folder: PathBuf,
        language: luch_study::Language,
        wake: impl FnOnce() + Send + 'static,
    ) -> io::Result<Self> {
        let (send, answer) = sync_channel(1);
        thread::Builder::new().name("luch-study-files".into()).spawn(move || {
            let outcome = match write(&findings, &folder, language) {
                Ok(()) => Outcome::Saved(folder),
                Err(message) => Outcome::NotSaved(message),
            };
            let _ = send.send(outcome);
            wake();
        })?;
        Ok(Self { answer })
    }

    pub(super) fn poll(&self) -> Option<Outcome> {
        self.answer.try_recv().ok()
    }
}

fn write(findings: &Findings, folder: &Path, language: luch_study::Language) -> Result<(), String> {
    let drawn = files::files(findings, language)?;
    files::make_folder(folder).map_err(|error| error.to_string())?;
    files::write(folder, &drawn).map_err(|error| error.to_string())
}
