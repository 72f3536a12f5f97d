//! How far away what a picture shows is.

use crate::compiled::CompiledScene;
use crate::integrator::{Lens, PixelList};
use crate::math::ray::{Coherence, HitBatch, RayBatch};
use crate::session::job::RenderJob;
use std::fmt;

/// Side of the blocks of rays that are traced side by side.
const BLOCK: u32 = 4;

/// Distances along the view direction, one for each block of a picture.
#[derive(Clone, PartialEq)]
pub struct DepthMap {
    shrink: u32,
    columns: u32,
    rows: u32,
    depths: Vec<f32>,
}

impl DepthMap {
    /// Pixels of the picture along the side of a block.
    #[must_use]
    pub const fn shrink(&self) -> u32 {
        self.shrink
    }

    /// Blocks in a row: the picture's width divided by `shrink`, rounded up.
    #[must_use]
    pub const fn columns(&self) -> u32 {
        self.columns
    }

    /// Rows of blocks: the picture's height divided by `shrink`, rounded up.
    #[must_use]
    pub const fn rows(&self) -> u32 {
        self.rows
    }

    /// The distances by rows from the top; infinite where there is nothing.
    #[must_use]
    pub fn depths(&self) -> &[f32] {
        &self.depths
    }
}

impl fmt::Debug for DepthMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { shrink, columns, rows, .. } = self;
        f.debug_struct("DepthMap").field("shrink", shrink).field("size", &[columns, rows]).finish_non_exhaustive()
    }
}

/// How far along the view direction what is seen lies: one ray for each block of `shrink` times `shrink` pixels, through
/// its centre and from a closed lens. Needs no session. Runs on the caller's thread, at some ten million rays a second.
#[must_use]
pub fn depths(compiled: &CompiledScene, job: &RenderJob, shrink: u32) -> DepthMap {
    let shrink = shrink.max(1);
    let (columns, rows) = (job.size.width().div_ceil(shrink), job.size.height().div_ceil(shrink));
    let level = job.simd.level_or_best();
    let lens = Lens::new(&job.camera, job.size, false, false).of_blocks(shrink);
    let forward = job.camera.frame()[2];
    let mut depths = vec![f32::INFINITY; columns as usize * rows as usize];
    let (mut pixels, mut rays, mut hits) = (PixelList::default(), RayBatch::new(), HitBatch::new());
    let mut places = Vec::new();
    for top in (0..rows).step_by(BLOCK as usize) {
        // A strip, in blocks of neighbours.
        places.clear();
        for left in (0..columns).step_by(BLOCK as usize) {
            for y in top..rows.min(top + BLOCK) {
                places.extend((left..columns.min(left + BLOCK)).map(|x| [x, y]));
            }
        }
        pixels.set(places.iter().copied());
        lens.rays(level, &pixels, 0, &mut rays);
        compiled.tree.closest_hits(level, &rays, Coherence::Coherent, &mut hits);
        for (index, [x, y]) in places.iter().enumerate() {
            if let Some(hit) = hits.get(index) {
                depths[*y as usize * columns as usize + *x as usize] = hit.t * rays.get(index).direction.dot(forward);
            }
        }
    }
    DepthMap { shrink, columns, rows, depths }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compiled::{MeshTrees, compile};
    use crate::session::live::pick;
    use glam::Vec3;
    use luch_scene::{Aim, Camera, ImageSize, NonNegative, Object, Point, Sampling, Scene, Shape, Size};

    fn scene() -> Scene {
        let mut scene = Scene::new("s");
        for x in [-1.5, 0.0, 1.5] {
            let center = Point::clamped(Vec3::new(x, 0.0, x * -2.0));
            scene.objects.push(Object::new(format!("{x}"), Shape::Sphere { center, radius: Size::ONE }));
        }
        let mut camera = Camera::new("c", Point::clamped(Vec3::new(1.0, 2.0, 9.0)), Aim::At(Point::ORIGIN));
        camera.lens_radius = NonNegative::clamped(0.5);
        scene.cameras.push(camera);
        scene.settings.size = ImageSize::new(61, 43).unwrap();
        scene
    }

    #[test]
    fn depths_are_those_of_the_points_that_are_picked() {
        let scene = scene();
        let compiled = compile(&scene, &mut MeshTrees::new(), 1);
        let mut job = RenderJob::of_scene(&scene, 0);
        let map = depths(&compiled, &job, 1);
        assert_eq!((map.columns(), map.rows()), (61, 43));
        let (eye, forward) = (job.camera.position.get(), job.camera.frame()[2]);
        let mut seen = 0;
        for (place, &depth) in (0_u32..).zip(map.depths()) {
            match pick(&compiled, &job, place % 61, place / 61) {
                Some(hit) => {
                    seen += 1;
                    assert!((depth - (hit.point - eye).dot(forward)).abs() < 1e-4, "{place}");
                }
                None => assert_eq!(depth, f32::INFINITY),
            }
        }
        assert!(seen > 100 && seen < 61 * 43);
        // An open lens and spread rays make no difference.
        job.depth_of_field = Sampling { on: true, ..job.depth_of_field };
        job.antialiasing = Sampling { on: true, ..job.antialiasing };
        assert!(depths(&compiled, &job, 1) == map);
    }

    #[test]
    fn blocks_cover_the_picture_and_have_the_depth_at_their_centre() {
        let scene = scene();
        let compiled = compile(&scene, &mut MeshTrees::new(), 1);
        let job = RenderJob::of_scene(&scene, 0);
        let (whole, blocks) = (depths(&compiled, &job, 1), depths(&compiled, &job, 3));
        assert_eq!((blocks.columns(), blocks.rows(), blocks.shrink()), (21, 15, 3));
        for y in 0..14 {
            for x in 0..20 {
                let [block, centre] = [blocks.depths()[y * 21 + x], whole.depths()[(y * 3 + 1) * 61 + x * 3 + 1]];
                assert!(block == centre || (block - centre).abs() < 1e-4, "{x} {y}: {block} {centre}");
            }
        }
    }
}
