//! How rays per second and memory grow with the number of triangles: a table, and a plot as SVG.
//!
//! `cargo run --release -p luch-verify --example growth -- docs/growth.svg`
//!
//! A bumpy sphere of 1,000 to 10,000,000 triangles is seen by 1024x768 camera rays; from what they hit go a shadow ray to
//! one light and a ray in a random direction. One thread, the best of three passes.

#![allow(missing_docs, clippy::print_stdout, reason = "a program for the terminal")]

use glam::Vec3;
use luch_render::accel::{Geometry, Level, MeshTree, Placement, SceneTree};
use luch_render::math::ray::{Coherence, HitBatch, Mask, Ray, RayBatch};
use luch_render::sampler::{Use, sample_pair};
use std::f32::consts::TAU;
use std::fmt::Write as _;
use std::sync::Arc;
use std::time::Instant;

const WIDTH: u32 = 1024;
const HEIGHT: u32 = 768;

/// One row of the table.
struct Row {
    triangles: usize,
    build_ms: f64,
    bytes_per_triangle: f64,
    /// Mray/s of camera, shadow and diffuse rays.
    rays: [f64; 3],
}

fn main() {
    let path = std::env::args().nth(1).expect("usage: growth OUT.svg");
    let rows: Vec<Row> = [1e3, 1e4, 1e5, 1e6, 1e7].into_iter().map(measure).collect();
    println!("| triangles | build, ms | bytes per triangle | camera | shadow | diffuse, Mray/s |");
    println!("|---|---|---|---|---|---|");
    for Row { triangles, build_ms, bytes_per_triangle, rays: [camera, shadow, diffuse] } in &rows {
        println!(
            "| {triangles} | {build_ms:.1} | {bytes_per_triangle:.0} | {camera:.1} | {shadow:.1} | {diffuse:.1} |"
        );
    }
    std::fs::write(&path, plot(&rows)).expect("the plot can be written");
}

fn measure(about: f64) -> Row {
    let (positions, triangles) = bumpy_sphere(about);
    let start = Instant::now();
    let tree = Arc::new(MeshTree::build(&positions, &triangles, 2));
    let build_ms = start.elapsed().as_secs_f64() * 1e3;
    let bytes_per_triangle = tree.memory_bytes() as f64 / triangles.len() as f64;
    let scene = SceneTree::build(&[Geometry::Instance { tree, world_from_object: Placement::IDENTITY }]);

    let camera = camera_rays();
    let mut hits = HitBatch::new();
    let level = Level::new();
    scene.closest_hits(level, &camera, Coherence::Coherent, &mut hits);
    let (mut shadow, mut diffuse) = (RayBatch::new(), RayBatch::new());
    for index in 0..camera.len() {
        if let Some(hit) = hits.get(index) {
            let [a, b, c] = triangles[hit.primitive as usize].map(|i| positions[i as usize]);
            let ray = camera.get(index);
            let normal = (b - a).cross(c - a).normalize_or_zero();
            let normal = if normal.dot(ray.direction) > 0.0 { -normal } else { normal };
            let origin = ray.at(hit.t) + normal * 1e-4;
            let to_light = Vec3::new(3.0, 4.0, 5.0) - origin;
            shadow.push(&Ray { t_max: 0.999, ..Ray::new(origin, to_light) });
            diffuse.push(&Ray::new(origin, bounce(normal, index as u32)));
        }
    }
    let mut mask = Mask::new();
    let rays = [
        best(camera.len(), || scene.closest_hits(level, &camera, Coherence::Coherent, &mut hits)),
        best(shadow.len(), || scene.occluded(level, &shadow, Coherence::Coherent, &mut mask)),
        best(diffuse.len(), || scene.closest_hits(level, &diffuse, Coherence::Incoherent, &mut hits)),
    ];
    Row { triangles: triangles.len(), build_ms, bytes_per_triangle, rays }
}

/// Million rays per second, the best of three passes.
fn best(rays: usize, mut pass: impl FnMut()) -> f64 {
    let seconds = (0..3).map(|_| {
        let start = Instant::now();
        pass();
        start.elapsed().as_secs_f64()
    });
    rays as f64 / seconds.fold(f64::INFINITY, f64::min) / 1e6
}

fn bumpy_sphere(about: f64) -> (Vec<Vec3>, Vec<[u32; 3]>) {
    let n = (about / 2.0).sqrt().round() as u32;
    let point = |i: u32, j: u32| {
        let (a, b) = (TAU / 2.0 * i as f32 / n as f32, TAU * j as f32 / n as f32);
        let ((sin_a, cos_a), (sin_b, cos_b)) = (libm::sincosf(a), libm::sincosf(b));
        let r = 1.0 + 0.1 * libm::sinf(13.0 * a) * libm::cosf(17.0 * b);
        Vec3::new(r * sin_a * cos_b, r * cos_a, r * sin_a * sin_b)
    };
    let positions = (0..=n).flat_map(|i| (0..n).map(move |j| point(i, j))).collect();
    let at = |i: u32, j: u32| i * n + j % n;
    let cells = (0..n).flat_map(|i| (0..n).map(move |j| (i, j)));
    let triangles = cells
        .flat_map(|(i, j)| [[at(i, j), at(i + 1, j), at(i, j + 1)], [at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)]])
        .collect();
    (positions, triangles)
}

/// Tiles of 8x8 pixels, row by row.
fn camera_rays() -> RayBatch {
    let mut rays = RayBatch::with_capacity((WIDTH * HEIGHT) as usize);
    for tile in (0..HEIGHT).step_by(8).flat_map(|y| (0..WIDTH).step_by(8).map(move |x| [x, y])) {
        for [x, y] in (0..8).flat_map(|y| (0..8).map(move |x| [tile[0] + x, tile[1] + y])) {
            let across = (x as f32 + 0.5) / WIDTH as f32 - 0.5;
            let along = 0.5 - (y as f32 + 0.5) / HEIGHT as f32;
            let direction = Vec3::new(across * 1.1, along * 1.1 * HEIGHT as f32 / WIDTH as f32, -1.0);
            rays.push(&Ray::new(Vec3::new(0.0, 0.0, 3.0), direction.normalize_or_zero()));
        }
    }
    rays
}

/// A direction on the normal's side, more often near it.
fn bounce(normal: Vec3, index: u32) -> Vec3 {
    let [u, v] = sample_pair(index, 0, 0, Use::Pixel);
    let (z, (sin, cos)) = (1.0 - 2.0 * u, libm::sincosf(TAU * v));
    let r = (1.0 - z * z).max(0.0).sqrt();
    (normal + Vec3::new(r * cos, r * sin, z) * 0.999).normalize_or_zero()
}

/// Mray/s over triangles, both in powers of ten.
fn plot(rows: &[Row]) -> String {
    const SERIES: [(&str, &str); 3] = [("camera", "#0072b2"), ("shadow", "#d55e00"), ("diffuse", "#009e73")];
    let x = |triangles: f64| 80.0 + (triangles.log10() - 3.0) / 4.0 * 500.0;
    let y = |rate: f64| 340.0 - rate.log10() / 2.5 * 300.0;
    let mut svg = String::from(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 700 400\" font-family=\"sans-serif\" font-size=\"14\">\n\
         <rect width=\"700\" height=\"400\" fill=\"white\"/>\n\
         <text x=\"330\" y=\"24\" text-anchor=\"middle\">Million rays per second, one thread</text>\n\
         <text x=\"330\" y=\"390\" text-anchor=\"middle\">triangles</text>\n",
    );
    let mut add = |line: String| writeln!(svg, "{line}").expect("a string takes all");
    for (power, name) in [(3, "1,000"), (4, "10,000"), (5, "100,000"), (6, "1,000,000"), (7, "10,000,000")] {
        let at = x(10_f64.powi(power));
        add(format!("<path d=\"M{at:.0} 40V340\" stroke=\"#ddd\"/>"));
        add(format!("<text x=\"{at:.0}\" y=\"362\" text-anchor=\"middle\">{name}</text>"));
    }
    for rate in [1.0, 3.0, 10.0, 30.0, 100.0, 300.0] {
        let at = y(rate);
        add(format!("<path d=\"M80 {at:.0}H580\" stroke=\"#ddd\"/>"));
        add(format!("<text x=\"70\" y=\"{:.0}\" text-anchor=\"end\">{rate}</text>", at + 5.0));
    }
    for (k, (name, color)) in SERIES.into_iter().enumerate() {
        let points: Vec<[f64; 2]> = rows.iter().map(|row| [x(row.triangles as f64), y(row.rays[k])]).collect();
        let line: Vec<String> = points.iter().map(|[x, y]| format!("{x:.1},{y:.1}")).collect();
        add(format!("<polyline points=\"{}\" fill=\"none\" stroke=\"{color}\" stroke-width=\"2\"/>", line.join(" ")));
        for [x, y] in &points {
            add(format!("<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"4\" fill=\"{color}\"/>"));
        }
        if let Some([x, y]) = points.last() {
            add(format!("<text x=\"{:.0}\" y=\"{:.0}\" fill=\"{color}\">{name}</text>", x + 10.0, y + 5.0));
        }
    }
    add("</svg>".to_owned());
    svg
}
