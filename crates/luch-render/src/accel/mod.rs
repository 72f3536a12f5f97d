//! Acceleration structures and the ray queries over them.
//!
//! A [`MeshTree`] holds the triangles of one mesh and is built once per mesh. A [`SceneTree`] holds the objects of a
//! scene, instances of mesh trees among them, and is cheap enough to build again after every edit. Queries take batches.
//!
//! The nearest hit is the one with the smallest `t`, ties going to the smaller (object, primitive): never to whichever
//! the traversal met first. So the result has the same bits at every SIMD level, batch size, thread and coherence hint.

mod build;
mod bundle;
mod geometry;
mod group;
mod jobs;
mod lanes;
mod leaf_test;
mod mesh_tree;
mod nodes;
mod objects;
mod packet;
mod scene_tree;
mod shapes;
mod single;
mod slabs;
pub(crate) mod walk;

pub use fearless_simd::Level;
pub use geometry::{Geometry, ObjectFromWorld, Placement};
pub use mesh_tree::{MeshStatistics, MeshTree};
pub use scene_tree::{CostBatch, SceneTree};
pub use walk::Query;

/// The SIMD levels this machine can run, slowest first, each with the name the command line uses.
///
/// `scalar` is what every machine of the target has without asking (SSE2 on x86-64, NEON on 64-bit ARM). The library's
/// own emulation of 16 lanes by arrays is not compiled: it made the build of this crate ten times slower.
pub fn available_levels() -> Vec<(&'static str, Level)> {
    use crate::simd::SimdLevel;
    SimdLevel::available().into_iter().filter_map(|level| Some((level.word(), level.level()?))).collect()
}
