//! A scene made ready for rays: immutable, shared between threads, built from a [`Scene`] in one step.

mod mesh_trees;
mod object;
mod shading_mesh;

pub use mesh_trees::MeshTrees;
pub(crate) use object::{CompiledChecker, CompiledObject, Look, Surface};
pub use object::{highlight_exponent, highlight_strength};

use crate::accel::SceneTree;
use crate::math::bounds::Bounds;
use glam::Vec3;
use luch_scene::{Object, Scene, Shape};
use std::sync::Arc;

/// A light, ready for the lighting sum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct CompiledLight {
    /// Place of the light in the scene's list.
    pub(crate) index: u32,
    pub(crate) position: Vec3,
    pub(crate) intensity: f32,
    pub(crate) color: Vec3,
}

/// A scene ready for rays. Objects keep the place that they have in the [`Scene`]: a hit's object is that number.
#[derive(Debug)]
pub struct CompiledScene {
    pub(crate) tree: Arc<SceneTree>,
    pub(crate) objects: Vec<CompiledObject>,
    pub(crate) lights: Vec<CompiledLight>,
    pub(crate) background: Vec3,
    pub(crate) ambient: f32,
    pub(crate) attenuation: f32,
    tree_bytes: usize,
    triangles: u64,
}

impl CompiledScene {
    /// The box around all bounded objects; empty if there are none.
    #[must_use]
    pub fn bounds(&self) -> Bounds {
        self.tree.bounds()
    }

    /// Bytes of the trees and shading layouts of all meshes in use, each counted once.
    #[must_use]
    pub const fn tree_bytes(&self) -> usize {
        self.tree_bytes
    }

    /// Triangles of all visible objects, shared meshes counted once for each object.
    #[must_use]
    pub const fn triangles(&self) -> u64 {
        self.triangles
    }
}

/// Makes a scene ready for rays.
///
/// Trees of meshes come from `trees` and are built, with `threads` threads, only for meshes it does not know yet: after
/// an edit that moves or recolours objects this takes well under a millisecond.
#[must_use]
pub fn compile(scene: &Scene, trees: &mut MeshTrees, threads: usize) -> CompiledScene {
    compile_after(None, scene, trees, threads)
}

/// As [`compile`], after another scene: where only looks have changed since, the tree over the objects is shared.
pub(crate) fn compile_after(
    before: Option<(&Scene, &CompiledScene)>,
    scene: &Scene,
    trees: &mut MeshTrees,
    threads: usize,
) -> CompiledScene {
    let known = before.filter(|(old, _)| have_same_shapes(old, scene)).map(|(_, compiled)| Arc::clone(&compiled.tree));
    let mut tree_bytes = 0;
    let mut counted = std::collections::HashSet::new();
    let mut geometry = Vec::new();
    let mut objects = Vec::with_capacity(scene.objects.len());
    for object in &scene.objects {
        let mesh = match &object.shape {
            Shape::Mesh(instance) if !object.hidden => Some((instance.mesh.id(), trees.of(&instance.mesh, threads))),
            _ => None,
        };
        if let Some((id, mesh)) = &mesh
            && counted.insert(*id)
        {
            tree_bytes += mesh.tree.memory_bytes() + mesh.shading.memory_bytes();
        }
        let mesh = mesh.map(|(_, mesh)| mesh);
        if known.is_none() {
            geometry.push(object::geometry_of(object, mesh.as_ref()));
        }
        objects.push(CompiledObject::of(object, mesh.as_ref(), scene.settings.shading));
    }
    CompiledScene {
        tree: known.unwrap_or_else(|| Arc::new(SceneTree::build(&geometry))),
        objects,
        lights: lights_of(scene),
        background: scene.background.get(),
        ambient: scene.ambient.get(),
        attenuation: scene.attenuation.get(),
        tree_bytes,
        triangles: scene.triangle_count(),
    }
}

/// Whether rays meet the same objects in both scenes, whatever they look like. Meshes are compared by identity.
pub(crate) fn have_same_shapes(a: &Scene, b: &Scene) -> bool {
    let same = |(a, b): (&Object, &Object)| a.hidden == b.hidden && (a.hidden || a.shape == b.shape);
    std::ptr::eq(a, b) || (a.objects.len() == b.objects.len() && a.objects.iter().zip(&b.objects).all(same))
}

/// The lights that are on, in the scene's order.
fn lights_of(scene: &Scene) -> Vec<CompiledLight> {
    let on = scene.lights.iter().zip(0_u32..).filter(|(light, _)| !light.hidden);
    on.map(|(light, index)| CompiledLight {
        index,
        position: light.position.get(),
        intensity: light.intensity.get(),
        color: light.color.get(),
    })
    .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::{Color, Light, Point, Size};

    #[test]
    fn a_change_of_looks_keeps_the_tree_and_a_change_of_shapes_does_not() {
        let mut trees = MeshTrees::new();
        let mut scene = Scene::new("Two balls");
        for (name, x) in [("Left", -2.0), ("Right", 2.0)] {
            let center = Point::clamped([x, 0.0, 0.0].into());
            scene.objects.push(Object::new(name, Shape::Sphere { center, radius: Size::ONE }));
        }
        let compiled = compile(&scene, &mut trees, 1);
        let mut keeps = |change: &dyn Fn(&mut Scene)| {
            let mut changed = scene.clone();
            change(&mut changed);
            let again = compile_after(Some((&scene, &compiled)), &changed, &mut trees, 1);
            assert_eq!(again.objects.len(), changed.objects.len());
            Arc::ptr_eq(&again.tree, &compiled.tree)
        };
        assert!(keeps(&|_| ()));
        assert!(keeps(&|scene| scene.objects[1].material.color = Color::from_hex("#ff0000")));
        assert!(keeps(&|scene| scene.lights.push(Light::new("Lamp", Point::ORIGIN))));
        assert!(!keeps(&|scene| scene.objects[1].hidden = true));
        assert!(!keeps(&|scene| scene.objects.swap(0, 1)));
        assert!(!keeps(&|scene| drop(scene.objects.pop())));
        let unit = Shape::Sphere { center: Point::ORIGIN, radius: Size::ONE };
        assert!(!keeps(&|scene| scene.objects[0].shape = unit.clone()));
    }
}
