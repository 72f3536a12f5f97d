//! A picture made for a file, with threads of its own, while one goes on working.

use super::task::Task;
use egui::Context;
use luch_io::budget::Budget;
use luch_io::{
    Error, Metadata, PictureFormat, PictureSettings, Pixels, check_writable, linear_hash, write_exr, write_png,
};
use luch_render::film::color_bar;
use luch_render::film::tonemap::{srgb8, srgb16};
use luch_render::{Film, MeshTrees, Progress, RenderError, RenderJob, compile, render};
use luch_scene::{ImageSize, Sampling, Scene};
use std::borrow::Cow;
use std::path::{Path, PathBuf};
use std::sync::{Arc, OnceLock};
use std::time::{Duration, Instant};

/// A kind of picture file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum PictureKind {
    Png8,
    Png16,
    Exr,
}

impl PictureKind {
    pub(crate) const ALL: [Self; 3] = [Self::Png8, Self::Png16, Self::Exr];

    pub(crate) const fn ending(self) -> &'static str {
        match self {
            Self::Png8 | Self::Png16 => "png",
            Self::Exr => "exr",
        }
    }

    /// The kind that a path's ending names; `None` for another ending.
    pub(crate) fn of(path: &Path, sixteen_bits: bool) -> Option<Self> {
        Some(match PictureFormat::of(path).ok()? {
            PictureFormat::Exr => Self::Exr,
            PictureFormat::Png if sixteen_bits => Self::Png16,
            PictureFormat::Png => Self::Png8,
        })
    }

    /// Bytes that the pixel of a file takes until it is written.
    const fn bytes_per_pixel(self) -> u64 {
        match self {
            Self::Png8 => 3,
            Self::Png16 | Self::Exr => 12,
        }
    }
}

/// The picture that is wanted, as far as it does not depend on the scene.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ExportForm {
    pub(crate) path: PathBuf,
    pub(crate) kind: PictureKind,
    pub(crate) size: ImageSize,
    pub(crate) antialiasing: Sampling,
    pub(crate) depth_of_field: Sampling,
    /// Whether a file that is there may be replaced.
    pub(crate) replace: bool,
}

impl ExportForm {
    /// Bytes that the picture takes while it is made.
    fn bytes(kind: PictureKind, job: &RenderJob) -> u64 {
        job.memory_bytes().saturating_add(job.size.pixels().saturating_mul(kind.bytes_per_pixel()))
    }

    /// Bytes that a picture would take and that there are, if that is not enough.
    pub(crate) fn too_large(kind: PictureKind, job: &RenderJob) -> Option<[u64; 2]> {
        static LIMIT: OnceLock<u64> = OnceLock::new();
        let limit = *LIMIT.get_or_init(|| Budget::default().limit());
        let needed = Self::bytes(kind, job);
        (needed > limit).then_some([needed, limit])
    }
}

/// A picture on its way to a file.
#[derive(Debug)]
pub(crate) struct Export {
    task: Task<ExportEnd>,
    progress: Arc<Progress>,
    began: Instant,
    form: ExportForm,
    /// Whether the dialog that asked for it is done.
    pub(crate) dismissed: bool,
}

/// What came of it.
#[derive(Debug)]
pub(crate) enum ExportEnd {
    Written,
    Cancelled,
    /// There is a file already, and nobody said that it may be replaced.
    Exists,
    /// The file is at fault.
    Failed(Error),
    /// A thread panicked: a bug, told with what it said.
    Internal(String),
}

impl Export {
    /// Starts to make the picture of a job.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn start(scene: Arc<Scene>, job: RenderJob, form: ExportForm, ctx: &Context) -> std::io::Result<Self> {
        let progress = Arc::new(Progress::new());
        let (watched, wanted) = (Arc::clone(&progress), form.clone());
        let task = Task::start("luch-export", ctx, move || {
            make(&scene, &job, &wanted, &watched).unwrap_or_else(ExportEnd::Failed)
        })?;
        Ok(Self { task, progress, began: Instant::now(), form, dismissed: false })
    }

    pub(crate) const fn form(&self) -> &ExportForm {
        &self.form
    }

    /// How much is done, from 0 to 1; `None` before the first ray.
    pub(crate) fn share(&self) -> Option<f32> {
        let total = self.progress.total();
        (total > 0).then(|| self.progress.done() as f32 / total as f32)
    }

    pub(crate) fn elapsed(&self) -> Duration {
        self.began.elapsed()
    }

    /// Asks it to stop; it does within a few milliseconds unless the file is being written.
    pub(crate) fn cancel(&self) {
        self.progress.cancel();
    }

    /// Whether there is something to say of it.
    pub(crate) fn is_done(&self) -> bool {
        self.task.is_done()
    }

    /// What came of it.
    pub(crate) fn into_end(self) -> ExportEnd {
        self.task.finish().unwrap_or_else(ExportEnd::Internal)
    }

    /// Stops it and waits until it has stopped.
    pub(crate) fn end(self) {
        self.cancel();
        self.task.wait();
    }
}

/// Makes the picture and writes it, as `luch render` does.
fn make(scene: &Scene, job: &RenderJob, form: &ExportForm, progress: &Progress) -> Result<ExportEnd, Error> {
    let path = &form.path;
    if !form.replace && path.exists() {
        return Ok(ExportEnd::Exists);
    }
    check_writable(path)?;
    let bytes = ExportForm::bytes(form.kind, job);
    Budget::default().charge("the picture", bytes).map_err(|over| over.in_file(path))?;
    let compiled = compile(scene, &mut MeshTrees::new(), job.threads);
    let film = match render(&compiled, job, progress) {
        Ok(film) => film,
        Err(RenderError::Cancelled) => return Ok(ExportEnd::Cancelled),
        Err(error) => return Ok(ExportEnd::Internal(error.to_string())),
    };
    write(&film, scene, job, form)?;
    Ok(ExportEnd::Written)
}

fn write(film: &Film, scene: &Scene, job: &RenderJob, form: &ExportForm) -> Result<(), Error> {
    let linear = film.linear();
    let (path, mut width, height) = (&form.path, film.width(), film.height());
    // Counts mean nothing without their scale; an EXR file holds the picture's own numbers.
    let color_bar = job.integrator.shows_counts() && form.kind != PictureKind::Exr;
    let metadata = metadata(scene, job, color_bar, &linear_hash(&linear));
    let mut shown = Cow::Borrowed(&linear);
    if color_bar {
        let (wider, with_bar) = color_bar::beside(&linear, [width, height], job.integrator.word());
        (width, shown) = (wider, Cow::Owned(with_bar));
    }
    match form.kind {
        PictureKind::Png8 => write_png(path, width, height, Pixels::Rgb8(&srgb8(&shown)), &metadata),
        PictureKind::Png16 => write_png(path, width, height, Pixels::Rgb16(&srgb16(&shown)), &metadata),
        PictureKind::Exr => write_exr(path, width, height, &linear, &metadata),
    }
}

fn metadata(scene: &Scene, job: &RenderJob, color_bar: bool, hash: &str) -> Metadata {
    let settings = PictureSettings {
        camera: &job.camera.name,
        size: [job.size.width(), job.size.height()],
        crop: None,
        rays_per_pixel: job.rays_per_pixel(),
        antialiasing: job.antialiasing.on,
        depth_of_field: job.depth_of_field.on,
        depth: job.depth,
        integrator: job.integrator.word(),
        color_bar,
    };
    settings.metadata(&scene.name, hash)
}
