//! The surface at each hit of a batch: place, normals, look, and where its shadow rays start.

use super::gather::Gathered;
use crate::compiled::{CompiledChecker, CompiledScene};
use crate::math::lanes::{LANES, LaneMask, Lanes, Vec3Lanes, greater};
use crate::math::ray::{HitBatch, RayBatch};
use fearless_simd::prelude::*;

/// The surfaces at the hits of a batch, in lanes as the batch is.
#[derive(Debug, Default)]
pub(crate) struct SurfaceBatch {
    /// Which lanes of each group of sixteen hit anything.
    pub(crate) hit: Vec<u16>,
    /// Which lanes are lit at their vertices.
    pub(crate) gouraud: Vec<u16>,
    pub(crate) position: [Vec<f32>; 3],
    /// The true face's normal, turned to the side that the ray comes from.
    pub(crate) geometric_normal: [Vec<f32>; 3],
    /// The normal that lighting and mirroring use, turned to the same side.
    pub(crate) normal: [Vec<f32>; 3],
    /// Where shadow rays start: above the true face, and on smooth meshes above the curved surface it stands for.
    pub(crate) shadow_origin: [Vec<f32>; 3],
    /// How far a new ray must start above the face to be clear of rounding.
    pub(crate) offset: Vec<f32>,
    /// k_d and k_a.
    pub(crate) base: [Vec<f32>; 3],
    /// k_s.
    pub(crate) highlight: Vec<f32>,
    /// n.
    pub(crate) exponent: Vec<f32>,
    /// Mirror share.
    pub(crate) reflection: Vec<f32>,
    facts: Box<Gathered>,
}

/// A surface's point is right to a few units in the last place of the largest number that went into it; a ray that
/// starts this many of them above the face is on the right side of it.
const CLEARANCE: f32 = 16.0 / 16_777_216.0;

impl SurfaceBatch {
    fn resize(&mut self, padded: usize) {
        self.hit.resize(padded / LANES, 0);
        self.gouraud.resize(padded / LANES, 0);
        let vectors =
            [&mut self.position, &mut self.geometric_normal, &mut self.normal, &mut self.shadow_origin, &mut self.base];
        for list in vectors.into_iter().flatten() {
            list.resize(padded, 0.0);
        }
        for list in [&mut self.offset, &mut self.highlight, &mut self.exponent, &mut self.reflection] {
            list.resize(padded, 0.0);
        }
    }

    /// Fills the batch with the surfaces that the rays hit.
    #[inline(always)]
    pub(crate) fn fill<S: Simd>(&mut self, simd: S, scene: &CompiledScene, rays: &RayBatch, hits: &HitBatch) {
        let padded = rays.padded_len();
        self.resize(padded);
        let mut facts = std::mem::take(&mut self.facts);
        for at in (0..padded).step_by(LANES) {
            facts.fetch(scene, hits, at);
            self.hit[at / LANES] = facts.hit;
            self.gouraud[at / LANES] = facts.gouraud;
            if facts.hit != 0 {
                self.fill_group(simd, scene, rays, hits, at, &facts);
            }
        }
        self.facts = facts;
    }

    #[inline(always)]
    fn fill_group<S: Simd>(
        &mut self,
        simd: S,
        scene: &CompiledScene,
        rays: &RayBatch,
        hits: &HitBatch,
        at: usize,
        facts: &Gathered,
    ) {
        let origin = Vec3Lanes::load(simd, [rays.origin(0), rays.origin(1), rays.origin(2)], at);
        let direction = Vec3Lanes::load(simd, [rays.direction(0), rays.direction(1), rays.direction(2)], at);
        let t = Lanes::from_slice(simd, &hits.t[at..at + LANES]);
        let hit = LaneMask::from_bitmask(simd, u64::from(facts.hit));
        let t = hit.select(t, Lanes::splat(simd, 0.0));

        let mut place = analytic_place(simd, facts, origin + direction.scale(t));
        if facts.mesh != 0 {
            let mesh = LaneMask::from_bitmask(simd, u64::from(facts.mesh));
            let u = Lanes::from_slice(simd, &hits.u[at..at + LANES]);
            let v = Lanes::from_slice(simd, &hits.v[at..at + LANES]);
            place = Place::select(mesh, mesh_place(simd, facts, [u, v], direction), place);
        }

        // Surfaces are two-sided: normals are turned to the side that the ray comes from.
        let zero = Lanes::splat(simd, 0.0);
        let away = place.geometric_normal.dot(direction).simd_gt(zero);
        let geometric = Vec3Lanes::select(away, -place.geometric_normal, place.geometric_normal);
        let turned = place.normal.dot(geometric).simd_lt(zero);
        let normal = Vec3Lanes::select(turned, -place.normal, place.normal);

        let offset = place.magnitude * CLEARANCE;
        let base = Vec3Lanes::from_arrays(simd, &facts.base);
        let base = match facts.checker {
            0 => base,
            _ => checkered(simd, scene, hits, at, facts.checker, (place.position, geometric), base),
        };
        place.position.store(parts(&mut self.position), at);
        geometric.store(parts(&mut self.geometric_normal), at);
        normal.store(parts(&mut self.normal), at);
        (place.raised + geometric.scale(offset)).store(parts(&mut self.shadow_origin), at);
        base.store(parts(&mut self.base), at);
        offset.store_slice(&mut self.offset[at..at + LANES]);
        self.highlight[at..at + LANES].copy_from_slice(&facts.highlight);
        self.exponent[at..at + LANES].copy_from_slice(&facts.exponent);
        self.reflection[at..at + LANES].copy_from_slice(&facts.reflection);
    }
}

/// Three lists to write vectors into.
pub(crate) fn parts(lists: &mut [Vec<f32>; 3]) -> [&mut [f32]; 3] {
    let [x, y, z] = lists;
    [x, y, z]
}

/// Three lists to read vectors from.
pub(crate) fn views(lists: &[Vec<f32>; 3]) -> [&[f32]; 3] {
    [&lists[0], &lists[1], &lists[2]]
}

/// Where the hits are and how their surfaces stand, before the sides are sorted out.
#[derive(Clone, Copy)]
struct Place<S: Simd> {
    position: Vec3Lanes<S>,
    geometric_normal: Vec3Lanes<S>,
    normal: Vec3Lanes<S>,
    /// The position, on smooth meshes raised to the curved surface that the flat faces stand for.
    raised: Vec3Lanes<S>,
    /// The largest number that went into the position.
    magnitude: Lanes<S>,
}

impl<S: Simd> Place<S> {
    #[inline(always)]
    fn select(mask: LaneMask<S>, yes: Self, no: Self) -> Self {
        Self {
            position: Vec3Lanes::select(mask, yes.position, no.position),
            geometric_normal: Vec3Lanes::select(mask, yes.geometric_normal, no.geometric_normal),
            normal: Vec3Lanes::select(mask, yes.normal, no.normal),
            raised: Vec3Lanes::select(mask, yes.raised, no.raised),
            magnitude: mask.select(yes.magnitude, no.magnitude),
        }
    }
}

/// Spheres, walls and cuboids. The point on the ray is moved onto the surface, which it misses by the error of `t`.
#[inline(always)]
fn analytic_place<S: Simd>(simd: S, facts: &Gathered, on_ray: Vec3Lanes<S>) -> Place<S> {
    let sphere = LaneMask::from_bitmask(simd, u64::from(facts.sphere));
    let anchor = Vec3Lanes::from_arrays(simd, &facts.vertices[0]);
    let radius = Lanes::load_array_ref(simd, &facts.radius);
    let round = (on_ray - anchor).unit_or_zero(simd);
    let flat = Vec3Lanes::from_arrays(simd, &facts.normals[0]);
    let normal = Vec3Lanes::select(sphere, round, flat);
    let on_sphere = anchor + round.scale(radius);
    let on_face = on_ray - flat.scale((on_ray - anchor).dot(flat));
    let position = Vec3Lanes::select(sphere, on_sphere, on_face);
    let magnitude = position.largest() + anchor.largest() + radius;
    Place { position, geometric_normal: normal, normal, raised: position, magnitude }
}

/// Triangles, from the barycentric weights of the hit.
#[inline(always)]
fn mesh_place<S: Simd>(simd: S, facts: &Gathered, [u, v]: [Lanes<S>; 2], direction: Vec3Lanes<S>) -> Place<S> {
    let zero = Lanes::splat(simd, 0.0);
    let weights = [Lanes::splat(simd, 1.0) - u - v, u, v];
    let corners = facts.world_vertices(simd);
    let position = blend(weights, corners);
    let (edge_1, edge_2) = (corners[1] - corners[0], corners[2] - corners[0]);
    // Edges are brought to unit length first: the cross product of tiny or huge ones would leave the range of f32.
    let geometric_normal = edge_1.unit_or_zero(simd).cross(edge_2.unit_or_zero(simd)).unit_or_zero(simd);
    let translation = Vec3Lanes::from_arrays(simd, &facts.translation);
    let magnitude = position.largest() + edge_1.largest() + edge_2.largest() + translation.largest();
    let flat = Place { position, geometric_normal, normal: geometric_normal, raised: position, magnitude };
    if facts.smooth == 0 {
        return flat;
    }

    // Turn the vertex normals, all three alike, to the side of the face that the ray comes from.
    let away = geometric_normal.dot(direction).simd_gt(zero);
    let facing = Vec3Lanes::select(away, -geometric_normal, geometric_normal);
    let normals = facts.turned_normals(simd, facing);
    let blended = blend(weights, normals).unit_or_zero(simd);
    let usable = blended.dot(blended).simd_gt(zero);
    let normal = Vec3Lanes::select(usable, blended, geometric_normal);

    // Hanika, "Hacking the Shadow Terminator", 2021: raise the point to the planes of the vertices, where it is below.
    let lifts = [
        lift(simd, position, corners[0], normals[0]),
        lift(simd, position, corners[1], normals[1]),
        lift(simd, position, corners[2], normals[2]),
    ];
    let raised = position + blend(weights, lifts);
    let smooth = LaneMask::from_bitmask(simd, u64::from(facts.smooth));
    Place {
        normal: Vec3Lanes::select(smooth, normal, flat.normal),
        raised: Vec3Lanes::select(smooth, raised, position),
        ..flat
    }
}

/// The way from the point up to a vertex's tangent plane; zero where the point is above it.
#[inline(always)]
fn lift<S: Simd>(simd: S, position: Vec3Lanes<S>, corner: Vec3Lanes<S>, normal: Vec3Lanes<S>) -> Vec3Lanes<S> {
    let zero = Lanes::splat(simd, 0.0);
    normal.scale(greater(zero - (position - corner).dot(normal), zero))
}

#[inline(always)]
fn blend<S: Simd>(weights: [Lanes<S>; 3], v: [Vec3Lanes<S>; 3]) -> Vec3Lanes<S> {
    v[0].scale(weights[0]) + v[1].scale(weights[1]) + v[2].scale(weights[2])
}

/// The base colours, with the second colour where a pattern has it.
#[inline(always)]
fn checkered<S: Simd>(
    simd: S,
    scene: &CompiledScene,
    hits: &HitBatch,
    at: usize,
    lanes: u16,
    (position, normal): (Vec3Lanes<S>, Vec3Lanes<S>),
    base: Vec3Lanes<S>,
) -> Vec3Lanes<S> {
    let mut origin = [[0.0; LANES]; 3];
    let mut rows = [[[0.0; LANES]; 3]; 3];
    let mut color = [[0.0; LANES]; 3];
    let mut inset = [0.0; LANES];
    for lane in (0..LANES).filter(|lane| lanes & (1 << lane) != 0) {
        let object = hits.object[at + lane] as usize;
        if let Some(CompiledChecker { origin: o, rows: r, color: c, inset: i }) = scene.objects[object].checker {
            for axis in 0..3 {
                origin[axis][lane] = o[axis];
                color[axis][lane] = c[axis];
                for k in 0..3 {
                    rows[k][axis][lane] = r[k][axis];
                }
            }
            inset[lane] = i;
        }
    }
    let from_origin = position - normal.scale(Lanes::load_array(simd, inset)) - Vec3Lanes::from_arrays(simd, &origin);
    let mut count = Lanes::splat(simd, 0.0);
    for row in &rows {
        count += from_origin.dot(Vec3Lanes::from_arrays(simd, row)).floor();
    }
    // Odd squares have the second colour.
    let odd = (count - (count * 0.5).floor() * 2.0).simd_gt(Lanes::splat(simd, 0.5));
    let patterned = LaneMask::from_bitmask(simd, u64::from(lanes));
    Vec3Lanes::select(odd & patterned, Vec3Lanes::from_arrays(simd, &color), base)
}
