//! Whoever looks on while the classic integrator works: the one who explains a pixel.

use super::Colors;
use super::classic::{Shadows, Wave};
use crate::math::ray::{Coherence, HitBatch, RayBatch};
use crate::shading::surface::SurfaceBatch;

/// Looks on while waves are worked out, and changes nothing: whoever explains a picture sees what made it.
///
/// It is called a few times a wave, never for a single ray, so that a picture does not pay for it.
pub(crate) trait Onlooker {
    /// A wave begins; false stops the trace before it.
    fn wave(&mut self, _rays: &RayBatch) -> bool {
        true
    }

    /// The surfaces of a wave are known, and the colours hold the ambient term or the background. A wave that may look
    /// no further has no surfaces, and this is not called.
    fn surfaces(&mut self, _rays: &RayBatch, _hits: &HitBatch, _surfaces: &SurfaceBatch, _colors: &Colors) {}

    /// Light `light` of the compiled scene has been asked for `asked` shadow rays, and the colours hold its share.
    fn light(&mut self, _light: usize, _asked: u64, _at: &Lighting<'_>, _colors: &Colors) {}

    /// The wave is done but for what it mirrors.
    fn local(&mut self, _wave: &Wave) {}

    /// All waves are done, and mixed with what they mirror.
    fn mixed(&mut self, _waves: &[Wave]) {}
}

/// Where the lighting sum of a wave is.
pub(crate) struct Lighting<'a> {
    pub(crate) rays: &'a RayBatch,
    pub(crate) hits: &'a HitBatch,
    pub(crate) surfaces: &'a SurfaceBatch,
    pub(crate) shadows: &'a Shadows,
    pub(crate) coherence: Coherence,
}

/// Nobody looks on.
impl Onlooker for () {}
