//! Any bytes as a scene file, rendered at 8 x 8 with one ray a pixel: every number of the picture is finite and not
//! below zero.
#![no_main]

use libfuzzer_sys::fuzz_target;
use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::resolve::SceneFolder;
use luch_io::{Report, parse_scene};
use luch_render::{MeshTrees, Progress, RenderJob, compile, render};
use luch_scene::{ImageSize, RenderSettings, Scene, Shape};
use std::path::Path;

/// Far more than a fuzzer needs to find what is wrong, and little enough to be quick.
fn is_small(scene: &Scene) -> bool {
    let meshes = scene.objects.iter().filter(|o| matches!(o.shape, Shape::Mesh(_))).count();
    scene.objects.len() <= 64 && scene.lights.len() <= 64 && meshes <= 4
}

fuzz_target!(|bytes: &[u8]| {
    let folder = SceneFolder::built_in();
    let mut library = MeshLibrary::new();
    let mut load = |path: &str, report: &mut Report| {
        let mut budget = Budget::new(256 << 20);
        library.mesh(&folder, path, &mut budget, report)
    };
    let Ok(mut scene) = parse_scene(bytes, Path::new("s.toml"), &mut load, &mut Report::default()) else { return };
    if !is_small(&scene) {
        return;
    }
    let settings = RenderSettings::default();
    scene.settings.size = ImageSize::new(8, 8).expect("in range");
    scene.settings.depth = scene.settings.depth.min(16);
    scene.settings.antialiasing = settings.antialiasing;
    scene.settings.depth_of_field = settings.depth_of_field;
    let compiled = compile(&scene, &mut MeshTrees::new(), 1);
    for camera in 0..scene.cameras.len().min(3) {
        let job = RenderJob { threads: 1, ..RenderJob::of_scene(&scene, camera) };
        let film = render(&compiled, &job, &Progress::new()).expect("nothing stops it");
        assert!(film.linear().iter().all(|c| c.is_finite() && *c >= 0.0), "a pixel is no light");
    }
});
