//! Camera rays: a thin lens before a plane of pixels.

use crate::math::lanes::{LANES, Lanes, Vec3Lanes};
use crate::math::ray::RayBatch;
use crate::sampler::{Use, sample_disk, sample_pair, sample_tent};
use crate::simd::shade_at;
use fearless_simd::Level;
use fearless_simd::prelude::*;
use fearless_simd::u32x16;
use glam::Vec3;
use luch_scene::{Camera, ImageSize};

/// Pixels of a picture in the order of their rays, column and row from the top left, padded to whole groups of lanes.
#[derive(Debug, Default)]
pub(crate) struct PixelList {
    columns: Vec<u32>,
    rows: Vec<u32>,
    len: usize,
}

impl PixelList {
    /// Replaces the pixels.
    pub(crate) fn set(&mut self, pixels: impl ExactSizeIterator<Item = [u32; 2]>) {
        self.len = pixels.len();
        let padded = self.len.next_multiple_of(LANES);
        for list in [&mut self.columns, &mut self.rows] {
            list.resize(padded, 0);
        }
        for ((column, row), [x, y]) in self.columns.iter_mut().zip(&mut self.rows).zip(pixels) {
            (*column, *row) = (x, y);
        }
    }

    /// How many pixels there are, padding not counted.
    pub(crate) const fn len(&self) -> usize {
        self.len
    }
}

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

    /// The lens closed, with one ray through the centre of each block of `shrink` times `shrink` pixels: block (i, j)
    /// takes the place of pixel (i, j). The last blocks of a row or column may reach beyond the picture.
    #[must_use]
    pub(crate) fn of_blocks(self, shrink: u32) -> Self {
        #[allow(clippy::cast_precision_loss, reason = "at most the side of a picture")]
        let side = shrink as f32;
        Self { size: self.size.map(|pixels| pixels / side), radius: 0.0, antialiasing: false, ..self }
    }

    /// Whether every ray goes through the centre of its pixel, from the centre of the lens.
    pub(crate) fn is_centered(&self) -> bool {
        !self.antialiasing && self.radius == 0.0
    }

    /// Makes the rays of one sample of the pixels.
    pub(crate) fn rays(&self, level: Level, pixels: &PixelList, sample: u32, rays: &mut RayBatch) {
        rays.resize(pixels.len);
        shade_at!(level, simd => self.fill(simd, pixels, sample, rays));
    }

    #[inline(always)]
    fn fill<S: Simd>(&self, simd: S, pixels: &PixelList, sample: u32, rays: &mut RayBatch) {
        let lanes = rays.lanes_mut();
        let [ox, oy, oz] = lanes.origin;
        let [dx, dy, dz] = lanes.direction;
        let half = Lanes::splat(simd, 0.5);
        let mut offset = [[0.0; LANES]; 2];
        let mut disk = [[0.0; LANES]; 2];
        for at in (0..pixels.columns.len()).step_by(LANES) {
            let columns = u32x16::from_slice(simd, &pixels.columns[at..at + LANES]);
            let rows = u32x16::from_slice(simd, &pixels.rows[at..at + LANES]);
            let [mut x, mut y]: [Lanes<S>; 2] = [columns.to_float(), rows.to_float()];
            if self.antialiasing || self.radius > 0.0 {
                self.draw(pixels, at, sample, &mut offset, &mut disk);
            }
            if self.antialiasing {
                x += Lanes::load_array_ref(simd, &offset[0]);
                y += Lanes::load_array_ref(simd, &offset[1]);
            } else {
                x += half;
                y += half;
            }
            let (origin, direction) = self.aim(simd, [x, y], &disk);
            origin.store([&mut *ox, &mut *oy, &mut *oz], at);
            direction.store([&mut *dx, &mut *dy, &mut *dz], at);
            let live = pixels.len - at;
            for lane in 0..LANES {
                lanes.t_min[at + lane] = 0.0;
                // The padding keeps rays that can hit nothing.
                lanes.t_max[at + lane] = if lane < live { f32::INFINITY } else { f32::NEG_INFINITY };
            }
        }
    }

    /// Where a sample of a pixel goes through the picture, in pixels from the upper left corner, and where it leaves the
    /// lens, in lens radii.
    pub(crate) fn place(&self, [x, y]: [u32; 2], sample: u32) -> ([f32; 2], [f32; 2]) {
        let mut pixel = PixelList::default();
        pixel.set(std::iter::once([x, y]));
        let (mut offset, mut disk) = ([[0.5; LANES]; 2], [[0.0; LANES]; 2]);
        self.draw(&pixel, 0, sample, &mut offset, &mut disk);
        #[allow(clippy::cast_precision_loss, reason = "pixels are counted in 16 bits")]
        let film = [x as f32 + offset[0][0], y as f32 + offset[1][0]];
        (film, [disk[0][0], disk[1][0]])
    }

    /// Draws the places within the pixel's filter and on the lens for the pixels from `at` on.
    #[inline(never)]
    fn draw(
        &self,
        pixels: &PixelList,
        at: usize,
        sample: u32,
        offset: &mut [[f32; LANES]; 2],
        disk: &mut [[f32; LANES]; 2],
    ) {
        for lane in 0..LANES {
            let (x, y) = (pixels.columns[at + lane], pixels.rows[at + lane]);
            if self.antialiasing {
                let [u, v] = sample_pair(x, y, sample, Use::Pixel);
                offset[0][lane] = 0.5 + sample_tent(u);
                offset[1][lane] = 0.5 + sample_tent(v);
            }
            if self.radius > 0.0 {
                let [u, v] = sample_disk(sample_pair(x, y, sample, Use::Lens));
                disk[0][lane] = u;
                disk[1][lane] = v;
            }
        }
    }

    /// Origins and unit directions of the rays through places of the film (in pixels) and of the unit disk.
    #[inline(always)]
    fn aim<S: Simd>(&self, simd: S, [x, y]: [Lanes<S>; 2], disk: &[[f32; LANES]; 2]) -> (Vec3Lanes<S>, Vec3Lanes<S>) {
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
        lens.rays(SimdLevel::Auto.level_or_best(), &list(pixels), sample, &mut rays);
        rays
    }

    fn list(pixels: &[[u32; 2]]) -> PixelList {
        let mut list = PixelList::default();
        list.set(pixels.iter().copied());
        list
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
                lens.rays(level.level_or_best(), &list(&[*pixel]), 7, &mut one);
                assert_eq!(one.get(0), all.get(i), "{} {i}", level.word());
            }
        }
    }
}
