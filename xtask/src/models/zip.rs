//! Joining two rings around the y axis by a strip of triangles.

use super::mesh::Face;

/// A corner of a ring: position index, normal index, angle around the axis in turns.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    /// Index of the position.
    pub v: u32,
    /// Index of the normal.
    pub n: u32,
    /// Angle, in turns, rising along the ring; the first corner lies in [0, 1), the ring spans less than one turn.
    pub turn: f64,
}

/// Triangles between ring `below` and ring `above`, both in the order of rising angle, facing outwards where `below` is the
/// earlier ring of an outline (see `profile`). A ring of one corner is a pole.
pub fn zip(below: &[Corner], above: &[Corner], faces: &mut Vec<Face>) {
    let at = |ring: &[Corner], i: usize| (ring[i % ring.len()], ring[i % ring.len()].turn + (i / ring.len()) as f64);
    let (nb, na) = (if below.len() == 1 { 0 } else { below.len() }, if above.len() == 1 { 0 } else { above.len() });
    let (mut i, mut j) = (0, 0);
    while i < nb || j < na {
        let (b, _) = at(below, i);
        let (a, _) = at(above, j);
        // Advance on the ring whose next corner comes first.
        let step_below = j >= na || (i < nb && at(below, i + 1).1 <= at(above, j + 1).1);
        if step_below {
            let (c, _) = at(below, i + 1);
            faces.push(Face { v: [b.v, a.v, c.v], n: [b.n, a.n, c.n] });
            i += 1;
        } else {
            let (c, _) = at(above, j + 1);
            faces.push(Face { v: [b.v, a.v, c.v], n: [b.n, a.n, c.n] });
            j += 1;
        }
    }
}
