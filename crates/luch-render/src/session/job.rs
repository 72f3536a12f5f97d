//! What is to be rendered.

use crate::integrator::Integrator;
use crate::simd::SimdLevel;
use luch_scene::{Camera, ImageSize, Sampling, Scene};

/// A rectangle of pixels of a picture, counted from the top left.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Crop {
    /// The leftmost column.
    pub x: u32,
    /// The topmost row.
    pub y: u32,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
}

impl Crop {
    /// The whole picture.
    #[must_use]
    pub const fn whole(size: ImageSize) -> Self {
        Self { x: 0, y: 0, width: size.width(), height: size.height() }
    }

    /// The part of the rectangle that lies in the picture; `None` if none does.
    #[must_use]
    pub fn within(self, size: ImageSize) -> Option<Self> {
        let right = self.x.saturating_add(self.width).min(size.width());
        let bottom = self.y.saturating_add(self.height).min(size.height());
        (self.x < right && self.y < bottom).then(|| Self {
            x: self.x,
            y: self.y,
            width: right - self.x,
            height: bottom - self.y,
        })
    }
}

/// Everything that a picture depends on besides the scene, and how it is to be made.
///
/// `threads`, `simd` and `tile_size` change the time that it takes; no bit of the picture depends on them.
#[derive(Debug, Clone, PartialEq)]
pub struct RenderJob {
    /// From where.
    pub camera: Camera,
    /// The size of the whole picture.
    pub size: ImageSize,
    /// The part of it to make; `None`: all.
    pub crop: Option<Crop>,
    /// Surfaces along a path, the first included.
    pub depth: u32,
    /// Rays spread over the pixel.
    pub antialiasing: Sampling,
    /// Rays spread over the lens.
    pub depth_of_field: Sampling,
    /// What to show.
    pub integrator: Integrator,
    /// Threads to use, at least 1. Those that the machine does not run at once begin one by one, when the picture has taken
    /// long enough to be worth it.
    pub threads: usize,
    /// Instruction set to use; the best of the machine where it lacks this one.
    pub simd: SimdLevel,
    /// Side of the square tiles that the picture is made in, in pixels.
    pub tile_size: u32,
}

impl RenderJob {
    /// Side of a tile, where nobody says otherwise.
    pub const TILE_SIZE: u32 = 32;

    /// A picture from camera `camera` of the scene, with the scene's own settings, one thread.
    ///
    /// # Panics
    /// If the scene has no camera of that number.
    #[must_use]
    pub fn of_scene(scene: &Scene, camera: usize) -> Self {
        let settings = &scene.settings;
        Self {
            camera: scene.cameras[camera].clone(),
            size: settings.size,
            crop: None,
            depth: settings.depth,
            antialiasing: settings.antialiasing,
            depth_of_field: settings.depth_of_field,
            integrator: Integrator::Classic,
            threads: 1,
            simd: SimdLevel::Auto,
            tile_size: Self::TILE_SIZE,
        }
    }

    /// Rays through each pixel: antialiasing and depth of field share theirs, so the larger number counts.
    #[must_use]
    pub fn rays_per_pixel(&self) -> u32 {
        self.antialiasing.rays_in_use().max(self.depth_of_field.rays_in_use())
    }

    /// Bytes that the picture takes while it is made: three sums and three means of 32 bits for each pixel.
    #[must_use]
    pub fn memory_bytes(&self) -> u64 {
        let pixels = self.pixels().map_or(0, |part| u64::from(part.width) * u64::from(part.height));
        pixels.saturating_mul(24)
    }

    /// The pixels to make; `None` if the crop lies outside the picture.
    #[must_use]
    pub fn pixels(&self) -> Option<Crop> {
        self.crop.unwrap_or(Crop::whole(self.size)).within(self.size)
    }
}
