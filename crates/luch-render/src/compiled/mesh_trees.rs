//! The trees of meshes, kept across edits of the scene.

use super::shading_mesh::ShadingMesh;
use crate::accel::MeshTree;
use luch_scene::{Mesh, MeshId, Scene, Shape};
use std::collections::{HashMap, HashSet};
use std::sync::{Arc, Weak};

/// One tree for each mesh that was compiled so far. A mesh never changes, so its tree never does.
#[derive(Debug, Default)]
pub struct MeshTrees {
    trees: HashMap<MeshId, (Weak<Mesh>, CompiledMesh)>,
}

/// A mesh made ready for rays and for shading.
#[derive(Debug, Clone)]
pub(crate) struct CompiledMesh {
    pub(crate) tree: Arc<MeshTree>,
    pub(crate) shading: Arc<ShadingMesh>,
}

impl MeshTrees {
    /// No trees yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The tree and layout of a mesh, built now if they are not known yet.
    pub(crate) fn of(&mut self, mesh: &Arc<Mesh>, threads: usize) -> CompiledMesh {
        let build = || {
            let tree = Arc::new(MeshTree::build(mesh.positions(), mesh.triangles(), threads));
            (Arc::downgrade(mesh), CompiledMesh { tree, shading: Arc::new(ShadingMesh::new(mesh)) })
        };
        self.trees.entry(mesh.id()).or_insert_with(build).1.clone()
    }

    /// Forgets the trees of meshes that nobody holds any more: no scene can ask for them again.
    pub fn keep_living(&mut self) {
        self.trees.retain(|_, (mesh, _)| mesh.strong_count() > 0);
    }

    /// Forgets the trees of meshes that the scene does not use.
    pub fn keep_only(&mut self, scene: &Scene) {
        let used: HashSet<MeshId> = scene
            .objects
            .iter()
            .filter_map(|object| match &object.shape {
                Shape::Mesh(instance) => Some(instance.mesh.id()),
                _ => None,
            })
            .collect();
        self.trees.retain(|id, _| used.contains(id));
    }

    /// How many trees there are.
    #[must_use]
    pub fn len(&self) -> usize {
        self.trees.len()
    }

    /// Whether there are none.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.trees.is_empty()
    }
}
