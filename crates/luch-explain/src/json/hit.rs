//! A surface that a ray hit.

use super::Named;
use crate::Explanation;
use luch_render::explain::{Face, LightAccount, LightFactors, Visibility};
use serde::Serialize;

#[derive(Serialize)]
pub(super) struct Hit<'a> {
    object: Named<'a>,
    kind: &'static str,
    primitive: u32,
    t: f32,
    position: [f32; 3],
    geometric_normal: [f32; 3],
    normal: [f32; 3],
    side: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    shading: Option<&'static str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    face: Option<FaceJson>,
    material: Material,
    ambient: [f32; 3],
    lights: Vec<Light<'a>>,
    local: [f32; 3],
    mirror: Option<u32>,
}

#[derive(Serialize)]
struct FaceJson {
    vertices: [[f32; 3]; 3],
    normals: [[f32; 3]; 3],
    weights: [f32; 3],
}

#[derive(Serialize)]
struct Material {
    color: [f32; 3],
    #[serde(skip_serializing_if = "Option::is_none")]
    square: Option<&'static str>,
    gloss: f32,
    k_s: f32,
    n: f32,
    reflection: f32,
}

#[derive(Serialize)]
struct Light<'a> {
    light: Named<'a>,
    factors: Factors,
    #[serde(skip_serializing_if = "Option::is_none")]
    vertices: Option<Vec<Factors>>,
    diffuse: f32,
    specular: f32,
    share: [f32; 3],
    visibility: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    blocked_by: Option<Named<'a>>,
    shadow: Option<u32>,
    sum: [f32; 3],
}

#[derive(Serialize)]
struct Factors {
    normal: [f32; 3],
    to_viewer: [f32; 3],
    to_light: [f32; 3],
    distance: f32,
    falloff: f32,
    strength: f32,
    cos_theta: f32,
    mirrored: [f32; 3],
    cos_alpha: f32,
    power: f32,
    diffuse: f32,
    specular: f32,
}

impl<'a> Hit<'a> {
    pub(super) fn of(explanation: &Explanation<'a>, place: u32) -> Self {
        let account = explanation.account;
        let surface = &account.surfaces[place as usize];
        let object = explanation.scene.objects.get(surface.object as usize);
        Self {
            object: explanation.object(surface.object),
            kind: object.map_or("?", |object| object.shape.kind()),
            primitive: surface.primitive,
            t: surface.t,
            position: surface.position.to_array(),
            geometric_normal: surface.geometric_normal.to_array(),
            normal: surface.normal.to_array(),
            side: surface.side.word(),
            shading: surface.shading.map(luch_scene::Shading::word),
            face: account.face_of(surface).map(FaceJson::of),
            material: Material {
                color: surface.base,
                square: surface.square.map(luch_render::explain::Square::word),
                gloss: surface.gloss,
                k_s: surface.highlight,
                n: surface.exponent,
                reflection: surface.reflection,
            },
            ambient: surface.ambient,
            lights: account.lights_of(place).iter().map(|light| Light::of(explanation, light)).collect(),
            local: surface.local,
            mirror: surface.mirror,
        }
    }
}

impl FaceJson {
    fn of(face: &Face) -> Self {
        Self {
            vertices: face.vertices.map(|v| v.to_array()),
            normals: face.normals.map(|v| v.to_array()),
            weights: face.weights,
        }
    }
}

impl<'a> Light<'a> {
    fn of(explanation: &Explanation<'a>, light: &LightAccount) -> Self {
        let vertices = explanation.account.vertices_of(light);
        let (visibility, blocked_by) = match light.visibility {
            Visibility::Visible => ("visible", None),
            Visibility::NotAsked => ("not asked", None),
            Visibility::Blocked(blocker) => ("blocked", Some(explanation.object(blocker.object))),
        };
        Self {
            light: explanation.light(light.light),
            factors: Factors::of(&light.factors),
            vertices: vertices.map(|vertices| vertices.iter().map(Factors::of).collect()),
            diffuse: light.diffuse,
            specular: light.specular,
            share: light.share,
            visibility,
            blocked_by,
            shadow: light.shadow,
            sum: light.sum,
        }
    }
}

impl Factors {
    fn of(factors: &LightFactors) -> Self {
        Self {
            normal: factors.normal.to_array(),
            to_viewer: factors.to_viewer.to_array(),
            to_light: factors.to_light.to_array(),
            distance: factors.distance,
            falloff: factors.falloff,
            strength: factors.strength,
            cos_theta: factors.cos_theta,
            mirrored: factors.mirrored.to_array(),
            cos_alpha: factors.cos_alpha,
            power: factors.power,
            diffuse: factors.diffuse,
            specular: factors.specular,
        }
    }
}
