//! `usemtl` and `mtllib`.

use super::read_with;
use luch_scene::{Material, Mesh};

const LIBRARY: &str =
    "newmtl red\nKd 1 0 0\nKs 1 1 1\nNs 1000\nnewmtl Material #25\nKd 0 1 0\nnewmtl unused\nKd 0 0 1\n";

fn model(middle: &str) -> String {
    format!("mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\n{middle}")
}

fn looks(mesh: &Mesh) -> Vec<(String, [u8; 3])> {
    (0..mesh.triangles().len())
        .map(|t| mesh.material_of(t).map_or_else(Default::default, |m| (m.name.clone(), m.color.to_srgb8())))
        .collect()
}

#[test]
fn each_triangle_has_the_material_named_before_it() {
    let text =
        model("f 1 2 3\nusemtl red\nf 1 2 3\nf 2 3 1\nusemtl Material #25\nf 1 2 3\nusemtl red # again\nf 3 1 2\n");
    let (data, report) = read_with(&text, &[("a.mtl", LIBRARY)]).unwrap();
    let mesh = Mesh::new(data).unwrap();
    let default = Material::DEFAULT_COLOR.to_srgb8();
    let expected = [
        ("", default),
        ("red", [255, 0, 0]),
        ("red", [255, 0, 0]),
        ("Material #25", [0, 255, 0]),
        ("red # again", [255, 0, 0]),
    ];
    assert_eq!(looks(&mesh), expected.map(|(n, c)| (n.to_owned(), c)));
    assert_eq!(mesh.material_of(1).unwrap().gloss.unwrap().get(), 1.0);
    assert_eq!(mesh.material_of(3).unwrap().gloss, None);
    assert_eq!(report.lines(), ["materials of a library that nothing uses: 1 (m.obj)"]);
}

#[test]
fn one_material_for_all_needs_no_list() {
    let (data, _) = read_with(&model("usemtl red\nf 1 2 3\nf 2 3 1\n"), &[("a.mtl", LIBRARY)]).unwrap();
    assert!(data.triangle_materials.is_empty());
    assert_eq!(data.materials.len(), 1);
}

#[test]
fn a_missing_library_or_material_is_a_warning() {
    let (data, report) = read_with(&model("usemtl red\nf 1 2 3\n"), &[]).unwrap();
    assert!(data.materials.is_empty());
    assert!(report.lines()[0].contains("a.mtl: no such file (m.obj:1)"), "{:?}", report.lines());
    let (data, report) = read_with(&model("usemtl blue\nf 1 2 3\n"), &[("a.mtl", LIBRARY)]).unwrap();
    assert_eq!(data.materials[0].color, Material::DEFAULT_COLOR);
    assert_eq!(report.count("materials that no library has get the default look"), 1);
}

#[test]
fn libraries_may_have_blanks_in_their_names_or_be_several() {
    let text = "mtllib my colours.mtl\nmtllib a.mtl  b.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl x\nf 1 2 3\nusemtl y\nf 1 2 3\nusemtl z\nf 1 2 3\n";
    let files = [
        ("my colours.mtl", "newmtl x\nKd 1 0 0\n"),
        ("a.mtl", "newmtl y\nKd 0 1 0\n"),
        ("b.mtl", "newmtl z\nKd 0 0 1\nnewmtl x\nKd 1 1 1\n"),
    ];
    let (data, report) = read_with(text, &files).unwrap();
    let colors = data.materials.iter().map(|m| m.color.to_srgb8()).collect::<Vec<_>>();
    assert_eq!(colors, [[255, 0, 0], [0, 255, 0], [0, 0, 255]], "the first of a name wins");
    assert!(report.is_empty(), "{:?}", report.lines());
    let (_, report) = read_with(text, &files[..2]).unwrap();
    assert!(report.lines().iter().any(|l| l.contains("b.mtl: no such file (m.obj:2)")), "{:?}", report.lines());
}
