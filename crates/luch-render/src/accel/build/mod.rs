//! Building trees: a binary tree by the surface area heuristic, then wide nodes from it.

mod binary;
mod leaves;
mod widen;

pub(crate) use binary::{Item, binary_tree, corners, index, tagged};
pub(crate) use leaves::Patches;
pub(crate) use widen::widen;

use crate::math::bounds::Bounds;
use fearless_simd::Level;

/// What becomes of the items where the binary tree ends.
pub(crate) trait LeafMaker: Sync {
    /// What a leaf is made of.
    type Leaf: Send;
    /// Most items a leaf can have.
    const MOST: usize;

    /// How many items, by guess, a leaf can have: to split off fewer saves nothing.
    fn grain(&self) -> u32 {
        1
    }

    /// The leaf of these items, or `None` if they do not fit one and must be split.
    fn make(&self, items: &[Item]) -> Option<Self::Leaf>;
}

/// The level builders run at; trees do not depend on it.
pub(crate) fn level() -> Level {
    Level::new()
}

/// A box and an index as the builder wants them.
pub(crate) fn pack(bounds: &Bounds, index: u32) -> Item {
    let (low, high) = (-bounds.min, bounds.max);
    [low.x, low.y, low.z, tagged(index), high.x, high.y, high.z, 0.0]
}

/// The largest coordinate of a box, by size.
pub(crate) fn reach(bounds: &[[f32; 3]; 2]) -> f32 {
    bounds.iter().flatten().fold(0.0, |reach, x| x.abs().max(reach))
}
