//! Leaves of a mesh: patches of triangles over shared vertices.

use super::{Item, LeafMaker, index};
use crate::accel::lanes::Nibbles;
use crate::accel::nodes::{Leaf, WIDTH};
use glam::Vec3;

/// Makes leaves of the triangles of one mesh.
#[derive(Debug)]
pub(crate) struct Patches<'a, P> {
    pub(crate) positions: &'a [P],
    pub(crate) triangles: &'a [[u32; 3]],
}

impl<P: Copy + Into<Vec3> + Sync> LeafMaker for Patches<'_, P> {
    type Leaf = Leaf;
    const MOST: usize = WIDTH;

    fn grain(&self) -> u32 {
        // Triangles that share no vertices: five of them fill a leaf, and a sixth would split it into halves.
        let separate = self.positions.len() > 2 * self.triangles.len();
        if separate { (WIDTH / 3) as u32 } else { 1 }
    }

    fn make(&self, items: &[Item]) -> Option<Self::Leaf> {
        let mut known = [u32::MAX; WIDTH];
        let mut position = [[0_u32; 4]; WIDTH];
        let mut corner = [Nibbles::ZERO; 3];
        let mut primitives = [u32::MAX; WIDTH];
        let mut used = 0;
        for (lane, item) in items.iter().enumerate() {
            let primitive = index(item);
            primitives[lane] = primitive;
            for (k, &vertex) in self.triangles[primitive as usize].iter().enumerate() {
                // The index first: it tells most of them apart without a look at the position.
                let mut slot = known[..used].iter().position(|&other| other == vertex);
                if slot.is_none() {
                    let p: Vec3 = self.positions[vertex as usize].into();
                    let bits = [p.x.to_bits(), p.y.to_bits(), p.z.to_bits(), 0];
                    // Meshes split vertices where normals or textures have a seam.
                    slot = position[..used].iter().position(|&other| other == bits);
                    if slot.is_none() && used < WIDTH {
                        (known[used], position[used]) = (vertex, bits);
                        slot = Some(used);
                        used += 1;
                    }
                }
                corner[k].set(lane, slot?);
            }
        }
        let mut vertex = [[0.0; WIDTH]; 3];
        for (axis, row) in vertex.iter_mut().enumerate() {
            for (slot, to) in row.iter_mut().enumerate() {
                *to = f32::from_bits(position[if slot < used { slot } else { 0 }][axis]);
            }
        }
        let bounds = [
            vertex.map(|row| row.iter().copied().fold(f32::INFINITY, f32::min)),
            vertex.map(|row| row.iter().copied().fold(f32::NEG_INFINITY, f32::max)),
        ];
        Some(Leaf { vertex, corner, bounds, count: items.len() as u32, primitive: primitives })
    }
}
