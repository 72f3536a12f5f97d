//! The renderer once more, in f64, by brute force, one ray at a time, written from the specification alone: slow, plain,
//! and sharing no code with the renderer that it checks.

use glam::{DMat3, DVec3, Vec3};
use luch_render::RenderJob;
use luch_scene::{Aim, Scene, Shading, Shape};

/// What a ray met.
struct Hit {
    t: f64,
    object: usize,
    position: DVec3,
    /// The face's own normal, towards the ray.
    face: DVec3,
    /// The normal that light is worked out with.
    normal: DVec3,
    /// A mesh triangle's corners: position, normal, weight.
    corners: Option<[(DVec3, DVec3, f64); 3]>,
}

/// The linear colour of each pixel, without antialiasing and depth of field.
pub fn picture(scene: &Scene, job: &RenderJob) -> Vec<f32> {
    let (width, height) = (f64::from(job.size.width()), f64::from(job.size.height()));
    let eye = job.camera.position.get().as_dvec3();
    let forward = match job.camera.aim {
        Aim::At(target) => (target.get().as_dvec3() - eye).normalize(),
        Aim::Along(direction) => direction.get().as_dvec3().normalize(),
    };
    let right = forward.cross(DVec3::Y).normalize();
    let up = right.cross(forward);
    let tall = (f64::from(job.camera.fov.get()).to_radians() / 2.0).tan();
    let mut linear = Vec::new();
    for y in 0..job.size.height() {
        for x in 0..job.size.width() {
            let across = ((f64::from(x) + 0.5) / width * 2.0 - 1.0) * tall * width / height;
            let along = (1.0 - (f64::from(y) + 0.5) / height * 2.0) * tall;
            let direction = (forward + right * across + up * along).normalize();
            linear.extend(radiance(scene, eye, direction, job.depth).as_vec3().to_array());
        }
    }
    linear
}

fn radiance(scene: &Scene, origin: DVec3, direction: DVec3, depth: u32) -> DVec3 {
    if depth == 0 {
        return color(scene.background.get());
    }
    let Some(hit) = nearest(scene, origin, direction, f64::INFINITY) else { return color(scene.background.get()) };
    let local = lit(scene, &hit, origin);
    let reflection = f64::from(scene.objects[hit.object].material.reflection.get());
    if reflection == 0.0 {
        return local;
    }
    let mut mirrored = direction - hit.normal * 2.0 * direction.dot(hit.normal);
    let height = mirrored.dot(hit.face);
    if height < 1e-3 {
        mirrored = (mirrored + hit.face * (1e-3 - height)).normalize();
    }
    let from = hit.position + hit.face * 1e-9 * (1.0 + hit.position.length());
    local * (1.0 - reflection) + radiance(scene, from, mirrored, depth - 1) * reflection
}

/// Ambient, diffuse and highlight of every light that the point sees.
fn lit(scene: &Scene, hit: &Hit, eye: DVec3) -> DVec3 {
    let object = &scene.objects[hit.object];
    let base = base_color(scene, hit);
    let gloss = object.material.gloss.map_or(0.0, |g| f64::from(g.get()));
    let (k_s, n) = (gloss, 2.0_f64.powf(2.0 + 6.0 * gloss));
    let mut sum = base * f64::from(scene.ambient.get());
    for light in scene.lights.iter().filter(|l| !l.hidden) {
        let place = light.position.get().as_dvec3();
        let terms = |p: DVec3, normal: DVec3| {
            let d = (place - p).length();
            let l = (place - p) / d;
            let cos_theta = normal.dot(l).max(0.0);
            let mirror = normal * 2.0 * normal.dot(l) - l;
            let cos_alpha = mirror.dot((eye - p).normalize()).max(0.0);
            let k = f64::from(scene.attenuation.get());
            let strength = f64::from(light.intensity.get()) * k / (d + k);
            let highlight = if cos_theta > 0.0 { k_s * cos_alpha.powf(n) } else { 0.0 };
            (strength * cos_theta, strength * highlight)
        };
        let (diffuse, specular) = match (&hit.corners, object.shading.unwrap_or(scene.settings.shading)) {
            (Some(corners), Shading::Gouraud) => corners.iter().fold((0.0, 0.0), |(d, s), &(p, normal, weight)| {
                let (diffuse, specular) = terms(p, normal);
                (d + weight * diffuse, s + weight * specular)
            }),
            _ => terms(hit.position, hit.normal),
        };
        if (diffuse > 0.0 || specular > 0.0) && sees(scene, hit, place) {
            sum += (base * diffuse + DVec3::splat(specular)) * color(light.color.get());
        }
    }
    sum
}

/// Whether nothing stands between the point and the light. Smooth meshes are tested from the curved surface that they
/// stand for (Hanika 2021), not from the flat face.
fn sees(scene: &Scene, hit: &Hit, light: DVec3) -> bool {
    let smooth = scene.objects[hit.object].shading.unwrap_or(scene.settings.shading) != Shading::Flat;
    let mut from = hit.position;
    if let Some(corners) = hit.corners.filter(|_| smooth) {
        for (p, normal, weight) in corners {
            from += normal * (-(hit.position - p).dot(normal)).max(0.0) * weight;
        }
    }
    from += hit.face * 1e-9 * (1.0 + from.length());
    let way = light - from;
    nearest(scene, from, way.normalize(), way.length() * 0.999_9).is_none()
}

fn base_color(scene: &Scene, hit: &Hit) -> DVec3 {
    let object = &scene.objects[hit.object];
    let own = object.material.color.unwrap_or(luch_scene::Material::DEFAULT_COLOR);
    let Some(checker) = object.material.checker else { return color(own.get()) };
    let Shape::Wall { point, normal, .. } = &object.shape else { panic!("the oracle knows patterns on walls only") };
    let [u, v] = Shape::wall_axes(*normal);
    let from = hit.position - point.get().as_dvec3();
    let squares = |axis: Vec3| (from.dot(axis.as_dvec3()) / f64::from(checker.size.get())).floor();
    let odd = (squares(u) + squares(v)).rem_euclid(2.0) == 1.0;
    color(if odd { checker.color.get() } else { own.get() })
}

fn color(c: Vec3) -> DVec3 {
    c.as_dvec3()
}

/// The nearest hit at `0 < t < t_max`: every object, every triangle.
fn nearest(scene: &Scene, origin: DVec3, direction: DVec3, t_max: f64) -> Option<Hit> {
    let mut best: Option<Hit> = None;
    for (object, thing) in scene.objects.iter().enumerate().filter(|(_, o)| !o.hidden) {
        let mut keep = |t: f64, normal: DVec3, smooth: Option<[(DVec3, DVec3, f64); 3]>| {
            if t > 0.0 && t < t_max && best.as_ref().is_none_or(|b| t < b.t) {
                let face = if normal.dot(direction) > 0.0 { -normal } else { normal };
                let corners = smooth.map(|corners| {
                    let sum: DVec3 = corners.iter().map(|c| c.1).sum();
                    let side = if sum.dot(face) < 0.0 { -1.0 } else { 1.0 };
                    corners.map(|(p, n, w)| (p, n * side, w))
                });
                let blended = corners.map(|c| c.iter().map(|(_, n, w)| *n * *w).sum::<DVec3>().normalize());
                let flat = thing.shading.unwrap_or(scene.settings.shading) == Shading::Flat;
                let normal = if flat { face } else { blended.unwrap_or(face) };
                best = Some(Hit { t, object, position: origin + direction * t, face, normal, corners });
            }
        };
        match &thing.shape {
            Shape::Sphere { center, radius } => {
                let (c, r) = (center.get().as_dvec3(), f64::from(radius.get()));
                let oc = origin - c;
                let half_b = oc.dot(direction);
                let root = (half_b * half_b - oc.length_squared() + r * r).sqrt();
                for t in [-half_b - root, -half_b + root] {
                    keep(t, (oc + direction * t) / r, None);
                }
            }
            Shape::Wall { point, normal, size } => {
                let (p, n) = (point.get().as_dvec3(), normal.get().as_dvec3().normalize());
                let t = (p - origin).dot(n) / direction.dot(n);
                let from = origin + direction * t - p;
                let inside = size.is_none_or(|[w, h]| {
                    let [u, v] = Shape::wall_axes(*normal).map(|axis| from.dot(axis.as_dvec3()).abs() * 2.0);
                    u <= f64::from(w.get()) && v <= f64::from(h.get())
                });
                if inside {
                    keep(t, n, None);
                }
            }
            Shape::Cuboid { center, size, rotation } => {
                let axes = matrix(rotation.degrees().as_dvec3());
                let c = center.get().as_dvec3();
                for axis in 0..3 {
                    for side in [-1.0, 1.0] {
                        let n = axes.col(axis) * side;
                        let half = |k: usize| f64::from(size[k].get()) / 2.0;
                        let t = (c + n * half(axis) - origin).dot(n) / direction.dot(n);
                        let from = origin + direction * t - c;
                        if (0..3).all(|k| k == axis || from.dot(axes.col(k)).abs() <= half(k)) {
                            keep(t, n, None);
                        }
                    }
                }
            }
            Shape::Mesh(instance) => {
                let turn = matrix(instance.rotation.degrees().as_dvec3());
                let (scale, place) = (f64::from(instance.scale.get()), instance.position.get().as_dvec3());
                let mesh = &instance.mesh;
                let world = |p: [f32; 3]| turn * (Vec3::from_array(p).as_dvec3() * scale) + place;
                for (corners, normals) in mesh.triangles().iter().zip(mesh.normal_triangles()) {
                    let [a, b, c] = corners.map(|i| world(mesh.positions()[i as usize]));
                    let [na, nb, nc] = normals.map(|i| turn * Vec3::from_array(mesh.normals()[i as usize]).as_dvec3());
                    let cross = (b - a).cross(c - a);
                    let n = cross.normalize();
                    let t = (a - origin).dot(n) / direction.dot(n);
                    let p = origin + direction * t;
                    let weight = |from: DVec3, to: DVec3| (to - from).cross(p - from).dot(n) / cross.length();
                    let w = [weight(b, c), weight(c, a), weight(a, b)];
                    if w.iter().all(|w| *w >= 0.0) {
                        keep(t, n, Some([(a, na, w[0]), (b, nb, w[1]), (c, nc, w[2])]));
                    }
                }
            }
        }
    }
    best
}

/// About x, then y, then z.
fn matrix(degrees: DVec3) -> DMat3 {
    let [x, y, z] = degrees.to_array().map(f64::to_radians);
    DMat3::from_rotation_z(z) * DMat3::from_rotation_y(y) * DMat3::from_rotation_x(x)
}
