//! Oracles and helpers for the tests and benches of Luch.

#![forbid(unsafe_code)]
#![allow(missing_docs, reason = "a crate of tests has no users")]

pub mod oracle;
pub mod scenes;

use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::{Report, SceneSource, linear_hash, load_scene};
use luch_render::{MeshTrees, Progress, RenderJob, compile, render};
use luch_scene::{ImageSize, RayCount, Sampling, Scene};

/// The ids of the built-in scenes.
pub fn built_in_ids() -> Vec<&'static str> {
    luch_io::builtin::ids().collect()
}

/// A built-in scene.
///
/// # Panics
/// If it cannot be loaded or says a warning.
pub fn built_in(id: &'static str) -> Scene {
    let mut report = Report::default();
    let source = SceneSource::BuiltIn(id);
    let scene = load_scene(&source, &mut MeshLibrary::new(), &mut Budget::default(), &mut report);
    assert!(report.is_empty(), "{id}: {:?}", report.lines());
    scene.unwrap_or_else(|error| panic!("{id}: {error}"))
}

/// The linear picture of a job.
///
/// # Panics
/// If it cannot be rendered, or holds anything but finite numbers of at least 0.
pub fn picture(scene: &Scene, job: &RenderJob) -> Vec<f32> {
    let compiled = compile(scene, &mut MeshTrees::new(), 2);
    let film = render(&compiled, job, &Progress::new()).unwrap_or_else(|error| panic!("{}: {error}", scene.name));
    let linear = film.linear();
    let bad = linear.iter().filter(|v| !(v.is_finite() && **v >= 0.0)).count();
    assert_eq!(bad, 0, "{}: numbers that are no light", scene.name);
    linear
}

/// The hash of the linear picture of a job.
pub fn hash(scene: &Scene, job: &RenderJob) -> String {
    linear_hash(&picture(scene, job))
}

/// A job of the scene's camera `camera` (from 0) at that size, with `rays` rays of antialiasing if more than one.
pub fn job(scene: &Scene, camera: usize, [width, height]: [u32; 2], rays: u32) -> RenderJob {
    let mut job = RenderJob::of_scene(scene, camera);
    job.size = ImageSize::new(width, height).expect("a size that is in range");
    job.antialiasing = sampling(rays);
    job.depth_of_field = sampling(1);
    job.threads = 2;
    job
}

/// An effect with that many rays; off if only one.
pub fn sampling(rays: u32) -> Sampling {
    Sampling { on: rays > 1, rays: RayCount::new(rays).expect("a number of rays that is in range") }
}
