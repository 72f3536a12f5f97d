//! An indexed triangle mesh whose corners name a position and a normal separately, so that creases need no double positions.

use glam::DVec3;

/// A triangle: three position indices and three normal indices, counter-clockwise seen from outside.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Face {
    /// Indices into [`Mesh::positions`].
    pub v: [u32; 3],
    /// Indices into [`Mesh::normals`].
    pub n: [u32; 3],
}

/// Positions in millimetres, unit normals, faces.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// Vertex positions, millimetres.
    pub positions: Vec<DVec3>,
    /// Unit normals, pointing outwards.
    pub normals: Vec<DVec3>,
    /// The triangles.
    pub faces: Vec<Face>,
}

impl Mesh {
    /// Adds a position and returns its index.
    pub fn add_position(&mut self, p: DVec3) -> u32 {
        self.positions.push(p);
        index(self.positions.len() - 1)
    }

    /// Adds a unit normal and returns its index.
    pub fn add_normal(&mut self, n: DVec3) -> u32 {
        self.normals.push(n);
        index(self.normals.len() - 1)
    }

    /// Twice the area of triangle `v` times its outward unit normal.
    #[must_use]
    pub fn area_vector(&self, v: [u32; 3]) -> DVec3 {
        let [a, b, c] = v.map(|i| self.positions[i as usize]);
        (b - a).cross(c - a)
    }
}

/// An index as the file's integer type. The meshes here stay far below the limit.
#[must_use]
pub fn index(i: usize) -> u32 {
    u32::try_from(i).expect("a chess piece has fewer than 2^32 vertices")
}
