//! Building trees: a binary tree by the surface area heuristic, then wide nodes from it.

mod binary;
mod leaves;
mod widen;

pub(crate) use binary::{Item, binary_tree, corners};
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
    [low.x, low.y, low.z, f32::from_bits(index), high.x, high.y, high.z, 0.0]
}

/// The largest coordinate of any box, by size.
pub(crate) fn reach(items: &[Item]) -> f32 {
    let sides = items.iter().flat_map(|item| [0, 1, 2, 4, 5, 6].map(|k| item[k].abs()));
    sides.fold(0.0, f32::max)
}
