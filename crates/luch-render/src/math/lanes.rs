//! Sixteen rays side by side: the vectors that shading is written in.
//!
//! One generic code serves every instruction set. It uses only operations that IEEE 754 rounds exactly (+ - * / sqrt,
//! comparison, selection), each written once and in one order, so that every level gives the same bits. `min` and `max`
//! of the hardware are not used where a NaN or a signed zero could reach a pixel: they differ between machines.

use fearless_simd::prelude::*;
use fearless_simd::{f32x16, mask32x16};
use glam::Vec3;
use std::ops::{Add, Mul, Neg, Sub};

pub(crate) use super::ray::LANES;

/// One number of each of sixteen rays.
pub(crate) type Lanes<S> = f32x16<S>;
/// One truth of each of sixteen rays.
pub(crate) type LaneMask<S> = mask32x16<S>;

/// One vector of each of sixteen rays.
#[derive(Clone, Copy)]
pub(crate) struct Vec3Lanes<S: Simd> {
    pub(crate) x: Lanes<S>,
    pub(crate) y: Lanes<S>,
    pub(crate) z: Lanes<S>,
}

impl<S: Simd> Vec3Lanes<S> {
    #[inline(always)]
    pub(crate) fn splat(simd: S, v: Vec3) -> Self {
        Self { x: Lanes::splat(simd, v.x), y: Lanes::splat(simd, v.y), z: Lanes::splat(simd, v.z) }
    }

    /// The lanes from `at` on of three lists.
    #[inline(always)]
    pub(crate) fn load(simd: S, lists: [&[f32]; 3], at: usize) -> Self {
        Self {
            x: Lanes::from_slice(simd, &lists[0][at..at + LANES]),
            y: Lanes::from_slice(simd, &lists[1][at..at + LANES]),
            z: Lanes::from_slice(simd, &lists[2][at..at + LANES]),
        }
    }

    /// The lanes of three gathered arrays.
    #[inline(always)]
    pub(crate) fn from_arrays(simd: S, arrays: &[[f32; LANES]; 3]) -> Self {
        Self {
            x: Lanes::load_array_ref(simd, &arrays[0]),
            y: Lanes::load_array_ref(simd, &arrays[1]),
            z: Lanes::load_array_ref(simd, &arrays[2]),
        }
    }

    /// Writes the lanes into three lists from `at` on.
    #[inline(always)]
    pub(crate) fn store(self, lists: [&mut [f32]; 3], at: usize) {
        let [x, y, z] = lists;
        self.x.store_slice(&mut x[at..at + LANES]);
        self.y.store_slice(&mut y[at..at + LANES]);
        self.z.store_slice(&mut z[at..at + LANES]);
    }

    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> Lanes<S> {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    #[inline(always)]
    pub(crate) fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    #[inline(always)]
    pub(crate) fn scale(self, by: Lanes<S>) -> Self {
        Self { x: self.x * by, y: self.y * by, z: self.z * by }
    }

    #[inline(always)]
    pub(crate) fn length(self) -> Lanes<S> {
        self.dot(self).sqrt()
    }

    /// The unit vector; zero stays zero instead of becoming NaN.
    ///
    /// The vector is scaled by its largest component first, so that its square neither overflows nor vanishes.
    #[inline(always)]
    pub(crate) fn unit_or_zero(self, simd: S) -> Self {
        let largest = self.largest();
        let zero = Lanes::splat(simd, 0.0);
        let usable = largest.simd_gt(zero);
        let one = Lanes::splat(simd, 1.0);
        let shrink = one / usable.select(largest, one);
        let v = self.scale(shrink);
        let inverse = one / usable.select(v.length(), one);
        v.scale(usable.select(inverse, zero))
    }

    /// The largest absolute component.
    #[inline(always)]
    pub(crate) fn largest(self) -> Lanes<S> {
        greater(greater(self.x.abs(), self.y.abs()), self.z.abs())
    }

    #[inline(always)]
    pub(crate) fn select(mask: LaneMask<S>, yes: Self, no: Self) -> Self {
        Self { x: mask.select(yes.x, no.x), y: mask.select(yes.y, no.y), z: mask.select(yes.z, no.z) }
    }

    /// The lanes of the mask moved to the front; what follows them is not said.
    #[inline(always)]
    pub(crate) fn compress(self, mask: LaneMask<S>) -> Self {
        Self { x: self.x.compress(mask), y: self.y.compress(mask), z: self.z.compress(mask) }
    }
}

/// The greater number; the second where they are not ordered. The same on every machine.
#[inline(always)]
pub(crate) fn greater<S: Simd>(a: Lanes<S>, b: Lanes<S>) -> Lanes<S> {
    a.simd_gt(b).select(a, b)
}

/// The smaller number; the second where they are not ordered. The same on every machine.
#[inline(always)]
pub(crate) fn smaller<S: Simd>(a: Lanes<S>, b: Lanes<S>) -> Lanes<S> {
    a.simd_lt(b).select(a, b)
}

impl<S: Simd> Add for Vec3Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<S: Simd> Sub for Vec3Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl<S: Simd> Mul for Vec3Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { x: self.x * other.x, y: self.y * other.y, z: self.z * other.z }
    }
}

impl<S: Simd> Neg for Vec3Lanes<S> {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}
