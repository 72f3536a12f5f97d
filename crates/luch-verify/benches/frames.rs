//! How fast whole pictures are: every built-in scene, and the stages of a frame one above the other.
//!
//! `cargo bench -p luch-verify --bench frames`. The figure is pixels per second on one core.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use luch_render::film::tonemap::{srgb8, srgb16};
use luch_render::{Integrator, MeshTrees, Progress, RenderJob, compile, render};
use luch_verify::{built_in, job};

fn main() {
    divan::main();
}

const SIZE: [u32; 2] = [640, 480];

/// Renders camera 1 of a built-in scene over and over.
fn frames(bencher: Bencher<'_, '_>, id: &'static str, change: impl Fn(&mut RenderJob)) {
    let scene = built_in(id);
    let compiled = compile(&scene, &mut MeshTrees::new(), 1);
    let mut job = job(&scene, 0, SIZE, 1);
    job.threads = 1;
    change(&mut job);
    bencher
        .counter(ItemsCount::new(SIZE[0] * SIZE[1]))
        .bench(|| render(black_box(&compiled), &job, &Progress::new()).expect("a picture"));
}

/// The classic picture, without antialiasing.
#[divan::bench(args = ["two-spheres", "knight", "chess"])]
fn classic(bencher: Bencher<'_, '_>, id: &'static str) {
    frames(bencher, id, |_| {});
}

/// One surface deep: no mirror rays. What is missing to `classic` is theirs.
#[divan::bench(args = ["two-spheres", "knight", "chess"])]
fn without_mirrors(bencher: Bencher<'_, '_>, id: &'static str) {
    frames(bencher, id, |job| job.depth = 1);
}

/// Camera rays, hits, and the surfaces at them, but no light. What is missing to `without_mirrors` is shadows and light.
#[divan::bench(args = ["two-spheres", "knight", "chess"])]
fn surfaces(bencher: Bencher<'_, '_>, id: &'static str) {
    frames(bencher, id, |job| job.integrator = Integrator::Normal);
}

/// Camera rays and hits alone. What is missing to `surfaces` is the shading of normals and looks.
#[divan::bench(args = ["two-spheres", "knight", "chess"])]
fn first_hits(bencher: Bencher<'_, '_>, id: &'static str) {
    frames(bencher, id, |job| job.integrator = Integrator::Objects);
}

/// The scene made ready for rays: trees and layouts of all meshes.
#[divan::bench(args = ["two-spheres", "knight", "chess"])]
fn compiling(bencher: Bencher<'_, '_>, id: &'static str) {
    let scene = built_in(id);
    bencher.bench(|| compile(black_box(&scene), &mut MeshTrees::new(), 1));
}

/// From linear light to bytes.
#[divan::bench]
fn tonemap_8_bit(bencher: Bencher<'_, '_>) {
    let linear: Vec<f32> = (0..SIZE[0] * SIZE[1] * 3).map(|i| (i % 1009) as f32 / 900.0).collect();
    bencher.counter(ItemsCount::new(SIZE[0] * SIZE[1])).bench(|| srgb8(black_box(&linear)));
}

/// From linear light to 16-bit numbers.
#[divan::bench]
fn tonemap_16_bit(bencher: Bencher<'_, '_>) {
    let linear: Vec<f32> = (0..SIZE[0] * SIZE[1] * 3).map(|i| (i % 1009) as f32 / 900.0).collect();
    bencher.counter(ItemsCount::new(SIZE[0] * SIZE[1])).bench(|| srgb16(black_box(&linear)));
}
