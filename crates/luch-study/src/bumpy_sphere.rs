//! Meshes made for the study of triangles: a sphere with bumps, in as many triangles as are wanted.

use glam::DVec3;
use luch_scene::{Mesh, MeshData};
use std::f64::consts::{PI, TAU};

/// How high the bumps are, the sphere's radius being 1.
const HEIGHT: f64 = 0.06;

/// Triangles of the mesh that [`mesh`] makes.
#[must_use]
pub(crate) fn triangles(about: u64) -> u64 {
    let rings = rings(about);
    // Two for each cell, but one at the poles; twice as many columns as rings.
    4 * rings * (rings - 1)
}

/// A closed mesh of about so many triangles, with smooth normals; the same for the same number on every machine.
#[must_use]
pub(crate) fn mesh(about: u64) -> Mesh {
    let rings = u32::try_from(rings(about)).unwrap_or(u32::MAX);
    let columns = rings * 2;
    let at = |ring: u32, column: u32| match ring {
        0 => 0,
        r if r == rings => 1 + (rings - 1) * columns,
        r => 1 + (r - 1) * columns + column % columns,
    };
    let inner = (1..rings).flat_map(|ring| (0..columns).map(move |column| [ring, column]));
    let places: Vec<DVec3> = std::iter::once([0, 0])
        .chain(inner)
        .chain([[rings, 0]])
        .map(|[ring, column]| place(f64::from(ring) / f64::from(rings), f64::from(column) / f64::from(columns)))
        .collect();
    let mut triangles = Vec::new();
    for ring in 0..rings {
        for column in 0..columns {
            let [a, b] = [at(ring, column), at(ring, column + 1)];
            let [c, d] = [at(ring + 1, column + 1), at(ring + 1, column)];
            if ring > 0 {
                triangles.push([a, c, b]);
            }
            if ring + 1 < rings {
                triangles.push([a, d, c]);
            }
        }
    }
    let normals = normals(&places, &triangles);
    let positions = places.iter().map(|p| p.as_vec3().to_array()).collect();
    let data = MeshData { positions, normals, triangles, ..MeshData::default() };
    // Every index is one of `at`, and every coordinate below 2.
    Mesh::new(data).unwrap_or_else(|error| unreachable!("a bumpy sphere is a mesh: {error}"))
}

/// The rings of cells whose triangles are nearest to the number wanted.
fn rings(about: u64) -> u64 {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "far below 2^32")]
    let rings = ((1.0 + (1.0 + about as f64).sqrt()) / 2.0).round() as u64;
    rings.max(2)
}

/// The point at a share of the way from pole to pole and around.
fn place(polar: f64, around: f64) -> DVec3 {
    let (a, b) = (PI * polar, TAU * around);
    let (sin_a, cos_a) = (libm::sin(a), libm::cos(a));
    // The bumps end at the poles, where all columns meet.
    let radius = 1.0 + HEIGHT * libm::sin(13.0 * a) * libm::cos(16.0 * b) * sin_a;
    DVec3::new(sin_a * libm::cos(b), cos_a, sin_a * -libm::sin(b)) * radius
}

/// For each vertex the sum of its faces' normals, each as long as the face is large.
fn normals(places: &[DVec3], triangles: &[[u32; 3]]) -> Vec<[f32; 3]> {
    let mut sums = vec![DVec3::ZERO; places.len()];
    for triangle in triangles {
        let [a, b, c] = triangle.map(|i| places[i as usize]);
        let normal = (b - a).cross(c - a);
        for &corner in triangle {
            sums[corner as usize] += normal;
        }
    }
    sums.iter().map(|n| n.normalize_or_zero().as_vec3().to_array()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    #[test]
    fn the_triangles_are_as_many_as_were_told_and_near_what_was_wanted() {
        for about in [8, 20, 100, 1_000, 30_000, 100_000] {
            let count = mesh(about).triangles().len() as u64;
            assert_eq!(count, triangles(about), "{about}");
            assert!(count.abs_diff(about) as f64 <= 4.0 * (about as f64).sqrt() + 8.0, "{about}: {count}");
        }
    }

    #[test]
    fn the_mesh_is_closed_and_faces_outwards() {
        for about in [8, 100, 5_000] {
            let mesh = mesh(about);
            let mut edges: HashMap<[u32; 2], i32> = HashMap::new();
            let mut volume = 0.0;
            for &[a, b, c] in mesh.triangles() {
                for [from, to] in [[a, b], [b, c], [c, a]] {
                    *edges.entry([from, to]).or_default() += 1;
                }
                let [a, b, c] = [a, b, c].map(|i| glam::Vec3::from_array(mesh.positions()[i as usize]));
                volume += f64::from(a.dot(b.cross(c))) / 6.0;
            }
            assert!(edges.iter().all(|(&[a, b], &n)| n == 1 && edges.get(&[b, a]) == Some(&1)), "{about}");
            assert!(volume > 0.5, "{about}: {volume}");
        }
    }

    #[test]
    fn normals_point_outwards() {
        let mesh = mesh(5_000);
        for (p, n) in mesh.positions().iter().zip(mesh.normals()) {
            assert!(glam::Vec3::from_array(*p).dot(glam::Vec3::from_array(*n)) > 0.0, "{p:?} {n:?}");
        }
    }
}
