//! No ray slips through a shared edge or vertex of a closed mesh.

mod support;

use glam::Vec3;
use luch_render::accel::{Geometry, MeshTree, Placement, SceneTree, available_levels};
use luch_render::math::ray::{Coherence, HitBatch, Mask, Ray, RayBatch};
use std::sync::Arc;
use support::{Mesh, Random, cube, lathe, octasphere, torus};

const RAYS: usize = 100_000;

/// Rays between a point inside and one far outside, through a point of an edge or through a vertex: half of them
/// start inside, half outside. Each has to cross the surface before it reaches its far end, at t = 1.
fn rays_through_edges(mesh: &Mesh, inside: impl Fn(&mut Random) -> Vec3, placement: &Placement) -> RayBatch {
    let mut random = Random(7);
    let mut rays = RayBatch::with_capacity(RAYS);
    for k in 0..RAYS {
        let triangle = mesh.1[random.below(mesh.1.len())];
        let [a, b] = [0, 1].map(|corner| mesh.0[triangle[corner] as usize]);
        let along = if k % 4 == 0 { 0.0 } else { random.unit() };
        let on_edge = placement.point(a + (b - a) * along);
        let from = placement.point(inside(&mut random));
        let away = on_edge - from;
        // 20 mesh sizes away; a point that happens to lie at the middle of the mesh has no direction of its own.
        let beyond = from + away * (20.0 * placement.linear.x_axis.length() / away.length().max(1e-6));
        let (origin, target) = if k % 2 == 0 { (from, beyond) } else { (beyond, from) };
        rays.push(&Ray { origin, direction: target - origin, t_min: 0.0, t_max: 1.0 });
    }
    rays
}

fn assert_no_leak(name: &str, mesh: &Mesh, inside: impl Fn(&mut Random) -> Vec3) {
    let tree = Arc::new(MeshTree::build(&mesh.0, &mesh.1, 2));
    let turned = Placement::new(Random(3).rotation(), 30.0, Vec3::new(100.0, -7.0, 3.0));
    for placement in [Placement::IDENTITY, turned] {
        let rays = rays_through_edges(mesh, &inside, &placement);
        let scene = SceneTree::build(&[Geometry::Instance { tree: tree.clone(), world_from_object: placement }]);
        for (level_name, level) in available_levels() {
            for coherence in [Coherence::Incoherent, Coherence::Coherent] {
                let (mut hits, mut occluded) = (HitBatch::new(), Mask::new());
                scene.closest_hits(level, &rays, coherence, &mut hits);
                scene.occluded(level, &rays, coherence, &mut occluded);
                let leaks = (0..RAYS).filter(|&k| hits.get(k).is_none()).count();
                let any_leaks = RAYS - occluded.count();
                assert_eq!((leaks, any_leaks), (0, 0), "{name}, {level_name}, {coherence:?}: closest, any");
            }
        }
    }
}

#[test]
fn octasphere_does_not_leak() {
    assert_no_leak("octasphere", &octasphere(4), |random| random.point() * 0.5);
}

#[test]
fn torus_does_not_leak() {
    assert_no_leak("torus", &torus(48, 24), |random| {
        let d = random.direction();
        let ring = Vec3::new(d.x, 0.0, d.z);
        ring / ring.length().max(1e-3) + random.point() * 0.1
    });
}

#[test]
fn cube_does_not_leak() {
    assert_no_leak("cube", &cube(), |random| random.point() * 0.9);
}

#[test]
fn lathe_body_does_not_leak() {
    assert_no_leak("lathe", &lathe(40), |random| Vec3::new(0.0, 0.05 + 1.2 * random.unit(), 0.0));
}
