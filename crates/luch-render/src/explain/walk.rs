//! What a ray's hit cost: the boxes that the ray goes into and the shapes that it is tested against.

use super::account::{PixelAccount, RayEnd, RayKind};
use crate::accel::Query;
use crate::accel::walk::Steps;
use crate::compiled::{CompiledScene, Surface};
use crate::math::bounds::Bounds;
use crate::math::ray::{Hit, Ray};
use glam::Vec3;

/// A ray's way through the trees.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Walk {
    /// What it found: of a ray that looks for the nearest hit the same as the picture, bit for bit.
    pub hit: Option<Hit>,
    /// The boxes that it goes into, in order: nodes of the tree over the objects, and those of meshes.
    pub boxes: Vec<BoxVisit>,
    /// The triangles and other shapes that it is tested against, in order.
    pub tests: Vec<ShapeTest>,
}

/// A box that a ray goes into.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoxVisit {
    /// Boxes around it: 0 for the root of the tree over the objects. The tree of a mesh goes on from where its object
    /// hangs.
    pub level: u32,
    /// The object whose mesh's tree it is part of; none in the tree over the objects.
    pub object: Option<u32>,
    /// Whether it holds triangles or a shape, not boxes.
    pub leaf: bool,
    /// The corners in world space: bit 0 of the place says which side along x, bit 1 along y, bit 2 along z, of the
    /// space that the tree is in.
    pub corners: [Vec3; 8],
}

/// A test of a ray against a triangle or another shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShapeTest {
    /// The object.
    pub object: u32,
    /// Its triangle; of a box the face that is met.
    pub primitive: u32,
    /// The box that holds it, its place in [`Walk::boxes`]; none for shapes that are tested for every ray: unbounded
    /// walls, and all shapes of a scene that has few.
    pub in_box: Option<u32>,
    /// Where the ray meets it, if it does, and not behind what it has met before.
    pub t: Option<f32>,
}

/// The edges of a box, as pairs of places in [`BoxVisit::corners`].
pub const BOX_EDGES: [[usize; 2]; 12] =
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

/// Walks with a ray. This is a walk of its own through the trees of the picture, one ray alone, nearest boxes first: the
/// kernels that make the picture share visits among neighbouring rays, and find the same.
#[must_use]
pub fn walk(scene: &CompiledScene, ray: &Ray, query: Query) -> Walk {
    let mut list = List { scene, walk: Walk::default() };
    let hit = scene.tree.walk(ray, query, &mut list);
    Walk { hit, ..list.walk }
}

/// How many boxes a ray goes into, and how many shapes it is tested against, on its way to the nearest hit.
pub(crate) fn counts(scene: &CompiledScene, ray: &Ray) -> [u32; 2] {
    let mut counts = Counts::default();
    scene.tree.walk(ray, Query::Closest, &mut counts);
    [counts.boxes, counts.tests]
}

impl PixelAccount {
    /// The way of one of the account's rays; empty if it was not traced.
    #[must_use]
    pub fn walk(&self, scene: &CompiledScene, ray: u32) -> Walk {
        let account = &self.rays[ray as usize];
        if account.end == RayEnd::DepthUsedUp {
            return Walk::default();
        }
        let query = if account.kind == RayKind::Shadow { Query::Any } else { Query::Closest };
        let ray = Ray { t_max: account.reach, ..Ray::new(account.origin, account.direction) };
        walk(scene, &ray, query)
    }
}

/// Writes the steps down.
struct List<'a> {
    scene: &'a CompiledScene,
    walk: Walk,
}

impl Steps for List<'_> {
    fn enter(&mut self, bounds: &[[f32; 3]; 2], level: u32, leaf: bool, object: Option<u32>) {
        let bounds = Bounds { min: bounds[0].into(), max: bounds[1].into() };
        let surface = object.map(|object| &self.scene.objects[object as usize].surface);
        let corners = match surface {
            Some(Surface::Mesh { placement, .. }) => bounds.corners().map(|corner| placement.point(corner)),
            _ => bounds.corners(),
        };
        self.walk.boxes.push(BoxVisit { level, object, leaf, corners });
    }

    fn test(&mut self, object: u32, primitive: u32, t: Option<f32>) {
        #[allow(clippy::cast_possible_truncation, reason = "a ray goes into far fewer than 2^32 boxes")]
        let in_box = self.walk.boxes.len().checked_sub(1).map(|last| last as u32);
        self.walk.tests.push(ShapeTest { object, primitive, in_box, t });
    }
}

/// Counts the steps.
#[derive(Default)]
struct Counts {
    boxes: u32,
    tests: u32,
}

impl Steps for Counts {
    fn enter(&mut self, _bounds: &[[f32; 3]; 2], _level: u32, _leaf: bool, _object: Option<u32>) {
        self.boxes += 1;
    }

    fn test(&mut self, _object: u32, _primitive: u32, _t: Option<f32>) {
        self.tests += 1;
    }
}
