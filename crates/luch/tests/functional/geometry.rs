//! What the scene's numbers say about the picture, in f64.

use glam::DVec3;
use luch_scene::{Camera, Light, Scene, Shape};

/// A ray of unit direction.
#[derive(Clone, Copy)]
pub(crate) struct Ray {
    pub(crate) origin: DVec3,
    pub(crate) direction: DVec3,
}

/// A camera before a picture of some size.
pub(crate) struct View {
    frame: [DVec3; 3],
    position: DVec3,
    size: [usize; 2],
    /// Pixels that a length of one takes at distance one.
    pub(crate) scale: f64,
}

impl View {
    pub(crate) fn new(camera: &Camera, size: [usize; 2]) -> Self {
        Self::with_fov(camera, f64::from(camera.fov.get()), size)
    }

    pub(crate) fn with_fov(camera: &Camera, degrees: f64, size: [usize; 2]) -> Self {
        Self {
            frame: camera.frame().map(|v| v.as_dvec3()),
            position: camera.position.get().as_dvec3(),
            size,
            scale: size[1] as f64 / (2.0 * (degrees.to_radians() / 2.0).tan()),
        }
    }

    /// The ray through the middle of a pixel.
    pub(crate) fn ray(&self, pixel: usize) -> Ray {
        let [width, height] = self.size;
        let x = (pixel % width) as f64 + 0.5 - width as f64 / 2.0;
        let y = height as f64 / 2.0 - (pixel / width) as f64 - 0.5;
        let [right, up, forward] = self.frame;
        let direction = forward + (right * x + up * y) / self.scale;
        Ray { origin: self.position, direction: direction / direction.length() }
    }

    /// The distance along the view direction of what is at `t` along the ray through a pixel.
    pub(crate) fn depth(&self, pixel: usize, t: f64) -> f64 {
        self.ray(pixel).direction.dot(self.frame[2]) * t
    }

    /// The column and row where a point is seen.
    pub(crate) fn project(&self, point: DVec3) -> [f64; 2] {
        let [x, y, z] = self.frame.map(|axis| axis.dot(point - self.position));
        let [width, height] = self.size.map(|s| s as f64);
        [width / 2.0 + x / z * self.scale, height / 2.0 - y / z * self.scale]
    }
}

/// A sphere of the scene.
pub(crate) struct Sphere {
    pub(crate) object: usize,
    center: DVec3,
    radius: f64,
}

pub(crate) fn spheres(scene: &Scene) -> Vec<Sphere> {
    let sphere = |(object, shape): (usize, &Shape)| match shape {
        Shape::Sphere { center, radius } => {
            Some(Sphere { object, center: center.get().as_dvec3(), radius: f64::from(radius.get()) })
        }
        _ => None,
    };
    scene.objects.iter().map(|o| &o.shape).enumerate().filter_map(sphere).collect()
}

impl Sphere {
    /// The nearer hit of a ray from outside.
    fn hit(&self, ray: Ray) -> Option<f64> {
        let to_center = self.center - ray.origin;
        let along = to_center.dot(ray.direction);
        let half_chord = self.radius.powi(2) - (to_center.length_squared() - along * along);
        (half_chord >= 0.0).then(|| along - half_chord.sqrt()).filter(|t| *t > 0.0)
    }

    /// Where a ray hits and the normal there.
    pub(crate) fn point(&self, ray: Ray) -> Option<(DVec3, DVec3)> {
        let point = ray.origin + ray.direction * self.hit(ray)?;
        Some((point, (point - self.center) / self.radius))
    }
}

/// The index of the sphere that a ray meets first.
pub(crate) fn first_sphere(spheres: &[Sphere], ray: Ray) -> Option<usize> {
    let hits = spheres.iter().filter_map(|s| Some((s.hit(ray)?, s.object)));
    hits.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, object)| object)
}

/// cos(theta), cos(alpha) and the share of a light's strength that arrives (SPEC 3), with nothing in between.
pub(crate) struct Terms {
    pub(crate) cos_theta: f64,
    pub(crate) cos_alpha: f64,
    pub(crate) strength: f64,
}

pub(crate) fn terms(scene: &Scene, light: &Light, ray: Ray, (point, normal): (DVec3, DVec3)) -> Terms {
    let to_light = light.position.get().as_dvec3() - point;
    let distance = to_light.length();
    let l = to_light / distance;
    let mirrored = normal * (2.0 * normal.dot(l)) - l;
    let k = f64::from(scene.attenuation.get());
    Terms {
        cos_theta: normal.dot(l),
        cos_alpha: mirrored.dot(-ray.direction),
        strength: f64::from(light.intensity.get()) * k / (distance + k),
    }
}
