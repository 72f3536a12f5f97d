//! What happens when something goes wrong, and when the owner goes away.

use super::*;
use crate::compiled::{CompiledScene, MeshTrees, Surface, compile, compile_after};
use crate::session::RenderJob;
use luch_scene::{
    Aim, Camera, ImageSize, Light, Mesh, MeshData, MeshInstance, Object, Point, RayCount, Rotation, Sampling, Scene,
    Shape, Size, Unit,
};
use std::sync::mpsc::{Receiver, SyncSender, sync_channel};
use std::sync::{Condvar, Mutex, Weak};
use std::time::{Duration, Instant};

const HUNG: Duration = Duration::from_secs(60);

/// A ball between two mirrors.
fn request(name: &str, side: u32) -> LiveRequest {
    let mut scene = Scene::new(name);
    let ball = Shape::Sphere { center: Point::ORIGIN, radius: Size::ONE };
    scene.objects.push(Object::new("Ball", ball));
    scene.objects[0].material.reflection = Unit::new(0.5).unwrap();
    scene.lights.push(Light::new("Lamp", Point::clamped([3.0, 4.0, 5.0].into())));
    scene.cameras.push(Camera::new("Camera", Point::clamped([0.0, 0.0, 5.0].into()), Aim::At(Point::ORIGIN)));
    let mut job = RenderJob::of_scene(&scene, 0);
    job.size = ImageSize::new(side, side).unwrap();
    job.threads = 3;
    LiveRequest { scene: Arc::new(scene), job }
}

/// Compiles a scene, but panics for one called "bad", and for one called "broken" gives one that breaks the workers.
fn sabotaged(
    _: Option<(&Scene, &CompiledScene)>,
    scene: &Scene,
    trees: &mut MeshTrees,
    threads: usize,
) -> CompiledScene {
    assert_ne!(scene.name, "bad");
    let mut compiled = compile(scene, trees, threads);
    if scene.name == "broken" {
        compiled.objects.clear();
    }
    compiled
}

fn bell() -> (SyncSender<()>, Receiver<()>) {
    sync_channel(1)
}

fn ringing(bell: SyncSender<()>) -> impl Fn() + Send + Sync {
    move || {
        // A bell that is ringing already need not be rung.
        let _ = bell.try_send(());
    }
}

fn end_of(session: &LiveSession, bell: &Receiver<()>, epoch: Epoch) -> LiveEnd {
    let start = Instant::now();
    loop {
        let status = session.status();
        if let (true, Some(end)) = (status.epoch == epoch, status.ended) {
            assert_eq!(status.phase, LivePhase::Idle);
            return end;
        }
        assert!(bell.recv_timeout(HUNG.saturating_sub(start.elapsed())).is_ok(), "hangs: {session:?}");
    }
}

#[test]
fn a_panic_becomes_a_failure_and_the_next_picture_is_made() {
    let (ring, bell) = bell();
    let mut conductor = Conductor::new(Box::new(ringing(ring)));
    conductor.compile = sabotaged;
    let session = LiveSession::start_with(conductor).unwrap();
    for _ in 0..3 {
        for (name, says) in [("bad", "internal error: assertion"), ("broken", "internal error in the tile")] {
            let epoch = session.show(request(name, 100));
            let LiveEnd::Failed(message) = end_of(&session, &bell, epoch) else { panic!("{name}: no failure") };
            assert!(message.starts_with(says), "{message}");
            let epoch = session.show(request("good", 100));
            assert_eq!(end_of(&session, &bell, epoch), LiveEnd::Finished);
            let snapshot = session.latest().unwrap();
            assert!(snapshot.epoch == epoch && snapshot.finished);
        }
    }
}

#[test]
fn a_wake_that_panics_does_not_end_the_session() {
    let (ring, bell) = bell();
    let session = LiveSession::start(move || {
        let _ = ring.try_send(());
        panic!("the owner's bug");
    })
    .unwrap();
    for side in [10, 20] {
        let epoch = session.show(request("good", side));
        assert_eq!(end_of(&session, &bell, epoch), LiveEnd::Finished);
    }
}

#[test]
fn the_last_owner_may_be_wake_itself() {
    let (tell, told) = sync_channel(1);
    let own: Arc<Mutex<Option<LiveSession>>> = Arc::default();
    let within = Arc::clone(&own);
    let session = LiveSession::start(move || {
        let session = within.lock().unwrap().take();
        let ended = session.is_some();
        // Here the session is dropped, on its own thread.
        drop(session);
        if ended {
            tell.send(()).unwrap();
        }
    })
    .unwrap();
    let mut slot = own.lock().unwrap();
    session.show(request("good", 10));
    *slot = Some(session);
    drop(slot);
    told.recv_timeout(HUNG).expect("it hangs");
}

#[test]
fn a_dropped_session_leaves_no_thread_and_no_memory() {
    for side in [1, 60, 400] {
        let counted = Arc::new(());
        let held = Arc::clone(&counted);
        let session = LiveSession::start(move || {
            let _ = &held;
        })
        .unwrap();
        let mut wanted = request("good", side);
        wanted.job.antialiasing = Sampling { on: true, rays: RayCount::new(4096).unwrap() };
        let scene = Arc::downgrade(&wanted.scene);
        session.show(wanted);
        if side == 60 {
            session.stop();
        }
        drop(session);
        assert_eq!(Arc::strong_count(&counted), 1, "the thread is gone, and with it its bell");
        assert_eq!(Weak::strong_count(&scene), 0, "nobody holds the scene");
    }
}

#[test]
fn what_is_idle_says_so() {
    let (ring, bell) = bell();
    let session = LiveSession::start(ringing(ring)).unwrap();
    let status = session.status();
    assert_eq!((status.epoch.get(), status.phase, status.ended), (0, LivePhase::Idle, None));
    session.stop();
    assert!(session.latest().is_none());
    let epoch = session.show(request("good", 10));
    assert_eq!(epoch.get(), 1);
    assert_ne!(session.status().phase, LivePhase::Idle, "{:?}", session.status());
    assert_eq!(end_of(&session, &bell, epoch), LiveEnd::Finished);
    let status = session.status();
    assert_eq!((status.done, status.total), (100, 100));
    assert!(status.rays >= 100 && status.elapsed == session.status().elapsed, "the clock stands");
    session.stop();
    assert_eq!(session.status().ended, Some(LiveEnd::Finished), "what is finished cannot be stopped");
}

#[test]
fn trees_live_as_long_as_somebody_has_their_mesh() {
    let (ring, bell) = bell();
    let session = LiveSession::start(ringing(ring)).unwrap();
    let data = MeshData {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]],
        triangles: vec![[0, 1, 2]],
        normal_triangles: Some(vec![[0, 0, 0]]),
        ..MeshData::default()
    };
    let mesh = Arc::new(Mesh::new(data).unwrap());
    let (path, position, rotation, scale) = (String::new(), Point::ORIGIN, Rotation::NONE, Size::ONE);
    let instance = MeshInstance { mesh: Arc::clone(&mesh), path, position, rotation, scale };
    let finished = |request: &LiveRequest| {
        let epoch = session.show(request.clone());
        assert_eq!(end_of(&session, &bell, epoch), LiveEnd::Finished);
        session.latest().unwrap()
    };
    let tree = |snapshot: &Snapshot| match &snapshot.compiled.objects.last().unwrap().surface {
        Surface::Mesh { layout, .. } => Arc::downgrade(layout),
        _ => panic!("no mesh"),
    };
    let mut with_mesh = request("mesh", 20);
    Arc::make_mut(&mut with_mesh.scene).objects.push(Object::new("Mesh", Shape::Mesh(instance)));
    let first = tree(&finished(&with_mesh));
    finished(&request("none", 20));
    assert!(first.ptr_eq(&tree(&finished(&with_mesh))), "the tree is the one that was built before");
    drop(with_mesh);
    finished(&request("none", 20));
    finished(&request("none", 20));
    assert_eq!(first.strong_count(), 1, "the mesh may come back");
    drop(mesh);
    finished(&request("none", 20));
    assert_eq!(first.strong_count(), 0, "nobody can ask for it any more");
}

/// Where the scene called "held" is held up while it is compiled.
#[derive(Clone, Copy, PartialEq)]
enum Gate {
    Nobody,
    Waiting,
    Open,
}

static GATE: (Mutex<Gate>, Condvar) = (Mutex::new(Gate::Nobody), Condvar::new());

fn set_gate(gate: Gate) {
    *GATE.0.lock().unwrap() = gate;
    GATE.1.notify_all();
}

fn wait_at_gate(until: Gate) {
    let lock = GATE.0.lock().unwrap();
    let (_lock, timeout) = GATE.1.wait_timeout_while(lock, HUNG, |gate| *gate != until).unwrap();
    assert!(!timeout.timed_out(), "nobody comes");
}

fn held_up(
    before: Option<(&Scene, &CompiledScene)>,
    scene: &Scene,
    trees: &mut MeshTrees,
    threads: usize,
) -> CompiledScene {
    if scene.name == "held" {
        set_gate(Gate::Waiting);
        wait_at_gate(Gate::Open);
    }
    compile_after(before, scene, trees, threads)
}

#[test]
fn a_picture_that_is_overtaken_before_its_first_ray_is_still_seen_once() {
    let ((ring, bell), (go_on, gone_on)) = (sync_channel(0), sync_channel(0));
    let gone_on = Mutex::new(gone_on);
    let mut conductor = Conductor::new(Box::new(move || {
        // The session waits until the test has looked.
        let _ = ring.send(());
        let _ = gone_on.lock().unwrap().recv();
    }));
    conductor.compile = held_up;
    conductor.patience = HUNG;
    let session = LiveSession::start_with(conductor).unwrap();
    let mut long = request("held", 200);
    long.job.antialiasing = Sampling { on: true, rays: RayCount::new(4096).unwrap() };
    let first = session.show(long);
    wait_at_gate(Gate::Waiting);
    let second = session.show(request("good", 10));
    set_gate(Gate::Open);
    let mut seen = Vec::new();
    while seen.last().is_none_or(|(_, finished)| !finished) {
        bell.recv_timeout(HUNG).expect("something is seen");
        seen.extend(session.latest().map(|snapshot| (snapshot.epoch, snapshot.finished)));
        go_on.send(()).unwrap();
    }
    assert_eq!(seen, [(first, false), (second, true)], "once, and not twice");
    drop((bell, go_on));
}
