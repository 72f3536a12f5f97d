//! The account of a pixel: plain numbers in flat lists, for whoever shows them.

use super::light::{LightAccount, LightFactors};
use super::surface::{Face, SurfaceAccount};
use crate::math::bounds::Bounds;
use glam::Vec3;
use luch_scene::ImageSize;

/// Everything that made the colour of one pixel.
///
/// Rays lie in one list, sample by sample, each ray directly before those that it caused: the shadow rays of the surface
/// it hit, in the order of the lights, then its mirror ray with all of its own. So a view may skip a closed branch by
/// [`RayAccount::descendants`], and the lists can be walked without recursion however deep the mirrors go.
///
/// Colours are linear light. Objects and lights are named by their places in the lists of the `Scene`.
#[derive(Debug, Clone, PartialEq)]
pub struct PixelAccount {
    /// Column of the pixel, from the left.
    pub x: u32,
    /// Row of the pixel, from the top.
    pub y: u32,
    /// The size of the whole picture.
    pub size: ImageSize,
    /// The pixel's linear red, green, blue: those of the picture, bit for bit.
    pub pixel: [f32; 3],
    /// How the samples differ.
    pub spread: Spread,
    /// What all rays share.
    pub setting: Setting,
    /// The rays through the pixel, in the order in which they are added.
    pub samples: Vec<SampleAccount>,
    /// All rays.
    pub rays: Vec<RayAccount>,
    /// The surfaces that camera and mirror rays hit, in the order of these rays.
    pub surfaces: Vec<SurfaceAccount>,
    /// For each surface one entry for each light of [`Setting::lights`]: see [`PixelAccount::lights_of`].
    pub lights: Vec<LightAccount>,
    /// The triangles among the surfaces.
    pub faces: Vec<Face>,
    /// Factors at the vertices of triangles with Gouraud shading, three for each light: see
    /// [`PixelAccount::vertices_of`].
    pub vertex_factors: Vec<LightFactors>,
}

/// What the lighting sum takes from the scene as a whole.
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    /// The colour of rays that meet nothing or may go no further.
    pub background: [f32; 3],
    /// I_a, the light that is everywhere.
    pub ambient: f32,
    /// K, the distance at which a light has half its strength.
    pub attenuation: f32,
    /// Surfaces along a path, the first included.
    pub depth: u32,
    /// The lights that are on, in the order in which they are added.
    pub lights: Vec<LightSource>,
    /// The box around all bounded objects; empty if there are none.
    pub bounds: Bounds,
}

/// A light as the lighting sum knows it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightSource {
    /// Its place in the scene's list.
    pub light: u32,
    /// Where it is.
    pub position: Vec3,
    /// i: 1 is the 100 % of the studio.
    pub intensity: f32,
    /// c, its colour.
    pub color: [f32; 3],
}

/// How the samples of a pixel differ, colour by colour.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// The darkest.
    pub min: [f32; 3],
    /// The brightest.
    pub max: [f32; 3],
    /// The standard deviation: the root of the mean square of the differences from the mean.
    pub std_dev: [f32; 3],
}

/// One ray through the pixel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SampleAccount {
    /// The camera ray, its place in [`PixelAccount::rays`].
    pub ray: u32,
    /// Where it goes through the picture, in pixels from the upper left corner: the middle of a pixel is at one half.
    pub film: [f32; 2],
    /// Where it leaves the lens, in lens radii to the right and up.
    pub lens: [f32; 2],
    /// What it brings.
    pub color: [f32; 3],
}

/// Why there is a ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RayKind {
    /// It looks from the lens through the pixel.
    Camera,
    /// It asks whether anything stands before a light.
    Shadow,
    /// It looks where a mirror looks.
    Mirror,
}

impl RayKind {
    /// Every kind.
    pub const ALL: [Self; 3] = [Self::Camera, Self::Shadow, Self::Mirror];

    /// The word for it.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Camera => "camera",
            Self::Shadow => "shadow",
            Self::Mirror => "mirror",
        }
    }
}

/// A ray and what became of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RayAccount {
    /// Why there is the ray.
    pub kind: RayKind,
    /// The ray that caused it; none for a camera ray.
    pub parent: Option<u32>,
    /// How many rays it caused, theirs included: they follow it in the list.
    pub descendants: u32,
    /// The sample that it belongs to.
    pub sample: u32,
    /// Surfaces on the way from the lens to its origin: 0 for a camera ray.
    pub depth: u32,
    /// Where it starts.
    pub origin: Vec3,
    /// Of unit length.
    pub direction: Vec3,
    /// How far it looks; infinite but for shadow rays.
    pub reach: f32,
    /// The share of its colour in the pixel. A shadow ray has that of the light it asks for.
    pub weight: f32,
    /// What it brings: of a shadow ray what the light adds to the surface, 0 if something blocks it.
    pub color: [f32; 3],
    /// Where it ends.
    pub end: RayEnd,
}

/// What became of a ray.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RayEnd {
    /// It hit a surface: the place of that in [`PixelAccount::surfaces`].
    Surface(u32),
    /// It met nothing and brings the background.
    Nothing,
    /// It was not traced, since [`Setting::depth`] surfaces lie behind it, and brings the background.
    DepthUsedUp,
    /// A shadow ray that nothing blocks: the light of this place in [`PixelAccount::lights`] counts.
    Light(u32),
    /// A shadow ray of the light of this place in [`PixelAccount::lights`], and what stands before that.
    Blocked {
        /// The light's entry.
        light: u32,
        /// What the ray meets first.
        blocker: Blocker,
    },
}

/// What stands before a light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Blocker {
    /// The object.
    pub object: u32,
    /// Its triangle or face.
    pub primitive: u32,
    /// How far along the shadow ray.
    pub t: f32,
}

impl PixelAccount {
    /// The entries of a surface's lights, in the order in which they are added.
    #[must_use]
    pub fn lights_of(&self, surface: u32) -> &[LightAccount] {
        let count = self.setting.lights.len();
        &self.lights[surface as usize * count..][..count]
    }

    /// The surface that a ray hit; none for shadow rays.
    #[must_use]
    pub fn surface_of(&self, ray: u32) -> Option<&SurfaceAccount> {
        match self.rays[ray as usize].end {
            RayEnd::Surface(surface) => Some(&self.surfaces[surface as usize]),
            _ => None,
        }
    }

    /// The triangle that a surface is part of, with the vertices' normals.
    #[must_use]
    pub fn face_of(&self, surface: &SurfaceAccount) -> Option<&Face> {
        surface.face.map(|face| &self.faces[face as usize])
    }

    /// The factors at the three vertices, under Gouraud shading.
    #[must_use]
    pub fn vertices_of(&self, light: &LightAccount) -> Option<&[LightFactors]> {
        light.vertices.map(|first| &self.vertex_factors[first as usize..][..3])
    }

    /// The rays that a ray caused itself, in order.
    pub fn children(&self, ray: u32) -> impl Iterator<Item = u32> + '_ {
        let end = ray + 1 + self.rays[ray as usize].descendants;
        let mut next = ray + 1;
        std::iter::from_fn(move || {
            let child = (next < end).then_some(next)?;
            next += 1 + self.rays[child as usize].descendants;
            Some(child)
        })
    }

    /// Bytes that the lists hold.
    #[must_use]
    pub fn memory_bytes(&self) -> usize {
        size_of_val(self.samples.as_slice())
            + size_of_val(self.rays.as_slice())
            + size_of_val(self.surfaces.as_slice())
            + size_of_val(self.lights.as_slice())
            + size_of_val(self.faces.as_slice())
            + size_of_val(self.vertex_factors.as_slice())
            + size_of_val(self.setting.lights.as_slice())
    }
}
