//! What shading wants to know of sixteen hits, fetched from the objects they fell on and laid side by side.

use crate::compiled::{CompiledObject, CompiledScene, Look, Surface};
use crate::math::lanes::{LANES, Lanes, Vec3Lanes};
use crate::math::ray::{HitBatch, NO_OBJECT};
use fearless_simd::prelude::*;
use glam::Mat3;
use luch_scene::Shading;

/// Three components of each of sixteen vectors.
pub(super) type VecArrays = [[f32; LANES]; 3];

/// The facts of sixteen hits. Lanes that hit nothing, and fields that a lane's kind of surface does not use, hold
/// whatever was there before: they are finite and never looked at.
#[derive(Debug)]
pub(crate) struct Gathered {
    pub(super) hit: u16,
    pub(super) sphere: u16,
    pub(crate) mesh: u16,
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
    /// Sphere: its radius; flat face: 0.
    pub(super) radius: [f32; LANES],
    pub(super) base: VecArrays,
    pub(super) highlight: [f32; LANES],
    pub(super) exponent: [f32; LANES],
    pub(super) reflection: [f32; LANES],
}

impl Default for Gathered {
    fn default() -> Self {
        Self {
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
        }
    }
}

/// Which lanes a fact is written to.
trait Lane: Copy {
    fn put(self, array: &mut [f32; LANES], value: f32);

    #[inline(always)]
    fn put_all(self, arrays: &mut VecArrays, v: [f32; 3]) {
        self.put(&mut arrays[0], v[0]);
        self.put(&mut arrays[1], v[1]);
        self.put(&mut arrays[2], v[2]);
    }

    #[inline(always)]
    fn put_matrix(self, columns: &mut [VecArrays; 3], m: &Mat3) {
        self.put_all(&mut columns[0], m.x_axis.to_array());
        self.put_all(&mut columns[1], m.y_axis.to_array());
        self.put_all(&mut columns[2], m.z_axis.to_array());
    }
}

#[derive(Clone, Copy)]
struct One(usize);

impl Lane for One {
    #[inline(always)]
    fn put(self, array: &mut [f32; LANES], value: f32) {
        array[self.0] = value;
    }
}

/// Every lane: rays side by side mostly hit one object, whose facts are then written once for all.
#[derive(Clone, Copy)]
struct Every;

impl Lane for Every {
    #[inline(always)]
    fn put(self, array: &mut [f32; LANES], value: f32) {
        *array = [value; LANES];
    }
}

impl Gathered {
    /// Fetches the facts of the hits from `at` on. Scalar work, compiled once for all instruction sets.
    #[inline(never)]
    pub(crate) fn fetch(&mut self, scene: &CompiledScene, hits: &HitBatch, at: usize) {
        let objects = &hits.object[at..at + LANES];
        let primitives = &hits.primitive[at..at + LANES];
        (self.sphere, self.mesh, self.smooth, self.gouraud, self.checker) = (0, 0, 0, 0, 0);
        let mut left = 0_u16;
        for (lane, &object) in objects.iter().enumerate() {
            left |= u16::from(object != NO_OBJECT) << lane;
        }
        self.hit = left;
        while left != 0 {
            let first = left.trailing_zeros() as usize;
            let mut same = 0_u16;
            for (lane, &object) in objects.iter().enumerate() {
                same |= u16::from(object == objects[first]) << lane;
            }
            let object = &scene.objects[objects[first] as usize];
            if same == self.hit {
                self.fetch_object(object, same, Every);
            } else {
                for lane in lanes_of(same) {
                    self.fetch_object(object, 1 << lane, One(lane));
                }
            }
            self.fetch_primitives(object, same, primitives);
            left &= !same;
        }
    }

    /// What all hits on an object have in common.
    #[inline(always)]
    fn fetch_object(&mut self, object: &CompiledObject, bits: u16, lanes: impl Lane) {
        match &object.surface {
            Surface::Sphere { center, radius } => {
                self.sphere |= bits;
                lanes.put_all(&mut self.vertices[0], center.to_array());
                lanes.put(&mut self.radius, *radius);
            }
            Surface::Plane { point, normal } => {
                lanes.put_all(&mut self.vertices[0], point.to_array());
                lanes.put_all(&mut self.normals[0], normal.to_array());
                lanes.put(&mut self.radius, 0.0);
            }
            Surface::Cuboid { .. } => lanes.put(&mut self.radius, 0.0),
            Surface::Nothing => {}
            Surface::Mesh { placement, rotation, .. } => {
                self.mesh |= bits;
                if object.shading != Shading::Flat {
                    self.smooth |= bits;
                }
                if object.shading == Shading::Gouraud {
                    self.gouraud |= bits;
                }
                lanes.put_matrix(&mut self.columns, &placement.linear);
                lanes.put_matrix(&mut self.turns, rotation);
                lanes.put_all(&mut self.translation, placement.translation.to_array());
            }
        }
        if object.checker.is_some() {
            self.checker |= bits;
        }
        self.put_look(&object.looks[0], lanes);
        lanes.put(&mut self.reflection, object.reflection);
    }

    /// What depends on the face or triangle that was hit.
    #[inline(always)]
    fn fetch_primitives(&mut self, object: &CompiledObject, bits: u16, primitives: &[u32]) {
        match &object.surface {
            Surface::Sphere { .. } | Surface::Plane { .. } | Surface::Nothing => {}
            Surface::Cuboid { center, half_size, axes } => {
                for lane in lanes_of(bits) {
                    let face = primitives[lane] as usize;
                    let axis = (face / 2).min(2);
                    let outward = if face % 2 == 1 { axes.col(axis) } else { -axes.col(axis) };
                    One(lane).put_all(&mut self.vertices[0], (*center + outward * half_size[axis]).to_array());
                    One(lane).put_all(&mut self.normals[0], outward.to_array());
                }
            }
            Surface::Mesh { mesh, layout, .. } => {
                for lane in lanes_of(bits) {
                    let primitive = primitives[lane] as usize;
                    let [a, b, c] = layout.corners(primitive);
                    One(lane).put_all(&mut self.vertices[0], a.position);
                    One(lane).put_all(&mut self.vertices[1], b.position);
                    One(lane).put_all(&mut self.vertices[2], c.position);
                    One(lane).put_all(&mut self.normals[0], a.normal);
                    One(lane).put_all(&mut self.normals[1], b.normal);
                    One(lane).put_all(&mut self.normals[2], c.normal);
                    if let Some(&look) = mesh.triangle_materials().get(primitive) {
                        self.put_look(&object.looks[usize::from(look)], One(lane));
                    }
                }
            }
        }
    }

    #[inline(always)]
    fn put_look(&mut self, look: &Look, lanes: impl Lane) {
        lanes.put_all(&mut self.base, look.base.to_array());
        lanes.put(&mut self.highlight, look.highlight);
        lanes.put(&mut self.exponent, look.exponent);
    }

    /// The vertices of the mesh lanes in world space.
    #[inline(always)]
    pub(crate) fn world_vertices<S: Simd>(&self, simd: S) -> [Vec3Lanes<S>; 3] {
        let columns = three(simd, &self.columns);
        let translation = Vec3Lanes::from_arrays(simd, &self.translation);
        let [a, b, c] = three(simd, &self.vertices);
        [transform(columns, a) + translation, transform(columns, b) + translation, transform(columns, c) + translation]
    }

    /// The vertex normals of the mesh lanes in world space, all three of a face turned alike: to the side of `facing`,
    /// the true face's normal on the side that the ray comes from.
    #[inline(always)]
    pub(crate) fn turned_normals<S: Simd>(&self, simd: S, facing: Vec3Lanes<S>) -> [Vec3Lanes<S>; 3] {
        let turns = three(simd, &self.turns);
        let [a, b, c] = three(simd, &self.normals);
        let [a, b, c] = [transform(turns, a), transform(turns, b), transform(turns, c)];
        let opposed = (a + b + c).dot(facing).simd_lt(Lanes::splat(simd, 0.0));
        [Vec3Lanes::select(opposed, -a, a), Vec3Lanes::select(opposed, -b, b), Vec3Lanes::select(opposed, -c, c)]
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

/// The lanes whose bits are set, lowest first.
#[inline(always)]
fn lanes_of(mut bits: u16) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = (bits != 0).then_some(bits.trailing_zeros() as usize);
        bits &= bits.wrapping_sub(1);
        lane
    })
}
