//! The interactive session under random hands: no deadlock, no stale frame, no growth.

mod support;

use luch_render::{
    CompiledScene, Epoch, LiveEnd, LiveRequest, LiveSession, MeshTrees, Progress, RenderJob, Snapshot, compile, render,
};
use luch_scene::{Color, ImageSize, Point, Scene, Shading, Shape, Unit};
use luch_verify::{built_in, job, sampling, scenes};
use std::sync::{Arc, Weak};
use std::time::Instant;
use support::Random;
use support::watched::{HUNG, Watched};

const SEQUENCES: u32 = 500;
const STEPS: usize = 30;

/// A person at the window: what they see, and what they saw before.
struct Hand<'a> {
    random: Random,
    watched: &'a Watched,
    start: &'a [Arc<Scene>],
    scene: Arc<Scene>,
    job: RenderJob,
    undo: Vec<(Arc<Scene>, RenderJob)>,
    /// Every request of the sequence, by its epoch.
    asked: Vec<(Epoch, LiveRequest)>,
    /// The newest epoch seen, and how far it was.
    seen: (Epoch, u32),
    /// The newest request that was stopped, and what was shown then.
    stopped: (Epoch, Option<Arc<Snapshot>>),
}

impl Hand<'_> {
    fn step(&mut self) {
        match self.random.below(12) {
            0..=3 => self.edit(),
            4 => self.camera(),
            5 => self.undo(),
            6 => self.switch(),
            7 => self.resize(),
            8 => self.job.threads = [1, 2, 3, 8][self.random.below(4)],
            9 => {
                self.watched.session.stop();
                if let Some((epoch, _)) = self.asked.last() {
                    self.stopped = (*epoch, self.watched.session.latest());
                    if self.random.below(2) == 0 {
                        self.watched.end_of(*epoch);
                    }
                }
                return self.look();
            }
            10 => self.job.antialiasing = sampling([1, 1, 3, 4096][self.random.below(4)]),
            _ => {
                // Wait for something to be seen of the newest request.
                if let Some((newest, _)) = self.asked.last()
                    && *newest > self.stopped.0
                {
                    let newest = *newest;
                    self.watched.until(|session| session.latest().filter(|s| s.epoch == newest));
                }
                return self.look();
            }
        }
        self.show();
        self.look();
    }

    fn show(&mut self) {
        let request = LiveRequest { scene: Arc::clone(&self.scene), job: self.job.clone() };
        let epoch = self.watched.session.show(request.clone());
        assert!(self.asked.last().is_none_or(|(last, _)| epoch > *last));
        assert_eq!(self.watched.session.status().epoch, epoch);
        self.asked.push((epoch, request));
    }

    fn edit(&mut self) {
        self.undo.push((Arc::clone(&self.scene), self.job.clone()));
        let mut scene = Scene::clone(&self.scene);
        if !scene.objects.is_empty() {
            let at = self.random.below(scene.objects.len());
            let object = &mut scene.objects[at];
            match self.random.below(5) {
                0 => object.material.color = Color::from_hex(["#ff0000", "#00ff80"][self.random.below(2)]),
                1 => object.material.reflection = Unit::new(self.random.unit()).unwrap(),
                2 => object.hidden = !object.hidden,
                3 => {
                    let place = Point::clamped(self.random.point() * 2.0);
                    match &mut object.shape {
                        Shape::Sphere { center, .. } | Shape::Cuboid { center, .. } => *center = place,
                        Shape::Wall { .. } => {}
                        Shape::Mesh(instance) => instance.position = place,
                    }
                }
                _ => drop(scene.objects.remove(at)),
            }
        }
        self.scene = Arc::new(scene);
    }

    fn camera(&mut self) {
        self.undo.push((Arc::clone(&self.scene), self.job.clone()));
        let p = self.job.camera.position.get() + self.random.point();
        self.job.camera.position = Point::clamped(p);
    }

    fn undo(&mut self) {
        if let Some((scene, job)) = self.undo.pop() {
            (self.scene, self.job) = (scene, job);
        }
    }

    fn switch(&mut self) {
        self.undo.clear();
        self.scene = Arc::clone(&self.start[self.random.below(self.start.len())]);
        self.job.camera = self.scene.cameras[0].clone();
    }

    fn resize(&mut self) {
        let [w, h] = [[1, 1], [48, 36], [31, 57], [200, 120], [1, 90]][self.random.below(5)];
        self.job.size = ImageSize::new(w, h).unwrap();
    }

    /// Looks at what is shown: never older than what was seen, and what it says it is.
    fn look(&mut self) {
        let Some(snapshot) = self.watched.session.latest() else { return };
        let Some((_, request)) = self.asked.iter().find(|(epoch, _)| *epoch == snapshot.epoch) else {
            assert!(self.asked.first().is_none_or(|(first, _)| snapshot.epoch < *first), "of the sequence before");
            return;
        };
        if snapshot.epoch <= self.stopped.0 {
            let last = self.stopped.1.as_ref().expect("it was shown before it was stopped");
            assert!(Arc::ptr_eq(&snapshot, last), "what was stopped goes on: {snapshot:?}");
        }
        let samples = if snapshot.shrink == 1 { snapshot.samples } else { 0 };
        assert!((snapshot.epoch, samples) >= self.seen, "{snapshot:?} after {:?}", self.seen);
        self.seen = (snapshot.epoch, samples);
        assert!(Arc::ptr_eq(&snapshot.scene, &request.scene) && snapshot.job == request.job);
        let (size, shrink) = (request.job.size, snapshot.shrink);
        assert_eq!([snapshot.width, snapshot.height], [size.width().div_ceil(shrink), size.height().div_ceil(shrink)]);
        assert_eq!(snapshot.pixels.len(), (snapshot.width * snapshot.height) as usize);
        assert_eq!(snapshot.finished, shrink == 1 && snapshot.samples == request.job.rays_per_pixel());
        let map = snapshot.objects.as_ref().expect("every snapshot says what is where");
        assert_eq!([map.width(), map.height()], [size.width(), size.height()]);
    }

    /// Ends with a picture that is made to the end, and is that of its request.
    fn finish(&mut self) {
        self.job.antialiasing = sampling([1, 2, 5][self.random.below(3)]);
        self.show();
        let (epoch, request) = self.asked.last().cloned().unwrap();
        assert_eq!(self.watched.end_of(epoch), LiveEnd::Finished);
        self.look();
        let snapshot = self.watched.session.latest().unwrap();
        assert!(snapshot.epoch == epoch && snapshot.finished);
        let compiled = compile(&request.scene, &mut MeshTrees::new(), 1);
        let linear = render(&compiled, &request.job, &Progress::new()).unwrap().linear();
        assert!(snapshot.linear().unwrap() == linear, "{epoch:?}: {}", request.scene.name);
        assert!(linear.iter().all(|value| value.is_finite()), "{epoch:?}: {}", request.scene.name);
        assert_map(&snapshot, &compiled);
    }
}

/// The map says what centre rays meet.
fn assert_map(snapshot: &Snapshot, compiled: &CompiledScene) {
    let mut job = snapshot.job.clone();
    (job.antialiasing, job.depth_of_field) = (sampling(1), sampling(1));
    let map = snapshot.objects.as_ref().unwrap();
    assert_eq!(map.shrink(), 1);
    for y in (0..map.height()).step_by(7) {
        for x in (0..map.width()).step_by(5) {
            let picked = luch_render::pick(compiled, &job, x, y).map(|pick| pick.object);
            assert_eq!(map.at(x, y), picked, "{x},{y}");
        }
    }
}

fn starting_scenes() -> Vec<Arc<Scene>> {
    let mut empty = Scene::new("Empty");
    empty.cameras = scenes::of_everything(Shading::Flat).cameras;
    let scenes =
        [empty, scenes::of_everything(Shading::Flat), scenes::of_everything(Shading::Phong), built_in("two-spheres")];
    scenes.into_iter().map(Arc::new).collect()
}

#[test]
fn random_hands_find_no_deadlock_no_stale_frame_and_no_growth() {
    let start = starting_scenes();
    let watched = Watched::start();
    let mut scenes: Vec<Weak<Scene>> = Vec::new();
    let mut compiled: Vec<Weak<CompiledScene>> = Vec::new();
    let mut snapshots: Vec<Weak<Snapshot>> = Vec::new();
    for seed in 0..SEQUENCES {
        let scene = Arc::clone(&start[seed as usize % start.len()]);
        let mut job = job(&scene, 0, [48, 36], 1);
        job.depth = 3;
        let (undo, asked) = (Vec::new(), Vec::new());
        let (seen, stopped) = Default::default();
        let random = Random(seed.wrapping_mul(0x9e37_79b9));
        let mut hand = Hand { random, watched: &watched, start: &start, scene, job, undo, asked, seen, stopped };
        for _ in 0..STEPS {
            hand.step();
            if let Some(snapshot) = watched.session.latest() {
                snapshots.push(Arc::downgrade(&snapshot));
                compiled.push(Arc::downgrade(&snapshot.compiled));
            }
        }
        hand.finish();
        scenes.extend(hand.asked.iter().map(|(_, request)| Arc::downgrade(&request.scene)));
        drop(hand);
        // What is left: the last snapshot and what it was made from, and the scenes to start with.
        let alive = living(&mut snapshots);
        assert!(alive <= 1, "seed {seed}: {alive} snapshots are alive");
        let alive = living(&mut compiled);
        assert!(alive <= 1, "seed {seed}: {alive} compiled scenes are alive");
        let alive = living(&mut scenes);
        assert!(alive <= start.len() + 1, "seed {seed}: {alive} scenes are alive");
    }
    drop(watched);
    assert_eq!((living(&mut snapshots), living(&mut compiled)), (0, 0), "nothing is left of a dropped session");
}

/// How many different ones are alive; forgets the others.
fn living<T>(list: &mut Vec<Weak<T>>) -> usize {
    list.retain(|weak| weak.strong_count() > 0);
    list.sort_by_key(|weak| weak.as_ptr().addr());
    list.dedup_by(|a, b| a.ptr_eq(b));
    list.len()
}

#[test]
fn two_threads_that_ask_at_once_end_with_the_newest() {
    let watched = Watched::start();
    let scene = Arc::new(scenes::of_everything(Shading::Flat));
    let job = job(&scene, 0, [64, 48], 2);
    let storm = |session: &LiveSession| {
        let mut last = Epoch::default();
        for step in 0..2000 {
            let request = LiveRequest { scene: Arc::clone(&scene), job: job.clone() };
            let epoch = session.show(request);
            assert!(epoch > last);
            last = epoch;
            if step % 7 == 0 {
                session.stop();
            }
            if let Some(snapshot) = session.latest() {
                assert!(snapshot.epoch <= session.status().epoch);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| storm(&watched.session));
        }
    });
    assert_eq!(watched.session.status().epoch.get(), 4000);
    watched.finished(&LiveRequest { scene: Arc::clone(&scene), job: job.clone() });
}

#[test]
fn requests_that_come_faster_than_pictures_still_show_some() {
    let watched = Watched::start();
    let scene = Arc::new(built_in("chess"));
    let job = job(&scene, 0, [640, 480], 1);
    // A request at every sign of life and more: each comes while the one before is being made.
    let mut shown = std::collections::BTreeSet::new();
    let start = Instant::now();
    while shown.len() < 5 {
        assert!(start.elapsed() < HUNG, "nothing is shown");
        watched.session.show(LiveRequest { scene: Arc::clone(&scene), job: job.clone() });
        shown.extend(watched.session.latest().map(|snapshot| snapshot.epoch));
    }
}
