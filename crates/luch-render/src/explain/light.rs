//! The account of one light at one surface: each factor of the lighting sum.

use super::account::Blocker;
use glam::Vec3;

/// What one light does at one surface.
///
/// ```text
/// falloff  = K / (d + K)
/// strength = falloff * i                        (I_l / (d + K) with I_l = K * i)
/// diffuse  = strength * (N.L)+
/// specular = strength * k_s * ((R.V)+)^n        where N.L > 0, else 0
/// share    = c * (k_d * diffuse + specular)     where nothing stands between, else 0
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightAccount {
    /// The light, its place in the scene's list.
    pub light: u32,
    /// The factors at the hit point, with its normal. Under Gouraud shading they are not used.
    pub factors: LightFactors,
    /// Under Gouraud shading the factors at the three vertices, whose terms are blended by the face's weights: the place
    /// of the first in the account's list.
    pub vertices: Option<u32>,
    /// What multiplies k_d.
    pub diffuse: f32,
    /// What is added for the highlight.
    pub specular: f32,
    /// What the light adds if nothing stands between.
    pub share: [f32; 3],
    /// Whether it does.
    pub visibility: Visibility,
    /// The shadow ray, its place in the account's list; none if the light would add nothing anyway.
    pub shadow: Option<u32>,
    /// The sum of the ambient term and the lights up to this one.
    pub sum: [f32; 3],
}

/// Whether a light reaches a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Visibility {
    /// Nothing stands between.
    Visible,
    /// Something does.
    Blocked(Blocker),
    /// Nobody asked: the light would add nothing, since it is behind the surface or has no strength.
    NotAsked,
}

/// The factors of the lighting sum at one point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightFactors {
    /// N.
    pub normal: Vec3,
    /// V, the unit direction to the viewer.
    pub to_viewer: Vec3,
    /// L, the unit direction to the light; zero at the light itself.
    pub to_light: Vec3,
    /// d.
    pub distance: f32,
    /// K / (d + K).
    pub falloff: f32,
    /// I_l / (d + K).
    pub strength: f32,
    /// N.L, negative for a light behind the surface.
    pub cos_theta: f32,
    /// R, L mirrored at N.
    pub mirrored: Vec3,
    /// (R.V)+.
    pub cos_alpha: f32,
    /// ((R.V)+)^n where there is a highlight, else 0.
    pub power: f32,
    /// What multiplies k_d.
    pub diffuse: f32,
    /// What is added for the highlight.
    pub specular: f32,
}
