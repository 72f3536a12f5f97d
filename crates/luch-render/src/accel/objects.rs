//! The objects of a scene as the kernels see them.

use super::build::{Item, LeafMaker, binary_tree, corners, index, level, pack, reach, widen};
use super::geometry::{Geometry, ObjectFromWorld};
use super::group::{Found, Group};
use super::lanes::{Wide, at_level};
use super::nodes::{Link, Tree};
use crate::math::bounds::Bounds;
use std::sync::Arc;

/// One object.
#[derive(Clone, Debug)]
pub(crate) enum Object {
    /// A mesh, and the way into its space.
    Instance { tree: Arc<Tree>, inverse: ObjectFromWorld },
    /// Anything that [`Geometry::intersect`] can meet.
    Shape(Geometry),
}

/// All objects, and the tree over those that go into it.
#[derive(Debug)]
pub(crate) struct Objects {
    /// By object index.
    pub(crate) list: Vec<Object>,
    /// Over instances, and over the bounded shapes when they are many.
    pub(crate) tree: Tree,
    /// The boxes of the objects, lower and upper corner.
    pub(crate) bounds: Vec<[[f32; 3]; 2]>,
    /// Shapes outside the tree, tested for every ray: unbounded ones, and all shapes when they are few.
    pub(crate) always: Vec<u32>,
    /// Entries of a ray's stack that suffice for the scene and any instance in it.
    pub(crate) stack_capacity: usize,
}

/// Up to this many shapes are tested one after the other: each test takes a whole vector of rays.
const FEW: usize = 8;

impl Objects {
    pub(crate) fn new(geometry: &[Geometry]) -> Self {
        let list: Vec<_> = geometry.iter().map(object).collect();
        let is_shape = |k: &usize| matches!(list[*k], Object::Shape(_));
        let bounds: Vec<_> = geometry.iter().map(Geometry::bounds).collect();
        let bounded: Vec<_> = (0..list.len()).filter(|&k| bounds[k].is_some_and(|b| !b.is_empty())).collect();
        let few = bounded.iter().filter(|k| is_shape(k)).count() <= FEW;
        let in_tree = |k: &usize| !(few && is_shape(k));
        let mut always: Vec<_> = (0..list.len()).filter(|&k| bounds[k].is_none()).map(|k| k as u32).collect();
        always.extend(bounded.iter().filter(|k| !in_tree(k)).map(|&k| k as u32));

        let items: Vec<Item> =
            bounded.iter().filter(|k| in_tree(k)).filter_map(|&k| Some(pack(&bounds[k]?, k as u32))).collect();
        let tree = tree_of(items);
        let deepest = list.iter().map(|object| match object {
            Object::Instance { tree, .. } => tree.stack_capacity(),
            Object::Shape(_) => 0,
        });
        let stack_capacity = tree.stack_capacity() + deepest.max().unwrap_or(0);
        let bounds = bounds.iter().map(|b| b.unwrap_or(Bounds::EMPTY)).map(|b| [b.min.to_array(), b.max.to_array()]);
        Self { list, tree, bounds: bounds.collect(), always, stack_capacity }
    }
}

impl Objects {
    /// Meets the shapes outside the tree.
    #[inline(always)]
    pub(crate) fn meet_always<S: Wide>(&self, simd: S, world: &Group, found: &mut Found) {
        for &index in &self.always {
            if let Object::Shape(shape) = &self.list[index as usize] {
                shape.meet(simd, world, found, index, 0xffff);
            }
        }
    }
}

fn object(geometry: &Geometry) -> Object {
    match geometry {
        Geometry::Instance { tree, world_from_object } => match ObjectFromWorld::new(world_from_object) {
            Some(inverse) => Object::Instance { tree: tree.shared(), inverse },
            None => Object::Shape(Geometry::Hidden),
        },
        shape => Object::Shape(shape.clone()),
    }
}

/// A leaf per object.
struct OneEach;

impl LeafMaker for OneEach {
    type Leaf = u32;
    const MOST: usize = 1;

    fn make(&self, items: &[Item]) -> Option<u32> {
        items.first().map(index)
    }
}

fn tree_of(items: Vec<Item>) -> Tree {
    let mut tree = Tree::default();
    if items.is_empty() {
        return tree;
    }
    let binary = at_level!(level(), simd => binary_tree(simd, items, &OneEach, 1));
    tree.bounds = corners(&binary.nodes[0].bounds);
    tree.reach = reach(&tree.bounds);
    let (root, depth) = widen(&binary.nodes, |leaf| Link::object(binary.leaves[leaf as usize]), &mut tree.nodes);
    (tree.root, tree.depth) = (Some(root), depth);
    tree
}
