//! The lighting sum of the classic model, term by term.
//!
//! For a light of intensity i and colour c at distance d, with N the normal, L the direction to the light, R the mirror
//! direction of L at N, and V the direction to the viewer:
//!
//! ```text
//! falloff  = K / (d + K)
//! strength = i * falloff                       (I_l / (d + K) with I_l = K * i)
//! diffuse  = strength * (N.L)+
//! specular = strength * k_s * ((R.V)+)^n       where N.L > 0, else 0
//! share    = c * (k_d * diffuse + specular)    where nothing stands between, else 0
//! colour   = k_a * I_a + sum of the shares, in the order of the lights
//! ```
//!
//! The picture and its explanation both come from this file. A highlight needs the light in front of the surface: the
//! mirror direction of a light behind it means nothing.

use crate::compiled::CompiledLight;
use crate::math::lanes::{Lanes, Vec3Lanes, greater, smaller};
use crate::math::pow::pow;
use fearless_simd::prelude::*;

/// What of a surface the lighting sum wants to know, for sixteen surfaces.
#[derive(Clone, Copy)]
pub(crate) struct LitPoint<S: Simd> {
    pub(crate) position: Vec3Lanes<S>,
    /// N, of unit length.
    pub(crate) normal: Vec3Lanes<S>,
    /// V, of unit length.
    pub(crate) to_viewer: Vec3Lanes<S>,
    /// k_s.
    pub(crate) highlight: Lanes<S>,
    /// n.
    pub(crate) exponent: Lanes<S>,
}

/// What one light does at sixteen points, if nothing stands between.
#[derive(Clone, Copy)]
pub(crate) struct LightTerms<S: Simd> {
    /// What multiplies k_d.
    pub(crate) diffuse: Lanes<S>,
    /// What is added for the highlight.
    pub(crate) specular: Lanes<S>,
    /// The numbers that the two were made of, for the explanation.
    pub(crate) factors: LightFactors<S>,
}

/// The numbers behind the terms of a light. A picture looks at none of them, and then the compiler drops them.
#[derive(Clone, Copy)]
pub(crate) struct LightFactors<S: Simd> {
    /// L, of unit length; zero at the light itself.
    pub(crate) to_light: Vec3Lanes<S>,
    /// d.
    pub(crate) distance: Lanes<S>,
    pub(crate) falloff: Lanes<S>,
    pub(crate) strength: Lanes<S>,
    /// N.L, negative for a light behind the surface.
    pub(crate) cos_theta: Lanes<S>,
    /// R.
    pub(crate) mirrored: Vec3Lanes<S>,
    /// (R.V)+.
    pub(crate) cos_alpha: Lanes<S>,
    /// ((R.V)+)^n where there is a highlight, else 0.
    pub(crate) power: Lanes<S>,
}

impl<S: Simd> LightTerms<S> {
    /// Works out the terms of a light at the points.
    #[inline(always)]
    pub(crate) fn at(simd: S, point: &LitPoint<S>, light: &CompiledLight, attenuation: f32) -> Self {
        let (zero, one) = (Lanes::splat(simd, 0.0), Lanes::splat(simd, 1.0));
        let to_light = Vec3Lanes::splat(simd, light.position) - point.position;
        let distance = to_light.length();
        // A point at the light itself has no direction to it, and is not lit by it.
        let apart = distance.simd_gt(zero);
        let l = to_light.scale(apart.select(one / apart.select(distance, one), zero));
        let cos_theta = point.normal.dot(l);
        let k = Lanes::splat(simd, attenuation);
        let falloff = k / (distance + k);
        let strength = falloff * light.intensity;
        let lit = cos_theta.simd_gt(zero);
        let diffuse = lit.select(strength * cos_theta, zero);

        let mirrored = point.normal.scale(cos_theta * 2.0) - l;
        let cos_alpha = smaller(greater(mirrored.dot(point.to_viewer), zero), one);
        let glossy = lit & point.highlight.simd_gt(zero) & cos_alpha.simd_gt(zero);
        let (specular, power) = if glossy.any_true() {
            let power = pow(simd, cos_alpha, point.exponent);
            (glossy.select(strength * point.highlight * power, zero), glossy.select(power, zero))
        } else {
            (zero, zero)
        };
        let factors = LightFactors { to_light: l, distance, falloff, strength, cos_theta, mirrored, cos_alpha, power };
        Self { diffuse, specular, factors }
    }
}

/// What a light adds to the colour of sixteen surfaces, if nothing stands between.
#[inline(always)]
pub(crate) fn share<S: Simd>(
    simd: S,
    base: Vec3Lanes<S>,
    (diffuse, specular): (Lanes<S>, Lanes<S>),
    light: &CompiledLight,
) -> Vec3Lanes<S> {
    let lit =
        Vec3Lanes { x: base.x * diffuse + specular, y: base.y * diffuse + specular, z: base.z * diffuse + specular };
    lit * Vec3Lanes::splat(simd, light.color)
}

/// No colour is brighter than this: sums of it stay finite, whatever the lights.
pub(crate) const BRIGHTEST: f32 = 1e30;

/// The colours with each component at most [`BRIGHTEST`].
#[inline(always)]
pub(crate) fn limited<S: Simd>(simd: S, v: Vec3Lanes<S>) -> Vec3Lanes<S> {
    let most = Lanes::splat(simd, BRIGHTEST);
    Vec3Lanes { x: smaller(v.x, most), y: smaller(v.y, most), z: smaller(v.z, most) }
}
