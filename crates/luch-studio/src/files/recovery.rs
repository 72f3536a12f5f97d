//! The scene kept safe while it is worked on, and those that earlier programs left when they died.

use super::Library;
use super::task::Task;
use crate::document::{Document, Stamp};
use egui::Context;
use luch_io::budget::Budget;
use luch_io::recovery::{Recoverable, RecoveryFolder, recoverable};
use luch_io::{Error, Report, SceneSource};
use luch_scene::Scene;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How long a change is at risk.
const EVERY: Duration = Duration::from_secs(20);
/// How soon it is tried again after it failed, at the earliest.
const RETRY: Duration = Duration::from_secs(1);

/// What keeps scenes safe. Without a data folder it does nothing.
#[derive(Debug)]
pub(crate) struct Recovery {
    data: Option<PathBuf>,
    every: Duration,
    library: Library,
    folder: Option<Arc<RecoveryFolder>>,
    keeping: Option<Task<Result<Arc<RecoveryFolder>, Error>>>,
    /// The state that is safe.
    kept: Option<Stamp>,
    /// Whether the last time failed.
    failing: bool,
    /// When the next one is due.
    due: Option<Instant>,
    searching: Option<Task<Vec<Recoverable>>>,
    found: Vec<Arc<Recoverable>>,
    recovering: Option<Recovering>,
    /// What was recovered, until the scene is safe in this program's own folder.
    adopted: Option<Arc<Recoverable>>,
}

/// A scene being read back.
#[derive(Debug)]
struct Recovering {
    task: Task<Recovered>,
    stop: Arc<AtomicBool>,
}

/// A scene that was read back.
#[derive(Debug)]
pub(crate) struct Recovered {
    pub(crate) from: Arc<Recoverable>,
    pub(crate) scene: Result<Scene, Error>,
    pub(crate) warnings: Vec<String>,
}

impl Recovery {
    pub(crate) fn new(data: Option<PathBuf>, every: Option<Duration>, library: Library, ctx: &Context) -> Self {
        let searched = data.clone();
        let searching = searched.and_then(|data| Task::start("luch-recovery", ctx, move || recoverable(&data)).ok());
        Self {
            data,
            every: every.unwrap_or(EVERY),
            library,
            folder: None,
            keeping: None,
            kept: None,
            failing: false,
            due: None,
            searching,
            found: Vec::new(),
            recovering: None,
            adopted: None,
        }
    }

    /// Whether nothing is under way.
    pub(crate) const fn is_idle(&self) -> bool {
        self.keeping.is_none() && self.searching.is_none() && self.recovering.is_none()
    }

    /// Keeps the document safe when that is due, and forgets it when it is saved.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn watch(&mut self, document: &Document, ctx: &Context) -> io::Result<()> {
        if self.keeping.is_some() || self.data.is_none() {
            return Ok(());
        }
        let stamp = document.stamp();
        if !document.is_changed() {
            self.due = None;
            let left = self.kept.take().is_some() || std::mem::take(&mut self.failing);
            return if left { self.clear(ctx) } else { Ok(()) };
        }
        if self.kept == Some(stamp) {
            return Ok(());
        }
        let now = Instant::now();
        let due = *self.due.get_or_insert(now + self.every);
        if due > now {
            ctx.request_repaint_after(due - now);
            return Ok(());
        }
        self.due = None;
        self.kept = Some(stamp);
        self.keep(Arc::clone(document.scene()), document.source.clone(), ctx)
    }

    /// Makes the next keeping due at once.
    pub(crate) fn hurry(&mut self) {
        self.due = Some(Instant::now());
    }

    fn keep(&mut self, scene: Arc<Scene>, source: Option<SceneSource>, ctx: &Context) -> io::Result<()> {
        let Some(data) = self.data.clone() else { return Ok(()) };
        let (folder, library) = (self.folder.clone(), self.library.clone());
        let keep = move || {
            let folder = folder.map_or_else(|| RecoveryFolder::create(&data).map(Arc::new), Ok)?;
            folder.save(&scene, source.as_ref(), &library.lock())?;
            Ok(folder)
        };
        self.keeping = Some(Task::start("luch-keep", ctx, keep)?);
        Ok(())
    }

    fn clear(&mut self, ctx: &Context) -> io::Result<()> {
        let Some(folder) = self.folder.clone() else { return Ok(()) };
        let clear = move || {
            folder.clear();
            Ok(folder)
        };
        self.keeping = Some(Task::start("luch-keep", ctx, clear)?);
        Ok(())
    }

    /// Takes in what the threads have done; answers with what went wrong.
    pub(crate) fn poll(&mut self) -> Option<String> {
        if let Some(found) = self.searching.as_ref().and_then(Task::poll) {
            self.searching = None;
            self.found = found.unwrap_or_default().into_iter().map(Arc::new).collect();
        }
        let kept = self.keeping.as_ref().and_then(Task::poll)?;
        self.keeping = None;
        match kept {
            Ok(Ok(folder)) => {
                self.folder = Some(folder);
                self.failing = false;
                if let Some(adopted) = self.adopted.take().filter(|_| self.kept.is_some()) {
                    adopted.discard();
                }
                None
            }
            Ok(Err(error)) => self.failed(error.to_string()),
            Err(message) => self.failed(message),
        }
    }

    /// Nothing is safe: it is tried again, and told once until it succeeds.
    fn failed(&mut self, message: String) -> Option<String> {
        self.kept = None;
        self.due = Some(Instant::now() + self.every.max(RETRY));
        (!std::mem::replace(&mut self.failing, true)).then_some(message)
    }

    /// The scenes that can be recovered.
    pub(crate) fn found(&self) -> &[Arc<Recoverable>] {
        &self.found
    }

    /// Leaves what was found to the next start of the program, also what is being read.
    pub(crate) fn leave(&mut self) {
        self.found.clear();
        if let Some(recovering) = self.recovering.take() {
            recovering.stop.store(true, Ordering::Relaxed);
        }
    }

    /// Removes one that was found.
    pub(crate) fn discard(&mut self, index: usize) {
        if index < self.found.len() {
            self.found.remove(index).discard();
        }
    }

    /// Starts to read one that was found.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn recover(&mut self, index: usize, ctx: &Context) -> io::Result<()> {
        let Some(from) = self.found.get(index).cloned() else { return Ok(()) };
        let (library, stop) = (self.library.clone(), Arc::new(AtomicBool::new(false)));
        let mut budget = Budget::default().cancelled_by(Arc::clone(&stop));
        let read = move || {
            let mut report = Report::default();
            let scene = library.read(|library| from.load(library, &mut budget, &mut report));
            Recovered { from: Arc::clone(&from), scene, warnings: report.lines() }
        };
        self.recovering = Some(Recovering { task: Task::start("luch-recovery", ctx, read)?, stop });
        Ok(())
    }

    /// Whether one is being read.
    pub(crate) const fn is_recovering(&self) -> bool {
        self.recovering.is_some()
    }

    /// What was read, once.
    pub(crate) fn recovered(&mut self) -> Option<Result<Recovered, String>> {
        let answer = self.recovering.as_ref()?.task.poll()?;
        self.recovering = None;
        Some(answer)
    }

    /// Takes over what was recovered: it is removed as soon as this program has it safe.
    pub(crate) fn adopt(&mut self, from: Arc<Recoverable>) {
        self.found.clear();
        self.adopted = Some(from);
        self.hurry();
    }

    /// Ends as a program should: nothing is left but what nobody has decided about.
    pub(crate) fn end(&mut self) {
        if let Some(keeping) = self.keeping.take() {
            self.folder = keeping.finish().ok().and_then(Result::ok).or_else(|| self.folder.take());
        }
        if let Some(folder) = self.folder.take() {
            folder.remove();
        }
        self.data = None;
    }

    /// Keeps the document safe in the last moment, on this thread.
    pub(crate) fn rescue(&mut self, document: &Document) {
        let Some(data) = self.data.take() else { return };
        if !document.is_changed() {
            return self.end();
        }
        // A thread that holds the library may take long: then the scene of the last time has to do.
        let Some(library) = self.library.try_lock() else { return };
        let folder = self.folder.take().map_or_else(|| RecoveryFolder::create(&data).map(Arc::new), Ok);
        // There is nobody left to tell.
        let _ = folder.and_then(|folder| folder.save(document.scene(), document.source.as_ref(), &library));
    }
}
