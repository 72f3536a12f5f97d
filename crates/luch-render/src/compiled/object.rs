//! Objects made ready for rays: the geometry that the tree wants, and what shading wants to know of a hit.

use super::mesh_trees::CompiledMesh;
use super::shading_mesh::ShadingMesh;
use crate::accel::{Geometry, Placement};
use crate::shape::cuboid::Cuboid;
use crate::shape::plane::Rectangle;
use glam::{Mat3, Vec3};
use luch_scene::{Material, Mesh, MeshInstance, Object, Shading, Shape, Unit};
use std::sync::Arc;

/// What shading wants to know of an object.
#[derive(Debug)]
pub(crate) struct CompiledObject {
    pub(crate) surface: Surface,
    /// The look of the object, or of each material of its mesh.
    pub(crate) looks: Vec<Look>,
    /// Mirror share, 0 to 1.
    pub(crate) reflection: f32,
    pub(crate) checker: Option<CompiledChecker>,
    pub(crate) shading: Shading,
}

/// The geometry behind a hit.
#[derive(Debug)]
pub(crate) enum Surface {
    Sphere {
        center: Vec3,
        radius: f32,
    },
    Cuboid {
        center: Vec3,
        half_size: Vec3,
        axes: Mat3,
    },
    Plane {
        point: Vec3,
        normal: Vec3,
    },
    Mesh {
        mesh: Arc<Mesh>,
        layout: Arc<ShadingMesh>,
        placement: Placement,
        rotation: Mat3,
    },
    /// A hidden object: no ray hits it.
    Nothing,
}

/// Colour and highlight of a surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Look {
    /// What `highlight` and `exponent` come from.
    pub(crate) gloss: f32,
    /// k_d and k_a.
    pub(crate) base: Vec3,
    /// k_s.
    pub(crate) highlight: f32,
    /// n.
    pub(crate) exponent: f32,
}

/// Squares of a second colour: `rows * (p - origin)` counts in squares.
#[derive(Debug, Clone, Copy)]
pub(crate) struct CompiledChecker {
    pub(crate) origin: Vec3,
    pub(crate) rows: [Vec3; 3],
    pub(crate) color: Vec3,
    /// How far below the surface the pattern is looked up, so that a face that lies on a border has one colour.
    pub(crate) inset: f32,
}

/// `k_s` of a gloss: the gloss itself.
#[must_use]
pub fn highlight_strength(gloss: Unit) -> f32 {
    gloss.get()
}

/// `n` of a gloss: `2^(2 + 6 gloss)`, from 4 (a wide sheen) to 256 (a tight spot); 0.6 gives 48.5.
#[must_use]
pub fn highlight_exponent(gloss: Unit) -> f32 {
    libm::exp2f(2.0 + 6.0 * gloss.get())
}

impl CompiledObject {
    /// `mesh` is the object's mesh, if it shows one.
    pub(crate) fn of(object: &Object, mesh: Option<&CompiledMesh>, scene_shading: Shading) -> Self {
        let material = &object.material;
        let surface = surface_of(&object.shape, mesh);
        Self {
            looks: looks_of(object),
            reflection: material.reflection.get(),
            checker: material.checker.map(|checker| {
                let size = checker.size.get();
                let (origin, rows, inset) = checker_frame(&object.shape);
                CompiledChecker {
                    origin,
                    rows: rows.map(|row| row / size),
                    color: checker.color.get(),
                    inset: inset * size,
                }
            }),
            shading: object.shading.unwrap_or(scene_shading),
            surface,
        }
    }
}

impl CompiledObject {
    /// The look of a triangle or face.
    pub(crate) fn look_of(&self, primitive: u32) -> &Look {
        let index = match &self.surface {
            Surface::Mesh { mesh, .. } => mesh.triangle_materials().get(primitive as usize).copied().unwrap_or(0),
            _ => 0,
        };
        &self.looks[usize::from(index)]
    }
}

fn look(color: Vec3, gloss: Unit) -> Look {
    Look { gloss: gloss.get(), base: color, highlight: highlight_strength(gloss), exponent: highlight_exponent(gloss) }
}

/// One look, or one for each material of the mesh where the object leaves something to the model's file.
fn looks_of(object: &Object) -> Vec<Look> {
    let Material { color, gloss, .. } = object.material;
    if let Shape::Mesh(instance) = &object.shape
        && !instance.mesh.materials().is_empty()
    {
        let of_file = |m: &luch_scene::MeshMaterial| {
            look(color.unwrap_or(m.color).get(), gloss.or(m.gloss).unwrap_or(Unit::ZERO))
        };
        return instance.mesh.materials().iter().map(of_file).collect();
    }
    vec![look(color.unwrap_or(Material::DEFAULT_COLOR).get(), gloss.unwrap_or(Unit::ZERO))]
}

fn placement_of(instance: &MeshInstance) -> (Placement, Mat3) {
    let rotation = instance.rotation.matrix();
    (Placement::new(rotation, instance.scale.get(), instance.position.get()), rotation)
}

fn surface_of(shape: &Shape, mesh: Option<&CompiledMesh>) -> Surface {
    match shape {
        Shape::Sphere { center, radius } => Surface::Sphere { center: center.get(), radius: radius.get() },
        Shape::Cuboid { center, size, rotation } => Surface::Cuboid {
            center: center.get(),
            half_size: Vec3::from_array(size.map(|s| s.get() * 0.5)),
            axes: rotation.matrix(),
        },
        Shape::Wall { point, normal, .. } => Surface::Plane { point: point.get(), normal: normal.unit() },
        Shape::Mesh(instance) => mesh.map_or(Surface::Nothing, |mesh| {
            let (placement, rotation) = placement_of(instance);
            Surface::Mesh { mesh: Arc::clone(&instance.mesh), layout: Arc::clone(&mesh.shading), placement, rotation }
        }),
    }
}

/// Origin and axes of the pattern, and how deep below the surface to look it up, in squares.
fn checker_frame(shape: &Shape) -> (Vec3, [Vec3; 3], f32) {
    const INSET: f32 = 1e-3;
    match shape {
        Shape::Sphere { center, .. } => (center.get(), [Vec3::X, Vec3::Y, Vec3::Z], INSET),
        Shape::Cuboid { center, size, rotation } => {
            let axes = rotation.matrix();
            let half = Vec3::from_array(size.map(|s| s.get() * 0.5));
            (center.get() - axes * half, [axes.x_axis, axes.y_axis, axes.z_axis], INSET)
        }
        // A wall has squares in its plane only, so that rounding across it cannot change the colour.
        Shape::Wall { point, normal, .. } => {
            let [u, v] = Shape::wall_axes(*normal);
            (point.get(), [u, v, Vec3::ZERO], 0.0)
        }
        Shape::Mesh(instance) => {
            let axes = instance.rotation.matrix();
            (instance.position.get(), [axes.x_axis, axes.y_axis, axes.z_axis], INSET)
        }
    }
}

/// The shape as the tree wants it; `mesh` is the object's mesh, if it shows one.
pub(crate) fn geometry_of(object: &Object, mesh: Option<&CompiledMesh>) -> Geometry {
    if object.hidden {
        return Geometry::Hidden;
    }
    match &object.shape {
        Shape::Sphere { center, radius } => Geometry::Sphere { center: center.get(), radius: radius.get() },
        Shape::Cuboid { center, size, rotation } => Geometry::Cuboid(Cuboid {
            center: center.get(),
            half_size: Vec3::from_array(size.map(|s| s.get() * 0.5)),
            rotation: (!rotation.is_none()).then(|| rotation.matrix()),
        }),
        Shape::Wall { point, normal, size } => Geometry::Plane {
            point: point.get(),
            normal: normal.unit(),
            bounds: size.map(|[width, height]| {
                let [axis_u, axis_v] = Shape::wall_axes(*normal);
                Rectangle { axis_u, axis_v, half_u: width.get() * 0.5, half_v: height.get() * 0.5 }
            }),
        },
        Shape::Mesh(instance) => mesh.map_or(Geometry::Hidden, |mesh| Geometry::Instance {
            tree: Arc::clone(&mesh.tree),
            world_from_object: placement_of(instance).0,
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gloss_goes_from_matt_to_a_tight_spot() {
        assert_eq!(highlight_strength(Unit::ZERO), 0.0);
        assert_eq!((highlight_strength(Unit::ONE), highlight_exponent(Unit::ONE)), (1.0, 256.0));
        assert_eq!(highlight_exponent(Unit::ZERO), 4.0);
        let gloss = Unit::new(0.6).unwrap();
        assert!((highlight_exponent(gloss) - 48.5).abs() < 0.03);
    }
}
