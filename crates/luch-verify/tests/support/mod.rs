//! What the ray tests share: random numbers and closed meshes.
#![allow(dead_code, reason = "each test binary uses a part of it")]

pub(crate) mod watched;

use glam::{Mat3, Quat, Vec3};
use std::collections::HashMap;
use std::f32::consts::TAU;

/// PCG-RXS-M-XS of 32 bits (O'Neill 2014): the same tests on every machine.
pub(crate) struct Random(pub(crate) u32);

impl Random {
    pub(crate) fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
        let word = ((self.0 >> ((self.0 >> 28) + 4)) ^ self.0).wrapping_mul(277_803_737);
        (word >> 22) ^ word
    }

    /// In [0, 1).
    pub(crate) fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / 16_777_216.0
    }

    /// In [-1, 1).
    pub(crate) fn signed(&mut self) -> f32 {
        self.unit() * 2.0 - 1.0
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.bits() as usize % n
    }

    /// In the cube of side 2.
    pub(crate) fn point(&mut self) -> Vec3 {
        Vec3::new(self.signed(), self.signed(), self.signed())
    }

    pub(crate) fn direction(&mut self) -> Vec3 {
        loop {
            let p = self.point();
            if (0.01..1.0).contains(&p.length_squared()) {
                return p / p.length();
            }
        }
    }

    pub(crate) fn rotation(&mut self) -> Mat3 {
        Mat3::from_quat(Quat::from_axis_angle(self.direction(), self.unit() * TAU))
    }
}

pub(crate) type Mesh = (Vec<Vec3>, Vec<[u32; 3]>);

/// A unit sphere: an octahedron whose faces are divided `levels` times.
pub(crate) fn octasphere(levels: usize) -> Mesh {
    let mut positions = vec![Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z];
    let mut triangles: Vec<[u32; 3]> =
        vec![[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    for _ in 0..levels {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                let p = positions[a as usize] + positions[b as usize];
                positions.push(p / p.length());
                positions.len() as u32 - 1
            })
        };
        triangles = triangles
            .iter()
            .flat_map(|&[a, b, c]| {
                let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
                [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]
            })
            .collect();
    }
    (positions, triangles)
}

/// The axis-parallel cube of side 2.
pub(crate) fn cube() -> Mesh {
    let positions = (0..8).map(|k| Vec3::new(corner(k, 0), corner(k, 1), corner(k, 2))).collect();
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    (positions, quads.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]).collect())
}

fn corner(k: u32, axis: u32) -> f32 {
    if k >> axis & 1 == 0 { -1.0 } else { 1.0 }
}

/// A torus about the y axis, with radii 1 and 0.4.
pub(crate) fn torus(around: u32, across: u32) -> Mesh {
    grid(around, across, true, |i, j| {
        let (a, b) = (TAU * i as f32 / around as f32, TAU * j as f32 / across as f32);
        let r = 1.0 + 0.4 * libm_cos(b);
        Vec3::new(r * libm_cos(a), 0.4 * libm_sin(b), r * libm_sin(a))
    })
}

/// A chess-pawn-like lathe body about the y axis, its poles closed by degenerate triangles as careless tools do.
pub(crate) fn lathe(around: u32) -> Mesh {
    let profile = [(0.0, 0.0), (0.4, 0.0), (0.38, 0.1), (0.2, 0.3), (0.15, 0.7), (0.28, 0.8), (0.2, 1.1), (0.0, 1.3)];
    grid(around, profile.len() as u32, false, |i, j| {
        let (a, (r, y)) = (TAU * i as f32 / around as f32, profile[j as usize]);
        Vec3::new(r * libm_cos(a), y, r * libm_sin(a))
    })
}

fn grid(around: u32, across: u32, wrap: bool, point: impl Fn(u32, u32) -> Vec3) -> Mesh {
    let positions = (0..around).flat_map(|i| (0..across).map(move |j| (i, j))).map(|(i, j)| point(i, j)).collect();
    let mut triangles = Vec::new();
    for i in 0..around {
        for j in 0..if wrap { across } else { across - 1 } {
            let at = |i: u32, j: u32| (i % around) * across + j % across;
            let (a, b, c, d) = (at(i, j), at(i, j + 1), at(i + 1, j), at(i + 1, j + 1));
            triangles.extend([[a, b, c], [c, b, d]]);
        }
    }
    (positions, triangles)
}

fn libm_cos(a: f32) -> f32 {
    f64::cos(f64::from(a)) as f32
}

fn libm_sin(a: f32) -> f32 {
    f64::sin(f64::from(a)) as f32
}
