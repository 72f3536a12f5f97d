//! What the interactive session shows is what `render` makes.

mod support {
    pub(crate) mod watched;
}

use luch_io::linear_hash;
use luch_render::film::tonemap::srgb8;
use luch_render::{
    Integrator, LiveEnd, LiveRequest, LiveSession, MeshTrees, Progress, RenderJob, Snapshot, compile, pick, render,
};
use luch_scene::{ImageSize, NonNegative, Scene, Shading};
use luch_verify::{built_in, built_in_ids, hash, job, picture, sampling, scenes};
use std::sync::Arc;
use std::sync::mpsc::sync_channel;
use support::watched::{HUNG, Watched};

/// The built-in scenes and one of everything, with lenses that are open.
fn scenes() -> Vec<Arc<Scene>> {
    let mut scenes: Vec<Scene> = built_in_ids().into_iter().map(built_in).collect();
    scenes.push(scenes::of_everything(Shading::Gouraud));
    for camera in scenes.iter_mut().flat_map(|scene| &mut scene.cameras) {
        camera.lens_radius = NonNegative::new(0.1).unwrap();
    }
    scenes.into_iter().map(Arc::new).collect()
}

/// Small, but with both effects and an odd size.
fn small(scene: &Scene) -> RenderJob {
    let mut job = job(scene, 0, [91, 61], 5);
    job.depth_of_field = sampling(7);
    job
}

fn bytes(snapshot: &Snapshot) -> Vec<u8> {
    snapshot.pixels.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect()
}

#[test]
fn a_finished_picture_has_the_bits_of_a_render() {
    let watched = Watched::start();
    for scene in scenes() {
        let base = small(&scene);
        let truth = picture(&scene, &base);
        for threads in [1, 2, 3, 8] {
            let request = LiveRequest { scene: Arc::clone(&scene), job: RenderJob { threads, ..base.clone() } };
            let snapshot = watched.finished(&request);
            assert_eq!((snapshot.shrink, snapshot.samples), (1, 7), "{}", scene.name);
            let linear = snapshot.linear().unwrap();
            assert_eq!(linear_hash(&linear), linear_hash(&truth), "{}: {threads} threads", scene.name);
            assert!(bytes(&snapshot) == srgb8(&truth) && snapshot.pixels.iter().all(|p| p[3] == 255), "{}", scene.name);
            let status = watched.session.status();
            assert_eq!((status.done, status.total), (91 * 61 * 7, 91 * 61 * 7));
        }
    }
}

#[test]
fn an_interrupted_picture_that_is_asked_for_again_has_the_same_bits() {
    let watched = Watched::start();
    for scene in scenes() {
        let mut job = small(&scene);
        let truth = hash(&scene, &job);
        let request = LiveRequest { scene: Arc::clone(&scene), job: job.clone() };
        // Overtaken at once, after the first snapshot, and stopped in the middle.
        job.antialiasing = sampling(4096);
        let other = LiveRequest { scene: Arc::clone(&scene), job };
        watched.session.show(request.clone());
        let epoch = watched.session.show(other.clone());
        watched.until(|session| session.latest().filter(|s| s.epoch == epoch));
        let snapshot = watched.finished(&request);
        assert_eq!(linear_hash(&snapshot.linear().unwrap()), truth, "{}", scene.name);
        let epoch = watched.session.show(other);
        watched.until(|session| session.latest().filter(|s| s.epoch == epoch && s.samples > 1));
        watched.session.stop();
        assert_eq!(watched.end_of(epoch), LiveEnd::Cancelled);
        assert_eq!(watched.session.latest().unwrap().epoch, epoch, "the last snapshot stays");
        let snapshot = watched.finished(&request);
        assert_eq!(linear_hash(&snapshot.linear().unwrap()), truth, "{}", scene.name);
    }
}

#[test]
fn a_preview_shows_the_pixels_in_the_middle_of_its_blocks() {
    let scene = Arc::new(built_in("knight"));
    let mut job = job(&scene, 0, [1280, 720], 16);
    job.threads = 1;
    // The session waits with the next picture until this one is taken.
    let (ring, bell) = sync_channel(0);
    let wake = move || {
        // Nobody takes anything any more once the preview is taken.
        let _ = ring.send(());
    };
    let session = LiveSession::start(wake).unwrap();
    // The first picture of a session is a careful one.
    let epoch = session.show(LiveRequest { scene: Arc::clone(&scene), job: job.clone() });
    bell.recv_timeout(HUNG).expect("the session lives");
    let preview = session.latest().unwrap();
    session.stop();
    drop(bell);
    assert!(preview.epoch == epoch && preview.shrink % 2 == 1 && preview.shrink > 1, "{preview:?}");
    assert!(preview.linear().is_none() && !preview.finished && preview.samples == 1);
    let (shrink, [across, down]) = (preview.shrink, preview.extent());
    assert!((across * (preview.width * shrink) as f32 - 1280.0).abs() < 1e-3);
    assert!((down * (preview.height * shrink) as f32 - 720.0).abs() < 1e-3);
    // Neither antialiasing nor the lens spreads its rays.
    job.antialiasing = sampling(1);
    let full = srgb8(&picture(&scene, &job));
    let map = preview.objects.as_ref().unwrap();
    let (mut same, mut seen) = (0, 0);
    for y in (shrink / 2..720).step_by(shrink as usize) {
        for x in (shrink / 2..1280).step_by(shrink as usize) {
            let block = (y / shrink * preview.width + x / shrink) as usize;
            let pixel = (y * 1280 + x) as usize;
            let near = |channel: usize| preview.pixels[block][channel].abs_diff(full[pixel * 3 + channel]) <= 1;
            let object = pick(&preview.compiled, &job, x, y).map(|pick| pick.object);
            seen += 1;
            same += usize::from((0..3).all(near) && map.at(x, y) == object);
        }
    }
    // Rays that differ in their last bit may see another side of an edge.
    assert!(same * 1000 >= seen * 995, "{same} of {seen}");
}

#[test]
fn an_unfinished_picture_is_the_mean_of_its_first_samples() {
    let watched = Watched::start();
    let scene = Arc::new(scenes::of_everything(Shading::Phong));
    let mut job = job(&scene, 0, [91, 61], 1);
    job.antialiasing = sampling(4096);
    let request = LiveRequest { scene: Arc::clone(&scene), job: job.clone() };
    let epoch = watched.session.show(request);
    let snapshot = watched.until(|session| session.latest().filter(|s| s.epoch == epoch && s.samples > 1));
    watched.session.stop();
    assert!(!snapshot.finished);
    job.antialiasing = sampling(snapshot.samples);
    let truth = picture(&scene, &job);
    assert!(snapshot.linear().unwrap() == truth && bytes(&snapshot) == srgb8(&truth));
}

/// Indices of the objects in the picture that shows them, through the colours that stand for them.
fn shown_objects(scene: &Scene, job: &RenderJob) -> Vec<[u32; 3]> {
    let job = RenderJob { integrator: Integrator::Objects, ..job.clone() };
    let compiled = compile(scene, &mut MeshTrees::new(), 1);
    let linear = render(&compiled, &job, &Progress::new()).unwrap().linear();
    linear.chunks_exact(3).map(|c| [c[0].to_bits(), c[1].to_bits(), c[2].to_bits()]).collect()
}

/// That two lists name the same objects: the same place in one wherever it is the same in the other.
fn assert_same_objects(of: &str, shown: &[[u32; 3]], found: &[Option<usize>]) {
    let mut names = std::collections::HashMap::new();
    let mut back = std::collections::HashMap::new();
    for (color, object) in shown.iter().zip(found) {
        assert_eq!(names.entry(color).or_insert(object), &object, "{of}");
        assert_eq!(back.entry(object).or_insert(color), &color, "{of}");
    }
    assert!(names.len() > 2, "{of}: there is something to see");
}

#[test]
fn the_map_and_a_pick_name_the_objects_that_the_objects_view_shows() {
    let watched = Watched::start();
    for scene in scenes() {
        for (antialiasing, integrator) in [(1, Integrator::Classic), (4, Integrator::Classic), (1, Integrator::Depth)] {
            let mut job = job(&scene, 0, [91, 61], antialiasing);
            job.integrator = integrator;
            let snapshot = watched.finished(&LiveRequest { scene: Arc::clone(&scene), job: job.clone() });
            let map = snapshot.objects.as_ref().unwrap();
            assert_eq!((map.width(), map.height(), map.shrink()), (91, 61, 1));
            let pixels = || (0..61).flat_map(|y| (0..91).map(move |x| (x, y)));
            let mapped: Vec<_> = pixels().map(|(x, y)| map.at(x, y)).collect();
            job.antialiasing = sampling(1);
            let shown = shown_objects(&scene, &job);
            assert_same_objects(&scene.name, &shown, &mapped);
            let picked: Vec<_> =
                pixels().map(|(x, y)| pick(&snapshot.compiled, &job, x, y).map(|pick| pick.object)).collect();
            assert!(picked == mapped, "{}", scene.name);
            assert_eq!((map.at(91, 0), map.at(0, 61)), (None, None));
        }
    }
}

#[test]
fn a_pick_follows_the_first_ray_of_the_pixel_through_the_lens() {
    for scene in scenes() {
        let mut job = small(&scene);
        let compiled = compile(&scene, &mut MeshTrees::new(), 1);
        let pixels = || (0..61).flat_map(|y| (0..91).map(move |x| (x, y)));
        let picks: Vec<_> = pixels().map(|(x, y)| pick(&compiled, &job, x, y)).collect();
        let found: Vec<_> = picks.iter().map(|pick| pick.map(|pick| pick.object)).collect();
        (job.antialiasing.rays, job.depth_of_field.rays) = (sampling(1).rays, sampling(1).rays);
        assert_same_objects(&scene.name, &shown_objects(&scene, &job), &found);
        for pick in picks.into_iter().flatten() {
            assert!((pick.normal.length() - 1.0).abs() < 1e-4 && pick.t > 0.0, "{}: {pick:?}", scene.name);
            let away = (pick.point - job.camera.position.get()).length();
            assert!((away - pick.t).abs() < 0.11, "{}: the lens is 0.1 wide: {pick:?}", scene.name);
        }
        assert_eq!(pick(&compiled, &job, 91, 0), None);
        assert_eq!(pick(&compiled, &job, 0, 61), None);
    }
}

#[test]
fn a_picture_too_large_to_be_shown_is_refused_and_the_next_one_made() {
    let watched = Watched::start();
    let scene = Arc::new(scenes::of_everything(Shading::Flat));
    let mut job = job(&scene, 0, [16, 16], 1);
    let request = LiveRequest { scene: Arc::clone(&scene), job: job.clone() };
    for size in [[65_535, 65_535], [8193, 8192]] {
        job.size = ImageSize::new(size[0], size[1]).unwrap();
        assert!(job.size.pixels() > LiveSession::MAX_PIXELS);
        let epoch = watched.session.show(LiveRequest { scene: Arc::clone(&scene), job: job.clone() });
        let LiveEnd::Failed(message) = watched.end_of(epoch) else { panic!("it was not refused") };
        assert!(message.contains("too large"), "{message}");
        watched.finished(&request);
    }
}
