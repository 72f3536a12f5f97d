//! `luch render`: load, change, build, render, write.

use crate::clock::Stopwatch;
use crate::exit::{Code, Failure};
use crate::meaning::{Format, Request, Stats};
use crate::output;
use crate::progress::{Meter, Stages};
use crate::signals::Watch;
use crate::source::{self, Loaded};
use luch_io::atomic_save::save;
use luch_io::{Metadata, PictureSettings, Pixels, check_writable, linear_hash, write_exr, write_png};
use luch_render::film::color_bar;
use luch_render::film::tonemap::{srgb8, srgb16};
use luch_render::{Film, MeshTrees, Progress, RenderError, RenderJob, compile, render};
use luch_scene::Scene;
use serde::Serialize;
use std::borrow::Cow;
use std::io;
use std::path::Path;
use std::sync::Arc;

/// What `--stats` tells. The keys are a fixed contract.
#[derive(Debug, Serialize)]
struct Figures {
    width: u32,
    height: u32,
    rays_per_pixel: u32,
    threads: usize,
    simd: &'static str,
    load_ms: f64,
    build_ms: f64,
    render_ms: f64,
    cpu_ms: Option<f64>,
    rays: u64,
    rays_per_s: f64,
    triangles: u64,
    hash: String,
}

pub(crate) fn run(request: &Request, watch: &Watch) -> Result<(), Failure> {
    request.outputs().try_for_each(check_writable)?;
    let stages = Stages::new(request.quiet);

    let loading = Stopwatch::start();
    let load = || source::load(&request.scene, request.memory, watch);
    // A load that was stopped fails as the signal that stopped it.
    let loaded = stages.during("loading", None, load).map_err(|failure| watch.check().err().unwrap_or(failure));
    let Loaded { mut scene, warnings, mut budget } = loaded?;
    let load_ms = loading.wall_ms();

    let camera = request.shot.apply(&mut scene)?;
    let job = request.job(&scene, camera)?;
    budget.charge("the picture", job.memory_bytes()).map_err(|over| over.in_file(&request.output))?;
    if !request.quiet {
        warnings.iter().chain(&request.shot.advice(&job)).for_each(|line| output::warning(line));
    }

    let building = Stopwatch::start();
    let build = || compile(&scene, &mut MeshTrees::new(), request.threads);
    let compiled = stages.during("building", None, build);
    let build_ms = building.wall_ms();

    let rendering = Stopwatch::start();
    let progress = Arc::new(Progress::new());
    let work = || stages.during("rendering", Some(Meter::Render(&progress)), || render(&compiled, &job, &progress));
    let outcome = watch.rendering(&progress, work)?;
    let (render_ms, cpu_ms) = (rendering.wall_ms(), rendering.cpu_ms());
    // A render stopped by the user fails as the signal that stopped it.
    watch.check()?;
    let film = outcome.map_err(|error| failed(&error))?;

    let linear = film.linear();
    let figures = Figures {
        width: film.width(),
        height: film.height(),
        rays_per_pixel: job.rays_per_pixel(),
        threads: request.threads,
        simd: request.simd.resolved().word(),
        load_ms,
        build_ms,
        render_ms,
        cpu_ms,
        rays: progress.rays(),
        rays_per_s: (progress.rays() as f64 / (render_ms / 1e3).max(1e-9)).round(),
        triangles: compiled.triangles(),
        hash: linear_hash(&linear),
    };
    let metadata = metadata(&scene, &job, request.color_bar, &figures.hash);
    let write = || write_all(request, &film, &linear, &metadata, &figures);
    watch.writing(request.outputs(), || stages.during("writing", None, write))?
}

fn failed(error: &RenderError) -> Failure {
    let code = if matches!(error, RenderError::Internal { .. }) { Code::Internal } else { Code::Render };
    Failure::new(code, error.to_string())
}

fn metadata(scene: &Scene, job: &RenderJob, color_bar: bool, hash: &str) -> Metadata {
    let settings = PictureSettings {
        camera: &job.camera.name,
        size: [job.size.width(), job.size.height()],
        crop: job.crop.map(|c| [c.x, c.y, c.width, c.height]),
        rays_per_pixel: job.rays_per_pixel(),
        antialiasing: job.antialiasing.on,
        depth_of_field: job.depth_of_field.on,
        depth: job.depth,
        integrator: job.integrator.word(),
        color_bar,
    };
    settings.metadata(&scene.name, hash)
}

/// Writes the picture and the figures: both, or neither.
fn write_all(
    request: &Request,
    film: &Film,
    linear: &[f32],
    metadata: &Metadata,
    figures: &Figures,
) -> Result<(), Failure> {
    let picture = || write_picture(request, film, linear, metadata);
    match &request.stats {
        Stats::Nowhere => picture(),
        // First, for a reader that has gone away is a failure, and a failed run leaves no picture.
        Stats::Stdout => output::json(figures).and_then(|()| picture()),
        Stats::File(path) => write_with_stats(path, figures, picture),
    }
}

/// Writes the figures beside their place, then the picture, then puts the figures in their place.
fn write_with_stats(
    path: &Path,
    figures: &Figures,
    picture: impl FnOnce() -> Result<(), Failure>,
) -> Result<(), Failure> {
    let text = output::to_json(figures)?;
    let mut failure = None;
    let saved = save(path, |file| {
        file.write_all(text.as_bytes())?;
        picture().map_err(|f| {
            failure = Some(f);
            io::Error::other("no picture")
        })
    });
    match failure {
        Some(failure) => Err(failure),
        None => Ok(saved?),
    }
}

fn write_picture(request: &Request, film: &Film, linear: &[f32], metadata: &Metadata) -> Result<(), Failure> {
    let (path, height) = (request.output.as_path(), film.height());
    let mut width = film.width();
    let mut shown = Cow::Borrowed(linear);
    if request.color_bar {
        let (wider, with_bar) = color_bar::beside(linear, [width, height], request.integrator().word());
        (width, shown) = (wider, Cow::Owned(with_bar));
    }
    match request.format {
        Format::Png8 => write_png(path, width, height, Pixels::Rgb8(&srgb8(&shown)), metadata)?,
        Format::Png16 => write_png(path, width, height, Pixels::Rgb16(&srgb16(&shown)), metadata)?,
        Format::Exr => write_exr(path, width, height, linear, metadata)?,
    }
    Ok(())
}
