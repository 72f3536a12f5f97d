//! `luch bench rays`: how many rays a second one mesh answers.

use crate::args::{BenchRaysArgs, Query};
use crate::clock::{Stopwatch, milliseconds};
use crate::exit::{Code, Failure};
use crate::signals::Watch;
use crate::{meaning, output, source};
use glam::Vec3;
use luch_render::SimdLevel;
use luch_render::accel::{self, Geometry, Level, MeshTree, Placement, SceneTree};
use luch_render::math::ray::{Coherence, HitBatch, Mask, Ray, RayBatch};
use serde::Serialize;
use std::fs::File;
use std::io::Read;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::{Duration, Instant};

/// Rays that a thread takes at a time.
const BATCH: usize = 4096;
/// Bytes of a ray in a file: eight f32.
const RAY_BYTES: usize = 32;
/// The largest ray file: what it takes in memory is twice that.
const MAX_FILE: u64 = 8 << 30;

#[derive(Debug, Serialize)]
struct Figures {
    tris: usize,
    build_ms: f64,
    rays: usize,
    hits: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    sum_t: Option<f64>,
    mrays_per_s: f64,
    threads: usize,
    simd: &'static str,
}

pub(crate) fn run(args: &BenchRaysArgs, watch: &Watch) -> Result<(), Failure> {
    let simd = meaning::available(args.simd)?.resolved();
    let threads = meaning::threads(args.threads);
    let batches = read_rays(&args.rays)?;
    let mesh = source::mesh(&args.mesh, watch)?;

    let building = Stopwatch::start();
    let tree = Arc::new(MeshTree::build(mesh.positions(), mesh.triangles(), threads));
    let scene = SceneTree::build(&[Geometry::Instance { tree, world_from_object: Placement::IDENTITY }]);
    let build_ms = building.wall_ms();

    let coherence = if args.coherent { Coherence::Coherent } else { Coherence::Incoherent };
    let job = Job { scene: &scene, level: level_of(simd)?, coherence, query: args.query, batches: &batches };
    // Asked once without the clock: it warms the caches and gives the sums.
    let sum_t = (args.query == Query::Closest).then(|| job.sum_of_t());
    let mut best = Duration::MAX;
    let mut hits = 0;
    for _ in 0..args.repeat {
        watch.check()?;
        let begin = Instant::now();
        hits = job.ask(threads);
        best = best.min(begin.elapsed());
    }
    let rays: usize = batches.iter().map(RayBatch::len).sum();
    let mrays_per_s = (rays as f64 / best.as_secs_f64().max(1e-9) / 1e3).round() / 1e3;
    let tris = mesh.triangles().len();
    report(&Figures { tris, build_ms, rays, hits, sum_t, mrays_per_s, threads, simd: simd.word() }, best, args.json)
}

fn report(figures: &Figures, best: Duration, json: bool) -> Result<(), Failure> {
    if json {
        return output::json(figures);
    }
    let Figures { tris, build_ms, rays, hits, sum_t, mrays_per_s, threads, simd } = figures;
    let sum_t = sum_t.map(|t| format!("sum of t     {t}\n")).unwrap_or_default();
    let best = milliseconds(best);
    output::result(&format!(
        "triangles    {tris}\nbuild        {build_ms} ms\nrays         {rays}\nhits         {hits}\n{sum_t}\
         best repeat  {best} ms, {mrays_per_s} Mray/s on {threads} threads with {simd}\n"
    ))
}

/// The kernels' name for a level.
fn level_of(simd: SimdLevel) -> Result<Level, Failure> {
    let known = accel::available_levels().into_iter().find(|(name, _)| *name == simd.word());
    known.map(|(_, level)| level).ok_or_else(|| Failure::usage(format!("--simd {}: no kernels for it", simd.word())))
}

/// Everything that is asked.
struct Job<'a> {
    scene: &'a SceneTree,
    level: Level,
    coherence: Coherence,
    query: Query,
    batches: &'a [RayBatch],
}

impl Job<'_> {
    /// Asks every batch once and counts the hits.
    fn ask(&self, threads: usize) -> u64 {
        let next = AtomicUsize::new(0);
        let work = || {
            let (mut hits, mut mask, mut count) = (HitBatch::new(), Mask::new(), 0);
            while let Some(batch) = self.batches.get(next.fetch_add(1, Ordering::Relaxed)) {
                count += self.ask_batch(batch, &mut hits, &mut mask);
            }
            count
        };
        if threads == 1 {
            return work();
        }
        thread::scope(|scope| {
            let name = |number: usize| format!("luch-rays-{number}");
            let spawn = |number| thread::Builder::new().name(name(number)).spawn_scoped(scope, work).ok();
            // A thread that the system does not give, or that panicked, leaves its share to this one.
            let helpers: Vec<_> = (1..threads).map_while(spawn).collect();
            let own = work();
            helpers.into_iter().filter_map(|helper| helper.join().ok()).fold(own, |sum, count| sum + count)
        })
    }

    fn ask_batch(&self, batch: &RayBatch, hits: &mut HitBatch, mask: &mut Mask) -> u64 {
        match self.query {
            Query::Closest => {
                self.scene.closest_hits(self.level, batch, self.coherence, hits);
                hits.t.iter().filter(|t| t.is_finite()).count() as u64
            }
            Query::Any => {
                self.scene.occluded(self.level, batch, self.coherence, mask);
                mask.count() as u64
            }
        }
    }

    /// The sum of the hits' t in the order of the rays.
    fn sum_of_t(&self) -> f64 {
        let mut hits = HitBatch::new();
        let mut sum = 0.0;
        for batch in self.batches {
            self.scene.closest_hits(self.level, batch, self.coherence, &mut hits);
            sum += hits.t.iter().filter(|t| t.is_finite()).map(|&t| f64::from(t)).sum::<f64>();
        }
        sum
    }
}

/// Reads a ray file into batches.
fn read_rays(path: &Path) -> Result<Vec<RayBatch>, Failure> {
    let bytes = read_file(path)?;
    let wrong = |text: String| Failure::new(Code::Malformed, format!("{}: {text}", path.display()));
    if bytes.is_empty() || bytes.len() % RAY_BYTES != 0 {
        let text = format!("{} bytes are no rays: each takes {RAY_BYTES}, and there is at least one", bytes.len());
        return Err(wrong(text).hint("a ray is ox oy oz dx dy dz tmin tmax, each a little-endian f32"));
    }
    let mut batches = Vec::with_capacity(bytes.len().div_ceil(BATCH * RAY_BYTES));
    for (number, chunk) in bytes.chunks(BATCH * RAY_BYTES).enumerate() {
        let mut batch = RayBatch::with_capacity(BATCH);
        for (index, ray) in chunk.chunks_exact(RAY_BYTES).enumerate() {
            let index = number * BATCH + index;
            batch.push(&ray_of(ray).map_err(|text| wrong(format!("byte {}: ray {index} {text}", index * RAY_BYTES)))?);
        }
        batches.push(batch);
    }
    Ok(batches)
}

/// The ray of 32 bytes.
fn ray_of(bytes: &[u8]) -> Result<Ray, &'static str> {
    let mut numbers = [0.0_f32; 8];
    for (number, four) in numbers.iter_mut().zip(bytes.as_chunks::<4>().0) {
        *number = f32::from_le_bytes(*four);
    }
    let [ox, oy, oz, dx, dy, dz, t_min, t_max] = numbers;
    // An endless ray may say so.
    if !numbers[..7].iter().all(|n| n.is_finite()) || t_max.is_nan() {
        return Err("has a number that is not finite");
    }
    if [dx, dy, dz] == [0.0; 3] {
        return Err("has no direction");
    }
    if t_min < 0.0 {
        return Err("begins behind its origin");
    }
    Ok(Ray { origin: Vec3::new(ox, oy, oz), direction: Vec3::new(dx, dy, dz), t_min, t_max })
}

fn read_file(path: &Path) -> Result<Vec<u8>, Failure> {
    let name = path.display();
    let forbidden = |e: std::io::Error| Failure::new(Code::Forbidden, format!("{name}: cannot be read: {e}"));
    // Asked before opening: opening a FIFO would wait for a writer for ever.
    let metadata = std::fs::metadata(path).map_err(forbidden)?;
    if !metadata.is_file() {
        return Err(Failure::new(Code::Forbidden, format!("{name}: is not a regular file")));
    }
    if metadata.len() > MAX_FILE {
        return Err(Failure::new(Code::Limit, format!("{name}: is larger than 8 GiB")));
    }
    let mut bytes = Vec::new();
    File::open(path).and_then(|file| file.take(MAX_FILE).read_to_end(&mut bytes)).map_err(forbidden)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn bytes(numbers: [f32; 8]) -> Vec<u8> {
        numbers.iter().flat_map(|n| n.to_le_bytes()).collect()
    }

    #[test]
    fn rays_are_read_in_order() {
        let ray = ray_of(&bytes([1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 0.5, f32::INFINITY])).unwrap();
        assert_eq!((ray.origin, ray.direction), (Vec3::new(1.0, 2.0, 3.0), Vec3::new(4.0, 5.0, 6.0)));
        assert_eq!((ray.t_min, ray.t_max), (0.5, f32::INFINITY));
    }

    #[test]
    fn rays_that_are_none() {
        for place in 0..8 {
            let mut numbers = [1.0; 8];
            numbers[place] = f32::NAN;
            assert!(ray_of(&bytes(numbers)).is_err(), "{place}");
        }
        assert!(ray_of(&bytes([0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0])).is_err(), "no direction");
        assert!(ray_of(&bytes([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, -1.0, 1.0])).is_err(), "behind the origin");
    }
}
