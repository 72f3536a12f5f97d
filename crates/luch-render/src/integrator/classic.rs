//! Backward ray tracing (Whitted, "An Improved Illumination Model for Shaded Display", 1980), a batch at a time.
//!
//! A wave is a batch of rays of the same depth: find their nearest hits, work out the surfaces, ask for each light which
//! of them it reaches, and send the mirror rays on as the next wave. When no wave is left, the colours are mixed on the
//! way back, deepest first: `(1 - r) * local + r * mirrored`.

use super::onlooker::{Lighting, Onlooker};
use super::{Colors, Orders};
use crate::compiled::{CompiledLight, CompiledScene};
use crate::math::lanes::{LANES, LaneMask, Lanes, Vec3Lanes};
use crate::math::ray::{Coherence, HitBatch, Mask, RayBatch};
use crate::shading::gouraud::Faces;
use crate::shading::spawn::{mirror_rays, shadow_rays};
use crate::shading::surface::{SurfaceBatch, parts, views};
use crate::shading::terms::{LightTerms, LitPoint, limited, share};
use crate::simd::shade_at;
use fearless_simd::prelude::*;

/// The memory of a tracer.
#[derive(Debug, Default)]
pub(crate) struct Waves {
    hits: HitBatch,
    surfaces: SurfaceBatch,
    shadows: Shadows,
    mirror: RayBatch,
    next: RayBatch,
    /// What is kept of each wave until the colours are mixed.
    kept: Vec<Wave>,
}

/// Waves whose memory is kept from picture to picture.
const KEPT_WAVES: usize = 32;

/// What is kept of a wave.
#[derive(Debug, Default)]
pub(crate) struct Wave {
    pub(crate) colors: Colors,
    /// For each ray of the next wave: the ray of this one that it came from, and its mirror share.
    pub(crate) mirrors: Vec<(u32, f32)>,
}

/// Shadow rays of one light, and what the light would add without them.
#[derive(Debug, Default)]
pub(crate) struct Shadows {
    pub(crate) rays: RayBatch,
    blocked: Mask,
    pub(crate) diffuse: Vec<f32>,
    pub(crate) specular: Vec<f32>,
}

impl Waves {
    /// Works out the colour of every ray and answers with the number of rays traced; `None` if it was stopped. The batch
    /// is used up. `objects` gets the objects of the first wave, if it looks for any.
    pub(crate) fn trace(
        &mut self,
        orders: &Orders<'_>,
        rays: &mut RayBatch,
        colors: &mut Colors,
        objects: Option<&mut Vec<u32>>,
    ) -> Option<u64> {
        self.trace_before(&mut (), orders, rays, colors, objects)
    }

    /// As [`Waves::trace`], with somebody who looks on.
    pub(crate) fn trace_before(
        &mut self,
        onlooker: &mut dyn Onlooker,
        orders: &Orders<'_>,
        rays: &mut RayBatch,
        colors: &mut Colors,
        mut objects: Option<&mut Vec<u32>>,
    ) -> Option<u64> {
        let mut traced = 0;
        let mut waves = 0;
        std::mem::swap(&mut self.mirror, rays);
        while !self.mirror.is_empty() {
            if !onlooker.wave(&self.mirror) {
                return None;
            }
            if self.kept.len() == waves {
                self.kept.push(Wave::default());
            }
            let mut wave = std::mem::take(&mut self.kept[waves]);
            traced += self.trace_wave(onlooker, orders, u32::try_from(waves).unwrap_or(u32::MAX), &mut wave)?;
            onlooker.local(&wave);
            self.kept[waves] = wave;
            if waves == 0
                && let Some(objects) = objects.take()
                && orders.depth > 0
            {
                objects.clone_from(&self.hits.object);
            }
            waves += 1;
            std::mem::swap(&mut self.mirror, &mut self.next);
        }
        std::mem::swap(&mut self.mirror, rays);
        self.mix(waves, orders.stop)?;
        onlooker.mixed(&self.kept[..waves]);
        if let Some(first) = self.kept.first_mut()
            && waves > 0
        {
            std::mem::swap(&mut first.colors, colors);
        }
        Some(traced)
    }

    /// Forgets the waves that only uncommonly deep pictures have.
    pub(crate) fn shrink(&mut self) {
        if self.kept.len() > KEPT_WAVES {
            self.kept.truncate(KEPT_WAVES);
            self.kept.shrink_to_fit();
        }
    }

    /// Traces the rays of `self.mirror` as wave number `number`, leaving its mirror rays in `self.next`; `None` if it was
    /// stopped.
    fn trace_wave(
        &mut self,
        onlooker: &mut dyn Onlooker,
        orders: &Orders<'_>,
        number: u32,
        wave: &mut Wave,
    ) -> Option<u64> {
        let Orders { scene, level, depth, stop, .. } = *orders;
        wave.colors.resize(self.mirror.len());
        wave.mirrors.clear();
        self.next.clear();
        if number >= depth {
            for index in 0..self.mirror.len() {
                wave.colors.set(index, scene.background.to_array());
            }
            return Some(0);
        }
        // A path may be ten thousand surfaces long, and a scene may have as many lights: none waits for them to end.
        if stop() {
            return None;
        }
        // The first mirror images of neighbours are still near each other; later ones are not.
        let coherence = if number <= 1 { Coherence::Coherent } else { Coherence::Incoherent };
        scene.tree.closest_hits(level, &self.mirror, coherence, &mut self.hits);
        let mut traced = self.mirror.len() as u64;
        let (rays, hits, surfaces) = (&self.mirror, &self.hits, &mut self.surfaces);
        shade_at!(level, simd => {
            surfaces.fill(simd, scene, rays, hits);
            ambient(simd, scene, surfaces, &mut wave.colors);
        });
        onlooker.surfaces(rays, hits, surfaces, &wave.colors);
        for (number, light) in scene.lights.iter().enumerate() {
            if stop() {
                return None;
            }
            let (surfaces, shadows) = (&self.surfaces, &mut self.shadows);
            let asked = shade_at!(level, simd => shadows.ask(simd, scene, light, (rays, hits), surfaces));
            if asked > 0 {
                traced += asked;
                scene.tree.occluded(level, &shadows.rays, coherence, &mut shadows.blocked);
                shade_at!(level, simd => shadows.add(simd, light, surfaces, &mut wave.colors));
            }
            let at = Lighting { rays, hits, surfaces, shadows, coherence };
            onlooker.light(number, asked, &at, &wave.colors);
        }
        let next = &mut self.next;
        shade_at!(level, simd => send_mirrors(simd, rays, surfaces_of(&self.surfaces), wave, next));
        Some(traced)
    }

    /// Mixes the colours of the waves into those of the first, deepest first; `None` if it was stopped.
    fn mix(&mut self, waves: usize, stop: &dyn Fn() -> bool) -> Option<()> {
        for number in (1..waves).rev() {
            if stop() {
                return None;
            }
            let (upper, lower) = self.kept.split_at_mut(number);
            let (above, below) = (&mut upper[number - 1], &lower[0]);
            for (index, &(parent, reflection)) in above.mirrors.iter().enumerate() {
                let (local, mirrored) = (above.colors.get(parent as usize), below.colors.get(index));
                let mix = std::array::from_fn(|c| (1.0 - reflection) * local[c] + reflection * mirrored[c]);
                above.colors.set(parent as usize, mix);
            }
        }
        Some(())
    }
}

/// Gives the closure of `shade_at!` a plain reference to capture.
const fn surfaces_of(surfaces: &SurfaceBatch) -> &SurfaceBatch {
    surfaces
}

/// Starts the colours with the ambient term; rays that hit nothing get the background.
#[inline(always)]
fn ambient<S: Simd>(simd: S, scene: &CompiledScene, surfaces: &SurfaceBatch, colors: &mut Colors) {
    let background = Vec3Lanes::splat(simd, scene.background);
    let level = Lanes::splat(simd, scene.ambient);
    for (group, &hit) in surfaces.hit.iter().enumerate() {
        let at = group * LANES;
        let mask = LaneMask::from_bitmask(simd, u64::from(hit));
        let base = Vec3Lanes::load(simd, views(&surfaces.base), at);
        let lit = limited(simd, base.scale(level));
        Vec3Lanes::select(mask, lit, background).store(parts(&mut colors.0), at);
    }
}

impl Shadows {
    /// Works out what a light would add to each surface, and makes shadow rays for those it would add anything to.
    /// Answers with their number.
    #[inline(always)]
    fn ask<S: Simd>(
        &mut self,
        simd: S,
        scene: &CompiledScene,
        light: &CompiledLight,
        (rays, hits): (&RayBatch, &HitBatch),
        surfaces: &SurfaceBatch,
    ) -> u64 {
        let padded = rays.padded_len();
        // Lanes without a shadow ray keep the origin and direction of an earlier one: their length alone says so.
        self.rays.resize(rays.len());
        self.diffuse.resize(padded, 0.0);
        self.specular.resize(padded, 0.0);
        let position = Vec3Lanes::splat(simd, light.position);
        let zero = Lanes::splat(simd, 0.0);
        let mut asked = 0;
        for at in (0..padded).step_by(LANES) {
            let (hit, gouraud) = (surfaces.hit[at / LANES], surfaces.gouraud[at / LANES]);
            let mut added = (zero, zero);
            if hit != 0 {
                let point = lit_point(simd, rays, surfaces, at);
                let terms = LightTerms::at(simd, &point, light, scene.attenuation);
                added = (terms.diffuse, terms.specular);
                if gouraud != 0 {
                    let facing = Vec3Lanes::load(simd, views(&surfaces.geometric_normal), at);
                    let faces = Faces::of(simd, scene, rays, hits, at, facing);
                    added = faces.blend(simd, gouraud, (light, scene.attenuation), added);
                }
            }
            let lit = added.0.simd_gt(zero) | added.1.simd_gt(zero);
            let wanted = lit & LaneMask::from_bitmask(simd, u64::from(hit));
            // Lanes without a shadow ray get nothing from the light either.
            wanted.select(added.0, zero).store_slice(&mut self.diffuse[at..at + LANES]);
            wanted.select(added.1, zero).store_slice(&mut self.specular[at..at + LANES]);
            let mut length = Lanes::splat(simd, f32::NEG_INFINITY);
            let lanes = self.rays.lanes_mut();
            if wanted.any_true() {
                asked += u64::from(wanted.to_bitmask().count_ones());
                let (origin, direction, to_light) = shadow_rays(simd, surfaces, at, position);
                origin.store(lanes.origin, at);
                direction.store(lanes.direction, at);
                length = wanted.select(to_light, length);
            }
            zero.store_slice(&mut lanes.t_min[at..at + LANES]);
            length.store_slice(&mut lanes.t_max[at..at + LANES]);
        }
        asked
    }

    /// Adds the light's share to the surfaces that it reaches.
    #[inline(always)]
    fn add<S: Simd>(&self, simd: S, light: &CompiledLight, surfaces: &SurfaceBatch, colors: &mut Colors) {
        for (group, &blocked) in self.blocked.words().iter().enumerate() {
            let at = group * LANES;
            let reached = !blocked & surfaces.hit[group];
            if reached == 0 {
                continue;
            }
            let mask = LaneMask::from_bitmask(simd, u64::from(reached));
            let diffuse = Lanes::from_slice(simd, &self.diffuse[at..at + LANES]);
            let specular = Lanes::from_slice(simd, &self.specular[at..at + LANES]);
            let base = Vec3Lanes::load(simd, views(&surfaces.base), at);
            let before = Vec3Lanes::load(simd, views(&colors.0), at);
            let after = limited(simd, before + share(simd, base, (diffuse, specular), light));
            Vec3Lanes::select(mask, after, before).store(parts(&mut colors.0), at);
        }
    }
}

/// The surfaces from `at` on, as the lighting sum wants them.
#[inline(always)]
pub(crate) fn lit_point<S: Simd>(simd: S, rays: &RayBatch, surfaces: &SurfaceBatch, at: usize) -> LitPoint<S> {
    let direction = Vec3Lanes::load(simd, [rays.direction(0), rays.direction(1), rays.direction(2)], at);
    LitPoint {
        position: Vec3Lanes::load(simd, views(&surfaces.position), at),
        normal: Vec3Lanes::load(simd, views(&surfaces.normal), at),
        to_viewer: -direction,
        highlight: Lanes::from_slice(simd, &surfaces.highlight[at..at + LANES]),
        exponent: Lanes::from_slice(simd, &surfaces.exponent[at..at + LANES]),
    }
}

/// Which surfaces of a group mirror anything.
#[inline(always)]
fn mirrors_of<S: Simd>(simd: S, surfaces: &SurfaceBatch, group: usize, hit: u16) -> LaneMask<S> {
    let at = group * LANES;
    let reflection = Lanes::from_slice(simd, &surfaces.reflection[at..at + LANES]);
    reflection.simd_gt(Lanes::splat(simd, 0.0)) & LaneMask::from_bitmask(simd, u64::from(hit))
}

/// Makes the mirror rays of the surfaces that mirror anything, in the order of the rays they come from.
#[inline(always)]
fn send_mirrors<S: Simd>(simd: S, rays: &RayBatch, surfaces: &SurfaceBatch, wave: &mut Wave, next: &mut RayBatch) {
    let zero = Lanes::splat(simd, 0.0);
    let mut total = 0;
    for (group, &hit) in surfaces.hit.iter().enumerate() {
        total += mirrors_of(simd, surfaces, group, hit).to_bitmask().count_ones() as usize;
    }
    if total == 0 {
        return;
    }
    // Room for the last group to be written whole.
    next.resize(total + LANES);
    let mut count = 0;
    for (group, &hit) in surfaces.hit.iter().enumerate() {
        let at = group * LANES;
        let mirrors = mirrors_of(simd, surfaces, group, hit);
        let mut bits = mirrors.to_bitmask();
        if bits == 0 {
            continue;
        }
        let (origin, direction) = mirror_rays(simd, surfaces, rays, at);
        let lanes = next.lanes_mut();
        origin.compress(mirrors).store(lanes.origin, count);
        direction.compress(mirrors).store(lanes.direction, count);
        zero.store_slice(&mut lanes.t_min[count..count + LANES]);
        Lanes::splat(simd, f32::INFINITY).store_slice(&mut lanes.t_max[count..count + LANES]);
        count += bits.count_ones() as usize;
        while bits != 0 {
            let lane = bits.trailing_zeros() as usize;
            bits &= bits - 1;
            #[allow(clippy::cast_possible_truncation, reason = "a batch has far fewer than 2^32 rays")]
            wave.mirrors.push(((at + lane) as u32, surfaces.reflection[at + lane]));
        }
    }
    next.resize(count);
}
