//! The session's thread: takes a request, compiles it, decides on passes, publishes what they make.

use super::LiveSession;
use super::canvas::Canvas;
use super::mailbox::{Asked, LiveRequest, Mail, Mailbox};
use super::objects::ObjectMap;
use super::pace::{Kind, Pace};
use super::pass::{Made, Outcome, Pass};
use super::pool::Pool;
use super::snapshot::Snapshot;
use crate::compiled::{CompiledScene, MeshTrees, compile};
use crate::math::ray::NO_OBJECT;
use crate::session::queue::message_of;
use crate::session::worker::View;
use luch_scene::Scene;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

/// How long a picture may go on to its first snapshot though a newer one is wanted.
const PATIENCE: Duration = Duration::from_millis(33);

/// Makes a scene ready for rays; tests put theirs in its place.
pub(super) type Compile = fn(&Scene, &mut MeshTrees, usize) -> CompiledScene;

/// Everything that the session's thread has.
pub(super) struct Conductor {
    mailbox: Arc<Mailbox>,
    wake: Box<dyn Fn() + Send + Sync>,
    compile: Compile,
    trees: MeshTrees,
    /// The scene compiled last.
    ready: Option<(Arc<Scene>, Arc<CompiledScene>)>,
    pool: Pool,
    pace: Pace,
}

/// A picture on its way.
struct Picture {
    asked: Asked,
    compiled: Arc<CompiledScene>,
    kind: Kind,
    threads: usize,
    patience: Instant,
    objects: Option<Arc<ObjectMap>>,
}

impl Conductor {
    pub(super) fn new(wake: Box<dyn Fn() + Send + Sync>) -> Self {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        Self {
            mailbox: Arc::new(Mailbox::new()),
            wake,
            compile,
            trees: MeshTrees::new(),
            ready: None,
            pool: Pool::new(),
            pace: Pace::new(cores),
        }
    }

    pub(super) const fn mailbox(&self) -> &Arc<Mailbox> {
        &self.mailbox
    }

    /// Serves until the session is dropped.
    pub(super) fn run(&mut self) {
        let mailbox = Arc::clone(&self.mailbox);
        while let Mail::Show(asked) = mailbox.wait(&|| self.tell()) {
            let epoch = asked.epoch;
            let failure = match catch_unwind(AssertUnwindSafe(|| self.picture(asked))) {
                Ok(Ok(())) => continue,
                Ok(Err(message)) => message,
                Err(panic) => {
                    // What was touched may be half done.
                    self.trees = MeshTrees::new();
                    self.ready = None;
                    format!("internal error: {}", message_of(panic.as_ref()))
                }
            };
            mailbox.fail(epoch, failure);
            self.tell();
        }
    }

    /// Says that there is something new.
    fn tell(&self) {
        // The caller's panic is not ours to die of.
        drop(catch_unwind(AssertUnwindSafe(|| (self.wake)())));
    }

    /// Makes a picture, as far as it is wanted.
    fn picture(&mut self, asked: Asked) -> Result<(), String> {
        let size = asked.request.job.size;
        if size.pixels() > LiveSession::MAX_PIXELS {
            let (width, height, most) = (size.width(), size.height(), LiveSession::MAX_PIXELS);
            return Err(format!("a picture of {width}x{height} pixels is too large to be shown: the limit is {most}"));
        }
        asked.progress.begin(size.pixels() * u64::from(asked.request.job.rays_per_pixel()));
        let compiled = self.compiled(&asked.request);
        self.mailbox.rendering();
        let patience = Instant::now() + PATIENCE;
        let (kind, threads) = (Kind::of(&asked.request), asked.request.job.threads.max(1));
        let mut picture = Picture { asked, compiled, kind, threads, patience, objects: None };
        for shrink in self.pace.previews(&picture.kind, [size.width(), size.height()], threads) {
            let mut canvas = Canvas::new(size, shrink, threads);
            if self.pass(&mut picture, &mut canvas, shrink, 1)?.is_none() {
                return Ok(());
            }
        }
        let mut canvas = Canvas::new(size, 1, threads);
        let wanted = picture.asked.request.job.rays_per_pixel();
        let mut samples = 1;
        while canvas.samples() < wanted {
            let Some(took) = self.pass(&mut picture, &mut canvas, 1, samples)? else { return Ok(()) };
            samples = Pace::samples(canvas.samples(), wanted, (samples, took));
        }
        Ok(())
    }

    /// The scene, ready for rays.
    fn compiled(&mut self, request: &LiveRequest) -> Arc<CompiledScene> {
        if let Some((scene, compiled)) = &self.ready
            && Arc::ptr_eq(scene, &request.scene)
        {
            return Arc::clone(compiled);
        }
        // The scene before is let go first, and with it the meshes that nobody else has.
        self.ready = None;
        self.trees.keep_living();
        let compiled = Arc::new((self.compile)(&request.scene, &mut self.trees, request.job.threads.max(1)));
        self.ready = Some((Arc::clone(&request.scene), Arc::clone(&compiled)));
        compiled
    }

    /// Makes one pass and publishes what it made. Answers with its time; `None` if it is not wanted any more.
    fn pass(
        &mut self,
        picture: &mut Picture,
        canvas: &mut Canvas,
        shrink: u32,
        samples: u32,
    ) -> Result<Option<Duration>, String> {
        let job = &picture.asked.request.job;
        let preview = shrink > 1;
        let pass = Pass {
            scene: Arc::clone(&picture.compiled),
            view: if preview { View::of_blocks(job, shrink) } else { View::of(job) },
            plan: canvas.plan(samples),
            before: canvas.sums(),
            objects: canvas.samples() == 0,
            progress: Arc::clone(&picture.asked.progress),
            counts: !preview,
            mailbox: Arc::clone(&self.mailbox),
            patience: picture.patience,
        };
        let Outcome { made, whole, took } = pass.run(&mut self.pool, picture.threads).map_err(|e| e.to_string())?;
        let pixels: u64 = made.iter().map(|made| made.pixels.len() as u64).sum();
        self.pace.learn(&picture.kind, preview, pixels * u64::from(samples), picture.threads, took, whole);
        if !whole {
            return Ok(None);
        }
        canvas.take(&made, samples);
        let snapshot = picture.snapshot(canvas, shrink, &made);
        drop(made);
        if !self.mailbox.publish(snapshot) {
            return Ok(None);
        }
        // It has been seen: from now on newer ones come first.
        picture.patience = picture.asked.at;
        self.tell();
        Ok(Some(took))
    }
}

impl Picture {
    fn snapshot(&mut self, canvas: &Canvas, shrink: u32, made: &[Made]) -> Snapshot {
        let LiveRequest { scene, job } = &self.asked.request;
        if canvas.samples() == 1 || self.objects.is_none() {
            let objects = canvas.assemble(NO_OBJECT, made.iter().map(|made| (made.tile, made.objects.as_slice())));
            self.objects = Some(Arc::new(ObjectMap::new(job.size, shrink, objects)));
        }
        Snapshot {
            epoch: self.asked.epoch,
            scene: Arc::clone(scene),
            compiled: Arc::clone(&self.compiled),
            job: job.clone(),
            shrink,
            width: canvas.width(),
            height: canvas.height(),
            pixels: canvas.assemble([0; 4], made.iter().map(|made| (made.tile, made.pixels.as_slice()))),
            samples: canvas.samples(),
            finished: shrink == 1 && canvas.samples() == job.rays_per_pixel(),
            objects: self.objects.clone(),
            rays: self.asked.progress.rays(),
            elapsed: self.asked.at.elapsed(),
            film: (shrink == 1).then(|| canvas.film()),
        }
    }
}
