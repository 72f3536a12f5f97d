//! The account of a surface that a ray hit.

use glam::Vec3;
use luch_scene::Shading;

/// Where a ray hit, what it hit, and the light there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfaceAccount {
    /// The ray that hit it.
    pub ray: u32,
    /// The object.
    pub object: u32,
    /// Index of the triangle in its mesh; of a box the face, `2 * axis`, plus 1 on the positive side; else 0.
    pub primitive: u32,
    /// How far along the ray.
    pub t: f32,
    /// The point, moved onto the surface.
    pub position: Vec3,
    /// The true face's normal, turned to the side that the ray comes from.
    pub geometric_normal: Vec3,
    /// N: the normal that lighting and mirroring use, turned to the same side.
    pub normal: Vec3,
    /// Which side was hit.
    pub side: Side,
    /// The shading model, where there is a choice: on meshes.
    pub shading: Option<Shading>,
    /// The triangle, its place in the account's list.
    pub face: Option<u32>,
    /// k_d and k_a: the colour at this point, pattern included.
    pub base: [f32; 3],
    /// The square of the pattern, if there is one.
    pub square: Option<Square>,
    /// The gloss that k_s and n come from.
    pub gloss: f32,
    /// k_s.
    pub highlight: f32,
    /// n.
    pub exponent: f32,
    /// r, the mirror share.
    pub reflection: f32,
    /// k_a I_a.
    pub ambient: [f32; 3],
    /// The lighting sum: the ambient term and the shares of all lights that reach the point.
    pub local: [f32; 3],
    /// The mirror ray, its place in the account's list; none where r is 0.
    pub mirror: Option<u32>,
}

/// A side of a surface.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The outside, or the side that a wall's or a face's normal points to.
    Front,
    /// The inside, or the other side.
    Back,
}

impl Side {
    /// The word for it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Front => "front",
            Self::Back => "back",
        }
    }
}

/// A square of a checker pattern.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Square {
    /// It has the object's colour.
    First,
    /// It has the pattern's colour.
    Second,
}

impl Square {
    /// The word for it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::First => "first",
            Self::Second => "second",
        }
    }
}

/// A triangle of a mesh, in world space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Face {
    /// Its vertices.
    pub vertices: [Vec3; 3],
    /// The normals at the vertices, turned to the side that the ray comes from: those that Phong shading blends, and
    /// Gouraud shading lights with. Zero where the model has none. Flat shading uses the face's own.
    pub normals: [Vec3; 3],
    /// How much of each vertex there is in the hit point.
    pub weights: [f32; 3],
}
