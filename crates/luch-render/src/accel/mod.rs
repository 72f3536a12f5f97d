//! Acceleration structures and the ray queries over them.
//!
//! A [`MeshTree`] holds the triangles of one mesh and is built once per mesh. A [`SceneTree`] holds the objects of a
//! scene, instances of mesh trees among them, and is cheap enough to build again after every edit. Queries take batches.
//!
//! The nearest hit is the one with the smallest `t`, ties going to the smaller (object, primitive): never to whichever
//! the traversal met first. So the result has the same bits at every SIMD level, batch size, thread and coherence hint.

mod build;
mod geometry;
mod lanes;
mod leaf_test;
mod mesh_tree;
mod nodes;
mod objects;
mod scene_tree;
mod single;
mod slabs;

pub use fearless_simd::Level;
pub use geometry::{Geometry, ObjectFromWorld, Placement};
pub use mesh_tree::{MeshStatistics, MeshTree};
pub use scene_tree::{CostBatch, SceneTree};

/// The SIMD levels this machine can run, slowest first, each with the name the command line uses.
pub fn available_levels() -> Vec<(&'static str, Level)> {
    let best = Level::new();
    let mut levels = vec![("scalar", Level::fallback())];
    #[cfg(target_arch = "x86_64")]
    levels.extend(
        [
            ("sse2", best.as_sse2().map(Level::Sse2)),
            ("sse4.2", best.as_sse4_2().map(Level::Sse4_2)),
            ("avx2", best.as_avx2().map(Level::Avx2)),
            ("avx512", best.as_avx512().map(Level::Avx512)),
        ]
        .into_iter()
        .filter_map(|(name, level)| Some((name, level?))),
    );
    #[cfg(target_arch = "aarch64")]
    levels.extend(best.as_neon().map(|neon| ("neon", Level::Neon(neon))));
    levels
}
