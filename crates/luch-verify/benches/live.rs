//! How soon the interactive session answers: no window, but the requests that one makes.
//!
//! `cargo bench -p luch-verify --bench live`. The chess scene at 1280x720 with the threads of the machine. Requests come
//! every 16 ms, as from a hand that drags, while the picture before is being refined; times are from the call of `show`
//! until the snapshot can be taken. README.md beside this file says how to keep other programs off the cores meanwhile.

#![allow(clippy::print_stdout, reason = "a bench prints its figures")]

use luch_render::{Epoch, LiveEnd, LivePhase, LiveRequest, LiveSession, RenderJob, Snapshot};
use luch_scene::{Aim, Color, Point, Scene};
use luch_verify::{built_in, job};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, sync_channel};
use std::time::{Duration, Instant};

const FRAME: Duration = Duration::from_millis(16);
const EDITS: usize = 250;

fn main() {
    let base = Arc::new(built_in("chess"));
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    println!("chess, 1280x720, {threads} threads, {EDITS} requests every {} ms", FRAME.as_millis());
    println!("{:34} {:>9} {:>9} {:>9}  shown as", "ms", "median", "95 %", "most");
    for effects in [1, 16] {
        let mut job = job(&base, 0, [1280, 720], effects);
        job.threads = threads;
        let of = if effects > 1 { ", 16 rays" } else { "" };
        drag(&format!("colour{of}"), &base, &job, &recolored);
        drag(&format!("position{of}"), &base, &job, &moved);
        drag(&format!("orbit{of}"), &base, &job, &orbited);
    }
    let mut job = job(&base, 0, [1280, 720], 1);
    job.threads = threads;
    full(&base, &job);
    job.antialiasing = luch_verify::sampling(64);
    cancel("cancel", &base, &job);
    let mirrors = Arc::new(luch_verify::scenes::hall_of_mirrors(100));
    job.camera = mirrors.cameras[0].clone();
    job.depth = 10_000;
    cancel("cancel, 10,000 mirrors deep", &mirrors, &job);
}

/// A session with a bell that rings when there is something new.
struct Watched {
    session: LiveSession,
    bell: Receiver<()>,
}

impl Watched {
    fn start() -> Self {
        let (ring, bell) = sync_channel(1);
        let wake = move || {
            let _ = ring.try_send(());
        };
        Self { session: LiveSession::start(wake).expect("a thread"), bell }
    }

    /// The next snapshot that is as wanted.
    fn wait(&self, wanted: impl Fn(&Snapshot) -> bool) -> Arc<Snapshot> {
        loop {
            if let Some(snapshot) = self.session.latest().filter(|s| wanted(s)) {
                return snapshot;
            }
            self.bell.recv().expect("the session lives");
        }
    }

    /// Waits until the next frame of the screen, or for a snapshot that is as wanted.
    fn wait_until(&self, end: Instant, wanted: impl Fn(&Snapshot) -> bool) -> Option<Arc<Snapshot>> {
        loop {
            if let Some(snapshot) = self.session.latest().filter(|s| wanted(s)) {
                return Some(snapshot);
            }
            match self.bell.recv_timeout(end.saturating_duration_since(Instant::now())) {
                Ok(()) => {}
                Err(RecvTimeoutError::Timeout) => return None,
                Err(RecvTimeoutError::Disconnected) => panic!("the session is gone"),
            }
        }
    }
}

type Change = dyn Fn(&Arc<Scene>, &RenderJob, usize) -> LiveRequest;

fn recolored(base: &Arc<Scene>, job: &RenderJob, step: usize) -> LiveRequest {
    let mut scene = Scene::clone(base);
    let object = scene.objects.len() / 2;
    scene.objects[object].material.color =
        Some(Color::from_hex(&format!("#{:02x}8040", step % 256)).expect("a colour"));
    LiveRequest { scene: Arc::new(scene), job: job.clone() }
}

fn moved(base: &Arc<Scene>, job: &RenderJob, step: usize) -> LiveRequest {
    let mut scene = Scene::clone(base);
    let shift = (step % 100) as f32 * 0.002;
    for object in scene.objects.iter_mut().rev().take(1) {
        if let luch_scene::Shape::Mesh(instance) = &mut object.shape {
            let p = instance.position.get();
            instance.position = Point::clamped([p.x + shift, p.y, p.z].into());
        }
    }
    LiveRequest { scene: Arc::new(scene), job: job.clone() }
}

fn orbited(base: &Arc<Scene>, job: &RenderJob, step: usize) -> LiveRequest {
    let mut job = job.clone();
    let center = match job.camera.aim {
        Aim::At(p) => p.get(),
        Aim::Along(d) => job.camera.position.get() + d.unit() * 5.0,
    };
    let (sin, cos) = libm::sincosf(step as f32 * 0.01);
    let arm = job.camera.position.get() - center;
    let turned = [arm.x * cos - arm.z * sin, arm.y, arm.x * sin + arm.z * cos];
    job.camera.position = Point::clamped(center + glam::Vec3::from_array(turned));
    job.camera.aim = Aim::At(Point::clamped(center));
    LiveRequest { scene: Arc::clone(base), job }
}

/// A hand that drags: from each request to the first picture that shows it, or a later one where it was overtaken.
fn drag(name: &str, base: &Arc<Scene>, job: &RenderJob, change: &Change) {
    let watched = Watched::start();
    watched.session.show(change(base, job, 0));
    watched.wait(|s| s.finished);
    let (mut times, mut shrinks, mut overtaken) = (Vec::new(), Vec::new(), 0);
    let mut awaited: Vec<(Epoch, Instant)> = Vec::new();
    let mut next = Instant::now();
    for step in 1..=EDITS {
        let request = change(base, job, step);
        let asked = Instant::now();
        awaited.push((watched.session.show(request), asked));
        next = (next + FRAME).max(asked);
        // The last request waits for its picture however long it takes.
        let end = if step < EDITS { next } else { next + Duration::from_secs(60) };
        while let Some(&(first, _)) = awaited.first()
            && let Some(snapshot) = watched.wait_until(end, |s| s.epoch >= first)
        {
            let now = Instant::now();
            let seen = awaited.iter().take_while(|(epoch, _)| *epoch <= snapshot.epoch).count();
            times.extend(awaited.drain(..seen).map(|(_, asked)| now - asked));
            shrinks.push(snapshot.shrink);
            overtaken += seen - 1;
        }
        std::thread::sleep(next.saturating_duration_since(Instant::now()));
    }
    shrinks.sort_unstable();
    report(
        &format!("{name}: first picture"),
        times,
        &format!("1/{}, {overtaken} overtaken", shrinks[shrinks.len() / 2]),
    );
}

/// From a request to the full resolution, the hand at rest.
fn full(base: &Arc<Scene>, job: &RenderJob) {
    for (name, change) in [("colour", &recolored as &Change), ("orbit", &orbited)] {
        let watched = Watched::start();
        let mut times = Vec::new();
        for step in 0..60 {
            let asked = Instant::now();
            let epoch = watched.session.show(change(base, job, step));
            watched.wait(|s| s.epoch == epoch && s.shrink == 1);
            times.push(asked.elapsed());
        }
        report(&format!("{name}: full resolution"), times, "1/1");
    }
}

/// From `stop` in the middle of the picture until no thread is at work.
fn cancel(name: &str, base: &Arc<Scene>, job: &RenderJob) {
    let watched = Watched::start();
    let mut times = Vec::new();
    // Trees of meshes are built once, and to the end.
    watched.session.show(orbited(base, job, 0));
    while watched.session.status().phase != LivePhase::Rendering {
        std::thread::yield_now();
    }
    for step in 1..=60 {
        watched.session.show(orbited(base, job, step));
        // Somewhere in the picture, at another place each time.
        std::thread::sleep(Duration::from_micros(1500 * step as u64));
        let asked = Instant::now();
        watched.session.stop();
        while watched.session.status().phase != LivePhase::Idle {
            watched.bell.recv().expect("the session lives");
        }
        times.push(asked.elapsed());
        assert_eq!(watched.session.status().ended, Some(LiveEnd::Cancelled));
    }
    report(name, times, "");
}

fn report(name: &str, mut times: Vec<Duration>, shown: &str) {
    times.sort_unstable();
    let at = |share: f64| times[((times.len() - 1) as f64 * share).round() as usize];
    let ms = |share: f64| at(share).as_secs_f64() * 1e3;
    println!("{name:34} {:>9.2} {:>9.2} {:>9.2}  {shown}", ms(0.5), ms(0.95), ms(1.0));
}
