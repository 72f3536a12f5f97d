//! Why a plan cannot be carried out.

use crate::language::Language;
use std::fmt;

/// A quantity that a plan has numbers of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// Threads of a render.
    Threads,
    /// Triangles of a mesh.
    Triangles,
    /// Rays per pixel.
    Rays,
    /// Sides of tiles.
    Tiles,
    /// Counted runs.
    Runs,
    /// Runs that are not counted.
    WarmUp,
}

/// What is wrong with a plan.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum PlanError {
    /// Nothing to vary.
    NoValues(Quantity),
    /// More values than [`crate::plan::MAX_VALUES`].
    TooManyValues {
        /// What there is too much of.
        quantity: Quantity,
        /// How many there are.
        count: usize,
    },
    /// A number that is no such quantity.
    OutOfRange {
        /// What it is a number of.
        quantity: Quantity,
        /// The number.
        value: u64,
        /// The smallest that is.
        least: u64,
        /// The largest that is.
        most: u64,
    },
    /// One value is there twice.
    Twice {
        /// What it is a number of.
        quantity: Quantity,
        /// The value.
        value: u64,
    },
    /// Two numbers of triangles for which the same mesh is made.
    SameMesh {
        /// The two numbers.
        wanted: [u64; 2],
        /// The triangles that the mesh has.
        triangles: u64,
    },
    /// The reference picture would not be better than what is compared with it.
    Reference {
        /// Its rays per pixel.
        reference: u64,
        /// The most rays per pixel of what is compared.
        most: u64,
    },
    /// More pixels than [`crate::plan::MAX_PIXELS`].
    TooLarge {
        /// Pixels in a row.
        width: u32,
        /// Rows.
        height: u32,
    },
    /// No scene to measure.
    NoScene,
    /// More scenes than [`crate::plan::MAX_VALUES`].
    TooManyScenes {
        /// How many there are.
        count: usize,
    },
    /// A scene is there twice.
    SceneTwice(String),
    /// A scene cannot be looked at.
    NoCamera(String),
}

impl PlanError {
    /// The sentence for a person, in their language.
    #[must_use]
    pub fn text(&self, language: Language) -> String {
        (language.text().plan_error)(self)
    }
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(Language::English))
    }
}

impl std::error::Error for PlanError {}
