//! How a picture of the scene is made, where the user does not say otherwise.

use crate::number::NumberError;
use crate::object::Shading;

/// Width and height of a picture in pixels, each from 1 to 65,535.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ImageSize {
    width: u32,
    height: u32,
}

impl ImageSize {
    /// The largest width and height.
    pub const MAX_SIDE: u32 = 65_535;
    /// 960 x 720.
    pub const DEFAULT: Self = Self { width: 960, height: 720 };

    /// Takes a width and a height.
    ///
    /// # Errors
    /// [`NumberError`] for a side that is 0 or above [`ImageSize::MAX_SIDE`].
    pub fn new(width: u32, height: u32) -> Result<Self, NumberError> {
        for side in [width, height] {
            if side == 0 || side > Self::MAX_SIDE {
                return Err(NumberError { value: f64::from(side), expected: "a number of pixels from 1 to 65535" });
            }
        }
        Ok(Self { width, height })
    }

    /// Pixels in a row.
    #[must_use]
    pub const fn width(self) -> u32 {
        self.width
    }

    /// Rows.
    #[must_use]
    pub const fn height(self) -> u32 {
        self.height
    }

    /// Pixels in all.
    #[must_use]
    pub const fn pixels(self) -> u64 {
        self.width as u64 * self.height as u64
    }
}

/// A number of rays per pixel, from 1 to 4096.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct RayCount(u32);

impl RayCount {
    /// The largest number of rays.
    pub const MAX: u32 = 4096;
    /// One ray through the centre.
    pub const ONE: Self = Self(1);

    /// Takes a number of rays.
    ///
    /// # Errors
    /// [`NumberError`] for 0 and for numbers above [`RayCount::MAX`].
    pub fn new(rays: u32) -> Result<Self, NumberError> {
        if rays == 0 || rays > Self::MAX {
            return Err(NumberError { value: f64::from(rays), expected: "a number of rays from 1 to 4096" });
        }
        Ok(Self(rays))
    }

    /// The number.
    #[must_use]
    pub const fn get(self) -> u32 {
        self.0
    }
}

/// An effect made with many rays: whether it is on, and with how many.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Sampling {
    /// Whether the effect is on.
    pub on: bool,
    /// Rays per pixel when it is.
    pub rays: RayCount,
}

impl Sampling {
    /// The rays that this effect asks for: 1 when it is off.
    #[must_use]
    pub const fn rays_in_use(self) -> u32 {
        if self.on { self.rays.get() } else { 1 }
    }
}

/// Defaults of a scene's pictures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RenderSettings {
    /// Size of the picture.
    pub size: ImageSize,
    /// How many surfaces are shaded along a path, the first included: beyond, a mirror shows the background.
    pub depth: u32,
    /// Rays spread over the pixel.
    pub antialiasing: Sampling,
    /// Rays spread over the lens.
    pub depth_of_field: Sampling,
    /// The shading model of every mesh that names none of its own.
    pub shading: Shading,
}

impl RenderSettings {
    /// The largest depth.
    pub const MAX_DEPTH: u32 = 10_000;

    /// Rays per pixel: antialiasing and depth of field share their rays, so the larger number counts.
    #[must_use]
    pub fn rays_per_pixel(&self) -> u32 {
        self.antialiasing.rays_in_use().max(self.depth_of_field.rays_in_use())
    }

    /// Takes a depth from 0 to [`RenderSettings::MAX_DEPTH`].
    ///
    /// # Errors
    /// [`NumberError`] for larger numbers.
    pub fn checked_depth(depth: u32) -> Result<u32, NumberError> {
        if depth > Self::MAX_DEPTH {
            return Err(NumberError { value: f64::from(depth), expected: "a depth from 0 to 10000" });
        }
        Ok(depth)
    }
}

impl Default for RenderSettings {
    fn default() -> Self {
        Self {
            size: ImageSize::DEFAULT,
            depth: 5,
            antialiasing: Sampling { on: false, rays: RayCount(16) },
            depth_of_field: Sampling { on: false, rays: RayCount(64) },
            shading: Shading::Phong,
        }
    }
}
