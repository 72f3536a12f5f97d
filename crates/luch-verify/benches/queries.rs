//! How fast rays are answered, per query, coherence and SIMD level, on a bumpy sphere over a floor.
//!
//! `cargo bench -p luch-verify --bench queries`. The figure is rays per second on one core.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use glam::Vec3;
use luch_render::accel::{Geometry, Level, MeshTree, Placement, SceneTree, available_levels};
use luch_render::math::ray::{Coherence, HitBatch, Mask, Ray, RayBatch};
use std::f64::consts::TAU;
use std::sync::Arc;

fn main() {
    divan::main();
}

/// Rays of a query.
const RAYS: u32 = 1 << 16;

fn scene() -> SceneTree {
    const N: u32 = 300;
    let point = |i: u32, j: u32| {
        let (a, b) = (TAU / 2.0 * f64::from(i) / f64::from(N), TAU * f64::from(j) / f64::from(N));
        let r = 1.0 + 0.1 * (13.0 * a).sin() * (17.0 * b).cos();
        Vec3::new((r * a.sin() * b.cos()) as f32, (r * a.cos()) as f32, (r * a.sin() * b.sin()) as f32)
    };
    let positions: Vec<_> = (0..=N).flat_map(|i| (0..N).map(move |j| point(i, j))).collect();
    let at = |i: u32, j: u32| i * N + j % N;
    let cells = (0..N).flat_map(|i| (0..N).map(move |j| (i, j)));
    let triangles: Vec<_> = cells
        .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i, j + 1)], [at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)]])
        .collect();
    let tree = Arc::new(MeshTree::build(&positions, &triangles, 1));
    SceneTree::build(&[
        Geometry::Instance { tree, world_from_object: Placement::IDENTITY },
        Geometry::Plane { point: Vec3::NEG_Y * 1.2, normal: Vec3::Y, bounds: None },
    ])
}

/// Camera rays in tiles of 8x8, as the integrators make them.
fn camera_rays() -> RayBatch {
    let side = RAYS.isqrt();
    let mut rays = RayBatch::with_capacity(RAYS as usize);
    for k in 0..RAYS {
        let (tile, x, y) = (k / 64, k % 8, k / 8 % 8);
        let (x, y) = (tile % (side / 8) * 8 + x, tile / (side / 8) * 8 + y);
        let at = |p: u32| (p as f32 + 0.5) / side as f32 - 0.5;
        rays.push(&Ray::new(Vec3::new(0.3, 0.4, -3.0), Vec3::new(at(x), at(y), 1.0)));
    }
    rays
}

/// From where camera rays hit, on to a light or anywhere.
fn next_rays(scene: &SceneTree, to_light: bool) -> RayBatch {
    let (camera, mut hits) = (camera_rays(), HitBatch::new());
    scene.closest_hits(Level::new(), &camera, Coherence::Coherent, &mut hits);
    let mut rays = RayBatch::new();
    for k in 0..camera.len() {
        let Some(hit) = hits.get(k) else { continue };
        let (from, light) = (camera.get(k).at(hit.t * 0.999), Vec3::new(4.0, 6.0, -5.0));
        // A direction from the low bits of the ray's number: no two neighbours alike.
        let turn = |shift: u32| ((k as u32).wrapping_mul(2_654_435_761) >> shift & 255) as f32 / 127.5 - 1.0;
        let direction = if to_light { light - from } else { Vec3::new(turn(0), turn(8) + 1.0, turn(16) - 1.0) };
        rays.push(&Ray { t_max: if to_light { 1.0 } else { f32::INFINITY }, ..Ray::new(from, direction) });
    }
    rays
}

fn levels() -> impl Iterator<Item = &'static str> {
    available_levels().into_iter().map(|(name, _)| name)
}

fn level(name: &str) -> Level {
    available_levels().into_iter().find(|known| known.0 == name).map_or_else(Level::new, |known| known.1)
}

#[divan::bench(args = levels())]
fn closest_camera(bencher: Bencher<'_, '_>, name: &str) {
    closest(bencher, name, &scene(), &camera_rays(), Coherence::Coherent);
}

#[divan::bench(args = levels())]
fn closest_diffuse(bencher: Bencher<'_, '_>, name: &str) {
    let scene = scene();
    closest(bencher, name, &scene, &next_rays(&scene, false), Coherence::Incoherent);
}

#[divan::bench(args = levels())]
fn occluded_shadow(bencher: Bencher<'_, '_>, name: &str) {
    let (scene, level, mut occluded) = (scene(), level(name), Mask::new());
    let rays = next_rays(&scene, true);
    bencher.counter(ItemsCount::new(rays.len())).bench_local(|| {
        scene.occluded(level, black_box(&rays), Coherence::Coherent, &mut occluded);
        occluded.count()
    });
}

fn closest(bencher: Bencher<'_, '_>, name: &str, scene: &SceneTree, rays: &RayBatch, coherence: Coherence) {
    let (level, mut hits) = (level(name), HitBatch::new());
    bencher.counter(ItemsCount::new(rays.len())).bench_local(|| {
        scene.closest_hits(level, black_box(rays), coherence, &mut hits);
        hits.t[0]
    });
}
