//! A mesh laid out for shading: what a hit needs lies together.

use luch_scene::Mesh;

/// Triangles over vertices that have one position and one normal each.
///
/// A [`Mesh`] may name its normals by indices of their own. Following both costs a hit eight places in memory, most of
/// them far from the processor; here it costs four.
#[derive(Debug)]
pub(crate) struct ShadingMesh {
    vertices: Vec<Vertex>,
    triangles: Vec<[u32; 3]>,
}

/// A corner of triangles, in object space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Vertex {
    pub(crate) position: [f32; 3],
    /// Of unit length, or zero: the face's own.
    pub(crate) normal: [f32; 3],
}

/// No further vertex of this position.
const NONE: u32 = u32::MAX;

impl ShadingMesh {
    /// Lays out a mesh; takes time and memory in proportion to its triangles.
    pub(crate) fn new(mesh: &Mesh) -> Self {
        let (positions, normals) = (mesh.positions(), mesh.normals());
        let mut vertices: Vec<Vertex> = Vec::with_capacity(positions.len());
        // For each position its first vertex, and for each vertex its normal and the next of the same position: nearly
        // all positions have one normal, and few more than three.
        let mut first = vec![NONE; positions.len()];
        let mut chain: Vec<[u32; 2]> = Vec::with_capacity(positions.len());
        let mut vertex_of = |position: u32, normal: u32| {
            let mut at = first[position as usize];
            while at != NONE {
                let [of, next] = chain[at as usize];
                if of == normal {
                    return at;
                }
                at = next;
            }
            #[allow(clippy::cast_possible_truncation, reason = "a mesh has fewer than 2^32 corners")]
            let new = vertices.len() as u32;
            vertices.push(Vertex { position: positions[position as usize], normal: normals[normal as usize] });
            chain.push([normal, first[position as usize]]);
            first[position as usize] = new;
            new
        };
        let corners = mesh.triangles().iter().zip(mesh.normal_triangles());
        let triangles =
            corners.map(|(p, n)| [vertex_of(p[0], n[0]), vertex_of(p[1], n[1]), vertex_of(p[2], n[2])]).collect();
        vertices.shrink_to_fit();
        Self { vertices, triangles }
    }

    /// The corners of a triangle.
    #[inline(always)]
    pub(crate) fn corners(&self, triangle: usize) -> [&Vertex; 3] {
        let [a, b, c] = self.triangles[triangle];
        [&self.vertices[a as usize], &self.vertices[b as usize], &self.vertices[c as usize]]
    }

    /// Bytes that the lists hold.
    pub(crate) fn memory_bytes(&self) -> usize {
        self.vertices.len() * size_of::<Vertex>() + self.triangles.len() * 12
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::MeshData;

    #[test]
    fn every_corner_keeps_its_position_and_normal_and_shared_ones_are_one_vertex() {
        let data = MeshData {
            positions: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]],
            normals: vec![[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
            triangles: vec![[0, 1, 2], [2, 1, 3], [0, 1, 3]],
            normal_triangles: Some(vec![[0, 0, 0], [0, 0, 1], [0, 2, 1]]),
            ..MeshData::default()
        };
        let mesh = Mesh::new(data).unwrap();
        let laid_out = ShadingMesh::new(&mesh);
        for triangle in 0..3 {
            for (k, corner) in laid_out.corners(triangle).into_iter().enumerate() {
                assert_eq!(corner.position, mesh.positions()[mesh.triangles()[triangle][k] as usize]);
                assert_eq!(corner.normal, mesh.normals()[mesh.normal_triangles()[triangle][k] as usize]);
            }
        }
        assert_eq!(laid_out.vertices.len(), 5, "position 1 has two normals, the others one");
    }
}
