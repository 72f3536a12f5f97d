//! What `luch render`'s arguments mean: checks that need no scene at once, the rest as edits of the scene and a job.

use crate::args::{Bits, PictureArgs, RenderArgs};
use crate::exit::{Code, Failure};
use crate::shot::Shot;
use luch_io::PictureFormat;
use luch_render::{Crop, Integrator, RenderJob, SimdLevel};
use luch_scene::{ImageSize, Scene};
use std::path::{Path, PathBuf};

/// A kind of picture file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Format {
    Png8,
    Png16,
    Exr,
}

/// Where the figures of a render go.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum Stats {
    Nowhere,
    Stdout,
    File(PathBuf),
}

/// A render as it was asked for, right but for what only the scene can tell.
#[derive(Debug)]
pub(crate) struct Request {
    pub(crate) scene: PathBuf,
    pub(crate) output: PathBuf,
    pub(crate) format: Format,
    pub(crate) stats: Stats,
    pub(crate) threads: usize,
    pub(crate) simd: SimdLevel,
    pub(crate) memory: Option<u64>,
    pub(crate) quiet: bool,
    pub(crate) color_bar: bool,
    pub(crate) shot: Shot,
    picture: PictureArgs,
}

impl Request {
    /// Checks everything that needs no scene, so that nobody waits for a picture that cannot be written.
    ///
    /// # Errors
    /// Usage, or an output that cannot be written.
    pub(crate) fn of(args: RenderArgs) -> Result<Self, Failure> {
        let RenderArgs { scene, output, frame, picture, camera, edits, work } = args;
        let format = format_of(&output, picture.bits)?;
        check_color_bar(&picture, format)?;
        let stats = match work.stats {
            None => Stats::Nowhere,
            Some(path) if path == output => return Err(Failure::usage("--stats and --output name the same place")),
            Some(path) if path == Path::new("-") => Stats::Stdout,
            Some(path) => Stats::File(path),
        };
        Ok(Self {
            scene,
            output,
            format,
            stats,
            threads: threads(work.machine.threads),
            simd: available(work.machine.simd)?,
            memory: work.machine.memory,
            quiet: work.quiet,
            color_bar: picture.color_bar,
            shot: Shot { frame, camera, edits },
            picture,
        })
    }

    /// The files that will be written.
    pub(crate) fn outputs(&self) -> impl Iterator<Item = &Path> {
        let stats = if let Stats::File(path) = &self.stats { Some(path.as_path()) } else { None };
        [self.output.as_path()].into_iter().chain(stats)
    }

    /// What the picture shows.
    pub(crate) const fn integrator(&self) -> Integrator {
        self.picture.integrator
    }

    /// The job, its crop inside the picture.
    ///
    /// # Errors
    /// Usage, if the crop reaches out of the picture.
    pub(crate) fn job(&self, scene: &Scene, camera: usize) -> Result<RenderJob, Failure> {
        let mut job = RenderJob::of_scene(scene, camera);
        if let Some(part) = self.picture.crop {
            let crop = Crop { x: part.x, y: part.y, width: part.width, height: part.height };
            if crop.within(job.size) != Some(crop) {
                return Err(crop_outside(crop, job.size));
            }
            job.crop = Some(crop);
        }
        job.integrator = self.picture.integrator;
        job.threads = self.threads;
        job.simd = self.simd;
        Ok(job)
    }
}

/// The threads asked for, or as many as the machine has.
pub(crate) fn threads(asked: Option<u32>) -> usize {
    match asked {
        Some(count) => count as usize,
        None => std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
    }
}

/// The level asked for, if this machine has it.
///
/// # Errors
/// Usage, with the levels that it has.
pub(crate) fn available(level: SimdLevel) -> Result<SimdLevel, Failure> {
    if level.is_available() {
        return Ok(level);
    }
    let words: Vec<&str> = SimdLevel::available().into_iter().map(SimdLevel::word).collect();
    Err(Failure::usage(format!("--simd {}: this machine cannot run it", level.word()))
        .hint(format!("it can run auto, {}", words.join(", "))))
}

fn format_of(output: &Path, bits: Option<Bits>) -> Result<Format, Failure> {
    let refused = |e: luch_io::Error| Failure { code: Code::Usage, ..Failure::from(e) };
    match (PictureFormat::of(output).map_err(refused)?, bits) {
        (PictureFormat::Png, None | Some(Bits::Eight)) => Ok(Format::Png8),
        (PictureFormat::Png, Some(Bits::Sixteen)) => Ok(Format::Png16),
        (PictureFormat::Exr, None) => Ok(Format::Exr),
        (PictureFormat::Exr, Some(_)) => {
            Err(Failure::usage("--bits is for PNG: an EXR picture always has 32 bits for each colour"))
        }
    }
}

/// The scale is for counts, and is drawn as a screen shows it.
fn check_color_bar(picture: &PictureArgs, format: Format) -> Result<(), Failure> {
    if picture.color_bar && !picture.integrator.shows_counts() {
        let word = picture.integrator.word();
        return Err(Failure::usage(format!("--color-bar: --integrator {word} shows no counts"))
            .hint("use it with --integrator nodes or --integrator triangles"));
    }
    if picture.color_bar && format == Format::Exr {
        return Err(Failure::usage("--color-bar is for PNG: an EXR picture holds nothing but the picture's own light"));
    }
    Ok(())
}

fn crop_outside(crop: Crop, size: ImageSize) -> Failure {
    let Crop { x, y, width, height } = crop;
    let picture = format!("{}x{}", size.width(), size.height());
    Failure::usage(format!("--crop {x},{y},{width},{height} reaches out of the picture, which has {picture} pixels"))
        .hint("X + W may be the width at most, and Y + H the height")
}
