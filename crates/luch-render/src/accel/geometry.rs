//! What a scene tree is built from.

use super::MeshTree;
use crate::math::bounds::Bounds;
use crate::math::ray::Ray;
use crate::shape::cuboid::{self, Cuboid};
use crate::shape::plane::{self, Rectangle};
use crate::shape::sphere;
use glam::{DMat3, Mat3, Vec3};
use std::sync::Arc;

/// The shape of one object, in world space. Its index in the slice given to [`super::SceneTree::build`] is the object
/// index of its hits.
#[derive(Clone, Debug)]
pub enum Geometry {
    /// An analytic sphere; a radius that is not positive is never hit.
    Sphere {
        /// The middle.
        center: Vec3,
        /// The radius.
        radius: f32,
    },
    /// An analytic box.
    Cuboid(Cuboid),
    /// A plane, or a rectangle of it.
    Plane {
        /// A point of the plane; the middle of the rectangle.
        point: Vec3,
        /// Across the plane; any length but 0.
        normal: Vec3,
        /// `None` for the whole plane.
        bounds: Option<Rectangle>,
    },
    /// A mesh, placed.
    Instance {
        /// The tree of the mesh, shared by all its instances.
        tree: Arc<MeshTree>,
        /// Where it stands.
        world_from_object: Placement,
    },
    /// Nothing: keeps the object's index taken.
    Hidden,
}

/// An affine map: `world = linear * object + translation`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placement {
    /// Rotation and scale.
    pub linear: Mat3,
    /// Where the origin goes.
    pub translation: Vec3,
}

impl Placement {
    /// The map that changes nothing.
    pub const IDENTITY: Self = Self { linear: Mat3::IDENTITY, translation: Vec3::ZERO };

    /// Rotation, then uniform scale, then translation.
    pub fn new(rotation: Mat3, scale: f32, translation: Vec3) -> Self {
        Self { linear: rotation * scale, translation }
    }

    /// The map of a point.
    pub fn point(&self, point: Vec3) -> Vec3 {
        self.linear * point + self.translation
    }
}

/// Takes world rays into the space of an object. The one arithmetic for it: kernels repeat it in lanes.
#[derive(Clone, Copy, Debug)]
pub struct ObjectFromWorld {
    /// Rows of the inverse linear map; `None` where the placement is the identity, which then is skipped everywhere.
    pub(crate) rows: Option<[Vec3; 3]>,
    pub(crate) translation: Vec3,
}

impl ObjectFromWorld {
    /// `None` when the placement flattens space or is not finite: such an instance is never hit.
    pub fn new(placement: &Placement) -> Option<Self> {
        if *placement == Placement::IDENTITY {
            return Some(Self { rows: None, translation: Vec3::ZERO });
        }
        // f64, so that the inverse of a rotation times a scale is right to the last bit but one.
        let linear = DMat3::from_cols(
            placement.linear.x_axis.as_dvec3(),
            placement.linear.y_axis.as_dvec3(),
            placement.linear.z_axis.as_dvec3(),
        );
        let inverse = linear.inverse().transpose();
        let rows = [inverse.x_axis.as_vec3(), inverse.y_axis.as_vec3(), inverse.z_axis.as_vec3()];
        let finite = rows.iter().all(|row| row.is_finite()) && placement.translation.is_finite();
        finite.then_some(Self { rows: Some(rows), translation: placement.translation })
    }

    /// The ray in object space. The direction is not normalised, so `t` stays the same parameter.
    pub fn ray(&self, ray: &Ray) -> Ray {
        let Some(rows) = &self.rows else { return *ray };
        let map = |v: Vec3| Vec3::from(rows.map(|row| (row.x * v.x + row.y * v.y) + row.z * v.z));
        Ray { origin: map(ray.origin - self.translation), direction: map(ray.direction), ..*ray }
    }
}

impl Geometry {
    /// The nearest `t` and primitive index at which a world ray meets an analytic shape; `None` for an instance.
    pub(crate) fn intersect(&self, ray: &Ray) -> Option<(f32, u32)> {
        match self {
            Self::Sphere { center, radius } => sphere::intersect(*center, *radius, ray).map(|t| (t, 0)),
            Self::Cuboid(cuboid) => cuboid::intersect(cuboid, ray),
            Self::Plane { point, normal, bounds } => {
                plane::intersect(*point, *normal, bounds.as_ref(), ray).map(|t| (t, 0))
            }
            Self::Instance { .. } | Self::Hidden => None,
        }
    }

    /// The box around the object in world space: `None` when it is unbounded, empty when it cannot be hit.
    pub fn bounds(&self) -> Option<Bounds> {
        let bounds = match self {
            Self::Sphere { center, radius } if *radius > 0.0 => {
                Bounds { min: *center - Vec3::splat(*radius), max: *center + Vec3::splat(*radius) }
            }
            Self::Cuboid(cuboid) => {
                let local = Bounds { min: -cuboid.half_size, max: cuboid.half_size };
                let turn = cuboid.rotation.unwrap_or(Mat3::IDENTITY);
                Bounds::of_points(local.corners().map(|corner| cuboid.center + turn * corner))
            }
            Self::Plane { bounds: None, .. } => return None,
            Self::Plane { point, bounds: Some(r), .. } => {
                let (u, v) = (r.axis_u * r.half_u, r.axis_v * r.half_v);
                Bounds::of_points([u + v, u - v, -u + v, -u - v].map(|corner| *point + corner))
            }
            Self::Instance { tree, world_from_object } if !tree.bounds().is_empty() => {
                Bounds::of_points(tree.bounds().corners().map(|corner| world_from_object.point(corner)))
            }
            Self::Sphere { .. } | Self::Instance { .. } | Self::Hidden => return Some(Bounds::EMPTY),
        };
        if !bounds.is_finite() {
            return Some(Bounds::EMPTY);
        }
        // The corners were rounded, and so are rays taken into object space: a few units in the last place more.
        let pad = bounds.min.abs().max(bounds.max.abs()) * (8.0 * f32::EPSILON);
        Some(Bounds { min: bounds.min - pad, max: bounds.max + pad })
    }
}
