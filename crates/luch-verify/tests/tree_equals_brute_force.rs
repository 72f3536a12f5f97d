//! The queries against their definition: test everything, keep the smallest t, ties to the smaller index. Bit for bit,
//! at every SIMD level, for both coherence hints, whatever the scene.

mod support;

use glam::Vec3;
use luch_render::accel::{Geometry, MeshTree, ObjectFromWorld, Placement, SceneTree, available_levels};
use luch_render::math::ray::{Coherence, Hit, HitBatch, Mask, Ray, RayBatch};
use luch_render::shape::cuboid::{self, Cuboid};
use luch_render::shape::plane::{self, Rectangle};
use luch_render::shape::sphere;
use luch_render::shape::triangle::{self, ShearedRay};
use std::sync::Arc;
use support::{Mesh, Random, cube, lathe, octasphere, torus};

/// A scene and, beside it, the meshes its instances were built from.
struct Scene {
    objects: Vec<Geometry>,
    meshes: Vec<Option<Arc<Mesh>>>,
}

impl Scene {
    fn new() -> Self {
        Self { objects: Vec::new(), meshes: Vec::new() }
    }

    fn add(&mut self, object: Geometry) {
        self.objects.push(object);
        self.meshes.push(None);
    }

    fn add_mesh(&mut self, tree: &Arc<MeshTree>, mesh: &Arc<Mesh>, world_from_object: Placement) {
        self.objects.push(Geometry::Instance { tree: tree.clone(), world_from_object });
        self.meshes.push(Some(mesh.clone()));
    }

    fn closest_hit(&self, ray: &Ray) -> Option<Hit> {
        let mut best: Option<Hit> = None;
        let mut offer = |hit: Hit| {
            if best.is_none_or(|old| (hit.t, hit.object, hit.primitive) < (old.t, old.object, old.primitive)) {
                best = Some(hit);
            }
        };
        for (object, (geometry, mesh)) in (0_u32..).zip(self.objects.iter().zip(&self.meshes)) {
            let shape = |(t, primitive)| Hit { t, u: 0.0, v: 0.0, object, primitive };
            let found = match geometry {
                Geometry::Sphere { center, radius } => sphere::intersect(*center, *radius, ray).map(|t| (t, 0)),
                Geometry::Cuboid(cuboid) => cuboid::intersect(cuboid, ray),
                Geometry::Plane { point, normal, bounds } => {
                    plane::intersect(*point, *normal, bounds.as_ref(), ray).map(|t| (t, 0))
                }
                Geometry::Instance { world_from_object, .. } => {
                    let Some(inverse) = ObjectFromWorld::new(world_from_object) else { continue };
                    let (ray, (positions, triangles)) = (inverse.ray(ray), mesh.as_deref().expect("set with the tree"));
                    let sheared = ShearedRay::new(ray.direction);
                    for (primitive, corners) in (0_u32..).zip(triangles) {
                        let vertices = corners.map(|k| positions[k as usize]);
                        if let Some(hit) = triangle::intersect(vertices, &ray, &sheared) {
                            offer(Hit { t: hit.t, u: hit.u, v: hit.v, object, primitive });
                        }
                    }
                    None
                }
                Geometry::Hidden => None,
            };
            found.map(shape).into_iter().for_each(&mut offer);
        }
        best
    }

    /// Compares every query with the definition on these rays, and in another order and batch size.
    fn check(&self, name: &str, rays: &RayBatch) -> usize {
        let tree = SceneTree::build(&self.objects);
        let expected: Vec<_> = (0..rays.len()).map(|k| self.closest_hit(&rays.get(k))).collect();
        let (mut hits, mut occluded) = (HitBatch::new(), Mask::new());
        for (level_name, level) in available_levels() {
            for coherence in [Coherence::Incoherent, Coherence::Coherent] {
                tree.closest_hits(level, rays, coherence, &mut hits);
                tree.occluded(level, rays, coherence, &mut occluded);
                for (k, want) in expected.iter().enumerate() {
                    let got = hits.get(k);
                    let same = bits(got) == bits(*want) && occluded.get(k) == want.is_some();
                    assert!(
                        same,
                        "{name}, {level_name}, {coherence:?}, ray {k} {:?}: got {got:?}, occluded {}, want {want:?}",
                        rays.get(k),
                        occluded.get(k),
                    );
                }
            }
        }
        // A batch of one gives the same bits.
        let (_, level) = available_levels().pop().expect("scalar is always there");
        for k in (0..rays.len()).step_by(37) {
            let mut one = RayBatch::new();
            one.push(&rays.get(k));
            tree.closest_hits(level, &one, Coherence::Incoherent, &mut hits);
            assert_eq!(bits(hits.get(0)), bits(expected[k]), "{name}: ray {k} alone");
        }
        expected.iter().flatten().count()
    }
}

fn bits(hit: Option<Hit>) -> Option<[u32; 5]> {
    hit.map(|h| [h.t.to_bits(), h.u.to_bits(), h.v.to_bits(), h.object, h.primitive])
}

/// Rays of every kind: from anywhere to anywhere, axis-parallel, starting on surfaces, short, and runs of neighbours.
fn rays(random: &mut Random, count: usize, reach: f32) -> RayBatch {
    let mut rays = RayBatch::new();
    while rays.len() < count {
        let mut ray = Ray::new(random.point() * reach, random.direction());
        match random.below(8) {
            0 => {
                let axis = random.below(3);
                ray.direction = Vec3::AXES[axis] * if random.below(2) == 0 { 1.0 } else { -1.0 };
            }
            1 => ray.origin = ray.origin.round(),
            2 => ray.t_max = random.unit() * reach,
            3 => ray.t_min = random.unit() * reach,
            4 => ray.direction *= 1e-3,
            5 | 6 => {
                // A coherent run: one origin, or nearly, and a small cone.
                let spread = if random.below(2) == 0 { 0.0 } else { 0.02 };
                for _ in 0..32 {
                    let origin = ray.origin + random.point() * spread;
                    rays.push(&Ray { origin, direction: ray.direction + random.point() * 0.05, ..ray });
                }
            }
            _ => {
                ray.direction = (random.point() * 0.3 - ray.origin) * 0.7;
            }
        }
        rays.push(&ray);
    }
    rays
}

fn placement(random: &mut Random) -> Placement {
    match random.below(4) {
        0 => Placement::IDENTITY,
        1 => Placement::new(glam::Mat3::IDENTITY, 1.0, random.point() * 3.0),
        _ => Placement::new(random.rotation(), 0.2 + 2.0 * random.unit(), random.point() * 3.0),
    }
}

fn soup(random: &mut Random, count: usize, size: f32) -> Mesh {
    let mut mesh = (Vec::new(), Vec::new());
    for _ in 0..count {
        let at = random.point();
        let first = mesh.0.len() as u32;
        mesh.0.extend([at, at + random.point() * size, at + random.point() * size]);
        mesh.1.push([first, first + 1, first + 2]);
    }
    mesh
}

#[test]
fn random_scenes_of_mixed_objects() {
    let mut random = Random(1);
    let meshes: Vec<_> = [octasphere(2), torus(20, 10), cube(), lathe(16), soup(&mut random, 300, 0.3)]
        .into_iter()
        .map(|mesh| (Arc::new(MeshTree::build(&mesh.0, &mesh.1, 2)), Arc::new(mesh)))
        .collect();
    let mut hits = 0;
    for round in 0..60 {
        let mut scene = Scene::new();
        for _ in 0..1 + random.below(if round % 10 == 0 { 60 } else { 8 }) {
            match random.below(9) {
                0 | 1 => scene.add(Geometry::Sphere { center: random.point() * 3.0, radius: random.unit() * 1.5 }),
                2 | 3 => scene.add(Geometry::Cuboid(Cuboid {
                    center: (random.point() * 3.0).round(),
                    half_size: random.point().abs() + Vec3::splat(0.1),
                    rotation: (random.below(2) == 0).then(|| random.rotation()),
                })),
                4 => {
                    let turn = random.rotation();
                    let bounds = (random.below(3) > 0).then(|| Rectangle {
                        axis_u: turn.x_axis,
                        axis_v: turn.y_axis,
                        half_u: random.unit() * 3.0,
                        half_v: random.unit() * 3.0,
                    });
                    scene.add(Geometry::Plane { point: random.point() * 3.0, normal: turn.z_axis, bounds });
                }
                5 => scene.add(Geometry::Hidden),
                _ => {
                    let (tree, mesh) = &meshes[random.below(meshes.len())];
                    scene.add_mesh(tree, mesh, placement(&mut random));
                }
            }
        }
        let rays = rays(&mut random, 600, 4.0);
        hits += scene.check(&format!("scene {round}"), &rays);
    }
    assert!(hits > 6_000, "only {hits} hits: the test tests nothing");
}

#[test]
fn meshes_of_all_sizes() {
    let mut random = Random(2);
    for count in [1, 2, 3, 7, 8, 9, 15, 16, 17, 31, 33, 63, 65, 200, 1000] {
        let mesh = Arc::new(soup(&mut random, count, 0.5));
        let mut scene = Scene::new();
        scene.add_mesh(&Arc::new(MeshTree::build(&mesh.0, &mesh.1, 1)), &mesh, Placement::IDENTITY);
        let rays = rays(&mut random, 300, 1.5);
        scene.check(&format!("{count} triangles"), &rays);
    }
}

#[test]
fn degenerate_meshes() {
    let mut random = Random(3);
    let one = [Vec3::new(-1.0, -1.0, 0.1), Vec3::new(1.0, -0.9, 0.2), Vec3::new(0.1, 1.0, -0.1)];
    let mut cases: Vec<(&str, Mesh)> = vec![
        ("no triangle", (one.to_vec(), Vec::new())),
        ("all triangles equal", (one.to_vec(), vec![[0, 1, 2]; 5000])),
        ("zero area", (vec![one[0]; 3], vec![[0, 1, 2]; 40])),
        ("index out of range", (one.to_vec(), vec![[0, 1, 2], [0, 1, 3], [9, 1, 2]])),
    ];
    // All in one plane, many overlapping: every ray meets ties.
    let mut flat = soup(&mut random, 400, 1.0);
    flat.0.iter_mut().for_each(|p| p.z = 0.0);
    cases.push(("all in one plane", flat));
    let mut mixed = soup(&mut random, 2000, 0.01);
    mixed.0.extend([Vec3::new(-1e4, -1e4, 0.3), Vec3::new(1e4, -1e4, 0.2), Vec3::new(0.0, 1e4, 0.4)]);
    mixed.1.push([6000, 6001, 6002]);
    cases.push(("one huge and many tiny", mixed));
    let mut needles = soup(&mut random, 500, 1.0);
    needles.0.chunks_exact_mut(3).for_each(|t| t[2] = t[1] + Vec3::new(1e-6, 0.0, 0.0));
    cases.push(("needles", needles));
    let mut broken = soup(&mut random, 50, 1.0);
    broken.0[4].x = f32::NAN;
    broken.0[10].y = f32::INFINITY;
    cases.push(("not finite", broken));
    let line = soup(&mut random, 100, 0.1);
    let spaced: Vec<_> = line.0.iter().enumerate().map(|(k, p)| *p + Vec3::X * 4f32.powi(k as i32 / 30)).collect();
    cases.push(("exponential spacing", (spaced, line.1)));

    for (name, mesh) in cases {
        let (tree, mesh) = (Arc::new(MeshTree::build(&mesh.0, &mesh.1, 2)), Arc::new(mesh));
        let mut scene = Scene::new();
        scene.add_mesh(&tree, &mesh, Placement::IDENTITY);
        // A second instance at the same place: ties between objects.
        scene.add_mesh(&tree, &mesh, Placement::IDENTITY);
        scene.add_mesh(&tree, &mesh, placement(&mut random));
        let rays = rays(&mut random, 200, 1.5);
        // Tests of a triangle with a vertex that is not finite must all fail, so the definition holds for it too.
        if name != "index out of range" {
            scene.check(name, &rays);
        } else {
            let kept = Arc::new((mesh.0.clone(), vec![[0, 1, 2]]));
            scene.meshes.iter_mut().for_each(|m| *m = Some(kept.clone()));
            scene.check(name, &rays);
        }
    }
}

#[test]
fn empty_scene_and_hidden_objects() {
    let mut random = Random(4);
    let rays = rays(&mut random, 100, 2.0);
    assert_eq!(Scene::new().check("empty", &rays), 0);
    let mut hidden = Scene::new();
    (0..3).for_each(|_| hidden.add(Geometry::Hidden));
    hidden.add(Geometry::Sphere { center: Vec3::ZERO, radius: -1.0 });
    hidden.add(Geometry::Sphere { center: Vec3::ZERO, radius: f32::NAN });
    assert_eq!(hidden.check("hidden", &rays), 0);
}

#[test]
fn many_instances() {
    let mut random = Random(5);
    let mesh = Arc::new(octasphere(1));
    let tree = Arc::new(MeshTree::build(&mesh.0, &mesh.1, 1));
    let mut scene = Scene::new();
    for k in 0..1000 {
        let at = Vec3::new((k % 10) as f32, (k / 10 % 10) as f32, (k / 100) as f32) - Vec3::splat(4.5);
        scene.add_mesh(&tree, &mesh, Placement::new(random.rotation(), 0.4, at));
    }
    let rays = rays(&mut random, 300, 6.0);
    assert!(scene.check("1000 instances", &rays) > 100);
}
