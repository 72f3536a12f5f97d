//! Every shape against an oracle in f64, on random and adversarial rays; the slab test on every edge case of its signs
//! and zeros.

mod support;

use glam::{DVec3, Vec3};
use luch_render::accel::{Geometry, SceneTree, available_levels};
use luch_render::math::ray::{Coherence, HitBatch, Ray, RayBatch};
use luch_render::shape::cuboid::{self, Cuboid};
use luch_render::shape::plane::{self, Rectangle};
use luch_render::shape::sphere;
use luch_render::shape::triangle::{self, ShearedRay};
use support::Random;

const RAYS: usize = 100_000;

/// What exact arithmetic says: the hit, or that the ray passes so close to an edge that f32 may say either.
#[derive(Debug, PartialEq)]
enum Oracle {
    Hit(f64),
    Miss,
    TooClose,
}

/// Picks the first root inside the ray's interval; too close where an end of the interval lies on a root.
fn first_inside(roots: &[f64], ray: &Ray) -> Oracle {
    for &t in roots {
        let near_end = |end: f32| (t - f64::from(end)).abs() <= 1e-5 * t.abs().max(1e-3);
        if near_end(ray.t_min) || near_end(ray.t_max) {
            return Oracle::TooClose;
        }
        if f64::from(ray.t_min) < t && t < f64::from(ray.t_max) {
            return Oracle::Hit(t);
        }
    }
    Oracle::Miss
}

/// Runs `RAYS` cases; `tolerance` is relative to the larger of t and 1e-3. At most 5 % may be too close to call.
fn check(name: &str, tolerance: f64, mut case: impl FnMut(&mut Random) -> (Ray, Option<f32>, Oracle)) {
    let mut random = Random(11);
    let (mut hits, mut unclear) = (0, 0);
    for k in 0..RAYS {
        let (ray, got, want) = case(&mut random);
        match (got, want) {
            (_, Oracle::TooClose) => unclear += 1,
            (Some(t), Oracle::Hit(exact)) => {
                hits += 1;
                let error = (f64::from(t) - exact).abs() / exact.abs().max(1e-3);
                assert!(error <= tolerance, "{name} {k}: t {t}, exact {exact}, error {error:e}, {ray:?}");
                assert!(ray.t_min < t && t < ray.t_max, "{name} {k}: t {t} outside {ray:?}");
            }
            (None, Oracle::Miss) => {}
            (got, want) => panic!("{name} {k}: got {got:?}, want {want:?}, {ray:?}"),
        }
    }
    assert!(hits > RAYS / 10 && unclear < RAYS / 20, "{name}: {hits} hits, {unclear} too close to call");
}

/// A ray from near, far or very far that mostly points at `target` within `size`.
fn ray_at(random: &mut Random, target: Vec3, size: f32) -> Ray {
    let distance = size * [0.0, 0.5, 2.0, 30.0, 1e3, 1e6][random.below(6)];
    let origin = target + random.direction() * distance + random.point() * size * 0.3;
    let aim = target + random.point() * size * 1.3;
    let direction = match random.below(6) {
        0 => Vec3::AXES[random.below(3)] * if random.below(2) == 0 { 1.0 } else { -1.0 },
        1 => random.direction(),
        _ => (aim - origin) * [1.0, 1e-3, 40.0][random.below(3)],
    };
    let mut ray = Ray::new(origin, direction);
    if random.below(4) == 0 {
        ray.t_min = random.unit() * distance / direction.length().max(1e-20);
    }
    if random.below(4) == 0 {
        ray.t_max = 2.0 * random.unit() * distance / direction.length().max(1e-20);
    }
    ray
}

fn scale(random: &mut Random) -> f32 {
    [1e-3, 0.1, 1.0, 10.0, 1e3, 1e6][random.below(6)]
}

#[test]
fn sphere_matches_the_oracle() {
    check("sphere", 2e-7, |random| {
        let radius = scale(random) * (0.2 + random.unit());
        let center = random.point() * radius * 5.0;
        let ray = ray_at(random, center, radius);
        let (f, d, r) = (ray.origin.as_dvec3() - center.as_dvec3(), ray.direction.as_dvec3(), f64::from(radius));
        let middle = -f.dot(d) / d.length_squared();
        // The distance of the line from the centre by the cross product: another way than the kernel's.
        let distance = f.cross(d).length() / d.length();
        let want = if (distance - r).abs() < 1e-9 * f.length().max(r) {
            Oracle::TooClose
        } else if distance > r {
            Oracle::Miss
        } else {
            let half = ((r - distance) * (r + distance)).sqrt() / d.length();
            // A root much smaller than the way to the centre is left to the next test: t 0 is not relative.
            let roots = [middle - half, middle + half];
            if roots.iter().any(|t| t.abs() < 1e-7 * (middle.abs() + half)) {
                Oracle::TooClose
            } else {
                first_inside(&roots, &ray)
            }
        };
        (ray, sphere::intersect(center, radius, &ray), want)
    });
}

#[test]
fn sphere_is_accurate_a_million_radii_away_and_from_its_surface() {
    let mut random = Random(5);
    for _ in 0..1000 {
        let direction = random.direction();
        let ray = Ray::new(direction * -1e6, direction);
        let t = sphere::intersect(Vec3::ZERO, 1.0, &ray).expect("through the middle");
        assert!((t - 999_999.0).abs() <= 0.5, "t {t}");
        let inside = sphere::intersect(Vec3::ZERO, 1.0, &Ray::new(Vec3::ZERO, direction)).expect("from the centre");
        assert!((inside - 1.0).abs() < 1e-6, "t {inside}");
    }
    for radius in [0.0, -1.0, f32::NAN] {
        assert_eq!(sphere::intersect(Vec3::ZERO, radius, &Ray::new(Vec3::Z * 3.0, Vec3::NEG_Z)), None);
    }
    assert_eq!(sphere::intersect(Vec3::ZERO, 1.0, &Ray::new(Vec3::ZERO, Vec3::ZERO)), None);
}

#[test]
fn cuboid_matches_the_oracle() {
    check("cuboid", 1e-4, |random| {
        let size = scale(random);
        let half_size = (random.point().abs() + Vec3::splat(0.1)) * size;
        let rotation = (random.below(2) == 0).then(|| random.rotation());
        let cuboid = Cuboid { center: random.point() * size, half_size, rotation };
        let mut ray = ray_at(random, cuboid.center, size);
        if rotation.is_some() || (ray.origin - cuboid.center).length() > 100.0 * size {
            // Taking the ray into the box's axes rounds by 1e-7 of the distance: stay where that is far from an edge.
            ray.origin = cuboid.center + (ray.origin - cuboid.center).clamp_length_max(10.0 * size);
        }
        let local = |v: Vec3| match rotation {
            Some(m) => m.as_dmat3().transpose() * v.as_dvec3(),
            None => v.as_dvec3(),
        };
        let o = local(ray.origin) - local(cuboid.center);
        let (want, _) = slabs(o, local(ray.direction), half_size.as_dvec3(), 1e-5, &ray);
        (ray, cuboid::intersect(&cuboid, &ray).map(|hit| hit.0), want)
    });
}

/// The slab test in f64; `margin` relative.
fn slabs(o: DVec3, d: DVec3, half: DVec3, margin: f64, ray: &Ray) -> (Oracle, [f64; 2]) {
    let (mut near, mut far, mut reach) = (f64::NEG_INFINITY, f64::INFINITY, 0.0_f64);
    for axis in 0..3 {
        if d[axis] == 0.0 {
            if o[axis].abs() > half[axis] {
                return (Oracle::Miss, [near, far]);
            }
            continue;
        }
        let (a, b) = ((-half[axis] - o[axis]) / d[axis], (half[axis] - o[axis]) / d[axis]);
        (near, far) = (near.max(a.min(b)), far.min(a.max(b)));
        reach = reach.max(o[axis].abs().max(half[axis]) / d.length());
    }
    let close = margin * reach;
    let oracle = if margin > 0.0 && ((near - far).abs() < close || near.abs() < close || far.abs() < close) {
        Oracle::TooClose
    } else if near > far {
        Oracle::Miss
    } else {
        first_inside(&[near, far], ray)
    };
    (oracle, [near, far])
}

#[test]
fn cuboid_is_exact_in_every_case_of_signs_and_zeros() {
    // Coordinates are small integers and halves, so f32, f64 and the rationals agree.
    let mut rays = RayBatch::new();
    let mut expected = Vec::new();
    let cuboid = Cuboid { center: Vec3::ZERO, half_size: Vec3::new(1.0, 2.0, 4.0), rotation: None };
    let signs = [-1.0_f32, 0.0, 1.0];
    // On a face, edge and corner, inside, outside; +0 and -0.
    let places = [-8.0_f32, -1.0, -0.0, 0.0, 0.5, 1.0, 8.0];
    for direction in (0..27).map(|k| Vec3::new(signs[k % 3], signs[k / 3 % 3], signs[k / 9])) {
        for origin in (0..343).map(|k| Vec3::new(places[k % 7], places[k / 7 % 7], places[k / 49]) * cuboid.half_size) {
            for zero in [0.0_f32, -0.0] {
                let direction = Vec3::from(direction.to_array().map(|d| if d == 0.0 { zero } else { d }));
                let ray = Ray::new(origin, direction);
                let (o, d) = (origin.as_dvec3(), direction.as_dvec3());
                let want = if direction == Vec3::ZERO {
                    None
                } else {
                    let (_, [near, far]) = slabs(o, d, cuboid.half_size.as_dvec3(), 0.0, &ray);
                    let met = near <= far && d.abs().max_element() > 0.0 && parallel_inside(o, d, &cuboid);
                    [near, far].into_iter().find(|&t| met && t > 0.0 && t.is_finite())
                };
                let got = cuboid::intersect(&cuboid, &ray);
                assert_eq!(got.map(|hit| f64::from(hit.0)), want, "{ray:?}");
                rays.push(&ray);
                expected.push(got);
            }
        }
    }
    // The kernels say the same.
    let tree = SceneTree::build(&[Geometry::Cuboid(cuboid)]);
    for (name, level) in available_levels() {
        for coherence in [Coherence::Coherent, Coherence::Incoherent] {
            let mut hits = HitBatch::new();
            tree.closest_hits(level, &rays, coherence, &mut hits);
            for (k, want) in expected.iter().enumerate() {
                assert_eq!(hits.get(k).map(|h| (h.t, h.primitive)), *want, "{name} {:?}", rays.get(k));
            }
        }
    }
}

fn parallel_inside(o: DVec3, d: DVec3, cuboid: &Cuboid) -> bool {
    (0..3).all(|axis| d[axis] != 0.0 || o[axis].abs() <= f64::from(cuboid.half_size[axis]))
}

#[test]
fn cuboid_hit_by_a_ray_along_its_edge() {
    // computergraphics.stackexchange.com/q/9533: y lies on a slab and the ray is parallel to it; x lies inside.
    let (low, high) = (Vec3::new(3.223, 0.241, 2.119), Vec3::new(3.225, 0.243, 2.121));
    let cuboid = Cuboid { center: (low + high) * 0.5, half_size: (high - low) * 0.5, rotation: None };
    // The centre and half size round differently from the corners: aim at the face the box really has.
    let origin = Vec3::new(cuboid.center.x, cuboid.center.y + cuboid.half_size.y, 2.221);
    let on_face = origin.y - cuboid.center.y <= cuboid.half_size.y;
    let hit = cuboid::intersect(&cuboid, &Ray::new(origin, Vec3::NEG_Z));
    assert_eq!(hit.is_some(), on_face, "{hit:?}");
}

#[test]
fn plane_and_rectangle_match_the_oracle() {
    check("plane", 2e-5, |random| {
        let size = scale(random);
        let turn = random.rotation();
        let (point, normal) = (random.point() * size, turn.z_axis);
        let rectangle = Rectangle { axis_u: turn.x_axis, axis_v: turn.y_axis, half_u: size, half_v: size * 0.4 };
        let bounds = (random.below(2) == 0).then_some(rectangle);
        let mut ray = ray_at(random, point, size);
        ray.origin = point + (ray.origin - point).clamp_length_max(30.0 * size);
        let (o, d, n) = (ray.origin.as_dvec3() - point.as_dvec3(), ray.direction.as_dvec3(), normal.as_dvec3());
        let t = -o.dot(n) / d.dot(n);
        let grazing = d.dot(n).abs() < 2e-2 * d.length() || o.dot(n).abs() < 2e-2 * o.length();
        let mut want = first_inside(&[t], &ray);
        if let (Some(r), Oracle::Hit(_)) = (bounds, &want) {
            let p = o + d * t;
            let outside = (p.dot(r.axis_u.as_dvec3()).abs() - f64::from(r.half_u))
                .max(p.dot(r.axis_v.as_dvec3()).abs() - f64::from(r.half_v));
            if outside.abs() < 3e-5 * (o.length() + f64::from(size)) {
                want = Oracle::TooClose;
            } else if outside > 0.0 {
                want = Oracle::Miss;
            }
        }
        // What is nearly parallel or starts nearly in the plane: only that the answer is sound.
        let got = plane::intersect(point, normal, bounds.as_ref(), &ray);
        assert!(got.is_none_or(|t| t.is_finite() && ray.t_min < t && t < ray.t_max), "{got:?} {ray:?}");
        if grazing {
            return (ray, None, Oracle::Miss);
        }
        (ray, got, want)
    });
    let parallel = Ray::new(Vec3::Y, Vec3::X);
    assert_eq!(plane::intersect(Vec3::ZERO, Vec3::Y, None, &parallel), None);
    assert_eq!(plane::intersect(Vec3::Y, Vec3::Y, None, &parallel), None, "in the plane");
}

#[test]
fn triangle_matches_the_oracle() {
    check("triangle", 2e-4, |random| {
        let size = scale(random);
        let center = random.point() * size * 2.0;
        let vertices = [0; 3].map(|_| center + random.point() * size);
        let mut ray = ray_at(random, center, size * 0.4);
        ray.origin = center + (ray.origin - center).clamp_length_max(30.0 * size);
        let [a, b, c] = vertices.map(|v| v.as_dvec3() - ray.origin.as_dvec3());
        let d = ray.direction.as_dvec3();
        let n = (b - a).cross(c - a);
        let (u, v, w) = (d.dot(c.cross(b)), d.dot(a.cross(c)), d.dot(b.cross(a)));
        let sum = u + v + w;
        let t = a.dot(n) / d.dot(n);
        let slim = n.length() < 0.05 * f64::from(size) * f64::from(size);
        let steep = d.dot(n).abs() < 0.05 * d.length() * n.length() || a.dot(n).abs() < 0.01 * a.length() * n.length();
        let edge = [u, v, w].iter().map(|e| e / sum).fold(f64::INFINITY, f64::min);
        let got = triangle::intersect(vertices, &ray, &ShearedRay::new(ray.direction));
        if let Some(hit) = got {
            assert!(hit.t.is_finite() && ray.t_min < hit.t && hit.t < ray.t_max, "{hit:?} {ray:?}");
            assert!(hit.u >= -0.0 && hit.v >= -0.0 && hit.u + hit.v <= 1.0 + 1e-6, "{hit:?}");
        }
        if slim || steep {
            return (ray, None, Oracle::Miss);
        }
        let want = if edge.abs() < 3e-4 {
            Oracle::TooClose
        } else if edge < 0.0 {
            Oracle::Miss
        } else {
            if let Some(hit) = got {
                let error = (f64::from(hit.u) - v / sum).abs().max((f64::from(hit.v) - w / sum).abs());
                assert!(error < 1e-3, "weights {hit:?}, exact {} {}", v / sum, w / sum);
            }
            first_inside(&[t], &ray)
        };
        (ray, got.map(|hit| hit.t), want)
    });
}

#[test]
fn a_triangle_without_area_is_never_hit() {
    let mut random = Random(9);
    for k in 0..10_000 {
        let (a, b) = (random.point(), random.point());
        let vertices = match k % 4 {
            0 => [a, a, a],
            1 => [a, b, a],
            2 => [a, a, b],
            _ => [a, Vec3::new(f32::NAN, 0.0, 0.0), b],
        };
        let ray = Ray::new(random.point() * 3.0, random.direction());
        let through = Ray { direction: a + (b - a) * random.unit() - ray.origin, ..ray };
        for ray in [ray, through] {
            assert_eq!(triangle::intersect(vertices, &ray, &ShearedRay::new(ray.direction)), None);
        }
    }
}
