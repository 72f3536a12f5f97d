//! Random meshes, written in random spellings and read back.

use super::read;
use proptest::prelude::*;
use std::fmt::Write;

#[derive(Debug, Clone)]
struct Model {
    positions: Vec<[f32; 3]>,
    normals: Vec<[f32; 3]>,
    triangles: Vec<[u32; 3]>,
    normal_triangles: Vec<[u32; 3]>,
}

fn model() -> impl Strategy<Value = Model> {
    let coordinate = || prop_oneof![-1e9_f32..1e9, -1.0_f32..1.0, -1e-30_f32..1e-30, Just(-0.0)];
    let point = move || [coordinate(), coordinate(), coordinate()];
    (proptest::collection::vec(point(), 3..40), proptest::collection::vec(point(), 1..20)).prop_flat_map(|(p, n)| {
        let (vertices, normals) = (p.len() as u32, n.len() as u32);
        let face = (0..vertices, 1..vertices, any::<u32>()).prop_filter_map("three corners", move |(a, step, c)| {
            let (b, c) = ((a + step) % vertices, c % vertices);
            (a != c && b != c).then_some([a, b, c])
        });
        let faces = proptest::collection::vec((face, [0..normals, 0..normals, 0..normals]), 1..60);
        faces.prop_map(move |faces| Model {
            positions: p.clone(),
            normals: n.clone(),
            triangles: faces.iter().map(|f| f.0).collect(),
            normal_triangles: faces.iter().map(|f| f.1).collect(),
        })
    })
}

/// Writes the model; each bit of `choices` picks one of two spellings.
fn write(model: &Model, mut choices: u64) -> String {
    let mut pick = || {
        choices = choices.rotate_left(1).wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ 0x55;
        choices & 1 == 1
    };
    let end = |pick: &mut dyn FnMut() -> bool| match (pick(), pick()) {
        (true, true) => "\r\n",
        (true, false) => " # end\n",
        (false, true) => "\r",
        (false, false) => "\n",
    };
    let mut text = String::new();
    for (word, list) in [("v", &model.positions), ("vn", &model.normals)] {
        for [x, y, z] in list {
            let line = if pick() { format!("{word} {x} {y} {z}") } else { format!("{word}\t{x:e}  {y} \\\n {z:e} ") };
            text.push_str(&line);
            text.push_str(end(&mut pick));
        }
    }
    let (vertices, normals) = (model.positions.len() as i64, model.normals.len() as i64);
    for (triangle, normal) in model.triangles.iter().zip(&model.normal_triangles) {
        text.push('f');
        for (v, n) in triangle.iter().zip(normal) {
            let v = if pick() { i64::from(*v) + 1 } else { i64::from(*v) - vertices };
            let n = if pick() { i64::from(*n) + 1 } else { i64::from(*n) - normals };
            let slot = if pick() { "7" } else { "" };
            write!(text, " {v}/{slot}/{n}").unwrap();
        }
        text.push_str(end(&mut pick));
    }
    text
}

proptest! {
    #[test]
    fn what_was_written_is_read(model in model(), choices in any::<u64>()) {
        let text = write(&model, choices);
        let (data, _) = read(&text).unwrap_or_else(|e| panic!("{e}\n{text}"));
        let bits = |list: &[[f32; 3]]| list.iter().map(|p| p.map(f32::to_bits)).collect::<Vec<_>>();
        prop_assert_eq!(bits(&data.positions), bits(&model.positions));
        prop_assert_eq!(bits(&data.normals), bits(&model.normals));
        prop_assert_eq!(data.normal_triangles.as_ref().unwrap_or(&data.triangles), &model.normal_triangles);
        prop_assert_eq!(&data.triangles, &model.triangles);
    }
}
