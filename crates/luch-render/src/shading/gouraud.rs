//! Gouraud shading: light worked out at the vertices of the face and blended over it (Gouraud, "Continuous Shading of
//! Curved Surfaces", 1971). Shadows are still tested at the hit point.

use super::gather::Gathered;
use super::terms::{LightTerms, LitPoint};
use crate::compiled::{CompiledLight, CompiledScene};
use crate::math::lanes::{LANES, LaneMask, Lanes, Vec3Lanes};
use crate::math::ray::{HitBatch, RayBatch};
use fearless_simd::prelude::*;

/// The vertices of sixteen faces, as the lighting sum wants them.
pub(crate) struct Faces<S: Simd> {
    /// Vertex k of each face, with its normal turned to the side of the face that the ray comes from.
    pub(crate) vertices: [LitPoint<S>; 3],
    /// How much of each vertex there is in the hit point.
    pub(crate) weights: [Lanes<S>; 3],
}

impl<S: Simd> Faces<S> {
    /// The faces of the hits from `at` on; `facing` is the true face's normal on the ray's side.
    #[inline(always)]
    pub(crate) fn of(
        simd: S,
        scene: &CompiledScene,
        rays: &RayBatch,
        hits: &HitBatch,
        at: usize,
        facing: Vec3Lanes<S>,
    ) -> Self {
        let mut facts = Gathered::default();
        facts.fetch(scene, hits, at);
        let corners = facts.world_vertices(simd);
        let normals = facts.turned_normals(simd, facing);
        let zero = Lanes::splat(simd, 0.0);
        let viewer = Vec3Lanes::load(simd, [rays.origin(0), rays.origin(1), rays.origin(2)], at);
        let highlight = Lanes::load_array_ref(simd, &facts.highlight);
        let exponent = Lanes::load_array_ref(simd, &facts.exponent);
        let mut vertices = [LitPoint { position: viewer, normal: facing, to_viewer: facing, highlight, exponent }; 3];
        for (k, vertex) in vertices.iter_mut().enumerate() {
            let usable = normals[k].dot(normals[k]).simd_gt(zero);
            vertex.position = corners[k];
            vertex.normal = Vec3Lanes::select(usable, normals[k], facing).unit_or_zero(simd);
            vertex.to_viewer = (viewer - corners[k]).unit_or_zero(simd);
        }
        let u = Lanes::from_slice(simd, &hits.u[at..at + LANES]);
        let v = Lanes::from_slice(simd, &hits.v[at..at + LANES]);
        Self { vertices, weights: [Lanes::splat(simd, 1.0) - u - v, u, v] }
    }

    /// What a light does at the three vertices.
    #[inline(always)]
    pub(crate) fn terms(&self, simd: S, light: &CompiledLight, attenuation: f32) -> [LightTerms<S>; 3] {
        [
            LightTerms::at(simd, &self.vertices[0], light, attenuation),
            LightTerms::at(simd, &self.vertices[1], light, attenuation),
            LightTerms::at(simd, &self.vertices[2], light, attenuation),
        ]
    }

    /// Diffuse and specular of a light, blended from the vertices, in the lanes of `gouraud`; elsewhere as they were.
    #[inline(always)]
    pub(crate) fn blend(
        &self,
        simd: S,
        gouraud: u16,
        (light, attenuation): (&CompiledLight, f32),
        (diffuse, specular): (Lanes<S>, Lanes<S>),
    ) -> (Lanes<S>, Lanes<S>) {
        let [a, b, c] = self.weights;
        let [t0, t1, t2] = self.terms(simd, light, attenuation);
        let blended_diffuse = t0.diffuse * a + t1.diffuse * b + t2.diffuse * c;
        let blended_specular = t0.specular * a + t1.specular * b + t2.specular * c;
        let lanes = LaneMask::from_bitmask(simd, u64::from(gouraud));
        (lanes.select(blended_diffuse, diffuse), lanes.select(blended_specular, specular))
    }
}
