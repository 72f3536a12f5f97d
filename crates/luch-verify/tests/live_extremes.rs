//! The interactive session at the ends of what can be asked of it.

mod support {
    pub(crate) mod watched;
}

use luch_render::{Epoch, Integrator, LiveEnd, LivePhase, LiveRequest, LiveSession, RenderJob};
use luch_scene::Shading;
use luch_verify::{job, picture, sampling, scenes};
use std::sync::Arc;
use std::sync::mpsc::sync_channel;
use std::time::Instant;
use support::watched::{HUNG, Watched};

#[test]
fn a_picture_without_end_is_cancelled_and_dropped_within_a_tile() {
    // One sample of one tile would take minutes: 10,000 surfaces along each path, each with 1000 lights.
    let scene = Arc::new(scenes::hall_of_mirrors(1000));
    let mut job = job(&scene, 0, [640, 480], 64);
    job.depth = 10_000;
    let request = LiveRequest { scene, job };
    let watched = Watched::start();
    for _ in 0..3 {
        let epoch = begin(&watched, &request);
        watched.session.stop();
        assert_eq!(watched.end_of(epoch), LiveEnd::Cancelled);
    }
    begin(&watched, &request);
    let (tell, told) = sync_channel(0);
    let end = std::thread::Builder::new().name("end".to_owned()).spawn(move || {
        drop(watched);
        tell.send(()).unwrap();
    });
    told.recv_timeout(HUNG).expect("the session does not end");
    end.unwrap().join().unwrap();
}

/// Asks for a picture and waits until its first rays are traced. No bell rings before there is something to see.
fn begin(watched: &Watched, request: &LiveRequest) -> Epoch {
    let epoch = watched.session.show(request.clone());
    let start = Instant::now();
    while watched.session.status().phase != LivePhase::Rendering {
        assert!(start.elapsed() < HUNG, "it is not begun");
        std::thread::yield_now();
    }
    epoch
}

#[test]
fn pictures_of_every_size_number_of_threads_and_view_are_finished() {
    let watched = Watched::start();
    let scene = Arc::new(scenes::of_everything(Shading::Phong));
    let check = |job: RenderJob| {
        let truth = picture(&scene, &job);
        let snapshot = watched.finished(&LiveRequest { scene: Arc::clone(&scene), job });
        assert!(snapshot.linear().unwrap() == truth, "{:?}", snapshot.job);
    };
    for size in [[1, 1], [1, 65_535], [65_535, 1], [7, 4001]] {
        check(job(&scene, 0, size, 1));
    }
    for integrator in Integrator::ALL {
        check(RenderJob { integrator, ..job(&scene, 0, [70, 50], 3) });
    }
    for threads in [0, 1, 1024, usize::MAX] {
        let base = job(&scene, 0, [70, 50], 1);
        // A plain render would start them all.
        let truth = picture(&scene, &base);
        let snapshot = watched.finished(&LiveRequest { scene: Arc::clone(&scene), job: RenderJob { threads, ..base } });
        assert!(snapshot.linear().unwrap() == truth);
    }
    for (depth, tile_size) in [(0, 32), (1, 0), (10_000, u32::MAX)] {
        check(RenderJob { depth, tile_size, ..job(&scene, 0, [70, 50], 1) });
    }
}

#[test]
fn a_session_that_is_dropped_at_once_leaves_nothing() {
    let scene = Arc::new(scenes::of_everything(Shading::Phong));
    for rays in 0..50 {
        let session = LiveSession::start(|| ()).unwrap();
        for _ in 0..rays % 3 {
            session.show(LiveRequest { scene: Arc::clone(&scene), job: job(&scene, 0, [320, 240], 1 + rays) });
        }
        if rays % 5 == 0 {
            session.stop();
        }
        drop(session);
        assert_eq!(Arc::strong_count(&scene), 1);
    }
    let mut job = job(&scene, 0, [16, 16], 1);
    job.antialiasing = sampling(2);
    Watched::start().finished(&LiveRequest { scene, job });
}
