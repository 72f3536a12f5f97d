//! The account of a pixel: every ray, every hit and every term that made its colour.
//!
//! [`explain`] traces the samples of one pixel by the code that makes the picture, which somebody looks over the
//! shoulder, so the account's sum is the picture's pixel bit for bit ([`PixelAccount::sum`] adds it up again from the
//! numbers shown).

mod account;
mod assembly;
mod light;
mod lit_group;
mod recorder;
mod segment;
mod sum;
mod surface;
mod walk;

pub use crate::accel::Query;
pub use account::{Blocker, LightSource, PixelAccount, RayAccount, RayEnd, RayKind, SampleAccount, Setting, Spread};
pub use light::{LightAccount, LightFactors, Visibility};
pub use segment::Segment;
pub use surface::{Face, Side, Square, SurfaceAccount};
pub(crate) use walk::counts;
pub use walk::{BOX_EDGES, BoxVisit, ShapeTest, Walk, walk};

use crate::compiled::CompiledScene;
use crate::integrator::classic::Waves;
use crate::integrator::{Colors, Integrator, Lens, Orders, PixelList};
use crate::math::ray::RayBatch;
use crate::session::RenderJob;
use luch_scene::ImageSize;
use recorder::Recorder;
use std::fmt;

/// Why a pixel is not explained.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ExplainError {
    /// There is no such pixel.
    OutsidePicture {
        /// The column that was asked for.
        x: u32,
        /// The row that was asked for.
        y: u32,
        /// The picture's size.
        size: ImageSize,
    },
    /// Its rays and lights are more than [`MOST_ENTRIES`].
    TooManyRays,
    /// Somebody asked to stop.
    Stopped,
}

impl fmt::Display for ExplainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::OutsidePicture { x, y, size } => {
                let (width, height) = (size.width(), size.height());
                let (right, bottom) = (width - 1, height - 1);
                write!(
                    f,
                    "the pixel {x},{y} lies outside the picture of {width}x{height} pixels: columns go from 0 to \
                     {right}, rows from 0 to {bottom}"
                )
            }
            Self::TooManyRays => write!(
                f,
                "the account of this pixel would have more than {MOST_ENTRIES} entries: take fewer rays per pixel, a \
                 smaller depth or fewer lights"
            ),
            Self::Stopped => write!(f, "stopped"),
        }
    }
}

impl std::error::Error for ExplainError {}

/// The most rays and lights at surfaces that an account has, together: about half a gigabyte.
pub const MOST_ENTRIES: usize = 4_000_000;

/// Explains the pixel at column `x` and row `y` of the whole picture of a job, crop or not.
///
/// The account is always that of the classic integrator. It takes about a microsecond a ray, and memory as
/// [`PixelAccount::memory_bytes`] says: some 300 bytes a ray.
///
/// # Errors
/// [`ExplainError`].
pub fn explain(scene: &CompiledScene, job: &RenderJob, x: u32, y: u32) -> Result<PixelAccount, ExplainError> {
    explain_unless(scene, job, [x, y], &|| false)
}

/// As [`explain`], unless `stop` says so: it is asked a few times for each depth of mirrors.
///
/// # Errors
/// [`ExplainError`].
pub fn explain_unless(
    scene: &CompiledScene,
    job: &RenderJob,
    [x, y]: [u32; 2],
    stop: &dyn Fn() -> bool,
) -> Result<PixelAccount, ExplainError> {
    let size = job.size;
    if x >= size.width() || y >= size.height() {
        return Err(ExplainError::OutsidePicture { x, y, size });
    }
    let level = job.simd.level_or_best();
    let lens = Lens::new(&job.camera, size, job.antialiasing.on, job.depth_of_field.on);
    let mut pixel = PixelList::default();
    pixel.set(std::iter::once([x, y]));
    let samples = job.rays_per_pixel();
    let (mut rays, mut one) = (RayBatch::with_capacity(samples as usize), RayBatch::new());
    for sample in 0..samples {
        lens.rays(level, &pixel, sample, &mut one);
        rays.push(&one.get(0));
    }
    let mut recorder = Recorder::new(scene, level, MOST_ENTRIES);
    let orders = Orders { scene, level, integrator: Integrator::Classic, depth: job.depth, stop };
    let mut waves = Waves::default();
    if waves.trace_before(&mut recorder, &orders, &mut rays, &mut Colors::default(), None).is_none() {
        return Err(if recorder.full { ExplainError::TooManyRays } else { ExplainError::Stopped });
    }
    Ok(assembly::assemble(scene, job, [x, y], &lens, &recorder))
}
