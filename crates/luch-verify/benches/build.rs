//! How fast trees are built: per mesh, and the scene's own over its instances.
//!
//! `cargo bench -p luch-verify --bench build`. The figure is triangles (objects) per second.

use divan::Bencher;
use divan::counter::ItemsCount;
use glam::Vec3;
use luch_render::accel::{Geometry, MeshTree, Placement, SceneTree};
use std::f64::consts::TAU;
use std::sync::Arc;

fn main() {
    divan::main();
}

/// A bumpy sphere of `2 * n * n` triangles, vertices shared.
fn bumpy_sphere(n: u32) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let point = |i: u32, j: u32| {
        let (a, b) = (TAU / 2.0 * f64::from(i) / f64::from(n), TAU * f64::from(j) / f64::from(n));
        let r = 1.0 + 0.1 * (13.0 * a).sin() * (17.0 * b).cos();
        Vec3::new((r * a.sin() * b.cos()) as f32, (r * a.cos()) as f32, (r * a.sin() * b.sin()) as f32)
    };
    let positions = (0..=n).flat_map(|i| (0..n).map(move |j| point(i, j))).collect();
    let at = |i: u32, j: u32| i * n + j % n;
    let cells = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    let triangles = cells
        .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i, j + 1)], [at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)]]);
    (positions, triangles.collect())
}

#[divan::bench(args = [(100, 1), (360, 1), (360, 2), (800, 2)], sample_count = 10)]
fn mesh_tree(bencher: Bencher<'_, '_>, (n, threads): (u32, usize)) {
    let (positions, triangles) = bumpy_sphere(n);
    bencher.counter(ItemsCount::new(triangles.len())).bench(|| MeshTree::build(&positions, &triangles, threads));
}

#[divan::bench(args = [32, 1000])]
fn scene_tree_of_instances(bencher: Bencher<'_, '_>, count: u32) {
    let (positions, triangles) = bumpy_sphere(30);
    let tree = Arc::new(MeshTree::build(&positions, &triangles, 1));
    let objects: Vec<_> = (0..count)
        .map(|k| {
            let translation = Vec3::new((k % 10) as f32, (k / 10 % 10) as f32, (k / 100) as f32) * 3.0;
            let world_from_object = Placement { translation, ..Placement::IDENTITY };
            Geometry::Instance { tree: tree.clone(), world_from_object }
        })
        .collect();
    bencher.counter(ItemsCount::new(objects.len())).bench(|| SceneTree::build(&objects));
}
