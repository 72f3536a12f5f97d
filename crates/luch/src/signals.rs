//! Ctrl-C and SIGTERM: stop within a second at any stage, at once the second time, and never leave a half file.

use crate::exit::{Code, Failure};
use crate::{output, progress};
use luch_render::Progress;
use luch_study::StudyProgress;
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::iterator::Signals;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// How long a stage may take to stop by itself before the program ends without it.
const PATIENCE: Duration = Duration::from_millis(500);
/// The same for a study, which writes what it has before it ends.
const PATIENCE_TO_WRITE: Duration = Duration::from_secs(10);

/// What a signal interrupts.
#[derive(Debug, Default)]
enum Stage {
    /// Nothing that would be left half done: loading, building, talking.
    #[default]
    Free,
    /// A render, which stops when told.
    Rendering(Arc<Progress>),
    /// A study, which stops when told and then writes what it has.
    Studying(Arc<StudyProgress>),
    /// These files are being written, each beside its place until it is whole.
    Writing(Vec<PathBuf>),
}

/// Stands between the signals and the work.
#[derive(Debug, Clone, Default)]
pub(crate) struct Watch {
    shared: Arc<Shared>,
}

#[derive(Debug, Default)]
struct Shared {
    stage: Mutex<Stage>,
    /// The first signal, once there was one.
    caught: Mutex<Option<Code>>,
    /// The same as a flag, for work that polls.
    stopping: Arc<AtomicBool>,
}

impl Watch {
    /// Begins to listen, on a thread of its own.
    ///
    /// # Errors
    /// If the system gives no thread or no handler.
    pub(crate) fn start() -> Result<Self, Failure> {
        let cannot = |e: std::io::Error| Failure::new(Code::Internal, format!("signals cannot be watched: {e}"));
        let watch = Self::default();
        let shared = Arc::clone(&watch.shared);
        let mut signals = Signals::new([SIGINT, SIGTERM]).map_err(cannot)?;
        let listen = move || {
            for signal in signals.forever() {
                shared.on_signal(if signal == SIGTERM { Code::Terminated } else { Code::Interrupted });
            }
        };
        thread::Builder::new().name("luch-signals".to_owned()).spawn(listen).map_err(cannot)?;
        Ok(watch)
    }

    /// A flag that becomes true when the user asks to stop.
    pub(crate) fn flag(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.shared.stopping)
    }

    /// Runs a render that a signal cancels.
    ///
    /// # Errors
    /// The signal, if there was one.
    pub(crate) fn rendering<T>(&self, progress: &Arc<Progress>, work: impl FnOnce() -> T) -> Result<T, Failure> {
        self.enter(Stage::Rendering(Arc::clone(progress)), work)
    }

    /// Runs a study that a signal cancels: what it has by then may be written by [`Watch::writing_the_rest`].
    ///
    /// # Errors
    /// The signal, if there was one before.
    pub(crate) fn studying<T>(&self, progress: &Arc<StudyProgress>, work: impl FnOnce() -> T) -> Result<T, Failure> {
        self.enter(Stage::Studying(Arc::clone(progress)), work)
    }

    /// Runs the writing of files also after a signal. A second one ends it, and nothing half written is left.
    pub(crate) fn writing_the_rest<'p, T>(&self, files: impl Iterator<Item = &'p Path>, work: impl FnOnce() -> T) -> T {
        *self.shared.stage() = Stage::Writing(files.map(Path::to_owned).collect());
        let outcome = work();
        *self.shared.stage() = Stage::Free;
        outcome
    }

    /// Runs the writing of files. A signal lets it come to its end if that is near: then the run is a success.
    ///
    /// # Errors
    /// The signal, if there was one before.
    pub(crate) fn writing<'p, T>(
        &self,
        files: impl Iterator<Item = &'p Path>,
        work: impl FnOnce() -> T,
    ) -> Result<T, Failure> {
        self.enter(Stage::Writing(files.map(Path::to_owned).collect()), work)
    }

    fn enter<T>(&self, stage: Stage, work: impl FnOnce() -> T) -> Result<T, Failure> {
        {
            let mut now = self.shared.stage();
            self.check()?;
            *now = stage;
        }
        let outcome = work();
        *self.shared.stage() = Stage::Free;
        Ok(outcome)
    }

    /// # Errors
    /// The signal, if there was one.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        lock(&self.shared.caught).map_or(Ok(()), |code| Err(stopped(code)))
    }
}

impl Shared {
    fn stage(&self) -> MutexGuard<'_, Stage> {
        lock(&self.stage)
    }

    fn on_signal(self: &Arc<Self>, code: Code) {
        // Held to the end: the main thread cannot begin to write while this thread ends the program.
        let stage = self.stage();
        let first = lock(&self.caught).replace(code).is_none();
        self.stopping.store(true, Ordering::Relaxed);
        match &*stage {
            Stage::Rendering(progress) if first => {
                progress.cancel();
                self.end_after(PATIENCE, code);
            }
            Stage::Studying(progress) if first => {
                progress.cancel();
                self.end_after(PATIENCE_TO_WRITE, code);
            }
            Stage::Writing(_) if first => self.end_after(PATIENCE, code),
            stage => quit(code, stage),
        }
    }

    /// Ends the program a little later, if it has not ended by itself.
    fn end_after(self: &Arc<Self>, patience: Duration, code: Code) {
        let shared = Arc::clone(self);
        let wait = move || {
            thread::sleep(patience);
            quit(code, &shared.stage());
        };
        if thread::Builder::new().name("luch-patience".to_owned()).spawn(wait).is_err() {
            quit(code, &Stage::Free);
        }
    }
}

/// The failure that a signal is.
fn stopped(code: Code) -> Failure {
    let by = if code == Code::Terminated { "by SIGTERM" } else { "by Ctrl-C" };
    Failure::new(code, format!("stopped {by}: nothing was written"))
}

#[allow(clippy::exit, reason = "the main thread may be deep in work that cannot be told to stop")]
fn quit(code: Code, stage: &Stage) -> ! {
    if let Stage::Writing(files) = stage {
        files.iter().for_each(|file| remove_temporaries(file));
    }
    progress::clear_line();
    output::error(&stopped(code).to_string());
    std::process::exit(i32::from(code as u8));
}

/// Removes what this process wrote beside the file: `.name.tmp-<process>-<n>`, as [`luch_io::atomic_save`] calls it.
fn remove_temporaries(file: &Path) {
    // A link is written through: what belongs to it lies beside the file that it points to.
    let file = file.canonicalize().unwrap_or_else(|_| file.to_owned());
    let folder = file.parent().filter(|p| !p.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let ours = format!(".tmp-{}-", std::process::id());
    let Ok(entries) = std::fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        if entry.file_name().to_string_lossy().contains(&ours) {
            // There is nobody left to tell.
            let _ = std::fs::remove_file(entry.path());
        }
    }
}

/// The lock, whether or not a thread panicked while it held it: what it guards is replaced whole.
fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
