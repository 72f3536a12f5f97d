//! What a study is to measure, as a person asks for it; [`crate::Study::new`] checks it.

use crate::subject::Subject;
use luch_render::SimdLevel;
use luch_scene::{ImageSize, RayCount};
use serde::{Deserialize, Serialize};
use std::ops::RangeInclusive;

/// Threads that a render may be asked for.
pub const THREADS: RangeInclusive<u64> = 1..=1024;
/// Counted runs of each case.
pub const RUNS: RangeInclusive<u64> = 1..=10_000;
/// Runs of each case that warm up and are not counted.
pub const WARM_UP: RangeInclusive<u64> = 0..=1_000;
/// Triangles of a mesh.
pub const TRIANGLES: RangeInclusive<u64> = 8..=10_000_000;
/// Rays per pixel.
pub const RAYS: RangeInclusive<u64> = 1..=RayCount::MAX as u64;
/// Sides of a tile in pixels. A thread's memory grows with the square: at 1024 it is some hundred megabytes.
pub const TILES: RangeInclusive<u64> = 1..=1024;
/// The most pixels of a picture, 7680x4320: many pictures are made, and larger ones teach nothing new.
pub const MAX_PIXELS: u64 = 7680 * 4320;
/// The most values that one study may vary a quantity over.
pub const MAX_VALUES: usize = 64;

/// Which question a study asks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// Time against the number of threads.
    Threads,
    /// Time against the number of triangles of a mesh.
    Triangles,
    /// Time and noise against rays per pixel.
    Rays,
    /// Time against the side of the tiles.
    Tiles,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Self; 4] = [Self::Threads, Self::Triangles, Self::Rays, Self::Tiles];

    /// The word for it on the command line and in files.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Threads => "threads",
            Self::Triangles => "triangles",
            Self::Rays => "rays",
            Self::Tiles => "tiles",
        }
    }
}

/// How much is measured, whatever is varied.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effort {
    /// Counted runs of each case.
    pub runs: u32,
    /// Runs of each case before, which are not counted.
    pub warm_up: u32,
    /// Size of the pictures.
    pub size: ImageSize,
    /// Instruction set.
    pub simd: SimdLevel,
}

/// What the rays of a pixel are spread over.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Effect {
    /// The pixel.
    Antialiasing,
    /// The lens.
    DepthOfField,
    /// Both.
    Both,
}

impl Effect {
    /// Every effect.
    pub const ALL: [Self; 3] = [Self::Antialiasing, Self::DepthOfField, Self::Both];

    /// The word for it on the command line and in files.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Antialiasing => "antialiasing",
            Self::DepthOfField => "depth-of-field",
            Self::Both => "both",
        }
    }
}

/// A study as it was asked for.
#[derive(Debug, Clone, PartialEq)]
pub enum Plan {
    /// Time against the number of threads.
    Threads {
        /// The scenes; the growth is told from the first to each other.
        subjects: Vec<Subject>,
        /// The numbers of threads.
        threads: Vec<u64>,
        /// How much is measured.
        effort: Effort,
    },
    /// Time to build and to render against the number of triangles, on meshes made for it.
    Triangles {
        /// About how many triangles the meshes shall have.
        triangles: Vec<u64>,
        /// Threads for building and rendering.
        threads: u64,
        /// How much is measured.
        effort: Effort,
    },
    /// Time and noise against rays per pixel.
    Rays {
        /// The scenes.
        subjects: Vec<Subject>,
        /// The numbers of rays per pixel.
        rays: Vec<u64>,
        /// Rays per pixel of the picture that stands for the truth.
        reference: u64,
        /// What the rays are spread over.
        effect: Effect,
        /// Threads.
        threads: u64,
        /// How much is measured.
        effort: Effort,
    },
    /// Time against the side of the tiles.
    Tiles {
        /// The scenes.
        subjects: Vec<Subject>,
        /// The sides, in pixels.
        tiles: Vec<u64>,
        /// Threads.
        threads: u64,
        /// How much is measured.
        effort: Effort,
    },
}

impl Plan {
    /// The numbers of threads of the published study.
    pub const THREADS: [u64; 9] = [1, 2, 4, 8, 12, 16, 20, 32, 64];
    /// Meshes from a thousand to a million triangles.
    pub const TRIANGLES: [u64; 7] = [1_000, 3_000, 10_000, 30_000, 100_000, 300_000, 1_000_000];
    /// Powers of two.
    pub const RAYS: [u64; 9] = [1, 2, 4, 8, 16, 32, 64, 128, 256];
    /// Rays of the picture that stands for the truth.
    pub const REFERENCE: u64 = 4096;
    /// Around the side that is used where nobody says otherwise.
    pub const TILES: [u64; 9] = [4, 8, 16, 24, 32, 48, 64, 128, 256];

    /// Which question it asks.
    #[must_use]
    pub const fn kind(&self) -> Kind {
        match self {
            Self::Threads { .. } => Kind::Threads,
            Self::Triangles { .. } => Kind::Triangles,
            Self::Rays { .. } => Kind::Rays,
            Self::Tiles { .. } => Kind::Tiles,
        }
    }

    /// How much is measured.
    #[must_use]
    pub const fn effort(&self) -> &Effort {
        match self {
            Self::Threads { effort, .. }
            | Self::Triangles { effort, .. }
            | Self::Rays { effort, .. }
            | Self::Tiles { effort, .. } => effort,
        }
    }

    /// The scenes that somebody named; none where the study makes its own.
    #[must_use]
    pub fn subjects(&self) -> &[Subject] {
        match self {
            Self::Threads { subjects, .. } | Self::Rays { subjects, .. } | Self::Tiles { subjects, .. } => subjects,
            Self::Triangles { .. } => &[],
        }
    }
}

impl Effort {
    /// The effort of a kind of study, where nobody says otherwise. On two cores each takes up to about a minute.
    #[must_use]
    pub fn of(kind: Kind) -> Self {
        let (runs, warm_up, [width, height]) = match kind {
            Kind::Threads => (50, 3, [1920, 1440]),
            Kind::Triangles => (11, 1, [960, 720]),
            Kind::Rays => (7, 1, [480, 360]),
            Kind::Tiles => (21, 2, [1920, 1440]),
        };
        let size = ImageSize::new(width, height).unwrap_or(ImageSize::DEFAULT);
        Self { runs, warm_up, size, simd: SimdLevel::Auto }
    }
}
