//! What a picture shows at a pixel.

use crate::compiled::CompiledScene;
use crate::integrator::{Lens, PixelList};
use crate::math::ray::{Coherence, HitBatch, RayBatch};
use crate::session::job::RenderJob;
use crate::shading::surface::SurfaceBatch;
use crate::simd::shade_at;
use glam::Vec3;

/// Where the ray of a pixel meets an object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pick {
    /// The object, by its place in the scene's list.
    pub object: usize,
    /// The point of its surface.
    pub point: Vec3,
    /// The distance from the start of the ray, which is on the lens.
    pub t: f32,
    /// The normal that the point is lit by, of unit length, turned to the side that the ray comes from.
    pub normal: Vec3,
}

/// What the picture shows at a pixel: traces the ray of its first sample, with its place in the pixel and on the lens.
/// `None` for the background and outside the picture. Takes microseconds, and needs no session.
#[must_use]
pub fn pick(compiled: &CompiledScene, job: &RenderJob, x: u32, y: u32) -> Option<Pick> {
    if x >= job.size.width() || y >= job.size.height() {
        return None;
    }
    let level = job.simd.level_or_best();
    let mut pixels = PixelList::default();
    pixels.set(std::iter::once([x, y]));
    let (mut rays, mut hits) = (RayBatch::new(), HitBatch::new());
    let lens = Lens::new(&job.camera, job.size, job.antialiasing.on, job.depth_of_field.on);
    lens.rays(level, &pixels, 0, &mut rays);
    compiled.tree.closest_hits(level, &rays, Coherence::Incoherent, &mut hits);
    let hit = hits.get(0)?;
    let mut surfaces = SurfaceBatch::default();
    let (batch, all) = (&rays, &hits);
    let surface = &mut surfaces;
    shade_at!(level, simd => surface.fill(simd, compiled, batch, all));
    let first = |lists: &[Vec<f32>; 3]| Vec3::from_array([0, 1, 2].map(|axis: usize| lists[axis][0]));
    Some(Pick {
        object: hit.object as usize,
        point: first(&surfaces.position),
        t: hit.t,
        normal: first(&surfaces.normal),
    })
}
