//! Rays per second on the meshes and ray files of the reference harness, without the program around it.
//!
//! usage: bench_rays MESH.bin PREFIX THREADS [REPEAT] [LEVEL] [QUERIES]
//! MESH.bin: u32 vertices, u32 triangles, f32 positions, u32 indices. PREFIX.{camera,shadow,diffuse}.rays: eight f32 per
//! ray. QUERIES: any of the letters c, s, d. Prints one JSON line.
#![allow(clippy::print_stdout, reason = "printing is what it is for")]

use luch_render::accel::{Geometry, Level, MeshTree, Placement, SceneTree, available_levels};
use luch_render::math::ray::{Coherence, HitBatch, Mask, Ray, RayBatch};
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

/// Rays per work item.
const CHUNK: usize = 4096;

fn words(path: &str) -> Vec<[u8; 4]> {
    let bytes = std::fs::read(path).unwrap_or_else(|error| panic!("{path}: {error}"));
    bytes.as_chunks().0.to_vec()
}

fn rays(path: &str) -> Vec<RayBatch> {
    let values: Vec<f32> = words(path).into_iter().map(f32::from_le_bytes).collect();
    let all: Vec<_> = values.as_chunks::<8>().0.to_vec();
    let batch = |chunk: &[[f32; 8]]| {
        let mut batch = RayBatch::with_capacity(CHUNK);
        for &[ox, oy, oz, dx, dy, dz, t_min, t_max] in chunk {
            batch.push(&Ray { origin: [ox, oy, oz].into(), direction: [dx, dy, dz].into(), t_min, t_max });
        }
        batch
    };
    all.chunks(CHUNK).map(batch).collect()
}

struct Answer {
    hits: usize,
    sum_t: f64,
    mrays_per_s: f64,
}

fn measure(
    scene: &SceneTree,
    level: Level,
    rays: &[RayBatch],
    any: bool,
    coherence: Coherence,
    threads: usize,
) -> Answer {
    let next = AtomicUsize::new(0);
    let start = Instant::now();
    let work = || {
        let (mut hits, mut occluded) = (HitBatch::new(), Mask::new());
        let (mut count, mut sum_t) = (0, 0.0);
        while let Some(batch) = rays.get(next.fetch_add(1, Ordering::Relaxed)) {
            if any {
                scene.occluded(level, batch, coherence, &mut occluded);
                count += occluded.count();
            } else {
                scene.closest_hits(level, batch, coherence, &mut hits);
                for t in hits.t[..batch.len()].iter().filter(|t| t.is_finite()) {
                    count += 1;
                    sum_t += f64::from(*t);
                }
            }
        }
        (count, sum_t)
    };
    let (hits, sum_t) = std::thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(work)).collect();
        let mine = work();
        others.into_iter().map(|other| other.join().expect("no panic")).fold(mine, |a, b| (a.0 + b.0, a.1 + b.1))
    });
    let total: usize = rays.iter().map(RayBatch::len).sum();
    Answer { hits, sum_t, mrays_per_s: total as f64 / start.elapsed().as_secs_f64() / 1e6 }
}

fn main() {
    let args: Vec<_> = std::env::args().collect();
    let [_, mesh, prefix, threads, rest @ ..] = args.as_slice() else {
        panic!("MESH.bin PREFIX THREADS [REPEAT] [LEVEL]")
    };
    let threads: usize = threads.parse().expect("threads");
    let repeat: usize = rest.first().map_or(5, |n| n.parse().expect("repeat"));
    let wanted = rest.get(1).map_or("auto", String::as_str);
    let level =
        available_levels().into_iter().find(|(name, _)| *name == wanted).map_or(Level::new(), |(_, level)| level);
    let queries = rest.get(2).map_or("csd", String::as_str);

    let data = words(mesh);
    let (vertices, count) = (u32::from_le_bytes(data[0]) as usize, u32::from_le_bytes(data[1]) as usize);
    let floats: Vec<f32> = data[2..2 + 3 * vertices].iter().map(|b| f32::from_le_bytes(*b)).collect();
    let indices: Vec<u32> = data[2 + 3 * vertices..].iter().map(|b| u32::from_le_bytes(*b)).collect();
    let (positions, triangles) = (floats.as_chunks::<3>().0, indices.as_chunks::<3>().0);
    let mut build_ms = f64::INFINITY;
    let mut tree = MeshTree::build(positions, &triangles[..1], 1);
    for _ in 0..repeat.min(3) {
        let start = Instant::now();
        tree = MeshTree::build(positions, triangles, threads);
        build_ms = build_ms.min(start.elapsed().as_secs_f64() * 1e3);
    }
    print!(
        "{{\"tris\":{count},\"threads\":{threads},\"build_ms\":{build_ms:.2},\"bytes_per_tri\":{:.1},\"tree\":\"{:?}\"",
        tree.memory_bytes() as f64 / count as f64,
        tree.statistics()
    );
    let scene =
        SceneTree::build(&[Geometry::Instance { tree: Arc::new(tree), world_from_object: Placement::IDENTITY }]);
    for (letter, name, any, coherence) in [
        ('c', "camera", false, Coherence::Coherent),
        ('s', "shadow", true, Coherence::Coherent),
        ('d', "diffuse", false, Coherence::Incoherent),
    ] {
        if !queries.contains(letter) {
            continue;
        }
        let rays = rays(&format!("{prefix}.{name}.rays"));
        let runs = (0..repeat).map(|_| measure(&scene, level, &rays, any, coherence, threads));
        let best = runs.max_by(|a, b| a.mrays_per_s.total_cmp(&b.mrays_per_s)).expect("one run");
        print!(",\"{name}\":{:.2},\"{name}_hits\":{},\"{name}_sum_t\":{:.3}", best.mrays_per_s, best.hits, best.sum_t);
    }
    println!("}}");
}
