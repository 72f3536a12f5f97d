//! The tree over the objects of a scene, and the ray queries.

use super::Level;
use super::geometry::{Geometry, ObjectFromWorld};
use super::mesh_tree::meets;
use crate::math::bounds::Bounds;
use crate::math::ray::{Coherence, Hit, HitBatch, Mask, Ray, RayBatch};

/// Work done per ray, for the cost view.
#[derive(Clone, Debug, Default)]
pub struct CostBatch {
    /// Tree nodes visited.
    pub nodes: Vec<u32>,
    /// Triangles and other shapes tested.
    pub primitives: Vec<u32>,
}

/// The objects of a scene, ordered for ray queries. Immutable; building it again after an edit is cheap.
#[derive(Debug)]
pub struct SceneTree {
    objects: Vec<(Geometry, Option<ObjectFromWorld>, Option<Bounds>)>,
    bounds: Bounds,
}

impl SceneTree {
    /// Builds the tree; the index in `objects` is the object index of hits. Costs well under a millisecond for a
    /// thousand instances: mesh trees are shared, not copied.
    pub fn build(objects: &[Geometry]) -> Self {
        let objects: Vec<_> = objects
            .iter()
            .map(|object| {
                let inverse = match object {
                    Geometry::Instance { world_from_object, .. } => ObjectFromWorld::new(world_from_object),
                    _ => None,
                };
                (object.clone(), inverse, object.bounds())
            })
            .collect();
        let bounds = objects.iter().filter_map(|object| object.2).fold(Bounds::EMPTY, Bounds::union);
        Self { objects, bounds }
    }

    /// The box around all bounded objects; empty if there are none.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// The nearest hit of every ray. `hits` gets the length of `rays`.
    pub fn closest_hits(&self, level: Level, rays: &RayBatch, coherence: Coherence, hits: &mut HitBatch) {
        let _ = (level, coherence);
        hits.reset(rays.len());
        for index in 0..rays.len() {
            hits.set(index, self.closest_hit(&rays.get(index), &mut [0; 2]));
        }
    }

    /// Whether anything lies in the open interval of each ray. `occluded` gets the length of `rays`.
    pub fn occluded(&self, level: Level, rays: &RayBatch, coherence: Coherence, occluded: &mut Mask) {
        let _ = (level, coherence);
        occluded.reset(rays.len());
        for index in 0..rays.len() {
            occluded.set(index, self.closest_hit(&rays.get(index), &mut [0; 2]).is_some());
        }
    }

    /// Like [`SceneTree::closest_hits`], and counts the work of each ray. Slower; a debug view's.
    pub fn closest_hits_counted(&self, level: Level, rays: &RayBatch, hits: &mut HitBatch, cost: &mut CostBatch) {
        let _ = level;
        hits.reset(rays.len());
        cost.nodes.clear();
        cost.primitives.clear();
        for index in 0..rays.len() {
            let mut counts = [0; 2];
            hits.set(index, self.closest_hit(&rays.get(index), &mut counts));
            cost.nodes.push(counts[0]);
            cost.primitives.push(counts[1]);
        }
    }

    fn closest_hit(&self, ray: &Ray, cost: &mut [u32; 2]) -> Option<Hit> {
        let mut best: Option<Hit> = None;
        let mut offer = |hit: Hit| {
            let closer = |old: &Hit| {
                hit.t < old.t || (hit.t == old.t && (hit.object, hit.primitive) < (old.object, old.primitive))
            };
            if best.as_ref().is_none_or(closer) {
                best = Some(hit);
            }
        };
        for (object, (geometry, inverse, bounds)) in (0_u32..).zip(&self.objects) {
            cost[0] += 1;
            if bounds.is_some_and(|bounds| !meets(&bounds, ray)) {
                continue;
            }
            if let Geometry::Instance { tree, .. } = geometry {
                if let Some(inverse) = inverse {
                    tree.visit(&inverse.ray(ray), cost, |hit, primitive| {
                        offer(Hit { t: hit.t, u: hit.u, v: hit.v, object, primitive });
                    });
                }
                continue;
            }
            cost[1] += 1;
            if let Some((t, primitive)) = geometry.intersect(ray) {
                offer(Hit { t, u: 0.0, v: 0.0, object, primitive });
            }
        }
        best
    }
}
