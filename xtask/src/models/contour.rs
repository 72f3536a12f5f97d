//! The surface of a field as a mesh: dual contouring.
//!
//! Tao Ju, Frank Losasso, Scott Schaefer, Joe Warren, "Dual Contouring of Hermite Data", 2002: a vertex per cell where the
//! tangent planes of the cell's edge crossings meet, which keeps sharp edges. A cell that the surface crosses in several
//! sheets gets a vertex per sheet (Gregory Nielson, "Dual Marching Cubes", 2004), which keeps the mesh a manifold.

use glam::{DMat3, DVec3, IVec3};

use super::field::Field;
use super::mesh::index;

/// Cells per side of a block; blocks far from the surface are skipped.
const BLOCK: i32 = 8;
/// The field may change by this factor times the distance moved; larger costs time, smaller may lose parts.
const LIPSCHITZ: f64 = 1.8;
/// How much a vertex prefers the middle of the crossings over the meeting point of their planes.
const REGULARITY: f64 = 0.02;

/// The box to contour and the side of its cells, millimetres.
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    /// The lower corner. The surface leaves the box only through its lower face, where it is cut.
    pub min: DVec3,
    /// The upper corner.
    pub max: DVec3,
    /// The side of a cell.
    pub cell: f64,
}

/// A triangle mesh that is open along one loop at the bottom of its grid.
pub struct Surface {
    /// Positions, millimetres.
    pub positions: Vec<DVec3>,
    /// Triangles, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// The two corners of each cell edge, corner bits x, y, z; edges 0-3 run along x, 4-7 along y, 8-11 along z.
const EDGES: [[usize; 2]; 12] =
    [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];

/// For each axis of a lattice edge: the offset of each of the four cells around it and the edge's number in that cell,
/// counter-clockwise seen from the edge's upper end.
const AROUND: [[([i32; 3], usize); 4]; 3] = [
    [([0, 0, 0], 0), ([0, -1, 0], 1), ([0, -1, -1], 3), ([0, 0, -1], 2)],
    [([0, 0, 0], 4), ([0, 0, -1], 6), ([-1, 0, -1], 7), ([-1, 0, 0], 5)],
    [([0, 0, 0], 8), ([-1, 0, 0], 9), ([-1, -1, 0], 11), ([0, -1, 0], 10)],
];

/// The corners of each face of a cell, in a cycle.
const FACES: [[usize; 4]; 6] = [[0, 2, 6, 4], [1, 3, 7, 5], [0, 1, 5, 4], [2, 3, 7, 6], [0, 1, 3, 2], [4, 5, 7, 6]];

struct Lattice {
    origin: DVec3,
    cell: f64,
    cells: IVec3,
    values: Vec<f32>,
}

impl Lattice {
    fn point(&self, at: IVec3) -> DVec3 {
        self.origin + at.as_dvec3() * self.cell
    }

    fn slot(&self, at: IVec3) -> usize {
        let n = self.cells + 1;
        ((at.z * n.y + at.y) * n.x + at.x) as usize
    }

    /// Evaluates the corners near the surface; the others stay NaN.
    fn sample(field: &dyn Field, grid: &Grid) -> Self {
        let cells = ((grid.max - grid.min) / grid.cell).ceil().as_ivec3();
        let count = ((cells.x + 1) * (cells.y + 1) * (cells.z + 1)) as usize;
        let mut lattice = Self { origin: grid.min, cell: grid.cell, cells, values: vec![f32::NAN; count] };
        let reach = LIPSCHITZ * grid.cell * f64::from(BLOCK) * 0.5 * 3f64.sqrt();
        for bz in 0..=cells.z / BLOCK {
            for by in 0..=cells.y / BLOCK {
                for bx in 0..=cells.x / BLOCK {
                    let first = IVec3::new(bx, by, bz) * BLOCK;
                    let center = lattice.point(first) + 0.5 * grid.cell * f64::from(BLOCK);
                    if field.at(center).abs() <= reach {
                        lattice.sample_block(field, first);
                    }
                }
            }
        }
        lattice
    }

    fn sample_block(&mut self, field: &dyn Field, first: IVec3) {
        let last = (first + BLOCK).min(self.cells);
        for z in first.z..=last.z {
            for y in first.y..=last.y {
                for x in first.x..=last.x {
                    let at = IVec3::new(x, y, z);
                    let slot = self.slot(at);
                    if self.values[slot].is_nan() {
                        self.values[slot] = field.at(self.point(at)) as f32;
                    }
                }
            }
        }
    }

    /// The values at the corners of a cell, if all are known.
    fn corners(&self, cell: IVec3) -> Option<[f32; 8]> {
        let mut values = [0.0; 8];
        for (i, value) in values.iter_mut().enumerate() {
            *value = self.values[self.slot(cell + corner(i))];
            if value.is_nan() {
                return None;
            }
        }
        Some(values)
    }
}

fn corner(i: usize) -> IVec3 {
    IVec3::new((i & 1) as i32, (i >> 1 & 1) as i32, (i >> 2 & 1) as i32)
}

/// A cell that the surface crosses: where its vertices start, and the sheet of each edge (255: no crossing).
struct Crossed {
    slot: usize,
    first_vertex: u32,
    sheet: [u8; 12],
}

/// Contours `field` in `grid`.
#[must_use]
pub fn contour(field: &dyn Field, grid: &Grid) -> Surface {
    let lattice = Lattice::sample(field, grid);
    let mut surface = Surface { positions: Vec::new(), triangles: Vec::new() };

    // Place a vertex for each sheet of each crossed cell.
    let mut crossed: Vec<Crossed> = Vec::new();
    for z in 0..lattice.cells.z {
        for y in 0..lattice.cells.y {
            for x in 0..lattice.cells.x {
                let cell = IVec3::new(x, y, z);
                let Some(values) = lattice.corners(cell) else { continue };
                let inside = values.map(|v| v < 0.0);
                if inside.iter().all(|i| *i == inside[0]) {
                    continue;
                }
                let (sheet, count) = sheets(&inside);
                crossed.push(Crossed { slot: lattice.slot(cell), first_vertex: index(surface.positions.len()), sheet });
                for s in 0..count {
                    surface.positions.push(place(field, &lattice, cell, &values, &sheet, s));
                }
            }
        }
    }

    // Join the four cells around each crossed lattice edge.
    let vertex = |cell: IVec3, edge: usize| -> Option<u32> {
        if cell.cmplt(IVec3::ZERO).any() {
            return None;
        }
        let at = crossed.binary_search_by_key(&lattice.slot(cell), |c| c.slot).ok()?;
        Some(crossed[at].first_vertex + u32::from(crossed[at].sheet[edge]))
    };
    for c in &crossed {
        let n = lattice.cells + 1;
        let slot = c.slot as i32;
        let cell = IVec3::new(slot % n.x, slot / n.x % n.y, slot / (n.x * n.y));
        for (axis, around) in AROUND.iter().enumerate() {
            if c.sheet[axis * 4] == 255 {
                continue;
            }
            let corners = around.map(|(offset, edge)| vertex(cell + IVec3::from(offset), edge));
            let [Some(a), Some(b), Some(d), Some(e)] = corners else { continue };
            let quad = if lattice.values[c.slot] < 0.0 { [a, b, d, e] } else { [e, d, b, a] };
            surface.push_quad(quad);
        }
    }
    surface
}

impl Surface {
    /// Adds a quad as two triangles, split along the shorter diagonal.
    fn push_quad(&mut self, [a, b, c, d]: [u32; 4]) {
        let p = |i: u32| self.positions[i as usize];
        if p(a).distance_squared(p(c)) <= p(b).distance_squared(p(d)) {
            self.triangles.extend([[a, b, c], [a, c, d]]);
        } else {
            self.triangles.extend([[b, c, d], [b, d, a]]);
        }
    }
}

/// Sorts the crossed edges of a cell into sheets: edges joined across a face belong together; on a face with four crossings
/// each inside corner keeps its own two.
fn sheets(inside: &[bool; 8]) -> ([u8; 12], u8) {
    let mut parent: [usize; 12] = std::array::from_fn(|i| i);
    fn root(parent: &[usize; 12], mut i: usize) -> usize {
        while parent[i] != i {
            i = parent[i];
        }
        i
    }
    let edge_between = |a: usize, b: usize| EDGES.iter().position(|e| *e == [a.min(b), a.max(b)]).unwrap_or(0);
    for face in FACES {
        let edges: [usize; 4] = std::array::from_fn(|i| edge_between(face[i], face[(i + 1) % 4]));
        let is_crossed: [bool; 4] = std::array::from_fn(|i| inside[face[i]] != inside[face[(i + 1) % 4]]);
        let count = is_crossed.iter().filter(|c| **c).count();
        let mut join = |i: usize, j: usize| {
            let (a, b) = (root(&parent, edges[i]), root(&parent, edges[j]));
            parent[a.max(b)] = a.min(b);
        };
        if count == 4 {
            for i in 0..4 {
                if inside[face[i]] {
                    join((i + 3) % 4, i);
                }
            }
        } else if count == 2 {
            let mut crossed = (0..4).filter(|i| is_crossed[*i]);
            if let (Some(i), Some(j)) = (crossed.next(), crossed.next()) {
                join(i, j);
            }
        }
    }
    let mut sheet = [255; 12];
    let mut count = 0;
    for (e, [a, b]) in EDGES.into_iter().enumerate() {
        if inside[a] != inside[b] {
            let r = root(&parent, e);
            if r == e {
                sheet[e] = count;
                count += 1;
            } else {
                sheet[e] = sheet[r];
            }
        }
    }
    (sheet, count)
}

/// The vertex of one sheet of a cell: the least-squares meeting point of the tangent planes at its crossings, kept in the cell.
fn place(field: &dyn Field, lattice: &Lattice, cell: IVec3, values: &[f32; 8], sheet: &[u8; 12], wanted: u8) -> DVec3 {
    let mut crossings = [(DVec3::ZERO, DVec3::ZERO); 12];
    let mut count = 0;
    for (e, [a, b]) in EDGES.into_iter().enumerate() {
        if sheet[e] != wanted {
            continue;
        }
        let (pa, pb) = (lattice.point(cell + corner(a)), lattice.point(cell + corner(b)));
        let p = crossing(field, pa, pb, f64::from(values[a]), f64::from(values[b]));
        crossings[count] = (p, field.gradient(p).normalize_or_zero());
        count += 1;
    }
    let crossings = &crossings[..count];
    let middle = crossings.iter().map(|c| c.0).sum::<DVec3>() / count as f64;
    let mut matrix = DMat3::from_diagonal(DVec3::splat(REGULARITY));
    let mut right = DVec3::ZERO;
    for (p, n) in crossings {
        matrix += DMat3::from_cols(*n * n.x, *n * n.y, *n * n.z);
        right += *n * n.dot(*p - middle);
    }
    let low = lattice.point(cell);
    let vertex = (middle + matrix.inverse() * right).clamp(low, low + lattice.cell);
    field.project(vertex, 0.5 * lattice.cell)
}

/// Where the field changes sign between two points: three steps of regula falsi (Illinois variant).
fn crossing(field: &dyn Field, mut a: DVec3, mut b: DVec3, mut fa: f64, mut fb: f64) -> DVec3 {
    let mut p = a;
    for _ in 0..3 {
        p = a + (b - a) * (fa / (fa - fb)).clamp(0.0, 1.0);
        let f = field.at(p);
        if f.abs() < 1e-6 {
            break;
        }
        if (f < 0.0) == (fa < 0.0) {
            (a, fa) = (p, f);
            fb *= 0.5;
        } else {
            (b, fb) = (p, f);
            fa *= 0.5;
        }
    }
    p
}
