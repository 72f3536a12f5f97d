//! Loads scenes on a thread of its own, so that the window never waits for a file.

use crate::document::Stamp;
use crate::files::Library;
use luch_io::budget::Budget;
use luch_io::{Error, Report, SceneSource, load_scene};
use luch_scene::Scene;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::thread;

/// What came of a load.
#[derive(Debug)]
pub(crate) struct Loaded {
    pub(crate) source: SceneSource,
    pub(crate) scene: Result<Scene, LoadFailure>,
    pub(crate) warnings: Vec<String>,
    /// Which state the scene at hand was in when the load began.
    pub(crate) over: Stamp,
    /// Whether there is no such file.
    pub(crate) missing: bool,
}

/// Why there is no scene.
#[derive(Debug)]
pub(crate) enum LoadFailure {
    /// The file is at fault, or may not be read.
    File(Error),
    /// A reader panicked: a bug, told with what it said.
    Internal(String),
}

/// The loads under way. The newest wins; older ones are stopped.
#[derive(Debug)]
pub(crate) struct Loader {
    library: Library,
    running: Option<Running>,
}

#[derive(Debug)]
struct Running {
    source: SceneSource,
    stop: Arc<AtomicBool>,
    answer: Receiver<Loaded>,
}

impl Loader {
    pub(crate) fn new() -> Self {
        Self { library: Library::default(), running: None }
    }

    /// The meshes that were read.
    pub(crate) fn library(&self) -> Library {
        self.library.clone()
    }

    /// Starts to load in place of the scene in the state `over`; `wake` is called when [`Loader::poll`] has something to answer.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn start(
        &mut self,
        source: SceneSource,
        over: Stamp,
        wake: impl FnOnce() + Send + 'static,
    ) -> Result<(), std::io::Error> {
        self.stop();
        let (send, answer) = sync_channel(1);
        let stop = Arc::new(AtomicBool::new(false));
        let work = Work { source: source.clone(), library: self.library(), over, stop: Arc::clone(&stop) };
        thread::Builder::new().name("luch-loader".into()).spawn(move || {
            work.run(&send);
            wake();
        })?;
        self.running = Some(Running { source, stop, answer });
        Ok(())
    }

    /// Stops the load that is under way.
    pub(crate) fn stop(&mut self) {
        if let Some(running) = self.running.take() {
            running.stop.store(true, Ordering::Relaxed);
        }
    }

    /// What is being loaded.
    pub(crate) fn source(&self) -> Option<&SceneSource> {
        self.running.as_ref().map(|running| &running.source)
    }

    /// What came of the load, once.
    pub(crate) fn poll(&mut self) -> Option<Loaded> {
        let loaded = self.running.as_ref()?.answer.try_recv().ok()?;
        self.running = None;
        Some(loaded)
    }
}

impl Drop for Loader {
    fn drop(&mut self) {
        self.stop();
    }
}

/// One load: everything that its thread needs.
struct Work {
    source: SceneSource,
    library: Library,
    over: Stamp,
    stop: Arc<AtomicBool>,
}

impl Work {
    fn run(self, answer: &SyncSender<Loaded>) {
        let mut report = Report::default();
        let read = std::panic::AssertUnwindSafe(|| {
            let mut budget = Budget::default().cancelled_by(Arc::clone(&self.stop));
            self.library.read(|library| load_scene(&self.source, library, &mut budget, &mut report))
        });
        let scene = match std::panic::catch_unwind(read) {
            Ok(scene) => scene.map_err(LoadFailure::File),
            Err(panic) => Err(LoadFailure::Internal(crate::panics::message(panic.as_ref()))),
        };
        let missing = scene.is_err() && self.source.path().is_some_and(|path| !path.exists());
        // A load that was stopped has nobody to answer to.
        let _ = answer.send(Loaded { source: self.source, scene, warnings: report.lines(), over: self.over, missing });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;

    fn stamp() -> Stamp {
        Document::untitled(Scene::new("s"), None, false).stamp()
    }

    #[test]
    fn the_newest_load_is_the_one_that_answers() {
        let mut loader = Loader::new();
        let (done, wait) = sync_channel(3);
        for id in ["chess", "knight", "two-spheres"] {
            let done = done.clone();
            loader.start(SceneSource::BuiltIn(id), stamp(), move || _ = done.send(id)).unwrap();
        }
        let mut ended: Vec<_> = (0..3).map(|_| wait.recv().unwrap()).collect();
        ended.sort_unstable();
        assert_eq!(ended, ["chess", "knight", "two-spheres"]);
        let loaded = loader.poll().unwrap();
        assert_eq!(loaded.source, SceneSource::BuiltIn("two-spheres"));
        assert_eq!(loaded.scene.unwrap().name, "Two spheres");
        assert!(loader.poll().is_none() && loader.source().is_none());
    }

    #[test]
    fn a_file_that_is_not_there_is_an_error_with_its_name() {
        let mut loader = Loader::new();
        let (done, wait) = sync_channel(1);
        loader.start(SceneSource::File("nowhere.toml".into()), stamp(), move || _ = done.send(())).unwrap();
        wait.recv().unwrap();
        let loaded = loader.poll().unwrap();
        assert!(loaded.missing);
        let Err(LoadFailure::File(error)) = loaded.scene else { panic!("it was read") };
        assert!(error.to_string().contains("nowhere.toml"));
    }
}
