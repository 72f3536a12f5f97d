//! From camera rays to colours.

mod camera;
pub(crate) mod classic;
mod debug;
pub(crate) mod onlooker;

pub use camera::Lens;
pub(crate) use camera::PixelList;

use crate::compiled::CompiledScene;
use crate::math::lanes::LANES;
use crate::math::ray::RayBatch;
use fearless_simd::Level;

/// What a picture shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Integrator {
    /// Backward (Whitted) ray tracing: shadows, mirrors, the lighting model of the scene.
    #[default]
    Classic,
    /// The direction of the shading normal, `(n + 1) / 2` as red, green, blue.
    Normal,
    /// The distance along the ray: white at the eye, half grey at the scene's own size, black far away.
    Depth,
    /// One colour for each object.
    Objects,
    /// The work of finding the first hit: boxes visited (red) and shapes tested (green), 64 of either being full.
    Cost,
    /// The boxes that a ray of its own goes into to find the first hit, on the scale of [`crate::film::heat`].
    Nodes,
    /// The triangles and other shapes that such a ray is tested against, on the same scale.
    Triangles,
}

impl Integrator {
    /// Every integrator, in the order of help texts.
    pub const ALL: [Self; 7] =
        [Self::Classic, Self::Normal, Self::Depth, Self::Objects, Self::Cost, Self::Nodes, Self::Triangles];

    /// The word for it on the command line.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Classic => "classic",
            Self::Normal => "normal",
            Self::Depth => "depth",
            Self::Objects => "objects",
            Self::Cost => "cost",
            Self::Nodes => "nodes",
            Self::Triangles => "triangles",
        }
    }

    /// Whether its colours are counts, which mean something only beside their scale.
    #[must_use]
    pub const fn shows_counts(self) -> bool {
        matches!(self, Self::Nodes | Self::Triangles)
    }

    /// The integrator of that word.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|i| i.word() == word)
    }
}

/// Colours of a batch of rays, in lanes as the batch is.
#[derive(Debug, Default)]
pub(crate) struct Colors(pub(crate) [Vec<f32>; 3]);

impl Colors {
    /// Makes room for `len` colours; what they are is not said.
    pub(crate) fn resize(&mut self, len: usize) {
        for list in &mut self.0 {
            list.resize(len.next_multiple_of(LANES), 0.0);
        }
    }

    /// Colour `index`.
    pub(crate) fn get(&self, index: usize) -> [f32; 3] {
        [self.0[0][index], self.0[1][index], self.0[2][index]]
    }

    /// Replaces colour `index`.
    pub(crate) fn set(&mut self, index: usize, color: [f32; 3]) {
        for (list, value) in self.0.iter_mut().zip(color) {
            list[index] = value;
        }
    }
}

/// What a tracer is to do: the same for all rays of a picture.
#[derive(Clone, Copy)]
pub(crate) struct Orders<'a> {
    pub(crate) scene: &'a CompiledScene,
    pub(crate) level: Level,
    pub(crate) integrator: Integrator,
    /// Surfaces along a path.
    pub(crate) depth: u32,
    /// Asked between the queries of a batch: whether the work is to be given up.
    pub(crate) stop: &'a dyn Fn() -> bool,
}

/// The memory that rays are traced in; each thread has its own, for picture after picture.
#[derive(Debug, Default)]
pub(crate) struct Tracer {
    classic: classic::Waves,
    debug: debug::Views,
}

impl Tracer {
    /// Works out the colour of every ray of the batch and answers with the number of rays traced for it; `None` if the
    /// work was given up. The batch is used up. `objects`, if it is asked for, gets the object that each ray met, or
    /// stays empty where the integrator looked for none.
    pub(crate) fn trace(
        &mut self,
        orders: &Orders<'_>,
        rays: &mut RayBatch,
        colors: &mut Colors,
        objects: Option<&mut Vec<u32>>,
    ) -> Option<u64> {
        colors.resize(rays.len());
        if orders.integrator == Integrator::Classic {
            self.classic.trace(orders, rays, colors, objects)
        } else {
            Some(self.debug.trace(orders, rays, colors, objects))
        }
    }

    /// Gives back what only an uncommonly deep picture needs.
    pub(crate) fn shrink(&mut self) {
        self.classic.shrink();
    }
}
