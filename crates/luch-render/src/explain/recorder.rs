//! Writes down what the picture's own code does, wave by wave.
//!
//! It looks on while [`Waves`](crate::integrator::classic::Waves) traces the samples of one pixel as one batch, and
//! takes the numbers from the batches of that code. What the code does not keep, the factors of each light, is worked
//! out again by the same functions from the same numbers; which instruction set they run on changes no bit.

use super::account::{Blocker, LightSource};
use super::light::{LightAccount, LightFactors, Visibility};
use super::lit_group::{LitGroup, arrays, lane_of};
use super::surface::{Face, Side, Square, SurfaceAccount};
use crate::compiled::{CompiledScene, Surface};
use crate::integrator::Colors;
use crate::integrator::classic::Wave;
use crate::integrator::onlooker::{Lighting, Onlooker};
use crate::math::lanes::{LANES, Lanes, Vec3Lanes};
use crate::math::ray::{HitBatch, Ray, RayBatch};
use crate::shading::gather::Gathered;
use crate::shading::surface::{SurfaceBatch, views};
use crate::simd::baseline;
use fearless_simd::Level;
use fearless_simd::prelude::*;
use glam::Vec3;

/// What was written down of a wave. Places in lists count within the wave.
#[derive(Debug, Default)]
pub(super) struct WaveRecord {
    pub(super) rays: Vec<Ray>,
    /// For each ray the surface that it hit.
    pub(super) hit: Vec<Option<u32>>,
    pub(super) surfaces: Vec<SurfaceAccount>,
    /// For each surface each light.
    pub(super) lights: Vec<LightAccount>,
    /// The shadow ray of each of `lights`, if there is one.
    pub(super) shadows: Vec<Option<Ray>>,
    pub(super) faces: Vec<Face>,
    pub(super) vertex_factors: Vec<LightFactors>,
    /// For each ray its mirror ray in the next wave.
    pub(super) mirror: Vec<Option<u32>>,
    /// The colour that each ray brings.
    pub(super) colors: Vec<[f32; 3]>,
    /// Whether the rays were not traced.
    pub(super) used_up: bool,
}

/// Looks on and writes down.
pub(super) struct Recorder<'a> {
    scene: &'a CompiledScene,
    level: Level,
    pub(super) waves: Vec<WaveRecord>,
    /// Entries that may still be written.
    left: usize,
    /// Whether there would have been more.
    pub(super) full: bool,
    blockers: HitBatch,
    facts: Box<Gathered>,
}

impl<'a> Recorder<'a> {
    pub(super) fn new(scene: &'a CompiledScene, level: Level, most: usize) -> Self {
        Self {
            scene,
            level,
            waves: Vec::new(),
            left: most,
            full: false,
            blockers: HitBatch::new(),
            facts: Box::default(),
        }
    }

    /// The lights as the account lists them.
    pub(super) fn light_sources(&self) -> Vec<LightSource> {
        let lights = self.scene.lights.iter();
        lights
            .map(|light| LightSource {
                light: light.index,
                position: light.position,
                intensity: light.intensity,
                color: light.color.to_array(),
            })
            .collect()
    }

    /// The triangles of the meshes in a group of sixteen hits, by lane.
    fn faces(&mut self, hits: &HitBatch, at: usize, surfaces: &SurfaceBatch) -> (u16, [Face; LANES]) {
        self.facts.fetch(self.scene, hits, at);
        let none = Face { vertices: [Vec3::ZERO; 3], normals: [Vec3::ZERO; 3], weights: [0.0; 3] };
        let mut faces = [none; LANES];
        if self.facts.mesh == 0 {
            return (0, faces);
        }
        let simd = baseline();
        let facing = Vec3Lanes::load(simd, views(&surfaces.geometric_normal), at);
        let corners = self.facts.world_vertices(simd).map(arrays);
        let normals = self.facts.turned_normals(simd, facing).map(arrays);
        let u = Lanes::from_slice(simd, &hits.u[at..at + LANES]);
        let v = Lanes::from_slice(simd, &hits.v[at..at + LANES]);
        let first = (Lanes::splat(simd, 1.0) - u - v).to_array();
        for (lane, face) in faces.iter_mut().enumerate() {
            *face = Face {
                vertices: corners.map(|rows| lane_of(&rows, lane)),
                normals: normals.map(|rows| lane_of(&rows, lane)),
                weights: [first[lane], hits.u[at + lane], hits.v[at + lane]],
            };
        }
        (self.facts.mesh, faces)
    }

    /// The account of the surface that ray `index` of the wave hit, before any light.
    fn surface(&self, index: usize, hits: &HitBatch, surfaces: &SurfaceBatch, face: Option<&Face>) -> SurfaceAccount {
        let (number, primitive) = (hits.object[index], hits.primitive[index]);
        let object = &self.scene.objects[number as usize];
        let look = object.look_of(primitive);
        let base = at(&surfaces.base, index).to_array();
        let (position, geometric_normal) = (at(&surfaces.position, index), at(&surfaces.geometric_normal, index));
        let outward = match &object.surface {
            Surface::Sphere { center, .. } => position - *center,
            Surface::Plane { normal, .. } => *normal,
            Surface::Cuboid { axes, .. } => {
                let axis = axes.col((primitive as usize / 2).min(2));
                if primitive % 2 == 1 { axis } else { -axis }
            }
            Surface::Mesh { .. } => face.map_or(Vec3::ZERO, |face| {
                let [a, b, c] = face.vertices.map(Vec3::as_dvec3);
                (b - a).cross(c - a).normalize_or_zero().as_vec3()
            }),
            Surface::Nothing => Vec3::ZERO,
        };
        SurfaceAccount {
            ray: 0,
            object: number,
            primitive,
            t: hits.t[index],
            position,
            geometric_normal,
            normal: at(&surfaces.normal, index),
            side: if outward.dot(geometric_normal) < 0.0 { Side::Back } else { Side::Front },
            shading: face.map(|_| object.shading),
            face: None,
            base,
            square: object.checker.map(|checker| {
                let second = base == checker.color.to_array() && base != look.base.to_array();
                if second { Square::Second } else { Square::First }
            }),
            gloss: look.gloss,
            highlight: surfaces.highlight[index],
            exponent: surfaces.exponent[index],
            reflection: surfaces.reflection[index],
            ambient: [0.0; 3],
            local: [0.0; 3],
            mirror: None,
        }
    }
}

impl Onlooker for Recorder<'_> {
    fn wave(&mut self, rays: &RayBatch) -> bool {
        // A ray, and for each light an entry and a shadow ray.
        let entries = rays.len().saturating_mul(1 + 2 * self.scene.lights.len());
        let Some(left) = self.left.checked_sub(entries) else {
            self.full = true;
            return false;
        };
        self.left = left;
        self.waves.push(WaveRecord {
            rays: (0..rays.len()).map(|index| rays.get(index)).collect(),
            hit: vec![None; rays.len()],
            mirror: vec![None; rays.len()],
            used_up: true,
            ..WaveRecord::default()
        });
        true
    }

    fn surfaces(&mut self, rays: &RayBatch, hits: &HitBatch, surfaces: &SurfaceBatch, colors: &Colors) {
        let Some(mut wave) = self.waves.pop() else { return };
        wave.used_up = false;
        for from in (0..rays.len()).step_by(LANES) {
            let (meshes, faces) = self.faces(hits, from, surfaces);
            for lane in lanes_in(surfaces.hit[from / LANES]) {
                let index = from + lane;
                let face = (meshes & (1 << lane) != 0).then_some(&faces[lane]);
                let mut surface = self.surface(index, hits, surfaces, face);
                surface.ambient = colors.get(index);
                surface.face = face.map(|_| count(&wave.faces));
                wave.faces.extend(face);
                wave.hit[index] = Some(count(&wave.surfaces));
                wave.surfaces.push(surface);
            }
        }
        let entries = wave.surfaces.len() * self.scene.lights.len();
        wave.lights.resize(entries, UNLIT);
        wave.shadows.resize(entries, None);
        self.waves.push(wave);
    }

    fn light(&mut self, number: usize, asked: u64, lighting: &Lighting<'_>, colors: &Colors) {
        let Some(mut wave) = self.waves.pop() else { return };
        let Lighting { rays, surfaces, shadows, coherence, .. } = *lighting;
        if asked > 0 {
            // The picture asks whether anything stands there; here it is asked what.
            self.scene.tree.closest_hits(self.level, &shadows.rays, coherence, &mut self.blockers);
        }
        let lights = self.scene.lights.len();
        for from in (0..rays.len()).step_by(LANES) {
            let hit = surfaces.hit[from / LANES];
            if hit == 0 {
                continue;
            }
            let group = LitGroup::of(self.scene, number, lighting, from);
            for lane in lanes_in(hit) {
                let index = from + lane;
                let Some(surface) = wave.hit[index] else { continue };
                let entry = surface as usize * lights + number;
                let shadow = (shadows.rays.t_max()[index] >= 0.0).then(|| shadows.rays.get(index));
                let visibility = match shadow.map(|_| self.blockers.get(index)) {
                    None => Visibility::NotAsked,
                    Some(None) => Visibility::Visible,
                    Some(Some(hit)) => {
                        Visibility::Blocked(Blocker { object: hit.object, primitive: hit.primitive, t: hit.t })
                    }
                };
                let vertices = group.vertices.as_ref().filter(|_| surfaces.gouraud[from / LANES] & (1 << lane) != 0);
                wave.lights[entry] = LightAccount {
                    light: self.scene.lights[number].index,
                    factors: group.point.lane(lane),
                    vertices: vertices.map(|_| count(&wave.vertex_factors)),
                    diffuse: shadows.diffuse[index],
                    specular: shadows.specular[index],
                    share: lane_of(&group.share, lane).to_array(),
                    visibility,
                    shadow: None,
                    sum: colors.get(index),
                };
                wave.shadows[entry] = shadow;
                wave.vertex_factors.extend(vertices.into_iter().flatten().map(|rows| rows.lane(lane)));
            }
        }
        self.waves.push(wave);
    }

    fn local(&mut self, traced: &Wave) {
        let Some(wave) = self.waves.last_mut() else { return };
        for (index, hit) in wave.hit.iter().enumerate() {
            if let Some(surface) = hit {
                wave.surfaces[*surface as usize].local = traced.colors.get(index);
            }
        }
        for (child, &(parent, _)) in (0..).zip(&traced.mirrors) {
            wave.mirror[parent as usize] = Some(child);
        }
    }

    fn mixed(&mut self, waves: &[Wave]) {
        for (wave, traced) in self.waves.iter_mut().zip(waves) {
            wave.colors = (0..wave.rays.len()).map(|index| traced.colors.get(index)).collect();
        }
    }
}

/// An entry before its light has been looked at.
const UNLIT: LightAccount = LightAccount {
    light: 0,
    factors: LightFactors {
        normal: Vec3::ZERO,
        to_viewer: Vec3::ZERO,
        to_light: Vec3::ZERO,
        distance: 0.0,
        falloff: 0.0,
        strength: 0.0,
        cos_theta: 0.0,
        mirrored: Vec3::ZERO,
        cos_alpha: 0.0,
        power: 0.0,
        diffuse: 0.0,
        specular: 0.0,
    },
    vertices: None,
    diffuse: 0.0,
    specular: 0.0,
    share: [0.0; 3],
    visibility: Visibility::NotAsked,
    shadow: None,
    sum: [0.0; 3],
};

fn at(lists: &[Vec<f32>; 3], index: usize) -> Vec3 {
    Vec3::new(lists[0][index], lists[1][index], lists[2][index])
}

/// The lanes whose bits are set.
fn lanes_in(bits: u16) -> impl Iterator<Item = usize> {
    (0..LANES).filter(move |lane| bits & (1 << lane) != 0)
}

/// The place of the next entry.
#[allow(clippy::cast_possible_truncation, reason = "the recorder's limit is far below 2^32")]
pub(super) fn count<T>(list: &[T]) -> u32 {
    list.len() as u32
}
