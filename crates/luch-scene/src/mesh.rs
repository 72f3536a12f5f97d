//! Triangle meshes: shared, immutable, checked once.

use crate::color::Color;
use crate::number::{MAX_COORDINATE, Unit};
use glam::Vec3;
use std::sync::atomic::{AtomicU64, Ordering};

/// Tells one loaded mesh from another within a run of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct MeshId(u64);

/// How the model's own file wants a part of it to look.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshMaterial {
    /// The name it has in the file.
    pub name: String,
    /// Diffuse colour.
    pub color: Color,
    /// Gloss, if the file says anything of highlights.
    pub gloss: Option<Unit>,
}

/// What a mesh is made of, before it is checked.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct MeshData {
    /// Vertex positions, in the units of the model.
    pub positions: Vec<[f32; 3]>,
    /// Vertex normals; their length does not matter.
    pub normals: Vec<[f32; 3]>,
    /// Three indices into `positions` a triangle, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
    /// Three indices into `normals` a triangle; `None` where they equal `triangles`.
    pub normal_triangles: Option<Vec<[u32; 3]>>,
    /// The looks that the model's file names.
    pub materials: Vec<MeshMaterial>,
    /// For each triangle the index of its material; empty where all have the first, or `materials` is empty.
    pub triangle_materials: Vec<u16>,
}

/// Why some data is no mesh.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum MeshError {
    /// There is nothing to see.
    #[error("the mesh has no triangles")]
    Empty,
    /// A triangle names a vertex, normal or material that is not there.
    #[error("triangle {triangle} names {what} {index} of {count}")]
    IndexOutOfRange {
        /// Number of the triangle, from 0.
        triangle: usize,
        /// `vertex`, `normal` or `material`.
        what: &'static str,
        /// The index that it names.
        index: u32,
        /// How many there are.
        count: usize,
    },
    /// A coordinate is not finite, or beyond [`MAX_COORDINATE`].
    #[error("vertex {vertex} has the coordinate {value}, which is not a number from -1e9 to 1e9")]
    Coordinate {
        /// Number of the vertex, from 0.
        vertex: usize,
        /// The coordinate.
        value: f32,
    },
    /// The lists disagree in length.
    #[error("{what}: {count} for {triangles} triangles")]
    Length {
        /// Which list.
        what: &'static str,
        /// Its length.
        count: usize,
        /// The number of triangles.
        triangles: usize,
    },
}

/// A checked triangle mesh: every index in range, every coordinate finite, every normal of unit length.
///
/// Two meshes are equal when they are the same loaded mesh ([`Mesh::id`]): vertices are not compared.
#[derive(Debug)]
pub struct Mesh {
    id: MeshId,
    data: MeshData,
    bounds: [Vec3; 2],
}

impl PartialEq for Mesh {
    fn eq(&self, other: &Self) -> bool {
        self.id == other.id
    }
}

impl Mesh {
    /// Checks the data and gives it an identity.
    ///
    /// Normals are brought to unit length; a normal that has none (zero or not finite) becomes zero, which shading
    /// reads as "use the face's own".
    ///
    /// # Errors
    /// [`MeshError`] says the first thing that is wrong.
    pub fn new(mut data: MeshData) -> Result<Self, MeshError> {
        static NEXT_ID: AtomicU64 = AtomicU64::new(1);
        check(&data)?;
        for n in &mut data.normals {
            *n = unit_or_zero(*n);
        }
        let used = || data.triangles.iter().flatten().map(|&i| Vec3::from_array(data.positions[i as usize]));
        let bounds = used().fold([Vec3::INFINITY, Vec3::NEG_INFINITY], |[lo, hi], p| [lo.min(p), hi.max(p)]);
        Ok(Self { id: MeshId(NEXT_ID.fetch_add(1, Ordering::Relaxed)), data, bounds })
    }

    /// The identity of this mesh in this run.
    #[must_use]
    pub const fn id(&self) -> MeshId {
        self.id
    }

    /// Vertex positions.
    #[must_use]
    pub fn positions(&self) -> &[[f32; 3]] {
        &self.data.positions
    }

    /// Vertex normals, each of unit length or zero.
    #[must_use]
    pub fn normals(&self) -> &[[f32; 3]] {
        &self.data.normals
    }

    /// Position indices of the triangles.
    #[must_use]
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.data.triangles
    }

    /// Normal indices of the triangles.
    #[must_use]
    pub fn normal_triangles(&self) -> &[[u32; 3]] {
        self.data.normal_triangles.as_deref().unwrap_or(&self.data.triangles)
    }

    /// The looks that the model's file names.
    #[must_use]
    pub fn materials(&self) -> &[MeshMaterial] {
        &self.data.materials
    }

    /// The look of a triangle, if the model's file names any.
    #[must_use]
    pub fn material_of(&self, triangle: usize) -> Option<&MeshMaterial> {
        let index = self.data.triangle_materials.get(triangle).map_or(0, |&m| usize::from(m));
        self.data.materials.get(index)
    }

    /// Index of the look of each triangle; empty where all have the first.
    #[must_use]
    pub fn triangle_materials(&self) -> &[u16] {
        &self.data.triangle_materials
    }

    /// Lower and upper corner of the box around the triangles.
    #[must_use]
    pub const fn bounds(&self) -> [Vec3; 2] {
        self.bounds
    }

    /// Bytes that the lists hold.
    #[must_use]
    pub fn memory_bytes(&self) -> usize {
        12 * (self.data.positions.len() + self.data.normals.len() + self.data.triangles.len())
            + 12 * self.data.normal_triangles.as_ref().map_or(0, Vec::len)
            + 2 * self.data.triangle_materials.len()
    }
}

fn check(data: &MeshData) -> Result<(), MeshError> {
    let triangles = data.triangles.len();
    if triangles == 0 {
        return Err(MeshError::Empty);
    }
    for (vertex, p) in data.positions.iter().enumerate() {
        // Written so that NaN, which fails every comparison, is refused.
        if let Some(&value) = p.iter().find(|c| !matches!(c.abs(), a if a <= MAX_COORDINATE)) {
            return Err(MeshError::Coordinate { vertex, value });
        }
    }
    check_indices(&data.triangles, "vertex", data.positions.len())?;
    match &data.normal_triangles {
        Some(list) if list.len() != triangles => {
            return Err(MeshError::Length { what: "normal indices", count: list.len(), triangles });
        }
        Some(list) => check_indices(list, "normal", data.normals.len())?,
        None => check_indices(&data.triangles, "normal", data.normals.len())?,
    }
    if !data.triangle_materials.is_empty() {
        if data.triangle_materials.len() != triangles {
            return Err(MeshError::Length {
                what: "material indices",
                count: data.triangle_materials.len(),
                triangles,
            });
        }
        let count = data.materials.len();
        if let Some((triangle, &m)) =
            data.triangle_materials.iter().enumerate().find(|&(_, &m)| usize::from(m) >= count)
        {
            return Err(MeshError::IndexOutOfRange { triangle, what: "material", index: u32::from(m), count });
        }
    }
    Ok(())
}

fn check_indices(list: &[[u32; 3]], what: &'static str, count: usize) -> Result<(), MeshError> {
    for (triangle, corners) in list.iter().enumerate() {
        if let Some(&index) = corners.iter().find(|&&i| i as usize >= count) {
            return Err(MeshError::IndexOutOfRange { triangle, what, index, count });
        }
    }
    Ok(())
}

fn unit_or_zero(n: [f32; 3]) -> [f32; 3] {
    let v = Vec3::from_array(n).as_dvec3();
    let length = v.length();
    if length > 0.0 && length.is_finite() { (v / length).as_vec3().to_array() } else { [0.0; 3] }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> MeshData {
        MeshData {
            positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [9.0; 3]],
            normals: vec![[0.0, 0.0, 2.0]],
            triangles: vec![[0, 1, 2]],
            normal_triangles: Some(vec![[0, 0, 0]]),
            ..MeshData::default()
        }
    }

    #[test]
    fn a_checked_mesh_has_unit_normals_and_bounds_of_what_is_used() {
        let mesh = Mesh::new(triangle()).unwrap();
        assert_eq!(mesh.normals(), [[0.0, 0.0, 1.0]]);
        assert_eq!(mesh.bounds(), [Vec3::ZERO, Vec3::new(1.0, 1.0, 0.0)], "the unused vertex at 9 is no part of it");
        assert_ne!(mesh, Mesh::new(triangle()).unwrap(), "loaded twice is two meshes");
    }

    #[test]
    fn wrong_data_is_refused_with_its_place() {
        let with = |change: &dyn Fn(&mut MeshData)| {
            let mut data = triangle();
            change(&mut data);
            Mesh::new(data).unwrap_err().to_string()
        };
        assert_eq!(with(&|d| d.triangles.clear()), "the mesh has no triangles");
        assert_eq!(with(&|d| d.triangles[0][1] = 4), "triangle 0 names vertex 4 of 4");
        assert_eq!(with(&|d| d.normal_triangles = None), "triangle 0 names normal 1 of 1");
        assert!(with(&|d| d.positions[2][0] = f32::NAN).starts_with("vertex 2 has the coordinate NaN"));
        assert_eq!(with(&|d| d.triangle_materials = vec![0]), "triangle 0 names material 0 of 0");
    }

    #[test]
    fn a_normal_without_length_becomes_zero_not_nan() {
        for n in [[0.0; 3], [f32::NAN, 0.0, 1.0], [f32::INFINITY, 0.0, 0.0]] {
            let mesh = Mesh::new(MeshData { normals: vec![n], ..triangle() }).unwrap();
            assert_eq!(mesh.normals(), [[0.0; 3]]);
        }
    }
}
