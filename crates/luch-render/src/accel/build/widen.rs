//! Wide nodes from a binary tree.

use super::binary::{Binary, LEAF, corners, half_area};
use crate::accel::lanes::Nibbles;
use crate::accel::nodes::{Link, Node, WIDTH};

/// What is best below a binary node if it may take up to `slots` slots of the wide node above it.
#[derive(Clone, Copy)]
struct Best {
    /// Cost by `slots - 1`: the areas of all wide nodes below.
    cost: [f32; WIDTH],
    /// Slots the left child takes, by `slots - 1`; 0 where the node rather takes one slot itself.
    left: [u8; WIDTH],
}

/// Collapses a binary tree into nodes of up to [`WIDTH`] children such that the areas of the nodes, and with them the
/// nodes an average ray visits, are least: dynamic programming as in Ylitie, Karras, Laine, "Efficient Incoherent Ray
/// Traversal on GPUs Through Compressed Wide BVHs" (2017). To open the largest child first, as is usual, left 5.9
/// children in an average node where this leaves 11.5.
/// `leaf` makes the link of a leaf index. Returns the link of the root, and the depth of the wide tree.
pub(crate) fn widen(binary: &[Binary], leaf: impl Fn(u32) -> Link, nodes: &mut Vec<Node>) -> (Link, usize) {
    let link = |k: u32| (binary[k as usize].axis == LEAF).then(|| leaf(binary[k as usize].child[0]));
    if let Some(root) = link(0) {
        return (root, 1);
    }
    let best = best_cuts(binary);
    let (mut depth, mut slots) = (1, Vec::with_capacity(WIDTH));
    // Binary node, its wide node, its depth.
    let mut waiting = vec![(0_u32, 0_usize, 1_usize)];
    nodes.push(Node::FREE);
    while let Some((top, here, level)) = waiting.pop() {
        depth = depth.max(level);
        let order = children(binary, &best, top, &mut slots);
        let mut node = Node { count: slots.len() as u32, order, ..Node::FREE };
        for (slot, &child) in slots.iter().enumerate() {
            let bounds = &binary[child as usize].bounds;
            for axis in 0..3 {
                node.planes[0][axis][slot] = -bounds[axis];
                node.planes[1][axis][slot] = bounds[4 + axis];
            }
            let to = link(child).unwrap_or_else(|| {
                nodes.push(Node::FREE);
                waiting.push((child, nodes.len() - 1, level + 1));
                Link::node(nodes.len() as u32 - 1)
            });
            node.child[slot] = to.0;
        }
        node.bounds = corners(&binary[top as usize].bounds);
        nodes[here] = node;
    }
    (Link::node(0), depth)
}

/// The best for every binary node, children before parents.
fn best_cuts(binary: &[Binary]) -> Vec<Best> {
    let mut best = vec![Best { cost: [0.0; WIDTH], left: [0; WIDTH] }; binary.len()];
    // Parents come before their children in the array.
    for (k, node) in binary.iter().enumerate().rev() {
        if node.axis == LEAF {
            continue;
        }
        let [left, right] = node.child.map(|child| best[child as usize].cost);
        let mut here = Best { cost: [f32::INFINITY; WIDTH], left: [0; WIDTH] };
        for slots in 2..=WIDTH {
            for to_left in 1..slots {
                let cost = left[to_left - 1] + right[slots - to_left - 1];
                if cost < here.cost[slots - 1] {
                    here.cost[slots - 1] = cost;
                    here.left[slots - 1] = to_left as u8;
                }
            }
        }
        // As a wide node it takes one slot, and has all of its own for its children.
        here.cost[0] = half_area(&node.bounds) + here.cost[WIDTH - 1];
        for slots in 1..WIDTH - 1 {
            if here.cost[0] < here.cost[slots] {
                (here.cost[slots], here.left[slots]) = (here.cost[0], 0);
            }
        }
        best[k] = here;
    }
    best
}

/// The binary nodes that become the children of `top`'s wide node, and their order near to far by octant: below every
/// split, the side the ray comes from first.
fn children(binary: &[Binary], best: &[Best], top: u32, slots: &mut Vec<u32>) -> [Nibbles; 4] {
    let mut orders = [Nibbles::ZERO; 4];
    slots.clear();
    for (octant, order) in orders.iter_mut().enumerate() {
        let mut lane = 0;
        // Binary nodes, and the slots each may take: never more than one for each slot.
        let mut waiting = [(0, 0); WIDTH];
        waiting[0] = (top, WIDTH);
        let mut depth = 1;
        while depth > 0 {
            let (k, room) = waiting[depth - 1];
            let node = &binary[k as usize];
            let to_left = best[k as usize].left[room - 1] as usize;
            if node.axis == LEAF || to_left == 0 {
                depth -= 1;
                // The first octant meets all children in the order that numbers the slots.
                let slot = if octant == 0 { slots.len() } else { slots.iter().position(|&s| s == k).unwrap_or(0) };
                if octant == 0 {
                    slots.push(k);
                }
                order.set(lane, slot);
                lane += 1;
                continue;
            }
            let (left, right) = ((node.child[0], to_left), (node.child[1], room - to_left));
            let negative = octant >> node.axis & 1 != 0;
            (waiting[depth - 1], waiting[depth]) = if negative { (left, right) } else { (right, left) };
            depth += 1;
        }
        // A permutation needs all sixteen; the free slots never count.
        (lane..WIDTH).for_each(|lane| order.set(lane, lane));
    }
    orders
}
