//! Sixteen rays in lanes, with what the box and triangle tests need of them.

use super::geometry::ObjectFromWorld;
use super::lanes::{Wide, each, load, splat};
use super::leaf_test::Frame;
use super::slabs::{OFFSET_SLACK, SLACK, Slabs, steepest};
use crate::math::ray::{HitBatch, LANES, NO_OBJECT, Ray, RayBatch};
use fearless_simd::prelude::*;
use fearless_simd::{f32x16, mask32x16, u32x16};
use glam::Vec3;

pub(crate) type Row = [f32; LANES];

/// Sixteen rays in one space, and the constants of [`Slabs`] and [`Frame`] for each.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Group {
    pub(crate) origin: [Row; 3],
    pub(crate) direction: [Row; 3],
    pub(crate) t_min: Row,
    pub(crate) near_mul: [Row; 3],
    pub(crate) near_add: [Row; 3],
    pub(crate) far_mul: [Row; 3],
    pub(crate) far_add: [Row; 3],
    /// [`Slabs::octant`].
    pub(crate) octant: [u32; LANES],
    /// Across, across and along the longest axis of the direction.
    pub(crate) shear: [Row; 3],
    /// That axis.
    pub(crate) along: [u32; LANES],
}

/// The nearest hits so far of sixteen rays.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Found {
    /// Where the nearest hit lies; without one, the last `t` that still counts.
    pub(crate) t: Row,
    pub(crate) u: Row,
    pub(crate) v: Row,
    pub(crate) object: [u32; LANES],
    pub(crate) primitive: [u32; LANES],
}

impl Group {
    pub(crate) const NOTHING: Self = {
        let rows = [[0.0; LANES]; 3];
        Self {
            origin: rows,
            direction: rows,
            t_min: [f32::INFINITY; LANES],
            near_mul: rows,
            near_add: rows,
            far_mul: rows,
            far_add: rows,
            octant: [0; LANES],
            shear: rows,
            along: [0; LANES],
        }
    };

    /// Loads rays `16 * k ..` of a batch. The constants are not set yet.
    #[inline(always)]
    pub(crate) fn load<S: Wide>(&mut self, simd: S, rays: &RayBatch, k: usize) {
        for axis in 0..3 {
            copy(simd, &rays.origin(axis).as_chunks().0[k], &mut self.origin[axis]);
            copy(simd, &rays.direction(axis).as_chunks().0[k], &mut self.direction[axis]);
        }
        copy(simd, &rays.t_min().as_chunks().0[k], &mut self.t_min);
    }

    /// The rays of another space, in that of an object: [`ObjectFromWorld::ray`] in lanes. Sets no constants.
    #[inline(always)]
    pub(crate) fn load_transformed<S: Wide>(&mut self, simd: S, world: &Self, inverse: &ObjectFromWorld) {
        copy(simd, &world.t_min, &mut self.t_min);
        let Some(rows) = &inverse.rows else {
            for axis in 0..3 {
                copy(simd, &world.origin[axis], &mut self.origin[axis]);
                copy(simd, &world.direction[axis], &mut self.direction[axis]);
            }
            return;
        };
        let from = inverse.translation;
        let origin = each(
            #[inline(always)]
            |axis| load(simd, &world.origin[axis]) - splat(simd, from[axis]),
        );
        let direction = each(
            #[inline(always)]
            |axis| load(simd, &world.direction[axis]),
        );
        for (axis, row) in rows.iter().enumerate() {
            along(simd, *row, origin).store_array(&mut self.origin[axis]);
            along(simd, *row, direction).store_array(&mut self.direction[axis]);
        }
    }

    /// Computes the constants. `reach` as for [`Slabs::new`].
    #[inline(always)]
    pub(crate) fn prepare<S: Wide>(&mut self, simd: S, reach: f32) {
        let origin = each(
            #[inline(always)]
            |axis| load(simd, &self.origin[axis]),
        );
        let direction = each(
            #[inline(always)]
            |axis| load(simd, &self.direction[axis]),
        );
        let farthest = origin[0].abs().max(origin[1].abs()).max(origin[2].abs()).reduce_max();
        let steepest = splat(simd, steepest(farthest.max(reach)));
        let inverse = each(
            #[inline(always)]
            |axis| splat(simd, 1.0) / direction[axis],
        );
        let mut octant = u32x16::splat(simd, 0);
        for axis in 0..3 {
            let d = direction[axis];
            let clamped = inverse[axis].abs().min(steepest).copysign(d);
            let (near, far) = (clamped * splat(simd, 1.0 - SLACK), clamped * splat(simd, 1.0 + SLACK));
            let (near_offset, far_offset) = (origin[axis] * near, origin[axis] * far);
            near.store_array(&mut self.near_mul[axis]);
            far.store_array(&mut self.far_mul[axis]);
            (-near_offset - near_offset.abs() * splat(simd, OFFSET_SLACK)).store_array(&mut self.near_add[axis]);
            (-far_offset + far_offset.abs() * splat(simd, OFFSET_SLACK)).store_array(&mut self.far_add[axis]);
            octant |= (d.bitcast::<u32x16<S>>() >> 31) << axis as u32;
        }
        octant.store_array(&mut self.octant);

        // The frame of the triangle test: `ShearedRay::new` in lanes.
        let size = each(
            #[inline(always)]
            |axis| direction[axis].abs(),
        );
        let y_over_x = size[1].simd_gt(size[0]);
        let z_over_both = size[2].simd_gt(y_over_x.select(size[1], size[0]));
        let pick = |x: f32x16<S>, y: f32x16<S>, z: f32x16<S>| z_over_both.select(z, y_over_x.select(y, x));
        let scale = pick(inverse[0], inverse[1], inverse[2]);
        let across_x = pick(direction[1], direction[2], direction[0]);
        let across_y = pick(direction[2], direction[0], direction[1]);
        (across_x * scale).store_array(&mut self.shear[0]);
        (across_y * scale).store_array(&mut self.shear[1]);
        scale.store_array(&mut self.shear[2]);
        let number = |k: u32| u32x16::splat(simd, k);
        let along = z_over_both.select(number(2), y_over_x.select(number(1), number(0)));
        along.store_array(&mut self.along);
    }

    /// Replaces one ray and its constants.
    #[inline(always)]
    pub(crate) fn set(&mut self, lane: usize, ray: &Ray, reach: f32) {
        let slabs = Slabs::new(ray.origin.to_array(), ray.direction.to_array(), ray.t_min, 0.0, reach);
        let frame = Frame::new(ray.origin, ray.direction);
        for axis in 0..3 {
            self.origin[axis][lane] = ray.origin[axis];
            self.direction[axis][lane] = ray.direction[axis];
            self.near_mul[axis][lane] = slabs.near_mul[axis];
            self.near_add[axis][lane] = slabs.near_add[axis];
            self.far_mul[axis][lane] = slabs.far_mul[axis];
            self.far_add[axis][lane] = slabs.far_add[axis];
            self.shear[axis][lane] = frame.shear[axis];
        }
        self.t_min[lane] = ray.t_min;
        self.octant[lane] = slabs.octant;
        self.along[lane] = u32::from(frame.axes[2]);
    }

    /// One ray again; `t_max` is not known here.
    #[inline(always)]
    pub(crate) fn ray(&self, lane: usize, t_max: f32) -> Ray {
        let pick = |rows: &[Row; 3]| Vec3::new(rows[0][lane], rows[1][lane], rows[2][lane]);
        Ray { origin: pick(&self.origin), direction: pick(&self.direction), t_min: self.t_min[lane], t_max }
    }

    #[inline(always)]
    pub(crate) fn slabs(&self, lane: usize, t_max: f32) -> Slabs {
        let lane = lane & (LANES - 1);
        let pick = |rows: &[Row; 3]| [rows[0][lane], rows[1][lane], rows[2][lane]];
        Slabs {
            near_mul: pick(&self.near_mul),
            near_add: pick(&self.near_add),
            far_mul: pick(&self.far_mul),
            far_add: pick(&self.far_add),
            t_min: self.t_min[lane],
            t_max,
            octant: self.octant[lane],
        }
    }

    #[inline(always)]
    pub(crate) fn frame(&self, lane: usize) -> Frame {
        const AXES: [[u8; 3]; 3] = [[1, 2, 0], [2, 0, 1], [0, 1, 2]];
        let lane = lane & (LANES - 1);
        let axes = AXES[self.along[lane] as usize];
        Frame {
            axes,
            origin: each(
                #[inline(always)]
                |k| self.origin[axes[k] as usize][lane],
            ),
            shear: [self.shear[0][lane], self.shear[1][lane], self.shear[2][lane]],
        }
    }

    /// Which rays meet a box before what they have found, and where they enter it.
    #[inline(always)]
    pub(crate) fn meet<S: Wide>(&self, simd: S, bounds: &[[f32; 3]; 2], last: &Row) -> (f32x16<S>, mask32x16<S>) {
        let (mut enter, mut leave) = (load(simd, &self.t_min), load(simd, last));
        let [lower, upper] = bounds;
        for axis in 0..3 {
            let (low, high) = (splat(simd, lower[axis]), splat(simd, upper[axis]));
            let negative = load(simd, &self.near_mul[axis]).simd_lt(splat(simd, 0.0));
            let (near, far) = (negative.select(high, low), negative.select(low, high));
            enter = enter.max(near.mul_add(load(simd, &self.near_mul[axis]), load(simd, &self.near_add[axis])));
            leave = leave.min(far.mul_add(load(simd, &self.far_mul[axis]), load(simd, &self.far_add[axis])));
        }
        (enter, enter.simd_le(leave))
    }
}

/// Dot products, added in order.
#[inline(always)]
fn along<S: Wide>(simd: S, row: Vec3, p: [f32x16<S>; 3]) -> f32x16<S> {
    (splat(simd, row.x) * p[0] + splat(simd, row.y) * p[1]) + splat(simd, row.z) * p[2]
}

/// A row from one place to another, without a call of memcpy.
#[inline(always)]
fn copy<S: Wide>(simd: S, from: &Row, to: &mut Row) {
    f32x16::load_array_ref(simd, from).store_array(to);
}

impl Found {
    pub(crate) const NOTHING: Self = Self {
        t: [0.0; LANES],
        u: [0.0; LANES],
        v: [0.0; LANES],
        object: [NO_OBJECT; LANES],
        primitive: [NO_OBJECT; LANES],
    };

    /// Nothing found yet by rays `16 * k ..` of a batch.
    #[inline(always)]
    pub(crate) fn reset<S: Wide>(&mut self, simd: S, rays: &RayBatch, k: usize) {
        let t_max = f32x16::load_array_ref(simd, &rays.t_max().as_chunks().0[k]);
        // A hit at t_max does not count, one at the number before does.
        let before: f32x16<S> = (t_max.bitcast::<u32x16<S>>() - u32x16::splat(simd, 1)).bitcast();
        let none = f32x16::splat(simd, f32::NEG_INFINITY);
        t_max.simd_gt(f32x16::splat(simd, 0.0)).select(before, none).store_array(&mut self.t);
        let (zero, no_object) = (f32x16::splat(simd, 0.0), u32x16::splat(simd, NO_OBJECT));
        zero.store_array(&mut self.u);
        zero.store_array(&mut self.v);
        no_object.store_array(&mut self.object);
        no_object.store_array(&mut self.primitive);
    }

    /// Writes the answers of rays `16 * k ..`.
    #[inline(always)]
    pub(crate) fn store<S: Wide>(&self, simd: S, hits: &mut HitBatch, k: usize) {
        let object = u32x16::load_array_ref(simd, &self.object);
        let missed = object.simd_eq(u32x16::splat(simd, NO_OBJECT));
        let t = missed.select(f32x16::splat(simd, f32::INFINITY), f32x16::load_array_ref(simd, &self.t));
        t.store_array(&mut hits.t.as_chunks_mut().0[k]);
        copy(simd, &self.u, &mut hits.u.as_chunks_mut().0[k]);
        copy(simd, &self.v, &mut hits.v.as_chunks_mut().0[k]);
        object.store_array(&mut hits.object.as_chunks_mut().0[k]);
        let primitive = u32x16::load_array_ref(simd, &self.primitive);
        primitive.store_array(&mut hits.primitive.as_chunks_mut().0[k]);
    }

    /// Takes a hit of one ray if it is nearer; tells whether it was.
    #[inline(always)]
    pub(crate) fn offer(&mut self, lane: usize, t: f32, weights: [f32; 2], object: u32, primitive: u32) -> bool {
        let old = self.t[lane];
        let wins = t < old || t == old && (object, primitive) < (self.object[lane], self.primitive[lane]);
        if wins {
            self.t[lane] = t;
            [self.u[lane], self.v[lane]] = weights;
            (self.object[lane], self.primitive[lane]) = (object, primitive);
        }
        wins
    }
}
