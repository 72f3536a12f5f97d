//! Makes the pictures of docs/explain.md: the scene with the pixels marked, and their rays from above.
//!
//! `cargo run --release -p luch-explain --example lesson -- docs/explain`; the heat maps beside them are made by
//! `luch render knight --size 480x360 --color-bar --integrator nodes -o docs/explain/nodes.png`, and `triangles` alike.

#![forbid(unsafe_code)]

mod marks;
mod top_view;

use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::{Metadata, Pixels, Report, SceneSource, linear_hash, load_scene, write_png};
use luch_render::explain::explain;
use luch_render::film::tonemap::srgb8;
use luch_render::{MeshTrees, Progress, RenderJob, compile, render};
use luch_scene::{ImageSize, RayCount, Sampling};
use std::error::Error;
use std::path::PathBuf;

/// The pixels of the lesson, in a picture of 960 x 720.
const PIXELS: [[u32; 2]; 3] = [[186, 240], [404, 348], [490, 500]];
/// The size of the picture that shows where they are.
const SHOWN: [u32; 2] = [640, 480];

fn main() -> Result<(), Box<dyn Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("usage: lesson FOLDER")?);
    std::fs::create_dir_all(&folder)?;
    let source = SceneSource::BuiltIn("two-spheres");
    let scene = load_scene(&source, &mut MeshLibrary::new(), &mut Budget::default(), &mut Report::default())?;
    let compiled = compile(&scene, &mut MeshTrees::new(), 2);

    let job = RenderJob::of_scene(&scene, 0);
    // The first has one ray and needs no picture.
    for (number, [x, y]) in (1..).zip(PIXELS).skip(1) {
        let account = explain(&compiled, &job, x, y)?;
        std::fs::write(folder.join(format!("rays-{number}.svg")), top_view::draw(&account, &scene))?;
    }

    let shown = RenderJob {
        size: ImageSize::new(SHOWN[0], SHOWN[1])?,
        antialiasing: Sampling { on: true, rays: RayCount::new(64)? },
        threads: 2,
        ..job.clone()
    };
    let linear = render(&compiled, &shown, &Progress::new())?.linear();
    let mut bytes = srgb8(&linear);
    for (number, [x, y]) in (1..).zip(PIXELS) {
        let place = [x * SHOWN[0] / job.size.width(), y * SHOWN[1] / job.size.height()];
        marks::mark(&mut bytes, SHOWN, place, number);
    }
    let metadata = Metadata { title: scene.name.clone(), settings: String::new(), hash: linear_hash(&linear) };
    write_png(&folder.join("pixels.png"), SHOWN[0], SHOWN[1], Pixels::Rgb8(&bytes), &metadata)?;
    Ok(())
}
