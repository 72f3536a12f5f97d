//! A picture as far as it has come.

use super::mailbox::Epoch;
use super::objects::ObjectMap;
use crate::compiled::CompiledScene;
use crate::film::Film;
use crate::session::job::RenderJob;
use luch_scene::Scene;
use std::fmt;
use std::sync::Arc;
use std::time::Duration;

/// A picture as far as it has come, with all that it was made from. It never changes.
pub struct Snapshot {
    /// The request that it answers.
    pub epoch: Epoch,
    /// What is seen.
    pub scene: Arc<Scene>,
    /// The same, ready for rays.
    pub compiled: Arc<CompiledScene>,
    /// How it is seen; without a crop.
    pub job: RenderJob,
    /// Pixels of the full picture along the side of the block that each of `pixels` stands for: 1 at full resolution. A
    /// preview has one ray for each block, through its centre and from a closed lens.
    pub shrink: u32,
    /// Columns of `pixels`: the picture's width divided by `shrink`, rounded up.
    pub width: u32,
    /// Rows of `pixels`: the picture's height divided by `shrink`, rounded up.
    pub height: u32,
    /// Red, green, blue as sRGB bytes, and 255, by rows from the top. When finished: the values of the 8-bit PNG that
    /// `luch render` writes.
    pub pixels: Vec<[u8; 4]>,
    /// Rays through each of `pixels`.
    pub samples: u32,
    /// Whether all rays that the job wants are in.
    pub finished: bool,
    /// The object at each pixel. Every full picture has it; that of a preview is as coarse as the preview, or that of an
    /// earlier picture where the objects stand as they stood.
    pub objects: Option<Arc<ObjectMap>>,
    /// Rays traced so far for this request, previews included.
    pub rays: u64,
    /// From the request to this snapshot.
    pub elapsed: Duration,
    pub(super) film: Option<Film>,
}

impl Snapshot {
    /// The linear picture, red, green, blue by rows from the top: the mean of the rays that are in. `None` for a preview.
    /// Copies the picture. When finished, the bits are those of [`render`](crate::render) with the same scene and job.
    #[must_use]
    pub fn linear(&self) -> Option<Vec<f32>> {
        self.film.as_ref().map(Film::linear)
    }

    /// The part of `pixels`, across and down, that lies in the picture: below 1 where the last blocks of a preview reach
    /// beyond its edge. Whoever stretches a preview over the place of the picture leaves the rest out.
    #[must_use]
    #[allow(clippy::cast_precision_loss, reason = "sides of a picture fit a float")]
    pub fn extent(&self) -> [f32; 2] {
        let share = |pixels: u32, blocks: u32| pixels as f32 / (blocks * self.shrink) as f32;
        [share(self.job.size.width(), self.width), share(self.job.size.height(), self.height)]
    }
}

impl fmt::Debug for Snapshot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Snapshot")
            .field("epoch", &self.epoch)
            .field("shrink", &self.shrink)
            .field("size", &[self.width, self.height])
            .field("samples", &self.samples)
            .field("finished", &self.finished)
            .finish_non_exhaustive()
    }
}
