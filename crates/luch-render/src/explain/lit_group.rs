//! The factors of one light at sixteen surfaces, by the functions that the picture uses.

use super::light::LightFactors;
use crate::compiled::CompiledScene;
use crate::integrator::classic::lit_point;
use crate::integrator::onlooker::Lighting;
use crate::math::lanes::{LANES, Lanes, Vec3Lanes};
use crate::shading::gouraud::Faces;
use crate::shading::surface::views;
use crate::shading::terms::{LightTerms, LitPoint, share};
use crate::simd::baseline;
use fearless_simd::prelude::*;
use glam::Vec3;

/// One light at sixteen surfaces.
pub(super) struct LitGroup {
    pub(super) point: FactorRows,
    pub(super) vertices: Option<[FactorRows; 3]>,
    pub(super) share: [[f32; LANES]; 3],
}

impl LitGroup {
    pub(super) fn of(scene: &CompiledScene, number: usize, lighting: &Lighting<'_>, from: usize) -> Self {
        let Lighting { rays, hits, surfaces, shadows, .. } = *lighting;
        let (simd, light) = (baseline(), &scene.lights[number]);
        let point = lit_point(simd, rays, surfaces, from);
        let terms = LightTerms::at(simd, &point, light, scene.attenuation);
        let vertices = (surfaces.gouraud[from / LANES] != 0).then(|| {
            let facing = Vec3Lanes::load(simd, views(&surfaces.geometric_normal), from);
            let faces = Faces::of(simd, scene, rays, hits, from, facing);
            let [a, b, c] = faces.terms(simd, light, scene.attenuation);
            let [p, q, r] = &faces.vertices;
            [FactorRows::of(p, &a), FactorRows::of(q, &b), FactorRows::of(r, &c)]
        });
        let base = Vec3Lanes::load(simd, views(&surfaces.base), from);
        let diffuse = Lanes::from_slice(simd, &shadows.diffuse[from..from + LANES]);
        let specular = Lanes::from_slice(simd, &shadows.specular[from..from + LANES]);
        let share = arrays(share(simd, base, (diffuse, specular), light));
        Self { point: FactorRows::of(&point, &terms), vertices, share }
    }
}

/// The factors of sixteen points.
pub(super) struct FactorRows {
    normal: [[f32; LANES]; 3],
    to_viewer: [[f32; LANES]; 3],
    to_light: [[f32; LANES]; 3],
    mirrored: [[f32; LANES]; 3],
    /// The rest, in the order of [`LightFactors`].
    rest: [[f32; LANES]; 8],
}

impl FactorRows {
    fn of<S: Simd>(point: &LitPoint<S>, terms: &LightTerms<S>) -> Self {
        let f = &terms.factors;
        Self {
            normal: arrays(point.normal),
            to_viewer: arrays(point.to_viewer),
            to_light: arrays(f.to_light),
            mirrored: arrays(f.mirrored),
            rest: [f.distance, f.falloff, f.strength, f.cos_theta, f.cos_alpha, f.power, terms.diffuse, terms.specular]
                .map(|lanes| lanes.to_array()),
        }
    }

    pub(super) fn lane(&self, lane: usize) -> LightFactors {
        let [distance, falloff, strength, cos_theta, cos_alpha, power, diffuse, specular] =
            self.rest.map(|row| row[lane]);
        LightFactors {
            normal: lane_of(&self.normal, lane),
            to_viewer: lane_of(&self.to_viewer, lane),
            to_light: lane_of(&self.to_light, lane),
            distance,
            falloff,
            strength,
            cos_theta,
            mirrored: lane_of(&self.mirrored, lane),
            cos_alpha,
            power,
            diffuse,
            specular,
        }
    }
}

/// Vectors in lanes as three arrays.
pub(super) fn arrays<S: Simd>(v: Vec3Lanes<S>) -> [[f32; LANES]; 3] {
    [v.x.to_array(), v.y.to_array(), v.z.to_array()]
}

pub(super) fn lane_of(rows: &[[f32; LANES]; 3], lane: usize) -> Vec3 {
    Vec3::new(rows[0][lane], rows[1][lane], rows[2][lane])
}
