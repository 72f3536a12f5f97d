//! The binary tree: top-down, binned surface area heuristic (Wald, "On fast Construction of SAH-based Bounding Volume
//! Hierarchies", 2007), over subtrees in parallel. It depends on the items alone, not on the number of threads.

use super::LeafMaker;
use crate::accel::lanes::Wide;
use fearless_simd::prelude::*;
use fearless_simd::{f32x4, f32x8, i32x4, mask32x8, u32x4};
use std::sync::atomic::{AtomicIsize, Ordering};
use std::thread;

/// A box and an index: `-min`, [`tagged`] index, `max`, 0. With the lower corner negated, the union of two boxes is one
/// vector maximum.
pub(crate) type Item = [f32; 8];

/// An index as a float that arithmetic may pass over: small indices would be denormal numbers, which some machines
/// treat slowly. Below a billion it is finite.
pub(crate) const fn tagged(index: u32) -> f32 {
    f32::from_bits(index + TAG)
}

/// The index of an item.
pub(crate) const fn index(item: &Item) -> u32 {
    item[3].to_bits().wrapping_sub(TAG)
}

const TAG: u32 = 1 << 30;

/// A box as in [`Item`].
pub(crate) type Packed = [f32; 8];

/// [`Binary::axis`] of a leaf.
pub(crate) const LEAF: u8 = 3;
const BINS: usize = 16;
/// Below this many items another thread is not worth its start.
const WORTH_A_THREAD: usize = 4096;
/// Deeper than this, items are halved by count, whatever it costs: no input makes the tree deeper than this plus 32.
const DEEPEST_BY_COST: usize = 40;
/// The box that grows to whatever is added.
pub(crate) const NOTHING: Packed = [f32::NEG_INFINITY; 8];

/// The lower and the upper corner.
pub(crate) fn corners(bounds: &Packed) -> [[f32; 3]; 2] {
    [[0, 1, 2].map(|axis| -bounds[axis]), [0, 1, 2].map(|axis| bounds[4 + axis])]
}

/// A node of the binary tree.
#[derive(Clone, Debug)]
pub(crate) struct Binary {
    pub(crate) bounds: Packed,
    /// Left and right child; of a leaf its index, twice.
    pub(crate) child: [u32; 2],
    /// The axis of the split, the left child below; 3 for a leaf.
    pub(crate) axis: u8,
}

/// A binary tree, its root first, and its leaves.
#[derive(Debug)]
pub(crate) struct BinaryTree<L> {
    pub(crate) nodes: Vec<Binary>,
    pub(crate) leaves: Vec<L>,
}

impl<L> BinaryTree<L> {
    /// Room for half again as many leaves as there must be: to grow the arrays by copying is a tenth of a build.
    fn with_room_for(least: usize) -> Self {
        let leaves = least + least / 2 + 1;
        Self { nodes: Vec::with_capacity(2 * leaves), leaves: Vec::with_capacity(leaves) }
    }
}

/// Builds the tree of at least one item.
pub(crate) fn binary_tree<S: Wide, M: LeafMaker>(
    simd: S,
    mut items: Vec<Item>,
    maker: &M,
    threads: usize,
) -> BinaryTree<M::Leaf> {
    let mut spare = vec![[0.0; 8]; items.len()];
    let node = simd.vectorize(
        #[inline(always)]
        || range_of(simd, &items, 0),
    );
    let mut tree = BinaryTree::with_room_for(items.len() / M::MOST);
    let crew = Crew { maker, idle: AtomicIsize::new(threads.saturating_sub(1).cast_signed()) };
    grow(simd, &mut items, &mut spare, &node, &crew, &mut tree);
    tree
}

/// What all threads of a build share.
struct Crew<'a, M> {
    maker: &'a M,
    /// Threads that may still be started; below 0 when one that waited goes on after another took its place.
    idle: AtomicIsize,
}

impl<M> Crew<'_, M> {
    /// Takes a thread if there is one.
    fn hire(&self) -> bool {
        let one_less = |idle: isize| (idle > 0).then(|| idle - 1);
        self.idle.fetch_update(Ordering::Relaxed, Ordering::Relaxed, one_less).is_ok()
    }

    fn dismiss(&self) {
        self.idle.fetch_add(1, Ordering::Relaxed);
    }
}

/// A range of items about to become a subtree: its box, and the box of its (doubled) centres.
struct Range {
    bounds: Packed,
    centers: Packed,
    depth: usize,
}

/// Adds `part` behind what is there.
fn append<L>(tree: &mut BinaryTree<L>, part: BinaryTree<L>) {
    let (first_node, first_leaf) = (tree.nodes.len() as u32, tree.leaves.len() as u32);
    tree.nodes.extend(part.nodes.into_iter().map(|mut node| {
        let first = if node.axis == LEAF { first_leaf } else { first_node };
        node.child = node.child.map(|child| child + first);
        node
    }));
    tree.leaves.extend(part.leaves);
}

/// Adds the subtree of a range. Whenever a large one is split and a thread is free, that thread takes the right part.
fn grow<S: Wide, M: LeafMaker>(
    simd: S,
    items: &mut [Item],
    spare: &mut [Item],
    range: &Range,
    crew: &Crew<'_, M>,
    tree: &mut BinaryTree<M::Leaf>,
) {
    let here = tree.nodes.len();
    if items.len() <= M::MOST
        && let Some(leaf) = crew.maker.make(items)
    {
        tree.nodes.push(Binary { bounds: range.bounds, child: [tree.leaves.len() as u32; 2], axis: LEAF });
        tree.leaves.push(leaf);
        return;
    }
    let split = simd.vectorize(
        #[inline(always)]
        || split(simd, items, spare, range, crew.maker.grain()),
    );
    // The items now lie in `spare`.
    tree.nodes.push(Binary { bounds: range.bounds, child: [here as u32 + 1; 2], axis: split.axis });
    let [left_range, right_range] = &split.children;
    let (left, right) = spare.split_at_mut(split.middle);
    let (left_spare, right_spare) = items.split_at_mut(split.middle);
    if left.len() + right.len() > WORTH_A_THREAD && crew.hire() {
        let right_tree = thread::scope(|scope| {
            let right_tree = thread::Builder::new()
                .name("luch build".into())
                .spawn_scoped(scope, || {
                    let mut part = BinaryTree::with_room_for(right.len() / M::MOST);
                    grow(simd, right, right_spare, right_range, crew, &mut part);
                    crew.dismiss();
                    part
                })
                .expect("the system gives a thread to whoever may use several");
            grow(simd, left, left_spare, left_range, crew, tree);
            // This thread waits now: another may run in its place.
            crew.dismiss();
            let part = right_tree.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            crew.idle.fetch_sub(1, Ordering::Relaxed);
            part
        });
        tree.nodes[here].child[1] = tree.nodes.len() as u32;
        append(tree, right_tree);
    } else {
        grow(simd, left, left_spare, left_range, crew, tree);
        tree.nodes[here].child[1] = tree.nodes.len() as u32;
        grow(simd, right, right_spare, right_range, crew, tree);
    }
}

/// Where a range was cut: how many items lie left, and both parts.
struct Split {
    axis: u8,
    middle: usize,
    children: [Range; 2],
}

/// Moves the items of a range to `to`, those left of the best cut first.
#[inline(always)]
fn split<S: Wide>(simd: S, items: &mut [Item], to: &mut [Item], range: &Range, grain: u32) -> Split {
    let (low, high) = f32x8::load_array_ref(simd, &range.centers).split();
    let low = -low;
    let extent = high - low;
    let sides: [f32; 4] = extent.into();
    let usable = |axis: usize| sides[axis] > 0.0 && sides[axis].is_finite();
    if range.depth >= DEEPEST_BY_COST || !(0..3).any(usable) {
        return halve(simd, items, to, range);
    }
    let scale = f32x4::from_fn(simd, |lane| if lane < 3 && usable(lane) { 15.999 / sides[lane] } else { 0.0 });
    let bin = |item: f32x8<S>| -> [u32; 4] {
        let (negative_min, max) = item.split();
        (((max - negative_min) - low) * scale).to_int::<i32x4<S>>().bitcast::<u32x4<S>>().into()
    };

    // Sort the items into bins.
    let mut bins = [[NOTHING; BINS]; 3];
    let mut counts = [[0_u32; BINS]; 3];
    for item in items.iter() {
        let item = f32x8::load_array_ref(simd, item);
        let at = bin(item);
        for axis in 0..3 {
            let k = at[axis] as usize & (BINS - 1);
            f32x8::load_array_ref(simd, &bins[axis][k]).max(item).store_array(&mut bins[axis][k]);
            counts[axis][k] += 1;
        }
    }

    // Find the cheapest cut.
    let mut best = (f32::INFINITY, 0, 0, NOTHING, NOTHING);
    for axis in (0..3).filter(|&axis| usable(axis)) {
        let mut after = [(NOTHING, 0.0); BINS];
        let (mut bounds, mut count) = (f32x8::splat(simd, f32::NEG_INFINITY), 0);
        for k in (1..BINS).rev() {
            bounds = bounds.max(f32x8::load_array_ref(simd, &bins[axis][k]));
            count += counts[axis][k];
            let packed: Packed = bounds.into();
            after[k] = (packed, if count > 0 { half_area(&packed) * cost(count, grain) } else { f32::NAN });
        }
        let (mut bounds, mut count) = (f32x8::splat(simd, f32::NEG_INFINITY), 0);
        for k in 1..BINS {
            bounds = bounds.max(f32x8::load_array_ref(simd, &bins[axis][k - 1]));
            count += counts[axis][k - 1];
            let packed: Packed = bounds.into();
            // A cut with nothing on its right costs NaN, which is below nothing.
            let total = half_area(&packed) * cost(count, grain) + after[k].1;
            if count > 0 && total < best.0 {
                best = (total, axis, k, packed, after[k].0);
            }
        }
    }
    let (total, axis, cut, left_bounds, right_bounds) = best;
    if total == f32::INFINITY {
        return halve(simd, items, to, range);
    }

    // Deal the items to both sides; every item is written to both, and counts on one: no branch to mispredict.
    let nothing = f32x8::splat(simd, f32::NEG_INFINITY);
    let mut centers = [nothing; 2];
    let (mut left, mut right) = (0, items.len());
    let (low, scale) = (low[axis], scale[axis]);
    for item in items.iter() {
        to[left] = *item;
        to[right - 1] = *item;
        // The arithmetic of `bin`, for one axis.
        let bin = (((item[4 + axis] - item[axis]) - low) * scale) as i32 as usize & (BINS - 1);
        let is_left = bin < cut;
        let item = f32x8::load_array_ref(simd, item);
        let (side, point) = (mask32x8::splat(simd, is_left), center(item));
        centers = [centers[0].max(side.select(point, nothing)), centers[1].max(side.select(nothing, point))];
        left += usize::from(is_left);
        right -= usize::from(!is_left);
    }
    let depth = range.depth + 1;
    let [left_centers, right_centers] = centers.map(Packed::from);
    Split {
        axis: axis as u8,
        middle: left,
        children: [
            Range { bounds: left_bounds, centers: left_centers, depth },
            Range { bounds: right_bounds, centers: right_centers, depth },
        ],
    }
}

/// Two halves of equal count along the widest axis: where cost finds nothing to tell the items apart.
#[inline(always)]
fn halve<S: Wide>(simd: S, items: &mut [Item], to: &mut [Item], range: &Range) -> Split {
    let side = |axis: usize| range.centers[4 + axis] + range.centers[axis];
    let axis = (1..3).fold(0, |best, axis| if side(axis) > side(best) { axis } else { best });
    let middle = items.len() / 2;
    items.select_nth_unstable_by(middle, |a, b| (a[4 + axis] - a[axis]).total_cmp(&(b[4 + axis] - b[axis])));
    to.copy_from_slice(items);
    let (left, right) = items.split_at(middle);
    let depth = range.depth + 1;
    Split { axis: axis as u8, middle, children: [range_of(simd, left, depth), range_of(simd, right, depth)] }
}

/// The range that these items are.
#[inline(always)]
fn range_of<S: Wide>(simd: S, items: &[Item], depth: usize) -> Range {
    let nothing = f32x8::splat(simd, f32::NEG_INFINITY);
    let (mut bounds, mut centers) = (nothing, nothing);
    for item in items {
        let item = f32x8::load_array_ref(simd, item);
        bounds = bounds.max(item);
        centers = centers.max(center(item));
    }
    Range { bounds: bounds.into(), centers: centers.into(), depth }
}

/// Twice the centre of a box, as a box.
#[inline(always)]
fn center<S: Wide>(item: f32x8<S>) -> f32x8<S> {
    let (negative_min, max) = item.split();
    let sum = max - negative_min;
    (-sum).combine(sum)
}

/// Half the surface of a box.
#[inline(always)]
pub(crate) fn half_area(bounds: &Packed) -> f32 {
    let [x, y, z] = [0, 1, 2].map(|axis| bounds[axis] + bounds[4 + axis]);
    x * y + y * z + z * x
}

/// What it costs to test this many items, in any unit.
#[inline(always)]
fn cost(count: u32, grain: u32) -> f32 {
    // Rounding up for well-shared meshes too was tried: leaves fuller by a twentieth, rays slower by as much.
    if grain == 1 { count as f32 } else { count.div_ceil(grain) as f32 }
}
