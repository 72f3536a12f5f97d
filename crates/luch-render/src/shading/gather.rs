//! What shading wants to know of sixteen hits, fetched from the objects they fell on and laid side by side.

use crate::compiled::{CompiledScene, Look, Surface};
use crate::math::lanes::{LANES, Vec3Lanes};
use crate::math::ray::{HitBatch, NO_OBJECT};
use fearless_simd::Simd;
use glam::{Mat3, Vec3};
use luch_scene::Shading;

/// Three components of each of sixteen vectors.
pub(super) type VecArrays = [[f32; LANES]; 3];

/// The facts of sixteen hits. A lane's fields that its kind of surface does not use are zero.
pub(super) struct Gathered {
    pub(super) hit: u16,
    pub(super) sphere: u16,
    pub(super) mesh: u16,
    /// Mesh lanes whose shading normal is blended from the vertices (Gouraud and Phong).
    pub(super) smooth: u16,
    pub(super) gouraud: u16,
    pub(super) checker: u16,
    /// Sphere: its centre. Flat face of a wall or cuboid: a point of it. Mesh: vertex 0, 1, 2 in object space.
    pub(super) vertices: [VecArrays; 3],
    /// Flat face: its normal in the first. Mesh: the normals at the vertices in object space.
    pub(super) normals: [VecArrays; 3],
    /// Mesh: columns of the map from object to world space.
    pub(super) columns: [VecArrays; 3],
    /// Mesh: columns of its rotation alone, for normals.
    pub(super) turns: [VecArrays; 3],
    pub(super) translation: VecArrays,
    pub(super) radius: [f32; LANES],
    pub(super) base: VecArrays,
    pub(super) highlight: [f32; LANES],
    pub(super) exponent: [f32; LANES],
    pub(super) reflection: [f32; LANES],
}

impl Gathered {
    const EMPTY: Self = Self {
        hit: 0,
        sphere: 0,
        mesh: 0,
        smooth: 0,
        gouraud: 0,
        checker: 0,
        vertices: [[[0.0; LANES]; 3]; 3],
        normals: [[[0.0; LANES]; 3]; 3],
        columns: [[[0.0; LANES]; 3]; 3],
        turns: [[[0.0; LANES]; 3]; 3],
        translation: [[0.0; LANES]; 3],
        radius: [0.0; LANES],
        base: [[0.0; LANES]; 3],
        highlight: [0.0; LANES],
        exponent: [0.0; LANES],
        reflection: [0.0; LANES],
    };

    /// Fetches the facts of the hits from `at` on. Scalar work, compiled once for all instruction sets.
    #[inline(never)]
    pub(super) fn of(scene: &CompiledScene, hits: &HitBatch, at: usize) -> Self {
        let mut all = Self::EMPTY;
        let objects = &hits.object[at..at + LANES];
        let primitives = &hits.primitive[at..at + LANES];
        for lane in 0..LANES {
            if objects[lane] != NO_OBJECT {
                all.fetch(scene, lane, objects[lane] as usize, primitives[lane] as usize);
            }
        }
        all
    }

    #[inline(always)]
    fn fetch(&mut self, scene: &CompiledScene, lane: usize, object: usize, primitive: usize) {
        let bit = 1 << lane;
        let object = &scene.objects[object];
        let mut look = 0;
        self.hit |= bit;
        match &object.surface {
            Surface::Sphere { center, radius } => {
                self.sphere |= bit;
                put(&mut self.vertices[0], lane, *center);
                self.radius[lane] = *radius;
            }
            Surface::Plane { point, normal } => {
                put(&mut self.vertices[0], lane, *point);
                put(&mut self.normals[0], lane, *normal);
            }
            Surface::Cuboid { center, half_size, axes } => {
                let axis = (primitive / 2).min(2);
                let outward = if primitive % 2 == 1 { axes.col(axis) } else { -axes.col(axis) };
                put(&mut self.vertices[0], lane, *center + outward * half_size[axis]);
                put(&mut self.normals[0], lane, outward);
            }
            Surface::Mesh { mesh, placement, rotation } => {
                self.mesh |= bit;
                if object.shading != Shading::Flat {
                    self.smooth |= bit;
                }
                if object.shading == Shading::Gouraud {
                    self.gouraud |= bit;
                }
                look = mesh.triangle_materials().get(primitive).map_or(0, |&m| usize::from(m));
                put_matrix(&mut self.columns, lane, &placement.linear);
                put_matrix(&mut self.turns, lane, rotation);
                put(&mut self.translation, lane, placement.translation);
                let (corners, normals) = (mesh.triangles()[primitive], mesh.normal_triangles()[primitive]);
                for k in 0..3 {
                    put_array(&mut self.vertices[k], lane, mesh.positions()[corners[k] as usize]);
                    put_array(&mut self.normals[k], lane, mesh.normals()[normals[k] as usize]);
                }
            }
        }
        if object.checker.is_some() {
            self.checker |= bit;
        }
        let Look { base, highlight, exponent } = object.looks[look];
        put(&mut self.base, lane, base);
        self.highlight[lane] = highlight;
        self.exponent[lane] = exponent;
        self.reflection[lane] = object.reflection;
    }

    /// The vertices of the mesh lanes in world space.
    #[inline(always)]
    pub(super) fn world_vertices<S: Simd>(&self, simd: S) -> [Vec3Lanes<S>; 3] {
        let columns = three(simd, &self.columns);
        let translation = Vec3Lanes::from_arrays(simd, &self.translation);
        let [a, b, c] = three(simd, &self.vertices);
        [transform(columns, a) + translation, transform(columns, b) + translation, transform(columns, c) + translation]
    }

    /// The vertex normals of the mesh lanes in world space.
    #[inline(always)]
    pub(super) fn world_normals<S: Simd>(&self, simd: S) -> [Vec3Lanes<S>; 3] {
        let turns = three(simd, &self.turns);
        let [a, b, c] = three(simd, &self.normals);
        [transform(turns, a), transform(turns, b), transform(turns, c)]
    }
}

/// Three gathered vectors. Written out, as all vector code here: a closure given to `map` or `from_fn` is compiled as a
/// function of its own, without the instruction set of its caller.
#[inline(always)]
fn three<S: Simd>(simd: S, arrays: &[VecArrays; 3]) -> [Vec3Lanes<S>; 3] {
    [
        Vec3Lanes::from_arrays(simd, &arrays[0]),
        Vec3Lanes::from_arrays(simd, &arrays[1]),
        Vec3Lanes::from_arrays(simd, &arrays[2]),
    ]
}

/// A matrix of three columns times a vector.
#[inline(always)]
fn transform<S: Simd>(columns: [Vec3Lanes<S>; 3], v: Vec3Lanes<S>) -> Vec3Lanes<S> {
    columns[0].scale(v.x) + columns[1].scale(v.y) + columns[2].scale(v.z)
}

#[inline(always)]
fn put(arrays: &mut VecArrays, lane: usize, v: Vec3) {
    put_array(arrays, lane, v.to_array());
}

#[inline(always)]
fn put_array(arrays: &mut VecArrays, lane: usize, v: [f32; 3]) {
    arrays[0][lane] = v[0];
    arrays[1][lane] = v[1];
    arrays[2][lane] = v[2];
}

#[inline(always)]
fn put_matrix(columns: &mut [VecArrays; 3], lane: usize, m: &Mat3) {
    put(&mut columns[0], lane, m.x_axis);
    put(&mut columns[1], lane, m.y_axis);
    put(&mut columns[2], lane, m.z_axis);
}
