//! The files of the window: what is read, written and looked up while one goes on working.
//!
//! Each piece of work has a thread of its own ([`task`]); the studio polls for what came of it. What a file holds is
//! the business of luch-io.

mod export;
mod library;
mod question;
mod recovery;
mod task;
mod typed;

pub(crate) use export::{Export, ExportEnd, ExportForm, PictureKind};
pub(crate) use library::Library;
pub(crate) use question::Purpose;
pub use question::{ChooseFile, FileQuestion};
pub(crate) use recovery::{Recovered, Recovery};
pub(crate) use typed::{TypedPath, shown};

use crate::command::Command;
use crate::document::Stamp;
use egui::Context;
use luch_io::budget::Budget;
use luch_io::folder::{self, Entry};
use luch_io::{Error, Model, Report, Saved, load_model, save_scene};
use luch_scene::Scene;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};
use task::Task;

/// The work with files that is under way.
#[derive(Debug)]
pub(crate) struct Files {
    library: Library,
    choose: ChooseFile,
    /// The folder of the user's own files, which `~` means.
    pub(crate) home: Option<PathBuf>,
    saving: Option<Saving>,
    listing: Option<Listing>,
    choosing: Option<Choosing>,
    adding: Option<Adding>,
    /// The picture on its way to a file.
    pub(crate) export: Option<Export>,
    pub(crate) recovery: Recovery,
}

/// A scene being written.
#[derive(Debug)]
struct Saving {
    task: Task<SaveEnd>,
    order: SaveOrder,
}

/// A scene to be written.
#[derive(Debug, Clone)]
pub(crate) struct SaveOrder {
    pub(crate) scene: Arc<Scene>,
    /// Which state of which document it is.
    pub(crate) stamp: Stamp,
    pub(crate) path: PathBuf,
    /// Whether a file that is there may be replaced.
    pub(crate) replace: bool,
    /// What to do when it is written.
    pub(crate) then: Option<Box<Command>>,
}

/// What came of writing a scene.
#[derive(Debug)]
pub(crate) enum SaveEnd {
    Written(Saved),
    /// There is a file already, and nobody said that it may be replaced.
    Exists,
    /// The disk or a model is at fault.
    Failed(Error),
    /// The writer panicked: a bug, told with what it said.
    Internal(String),
}

/// What lies in a folder.
#[derive(Debug)]
struct Listing {
    folder: PathBuf,
    purpose: Purpose,
    task: Task<Result<Vec<Entry>, Error>>,
    found: Option<Result<Vec<Entry>, String>>,
}

/// The system's dialog, open.
#[derive(Debug)]
struct Choosing {
    task: Task<Option<PathBuf>>,
    since: Instant,
    chosen: Option<Chosen>,
}

/// What the system's dialog answered.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Chosen {
    Path(PathBuf),
    /// Somebody closed it.
    Nothing,
    /// There is no such dialog.
    NoDialog,
}

/// Models being read to be put into the scene.
#[derive(Debug)]
struct Adding {
    task: Task<Added>,
    /// Whether a dialog asked for them, and waits.
    for_dialog: bool,
    stop: Arc<AtomicBool>,
}

/// The models that were read, those that were not, and what the reader says of them.
#[derive(Debug, Default)]
pub(crate) struct Added {
    pub(crate) models: Vec<Model>,
    pub(crate) errors: Vec<Error>,
    pub(crate) warnings: Vec<String>,
}

impl Files {
    /// A dialog that answers sooner than anybody can was none.
    const AT_ONCE: Duration = Duration::from_millis(400);

    pub(crate) fn new(library: Library, choose: Option<ChooseFile>, recovery: Recovery) -> Self {
        let choose = choose.unwrap_or(question::ask_system);
        let home = std::env::home_dir().filter(|home| !home.as_os_str().is_empty());
        let (saving, listing, choosing, adding, export) = (None, None, None, None, None);
        Self { library, choose, home, saving, listing, choosing, adding, export, recovery }
    }

    /// Whether nothing is under way that ends by itself.
    pub(crate) fn is_idle(&self) -> bool {
        let listed = self.listing.as_ref().is_none_or(|listing| listing.found.is_some());
        let chosen = self.choosing.as_ref().is_none_or(|choosing| choosing.chosen.is_some());
        self.saving.is_none() && self.adding.is_none() && listed && chosen && self.recovery.is_idle()
    }

    /// Starts to write a scene. One at a time: a second order waits for the first.
    pub(crate) fn save(&mut self, mut order: SaveOrder, ctx: &Context) -> io::Result<()> {
        let before = self.saving.take().map(|Saving { task, order: old }| {
            order.then = order.then.take().or(old.then);
            task
        });
        let library = self.library.clone();
        let SaveOrder { scene, path, replace, .. } = order.clone();
        let task = Task::start("luch-save", ctx, move || {
            if let Some(before) = before {
                before.wait();
            }
            if !replace && path.exists() {
                return SaveEnd::Exists;
            }
            let saved = save_scene(&scene, &path, &mut library.lock(), &mut Budget::default());
            saved.map_or_else(SaveEnd::Failed, SaveEnd::Written)
        })?;
        self.saving = Some(Saving { task, order });
        Ok(())
    }

    /// What came of writing a scene, once.
    pub(crate) fn saved(&mut self) -> Option<(SaveOrder, SaveEnd)> {
        let answer = self.saving.as_ref()?.task.poll()?;
        let Saving { order, .. } = self.saving.take()?;
        Some((order, answer.unwrap_or_else(SaveEnd::Internal)))
    }

    /// Does something when the scene that is being written is; `None`: nothing. Answers whether one is being written.
    pub(crate) fn after_saving(&mut self, then: Option<Command>) -> bool {
        let Some(saving) = &mut self.saving else { return false };
        saving.order.then = then.map(Box::new);
        true
    }

    /// Whether something is under way that a person waits for.
    pub(crate) const fn is_busy(&self) -> bool {
        self.saving.is_some() || self.adding.is_some() || self.export.is_some() || self.recovery.is_recovering()
    }

    /// Whether a scene is being written.
    pub(crate) const fn is_saving(&self) -> bool {
        self.saving.is_some()
    }

    /// Starts to look what lies in a folder.
    pub(crate) fn list(&mut self, folder: PathBuf, purpose: Purpose, ctx: &Context) -> io::Result<()> {
        let looked_at = folder.clone();
        let task = Task::start("luch-folder", ctx, move || folder::entries(&looked_at, purpose.endings()))?;
        self.listing = Some(Listing { folder, purpose, task, found: None });
        Ok(())
    }

    /// What lies in a folder, or why that is not known. `None` as long as nobody has looked: [`Files::is_listing`].
    pub(crate) fn listed(&self, folder: &Path, purpose: Purpose) -> Option<Result<&[Entry], &str>> {
        let listing = self.listing.as_ref().filter(|listing| listing.folder == folder && listing.purpose == purpose)?;
        let found = listing.found.as_ref()?;
        Some(found.as_ref().map(Vec::as_slice).map_err(String::as_str))
    }

    /// Whether somebody is looking into that folder, or has.
    pub(crate) fn is_listing(&self, folder: &Path, purpose: Purpose) -> bool {
        self.listing.as_ref().is_some_and(|listing| listing.folder == folder && listing.purpose == purpose)
    }

    /// Opens the system's dialog.
    pub(crate) fn choose(&mut self, question: FileQuestion, ctx: &Context) -> io::Result<()> {
        let choose = self.choose;
        let task = Task::start("luch-file-dialog", ctx, move || choose(&question))?;
        self.choosing = Some(Choosing { task, since: Instant::now(), chosen: None });
        Ok(())
    }

    /// Whether the system's dialog is open.
    pub(crate) fn is_choosing(&self) -> bool {
        self.choosing.as_ref().is_some_and(|choosing| choosing.chosen.is_none())
    }

    /// What the system's dialog answered.
    pub(crate) fn chosen(&self) -> Option<&Chosen> {
        self.choosing.as_ref()?.chosen.as_ref()
    }

    /// Forgets folders and answers: another dialog is open, or none.
    pub(crate) fn forget(&mut self) {
        self.listing = None;
        self.choosing = None;
    }

    /// Forgets the answer of the system's dialog: it was taken.
    pub(crate) fn forget_chosen(&mut self) {
        self.choosing = None;
    }

    /// Starts to read models, for a dialog that waits or without one.
    pub(crate) fn add(&mut self, paths: Vec<PathBuf>, for_dialog: bool, ctx: &Context) -> io::Result<()> {
        self.stop_adding();
        let (library, stop) = (self.library.clone(), Arc::new(AtomicBool::new(false)));
        let stopped = Arc::clone(&stop);
        let task = Task::start("luch-models", ctx, move || {
            let (mut added, mut report) = (Added::default(), Report::default());
            let mut budget = Budget::default().cancelled_by(stopped);
            library.read(|library| {
                for path in paths {
                    match load_model(&path, library, &mut budget, &mut report) {
                        Ok(model) => added.models.push(model),
                        Err(error) => added.errors.push(error),
                    }
                }
            });
            added.warnings = report.lines();
            added
        })?;
        self.adding = Some(Adding { task, for_dialog, stop });
        Ok(())
    }

    /// The models that were read, once.
    pub(crate) fn added(&mut self) -> Option<Result<Added, String>> {
        let answer = self.adding.as_ref()?.task.poll()?;
        self.adding = None;
        Some(answer)
    }

    /// Whether models are being read.
    pub(crate) const fn is_adding(&self) -> bool {
        self.adding.is_some()
    }

    /// Stops reading what a dialog asked for.
    pub(crate) fn stop_adding_for_dialog(&mut self) {
        if self.adding.as_ref().is_some_and(|adding| adding.for_dialog) {
            self.stop_adding();
        }
    }

    pub(crate) fn stop_adding(&mut self) {
        if let Some(adding) = self.adding.take() {
            adding.stop.store(true, Ordering::Relaxed);
        }
    }

    /// Takes in what is for the dialogs.
    pub(crate) fn poll(&mut self) {
        if let Some(listing) = &mut self.listing
            && let Some(answer) = listing.task.poll()
        {
            listing.found = Some(answer.and_then(|found| found.map_err(|error| error.text)));
        }
        if let Some(choosing) = &mut self.choosing
            && let Some(answer) = choosing.task.poll()
        {
            let at_once = choosing.since.elapsed() < Self::AT_ONCE;
            choosing.chosen = Some(match answer {
                Ok(Some(path)) => Chosen::Path(path),
                Ok(None) if !at_once => Chosen::Nothing,
                Ok(None) | Err(_) => Chosen::NoDialog,
            });
        }
    }
}

impl Drop for Files {
    fn drop(&mut self) {
        self.stop_adding();
        if let Some(export) = self.export.take() {
            export.end();
        }
        // A scene that is being written is waited for: the process would end in the middle of it.
        if let Some(saving) = self.saving.take() {
            saving.task.wait();
        }
    }
}
