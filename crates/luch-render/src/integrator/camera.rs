//! Camera rays: a thin lens before a plane of pixels.

use crate::math::lanes::{LANES, Lanes, Vec3Lanes};
use crate::math::ray::RayBatch;
use crate::sampler::{Use, sample_disk, sample_pair, sample_tent};
use crate::simd::shade_at;
use fearless_simd::Level;
use fearless_simd::prelude::*;
use glam::Vec3;
use luch_scene::{Camera, ImageSize};

/// A camera made ready for the pixels of a picture.
///
/// Rays leave a disk parallel to the picture's plane and meet again at the focal distance, measured along the view
/// direction: what is there is sharp. With the lens closed, the rays are those of a pinhole, bit for bit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Lens {
    position: Vec3,
    right: Vec3,
    up: Vec3,
    forward: Vec3,
    /// Width and height of the picture at distance 1.
    extent: [f32; 2],
    size: [f32; 2],
    radius: f32,
    focus: f32,
    antialiasing: bool,
}

impl Lens {
    /// The lens of a camera for a picture of that size. `antialiasing` spreads the samples over the pixel's filter,
    /// `depth_of_field` over the lens.
    #[must_use]
    pub fn new(camera: &Camera, size: ImageSize, antialiasing: bool, depth_of_field: bool) -> Self {
        let [right, up, forward] = camera.frame();
        let (width, height) = (f64::from(size.width()), f64::from(size.height()));
        let tall = 2.0 * libm::tan(f64::from(camera.fov.get()).to_radians() * 0.5);
        #[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
        let rounded = |v: f64| v as f32;
        Self {
            position: camera.position.get(),
            right,
            up,
            forward,
            extent: [rounded(tall * width / height), rounded(tall)],
            size: [rounded(width), rounded(height)],
            radius: if depth_of_field { camera.lens_radius.get() } else { 0.0 },
            focus: camera.focus(),
            antialiasing,
        }
    }

    /// Makes the rays of one sample of the pixels, given by column and row from the top left.
    pub(crate) fn rays(&self, level: Level, pixels: &[[u32; 2]], sample: u32, rays: &mut RayBatch) {
        rays.resize(pixels.len());
        shade_at!(level, simd => self.fill(simd, pixels, sample, rays));
    }

    #[inline(always)]
    fn fill<S: Simd>(&self, simd: S, pixels: &[[u32; 2]], sample: u32, rays: &mut RayBatch) {
        let lanes = rays.lanes_mut();
        let [ox, oy, oz] = lanes.origin;
        let [dx, dy, dz] = lanes.direction;
        for (group, at) in pixels.chunks(LANES).zip((0..).step_by(LANES)) {
            let mut film = [[0.0; LANES]; 2];
            let mut disk = [[0.0; LANES]; 2];
            for (lane, &[x, y]) in group.iter().enumerate() {
                let offset = if self.antialiasing {
                    sample_pair(x, y, sample, Use::Pixel).map(|u| 0.5 + sample_tent(u))
                } else {
                    [0.5, 0.5]
                };
                #[allow(clippy::cast_precision_loss, reason = "a picture's side is far below 2^24")]
                let place = [x as f32 + offset[0], y as f32 + offset[1]];
                film[0][lane] = place[0];
                film[1][lane] = place[1];
                if self.radius > 0.0 {
                    let point = sample_disk(sample_pair(x, y, sample, Use::Lens));
                    disk[0][lane] = point[0];
                    disk[1][lane] = point[1];
                }
            }
            let (origin, direction) = self.aim(simd, film, disk);
            origin.store([&mut *ox, &mut *oy, &mut *oz], at);
            direction.store([&mut *dx, &mut *dy, &mut *dz], at);
            for lane in 0..group.len() {
                lanes.t_min[at + lane] = 0.0;
                lanes.t_max[at + lane] = f32::INFINITY;
            }
        }
    }

    /// Origins and unit directions of the rays through places of the film (in pixels) and of the unit disk.
    #[inline(always)]
    fn aim<S: Simd>(&self, simd: S, film: [[f32; LANES]; 2], disk: [[f32; LANES]; 2]) -> (Vec3Lanes<S>, Vec3Lanes<S>) {
        let [x, y] = [Lanes::load_array_ref(simd, &film[0]), Lanes::load_array_ref(simd, &film[1])];
        let half = Lanes::splat(simd, 0.5);
        let across = (x / self.size[0] - half) * self.extent[0];
        let along = (half - y / self.size[1]) * self.extent[1];
        let (right, up) = (Vec3Lanes::splat(simd, self.right), Vec3Lanes::splat(simd, self.up));
        let through = Vec3Lanes::splat(simd, self.forward) + right.scale(across) + up.scale(along);
        let position = Vec3Lanes::splat(simd, self.position);
        if self.radius == 0.0 {
            return (position, through.unit_or_zero(simd));
        }
        // `through` reaches the plane of focus after `focus` of its lengths: aim there from the point on the lens.
        let u = Lanes::load_array_ref(simd, &disk[0]) * self.radius;
        let v = Lanes::load_array_ref(simd, &disk[1]) * self.radius;
        let from_center = right.scale(u) + up.scale(v);
        let direction = through - from_center.scale(Lanes::splat(simd, 1.0 / self.focus));
        (position + from_center, direction.unit_or_zero(simd))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simd::SimdLevel;
    use luch_scene::{Aim, Direction, NonNegative, Point, Positive};

    fn camera(lens_radius: f32) -> Camera {
        let along = Aim::Along(Direction::new(Vec3::new(0.3, -0.2, -1.0)).unwrap());
        let mut camera = Camera::new("c", Point::new(Vec3::new(1.0, 2.0, 3.0)).unwrap(), along);
        camera.lens_radius = NonNegative::new(lens_radius).unwrap();
        camera.focal_distance = Some(Positive::new(4.0).unwrap());
        camera
    }

    fn rays_of(lens: &Lens, pixels: &[[u32; 2]], sample: u32) -> RayBatch {
        let mut rays = RayBatch::new();
        lens.rays(SimdLevel::Auto.level_or_best(), pixels, sample, &mut rays);
        rays
    }

    #[test]
    fn the_middle_of_the_picture_is_the_view_direction_and_its_edges_the_field_of_view() {
        let size = ImageSize::new(201, 101).unwrap();
        let camera = camera(0.0);
        let lens = Lens::new(&camera, size, false, false);
        let rays = rays_of(&lens, &[[100, 50], [100, 0], [0, 50]], 0);
        assert!((rays.get(0).direction - camera.direction()).length() < 1e-6);
        // The centre of the top pixel lies half a pixel inside the picture.
        let tan = libm::tanf(45.0_f32.to_radians() * 0.5);
        let angle = |i: usize| libm::tanf(rays.get(i).direction.dot(camera.direction()).acos());
        assert!((angle(1) - tan * 100.0 / 101.0).abs() < 1e-4, "{}", angle(1));
        assert!((angle(2) - tan * 200.0 / 101.0).abs() < 1e-4, "{}", angle(2));
    }

    #[test]
    fn rays_through_the_lens_meet_at_the_focal_distance() {
        let size = ImageSize::new(64, 48).unwrap();
        let (open, forward) = (camera(0.5), camera(0.5).direction());
        let lens = Lens::new(&open, size, false, true);
        for pixel in [[0, 0], [63, 47], [20, 31]] {
            let pinhole = rays_of(&Lens::new(&open, size, false, false), &[pixel], 0).get(0);
            let sharp = pinhole.origin + pinhole.direction * (4.0 / pinhole.direction.dot(forward));
            for sample in 0..64 {
                let ray = rays_of(&lens, &[pixel], sample).get(0);
                assert!((ray.origin - pinhole.origin).length() <= 0.5 + 1e-6);
                assert!((ray.origin - pinhole.origin).dot(forward).abs() < 1e-6, "the disk is parallel to the picture");
                let meets =
                    ray.origin + ray.direction * ((sharp - ray.origin).dot(forward) / ray.direction.dot(forward));
                assert!((meets - sharp).length() < 1e-5, "{pixel:?} {sample}");
            }
        }
    }

    #[test]
    fn a_closed_lens_is_a_pinhole_bit_for_bit() {
        let size = ImageSize::new(64, 48).unwrap();
        let pixels: Vec<[u32; 2]> = (0..64).map(|x| [x, x % 48]).collect();
        let closed = rays_of(&Lens::new(&camera(0.0), size, false, true), &pixels, 3);
        let pinhole = rays_of(&Lens::new(&camera(0.7), size, false, false), &pixels, 0);
        for i in 0..pixels.len() {
            assert_eq!(closed.get(i), pinhole.get(i));
        }
    }

    #[test]
    fn a_ray_does_not_depend_on_its_batch_or_the_instruction_set() {
        let size = ImageSize::new(640, 480).unwrap();
        let pixels: Vec<[u32; 2]> = (0..40).map(|i| [i * 13, i * 11]).collect();
        let lens = Lens::new(&camera(0.2), size, true, true);
        let all = rays_of(&lens, &pixels, 7);
        for level in SimdLevel::available() {
            for (i, pixel) in pixels.iter().enumerate() {
                let mut one = RayBatch::new();
                lens.rays(level.level_or_best(), &[*pixel], 7, &mut one);
                assert_eq!(one.get(0), all.get(i), "{} {i}", level.word());
            }
        }
    }
}
