//! The trees of meshes, kept across edits of the scene.

use crate::accel::MeshTree;
use luch_scene::{Mesh, MeshId, Scene, Shape};
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// One tree for each mesh that was compiled so far. A mesh never changes, so its tree never does.
#[derive(Debug, Default)]
pub struct MeshTrees {
    trees: HashMap<MeshId, Arc<MeshTree>>,
}

impl MeshTrees {
    /// No trees yet.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// The tree of a mesh, built now if it is not known yet.
    pub(crate) fn tree_of(&mut self, mesh: &Mesh, threads: usize) -> Arc<MeshTree> {
        let build = || Arc::new(MeshTree::build(mesh.positions(), mesh.triangles(), threads));
        Arc::clone(self.trees.entry(mesh.id()).or_insert_with(build))
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
