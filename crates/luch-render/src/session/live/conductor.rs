//! The session's thread: takes a request, compiles it, decides on passes, publishes what they make.

use super::LiveSession;
use super::canvas::Canvas;
use super::mailbox::{Asked, LiveRequest, Mail, Mailbox};
use super::objects::{ObjectMap, Sight};
use super::pace::{Kind, Measured, Pace};
use super::pass::{Made, Outcome, Pass};
use super::pool::Pool;
use super::snapshot::Snapshot;
use crate::compiled::{CompiledScene, MeshTrees, compile_after};
use crate::session::queue::message_of;
use crate::session::worker::View;
use luch_scene::Scene;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use std::thread;
use std::time::{Duration, Instant};

/// Two frames of the screen.
const PATIENCE: Duration = Duration::from_millis(33);
/// More threads than this are not started, whatever a request says.
const MAX_THREADS: usize = 1024;

/// Makes a scene ready for rays; tests put theirs in its place.
pub(super) type Compile = fn(Option<(&Scene, &CompiledScene)>, &Scene, &mut MeshTrees, usize) -> CompiledScene;

/// Everything that the session's thread has.
pub(super) struct Conductor {
    pub(super) mailbox: Arc<Mailbox>,
    pub(super) compile: Compile,
    /// How long a picture may go on to its first snapshot though a newer one is wanted.
    pub(super) patience: Duration,
    wake: Box<dyn Fn() + Send + Sync>,
    trees: MeshTrees,
    /// The scene compiled last.
    ready: Option<(Arc<Scene>, Arc<CompiledScene>)>,
    /// What the last full picture saw where, while it still holds.
    sight: Option<Sight>,
    pool: Pool,
    pace: Pace,
}

/// A picture on its way.
struct Picture {
    asked: Asked,
    compiled: Arc<CompiledScene>,
    kind: Kind,
    threads: usize,
    /// Until then a newer request is no reason to give it up.
    patience: Instant,
    /// Whether there was a snapshot.
    seen: bool,
    objects: Option<Arc<ObjectMap>>,
}

impl Conductor {
    pub(super) fn new(wake: Box<dyn Fn() + Send + Sync>) -> Self {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        Self {
            mailbox: Arc::new(Mailbox::new()),
            compile: compile_after,
            patience: PATIENCE,
            wake,
            trees: MeshTrees::new(),
            ready: None,
            sight: None,
            pool: Pool::new(),
            pace: Pace::new(cores),
        }
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
                    (self.trees, self.ready, self.sight) = (MeshTrees::new(), None, None);
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
        let (size, wanted) = (asked.request.job.size, asked.request.job.rays_per_pixel());
        let sides = [size.width(), size.height()];
        if size.pixels() > LiveSession::MAX_PIXELS {
            let ([width, height], most) = (sides, LiveSession::MAX_PIXELS);
            return Err(format!(
                "a picture of {width}x{height} pixels is too large to be shown as it is made: the limit is {most} pixels"
            ));
        }
        let mut picture = self.begin(asked);
        let (kind, threads) = (picture.kind.clone(), picture.threads);
        let mut shrink = self.pace.first(&kind, sides, threads);
        while shrink > 1 {
            let mut canvas = Canvas::new(size, shrink, threads);
            let Some(took) = self.pass(&mut picture, &mut canvas, 1)? else { return Ok(()) };
            shrink = self.pace.next(&kind, sides, threads, shrink, took);
        }
        let (mut canvas, mut samples) = (Canvas::new(size, 1, threads), 1);
        while canvas.samples() < wanted {
            let Some(took) = self.pass(&mut picture, &mut canvas, samples)? else { return Ok(()) };
            samples = Pace::samples(canvas.samples(), wanted, (samples, took));
        }
        Ok(())
    }

    /// Makes everything ready for the first ray.
    fn begin(&mut self, asked: Asked) -> Picture {
        let LiveRequest { scene, job } = &asked.request;
        asked.progress.begin(job.size.pixels() * u64::from(job.rays_per_pixel()));
        let tiles = Canvas::most_tiles(job.size);
        let threads = job.threads.clamp(1, MAX_THREADS.min(tiles));
        let compiled = self.compiled(scene, threads);
        self.sight = self.sight.take().and_then(|sight| sight.through(&asked.request));
        self.pool.resize(threads);
        self.mailbox.rendering();
        Picture {
            kind: Kind::of(&asked.request),
            asked,
            compiled,
            threads,
            patience: Instant::now() + self.patience,
            seen: false,
            objects: self.sight.as_ref().map(|sight| Arc::clone(sight.map())),
        }
    }

    /// The scene, ready for rays.
    fn compiled(&mut self, scene: &Arc<Scene>, threads: usize) -> Arc<CompiledScene> {
        let before = self.ready.take();
        if let Some((known, compiled)) = &before
            && Arc::ptr_eq(known, scene)
        {
            let compiled = Arc::clone(compiled);
            self.ready = before;
            return compiled;
        }
        let last = before.as_ref().map(|(scene, compiled)| (&**scene, &**compiled));
        let compiled = Arc::new((self.compile)(last, scene, &mut self.trees, threads));
        self.ready = Some((Arc::clone(scene), Arc::clone(&compiled)));
        // With the scene before go the trees of meshes that nobody else has.
        drop(before);
        self.trees.keep_living();
        compiled
    }

    /// Makes the next `samples` samples of the canvas and publishes it. Answers with the time of the pass; `None` if the
    /// picture is not wanted any more.
    fn pass(&mut self, picture: &mut Picture, canvas: &mut Canvas, samples: u32) -> Result<Option<Duration>, String> {
        let objects = picture.objects.as_ref().is_none_or(|map| map.shrink() > 1);
        let pass = picture.pass(canvas, samples, objects, &self.mailbox);
        let Outcome { made, whole, took } = pass.run(&mut self.pool, picture.threads).map_err(|e| e.to_string())?;
        // A pass that was cut short for a newer request says nothing, unless it had its time.
        if whole || Instant::now() >= picture.patience && !picture.seen {
            let rays = made.iter().map(|made| made.pixels.len() as u64).sum::<u64>() * u64::from(samples);
            let preview = canvas.shrink() > 1;
            self.pace.learn(&picture.kind, Measured { preview, rays, threads: picture.threads, took, whole });
        }
        if !whole {
            return Ok(None);
        }
        canvas.take(&made, samples);
        if objects {
            let map = Arc::new(canvas.object_map(&made));
            if map.shrink() == 1 {
                self.sight = Some(Sight::new(&picture.asked.request, Arc::clone(&map)));
            }
            picture.objects = Some(map);
        }
        if !self.mailbox.publish(picture.snapshot(canvas, &made)) {
            return Ok(None);
        }
        // It has been seen: from now on newer ones come first.
        (picture.seen, picture.patience) = (true, picture.asked.at);
        drop(made);
        self.tell();
        Ok(Some(took))
    }
}

impl Picture {
    fn pass(&self, canvas: &Canvas, samples: u32, objects: bool, mailbox: &Arc<Mailbox>) -> Pass {
        let (job, shrink) = (&self.asked.request.job, canvas.shrink());
        Pass {
            scene: Arc::clone(&self.compiled),
            view: if shrink > 1 { View::of_blocks(job, shrink) } else { View::of(job) },
            plan: canvas.plan(samples),
            before: canvas.sums(),
            objects,
            progress: Arc::clone(&self.asked.progress),
            counts: shrink == 1,
            mailbox: Arc::clone(mailbox),
            patience: self.patience,
        }
    }

    fn snapshot(&self, canvas: &Canvas, made: &[Made]) -> Snapshot {
        let LiveRequest { scene, job } = &self.asked.request;
        let shrink = canvas.shrink();
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
