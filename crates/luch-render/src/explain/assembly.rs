//! From the records of waves to the account: rays in the order of a walk through the tree.

use super::account::{PixelAccount, RayAccount, RayEnd, RayKind, SampleAccount, Setting};
use super::light::Visibility;
use super::recorder::{Recorder, WaveRecord, count};
use super::sum::{mean, spread};
use crate::compiled::CompiledScene;
use crate::integrator::Lens;
use crate::session::RenderJob;

/// Puts the account of a pixel together.
pub(super) fn assemble(
    scene: &CompiledScene,
    job: &RenderJob,
    [x, y]: [u32; 2],
    lens: &Lens,
    recorder: &Recorder<'_>,
) -> PixelAccount {
    let setting = Setting {
        background: scene.background.to_array(),
        ambient: scene.ambient,
        attenuation: scene.attenuation,
        depth: job.depth,
        lights: recorder.light_sources(),
        bounds: scene.bounds(),
    };
    let colors: Vec<[f32; 3]> = recorder.waves.first().map_or_else(Vec::new, |wave| wave.colors.clone());
    let mut account = PixelAccount {
        x,
        y,
        size: job.size,
        pixel: mean(colors.iter().copied()),
        spread: spread(&colors),
        setting,
        samples: Vec::with_capacity(colors.len()),
        rays: Vec::new(),
        surfaces: Vec::new(),
        lights: Vec::new(),
        faces: Vec::new(),
        vertex_factors: Vec::new(),
    };
    #[allow(clippy::cast_precision_loss, reason = "at most 4096 samples")]
    let weight = 1.0 / colors.len().max(1) as f32;
    for (sample, &color) in (0..).zip(&colors) {
        let (film, lens) = lens.place([x, y], sample);
        account.samples.push(SampleAccount { ray: count(&account.rays), film, lens, color });
        account.add_path(&recorder.waves, sample, weight);
    }
    account.count_descendants();
    account
}

impl PixelAccount {
    /// Adds a camera ray with all that it causes. A surface has one mirror at most, so a path is a chain of surfaces
    /// with shadow rays at each.
    fn add_path(&mut self, waves: &[WaveRecord], sample: u32, mut weight: f32) {
        let (mut next, mut parent) = (Some(sample), None);
        for (depth, wave) in (0..).zip(waves) {
            let Some(index) = next.map(|index| index as usize) else { return };
            let (ray, place) = (wave.rays[index], count(&self.rays));
            let surface = wave.hit[index];
            let end = match surface {
                Some(_) => RayEnd::Surface(count(&self.surfaces)),
                None if wave.used_up => RayEnd::DepthUsedUp,
                None => RayEnd::Nothing,
            };
            self.rays.push(RayAccount {
                kind: if parent.is_none() { RayKind::Camera } else { RayKind::Mirror },
                parent,
                descendants: 0,
                sample,
                depth,
                origin: ray.origin,
                direction: ray.direction,
                reach: ray.t_max,
                weight,
                color: wave.colors[index],
                end,
            });
            let Some(surface) = surface else { return };
            next = wave.mirror[index];
            weight *= self.add_surface(wave, surface as usize, place, next.is_some());
            parent = Some(place);
        }
    }

    /// Adds a surface that the last ray hit, its lights and their shadow rays; answers with the share of the mirror.
    fn add_surface(&mut self, wave: &WaveRecord, number: usize, ray: u32, mirrors: bool) -> f32 {
        let mut surface = wave.surfaces[number];
        let caller = self.rays[ray as usize];
        surface.ray = ray;
        surface.face = surface.face.map(|face| {
            self.faces.push(wave.faces[face as usize]);
            count(&self.faces) - 1
        });
        let lights = self.setting.lights.len();
        for entry in number * lights..(number + 1) * lights {
            let mut light = wave.lights[entry];
            light.vertices = light.vertices.map(|first| {
                let factors = &wave.vertex_factors[first as usize..][..3];
                self.vertex_factors.extend_from_slice(factors);
                count(&self.vertex_factors) - 3
            });
            if let Some(shadow) = wave.shadows[entry] {
                light.shadow = Some(count(&self.rays));
                let place = count(&self.lights);
                let blocked = match light.visibility {
                    Visibility::Blocked(blocker) => Some(blocker),
                    Visibility::Visible | Visibility::NotAsked => None,
                };
                self.rays.push(RayAccount {
                    kind: RayKind::Shadow,
                    parent: Some(ray),
                    descendants: 0,
                    sample: caller.sample,
                    depth: caller.depth + 1,
                    origin: shadow.origin,
                    direction: shadow.direction,
                    reach: shadow.t_max,
                    weight: caller.weight * (1.0 - surface.reflection),
                    color: if blocked.is_some() { [0.0; 3] } else { light.share },
                    end: blocked.map_or(RayEnd::Light(place), |blocker| RayEnd::Blocked { light: place, blocker }),
                });
            }
            self.lights.push(light);
        }
        // The mirror ray follows the shadow rays.
        surface.mirror = mirrors.then(|| count(&self.rays));
        self.surfaces.push(surface);
        surface.reflection
    }

    /// Adds up the rays below each ray: children lie behind their parents.
    fn count_descendants(&mut self) {
        for index in (0..self.rays.len()).rev() {
            let RayAccount { parent, descendants, .. } = self.rays[index];
            if let Some(parent) = parent {
                self.rays[parent as usize].descendants += 1 + descendants;
            }
        }
    }
}
