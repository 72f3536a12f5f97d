//! Normals that the file does not give.

use super::{CUBE, CUBE_FACES, good, read};
use glam::Vec3;
use luch_scene::Mesh;
use std::fmt::Write;

/// The face's own normal.
fn face(mesh: &Mesh, triangle: usize) -> Vec3 {
    let [a, b, c] = mesh.triangles()[triangle].map(|i| Vec3::from_array(mesh.positions()[i as usize]));
    (b - a).cross(c - a).normalize_or_zero()
}

fn corner(mesh: &Mesh, triangle: usize, k: usize) -> Vec3 {
    Vec3::from_array(mesh.normals()[mesh.normal_triangles()[triangle][k] as usize])
}

/// A sphere of latitude and longitude, its poles fans.
fn sphere(rows: u32, columns: u32) -> String {
    let mut text = "v 0 1 0\nv 0 -1 0\n".to_owned();
    for row in 1..rows {
        for column in 0..columns {
            let (polar, around) = (
                row as f32 / rows as f32 * std::f32::consts::PI,
                column as f32 / columns as f32 * std::f32::consts::TAU,
            );
            let (s, c) = libm::sincosf(polar);
            let (sin, cos) = libm::sincosf(around);
            writeln!(text, "v {} {c} {}", s * sin, s * cos).unwrap();
        }
    }
    let at = |row: u32, column: u32| 3 + (row - 1) * columns + column % columns;
    for column in 0..columns {
        writeln!(text, "f 1 {} {}", at(1, column), at(1, column + 1)).unwrap();
        for row in 1..rows - 1 {
            let [a, b] = [at(row, column), at(row, column + 1)];
            let [d, c] = [at(row + 1, column), at(row + 1, column + 1)];
            writeln!(text, "f {a} {d} {c} {b}").unwrap();
        }
        writeln!(text, "f 2 {} {}", at(rows - 1, column + 1), at(rows - 1, column)).unwrap();
    }
    text
}

#[test]
fn a_cube_keeps_its_edges() {
    let (mesh, _) = good(&format!("{CUBE}{CUBE_FACES}"));
    assert_eq!(mesh.triangles().len(), 12);
    for t in 0..12 {
        for k in 0..3 {
            assert_eq!(corner(&mesh, t, k), face(&mesh, t));
        }
    }
    assert_eq!(mesh.normals().len(), 24, "three at each corner of the cube");
}

#[test]
fn a_sphere_is_smooth() {
    let (mesh, _) = good(&sphere(24, 48));
    for t in 0..mesh.triangles().len() {
        for k in 0..3 {
            let place = Vec3::from_array(mesh.positions()[mesh.triangles()[t][k] as usize]);
            assert!(corner(&mesh, t, k).dot(place) > 0.999, "{place}");
        }
    }
    assert_eq!(mesh.normals().len(), mesh.positions().len());
    assert!(read(&sphere(24, 48)).unwrap().0.normal_triangles.is_none(), "no list where none is needed");
}

#[test]
fn smoothing_groups_rule_where_the_file_has_them() {
    let all_one = good(&format!("{CUBE}s 1\n{CUBE_FACES}")).0;
    for t in 0..12 {
        for k in 0..3 {
            let place = Vec3::from_array(all_one.positions()[all_one.triangles()[t][k] as usize]);
            let outwards = (place - Vec3::splat(0.5)).normalize_or_zero();
            assert!(
                corner(&all_one, t, k).dot(outwards) > 0.9999,
                "weighted by angle, the cut of a square does not matter"
            );
        }
    }
    let off = good(&format!("{}s off\n", sphere(8, 8)).replace("f 1", "s 0\nf 1")).0;
    for t in 0..off.triangles().len() {
        assert_eq!(corner(&off, t, 0), Vec3::ZERO, "zero: shading uses the face's own");
    }
    // Two faces of the cube together, the others apart.
    let faces: Vec<&str> = CUBE_FACES.lines().collect();
    let two =
        good(&format!("{CUBE}s 7\n{}\n{}\ns 2\n{}\n{}\ns off\n{}\n", faces[0], faces[2], faces[1], faces[3], faces[4]))
            .0;
    let shared = (Vec3::NEG_Z + Vec3::NEG_Y).normalize_or_zero();
    let of_face = |t: usize| (0..3).map(|k| corner(&two, t, k)).collect::<Vec<_>>();
    assert!(of_face(0).iter().any(|n| n.dot(shared) > 0.9999));
    assert!(of_face(0).contains(&Vec3::NEG_Z), "where the other face of the group does not reach");
    assert_eq!(of_face(8), [Vec3::ZERO; 3]);
}

#[test]
fn faces_before_the_first_s_are_faceted() {
    let faces: Vec<&str> = CUBE_FACES.lines().collect();
    let mesh = good(&format!("{CUBE}{}\ns 1\n{}\n", faces[0], faces[2])).0;
    assert_eq!(corner(&mesh, 0, 0), Vec3::ZERO);
    assert!(corner(&mesh, 2, 0).dot(Vec3::NEG_Y) > 0.9999);
}

#[test]
fn faces_that_bring_their_own_vertices_are_smooth_too() {
    let shared = good(&sphere(16, 32)).0;
    let mut text = String::new();
    for t in shared.triangles() {
        for i in t {
            let [x, y, z] = shared.positions()[*i as usize];
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
        text.push_str("f -3 -2 -1\n");
    }
    let own = good(&text).0;
    for t in 0..own.triangles().len() {
        for k in 0..3 {
            assert!((corner(&own, t, k) - corner(&shared, t, k)).length() < 1e-6);
        }
    }
}

#[test]
fn normals_are_found_at_every_scale() {
    for scale in [1e-6_f32, 1e-3, 1e6, 9e8] {
        let text: String = sphere(12, 24)
            .lines()
            .map(|line| match line.strip_prefix("v ") {
                Some(p) => {
                    let p: Vec<String> =
                        p.split(' ').map(|c| (c.parse::<f32>().unwrap() * scale).to_string()).collect();
                    format!("v {}\n", p.join(" "))
                }
                None => format!("{line}\n"),
            })
            .collect();
        let mesh = good(&text).0;
        for (n, p) in mesh.normals().iter().zip(mesh.positions()) {
            assert!(Vec3::from_array(*n).dot(Vec3::from_array(*p) / scale) > 0.99, "{scale}");
        }
    }
}

#[test]
fn a_vertex_with_very_many_faces_takes_no_time() {
    let (n, start) = (50_000, std::time::Instant::now());
    let mut text = "v 0 1 0\n".to_owned();
    for i in 0..n {
        let (s, c) = libm::sincosf(i as f32 / n as f32 * std::f32::consts::TAU);
        // A star with sharp rays, so that the quick way for flat places is not taken.
        let y = if i % 2 == 0 { 0.0 } else { 0.9 };
        writeln!(text, "v {s} {y} {c}").unwrap();
    }
    for i in 0..n {
        writeln!(text, "f 1 {} {}", i + 2, (i + 1) % n + 2).unwrap();
    }
    good(&text);
    assert!(start.elapsed().as_secs_f32() < 3.0, "{:?}", start.elapsed());
}
