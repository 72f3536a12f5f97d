//! The memory of a tree: wide nodes, and leaves that share vertices.

use super::lanes::Nibbles;

/// Children per node, and triangles and vertices per leaf: the lanes of the widest vector.
pub(crate) const WIDTH: usize = 16;

/// What a tree's edge leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Child {
    Node(u32),
    Leaf(u32),
    Object(u32),
}

/// A [`Child`] in 32 bits.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(transparent)]
pub(crate) struct Link(pub(crate) u32);

impl Link {
    const LEAF: u32 = 1 << 31;
    const OBJECT: u32 = 1 << 30;
    /// Not an edge: the mark on a ray's stack below which its ray is back in world space.
    pub(crate) const LEAVE_INSTANCE: Self = Self(u32::MAX);

    pub(crate) const fn leaf(index: u32) -> Self {
        Self(Self::LEAF | index)
    }

    pub(crate) const fn node(index: u32) -> Self {
        Self(index)
    }

    pub(crate) const fn object(index: u32) -> Self {
        Self(Self::OBJECT | index)
    }

    /// True for anything but an inner node.
    pub(crate) const fn ends(self) -> bool {
        self.0 >= Self::OBJECT
    }

    /// The index, if it leads to a leaf.
    pub(crate) const fn as_leaf(self) -> Option<usize> {
        if self.0 & Self::LEAF != 0 && self.0 != Self::LEAVE_INSTANCE.0 {
            Some((self.0 & !Self::LEAF) as usize)
        } else {
            None
        }
    }

    /// What it leads to; the mark leads to no leaf that there is.
    pub(crate) const fn child(self) -> Child {
        if self.0 & Self::LEAF != 0 {
            Child::Leaf(self.0 & !Self::LEAF)
        } else if self.0 & Self::OBJECT != 0 {
            Child::Object(self.0 & !Self::OBJECT)
        } else {
            Child::Node(self.0)
        }
    }
}

/// Sixteen children with their boxes in lanes: one vector instruction per plane. 512 bytes.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Node {
    /// Lower, then upper planes, by axis, by child. A free slot has a box that is inside out: no ray meets it.
    pub(crate) planes: [[[f32; WIDTH]; 3]; 2],
    /// [`Link`]s as vectors load them.
    pub(crate) child: [u32; WIDTH],
    /// For the four octants with a direction that is not negative along z: the slots near to far, in the order in which
    /// the binary splits below this node meet the ray. The opposite octant has the reverse.
    pub(crate) order: [Nibbles; 4],
    /// The box of the node itself, lower and upper corner.
    pub(crate) bounds: [[f32; 3]; 2],
    pub(crate) count: u32,
}

impl Node {
    pub(crate) const FREE: Self = Self {
        planes: [[[f32::MAX; WIDTH]; 3], [[-f32::MAX; WIDTH]; 3]],
        child: [0; WIDTH],
        order: [Nibbles::ZERO; 4],
        bounds: [[f32::MAX; 3], [-f32::MAX; 3]],
        count: 0,
    };

    /// The slots near to far for the octant whose bit `axis` is set when the direction is negative along it.
    #[inline(always)]
    pub(crate) fn near_to_far(&self, octant: u32) -> Nibbles {
        let order = self.order[if octant & 4 == 0 { octant } else { !octant } as usize & 3];
        if octant & 4 == 0 { order } else { order.reversed() }
    }
}

/// Up to sixteen triangles over up to sixteen vertices. A patch of a mesh shares most of its vertices, so this takes a
/// third of the memory of separate triangles and lets a kernel bring each vertex into the ray's frame once. 320 bytes.
#[derive(Clone, Debug)]
#[repr(C, align(64))]
pub(crate) struct Leaf {
    /// Vertices by axis.
    pub(crate) vertex: [[f32; WIDTH]; 3],
    /// The three corners of each triangle. A free lane has three times vertex 0: no area, never hit.
    pub(crate) corner: [Nibbles; 3],
    /// The box of the leaf, lower and upper corner.
    pub(crate) bounds: [[f32; 3]; 2],
    /// Number of triangles.
    pub(crate) count: u32,
    /// Indices of the triangles in the mesh; on a cache line of their own, read for a hit only.
    pub(crate) primitive: [u32; WIDTH],
}

/// Nodes and leaves of one tree, the root first.
#[derive(Clone, Debug, Default)]
pub(crate) struct Tree {
    pub(crate) nodes: Vec<Node>,
    pub(crate) leaves: Vec<Leaf>,
    pub(crate) root: Option<Link>,
    /// Nodes on the longest way down.
    pub(crate) depth: usize,
    /// The box of the root, lower and upper corner.
    pub(crate) bounds: [[f32; 3]; 2],
    /// The largest coordinate of any box, by size.
    pub(crate) reach: f32,
}

impl Tree {
    /// How many entries the stack of a traversal can have: on each level all siblings wait, and a push writes whole
    /// vectors.
    pub(crate) fn stack_capacity(&self) -> usize {
        self.depth * (WIDTH - 1) + 2 * WIDTH
    }
}
