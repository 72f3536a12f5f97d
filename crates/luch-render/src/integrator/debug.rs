//! Views that show what the tracer sees: normals, distances, objects, work.

use super::{Colors, Integrator, Orders};
use crate::accel::CostBatch;
use crate::compiled::CompiledScene;
use crate::explain::counts;
use crate::film::heat::heat_of_count;
use crate::math::ray::{Coherence, HitBatch, RayBatch};
use crate::shading::surface::SurfaceBatch;
use crate::simd::shade_at;

/// The memory of the debug views.
#[derive(Debug, Default)]
pub(super) struct Views {
    hits: HitBatch,
    surfaces: SurfaceBatch,
    cost: CostBatch,
}

/// Boxes visited, or shapes tested, that make a channel of the cost view full.
const FULL_COST: f32 = 64.0;

impl Views {
    /// Works out the colour of every ray and answers with the number of rays traced.
    pub(super) fn trace(
        &mut self,
        orders: &Orders<'_>,
        rays: &RayBatch,
        colors: &mut Colors,
        objects: Option<&mut Vec<u32>>,
    ) -> u64 {
        let Orders { scene, level, integrator: view, .. } = *orders;
        if view == Integrator::Cost {
            scene.tree.closest_hits_counted(level, rays, &mut self.hits, &mut self.cost);
        } else {
            scene.tree.closest_hits(level, rays, Coherence::Coherent, &mut self.hits);
        }
        if let Some(objects) = objects {
            objects.clone_from(&self.hits.object);
        }
        let (hits, surfaces) = (&self.hits, &mut self.surfaces);
        if view == Integrator::Normal {
            shade_at!(level, simd => surfaces.fill(simd, scene, rays, hits));
        }
        let half_depth = scene_size(scene);
        for index in 0..rays.len() {
            let color = match (view, self.hits.get(index)) {
                (Integrator::Nodes, _) => heat_of_count(counts(scene, &rays.get(index))[0]),
                (Integrator::Triangles, _) => heat_of_count(counts(scene, &rays.get(index))[1]),
                (Integrator::Cost, _) => cost_color(self.cost.nodes[index], self.cost.primitives[index]),
                (Integrator::Depth, None) => [0.0; 3],
                (_, None) => scene.background.to_array(),
                (Integrator::Depth, Some(hit)) => [half_depth / (half_depth + hit.t); 3],
                (Integrator::Objects, Some(hit)) => object_color(hit.object),
                (_, Some(_)) => {
                    let normal = &self.surfaces.normal;
                    [0, 1, 2].map(|axis: usize| normal[axis][index] * 0.5 + 0.5)
                }
            };
            colors.set(index, color);
        }
        rays.len() as u64
    }
}

/// The diagonal of the bounded part of the scene, or 1: the distance that the depth view shows as half grey.
fn scene_size(scene: &CompiledScene) -> f32 {
    let bounds = scene.bounds();
    let size = if bounds.is_empty() { 0.0 } else { bounds.size().length() };
    if size > 0.0 && size.is_finite() { size } else { 1.0 }
}

fn cost_color(nodes: u32, primitives: u32) -> [f32; 3] {
    #[allow(clippy::cast_precision_loss, reason = "the counts of one ray are small")]
    let share = |count: u32| (count as f32 / FULL_COST).min(1.0);
    [share(nodes), share(primitives), 0.0]
}

/// A colour for an object: hues a golden angle apart, so that neighbours in the list differ most.
fn object_color(object: u32) -> [f32; 3] {
    let hue = f64::from(object) * 0.618_033_988_749_894_9;
    [0.0, 1.0 / 3.0, 2.0 / 3.0].map(|shift| {
        let wave = libm::cos((hue + shift) * std::f64::consts::TAU);
        #[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
        let channel = (0.45 + 0.4 * wave) as f32;
        channel
    })
}
