//! How fast models are read: a bumpy sphere of a million triangles, written as files in the wild write it.
//!
//! `cargo bench -p luch-verify --bench obj_reading`. The figure is bytes of text per second on one core, normals and all.

use divan::{Bencher, counter::BytesCount};
use luch_io::budget::Budget;
use luch_io::{Error, ErrorKind, Report, obj};
use std::fmt::Write;
use std::path::Path;

fn main() {
    divan::main();
}

/// How the file is written.
#[derive(Debug, Clone, Copy)]
enum Form {
    /// `f 1 2 3`, no normals: they are computed with the crease angle.
    Bare,
    /// The same with `s 1`.
    Smooth,
    /// `f 1//1 2//2 3//3` with a normal for each vertex.
    Normals,
    /// `f 1/1/1 2/2/2 3/3/3` with texture coordinates too.
    Everything,
    /// Faces of four corners.
    Quads,
}

const FORMS: [Form; 5] = [Form::Bare, Form::Smooth, Form::Normals, Form::Everything, Form::Quads];

/// A sphere of `2 * rows * columns` triangles, with six decimals.
fn model(form: Form, rows: u32, columns: u32) -> String {
    let mut text = String::from("# bumpy sphere\no sphere\n");
    for row in 0..=rows {
        for column in 0..columns {
            let polar = f64::from(row) / f64::from(rows) * std::f64::consts::PI;
            let around = f64::from(column) / f64::from(columns) * std::f64::consts::TAU;
            let (s, c) = polar.sin_cos();
            let (sin, cos) = around.sin_cos();
            let n = [s * sin, c, s * cos];
            let r = 1.0 + 0.01 * (40.0 * n[0]).sin() * (40.0 * n[1]).sin();
            let [x, y, z] = n.map(|c| c * r);
            writeln!(text, "v {x:.6} {y:.6} {z:.6}").expect("a string takes all");
            if matches!(form, Form::Everything) {
                writeln!(text, "vt {:.6} {:.6}", around / 6.3, polar / 3.2).expect("a string takes all");
            }
            if matches!(form, Form::Normals | Form::Everything) {
                let [x, y, z] = n;
                writeln!(text, "vn {x:.4} {y:.4} {z:.4}").expect("a string takes all");
            }
        }
    }
    if matches!(form, Form::Smooth) {
        text.push_str("s 1\n");
    }
    let corner = |row: u32, column: u32| {
        let i = row * columns + column % columns + 1;
        match form {
            Form::Normals => format!("{i}//{i}"),
            Form::Everything => format!("{i}/{i}/{i}"),
            _ => i.to_string(),
        }
    };
    for row in 0..rows {
        for column in 0..columns {
            let [a, b] = [corner(row, column), corner(row, column + 1)];
            let [d, c] = [corner(row + 1, column), corner(row + 1, column + 1)];
            match form {
                Form::Quads => writeln!(text, "f {a} {d} {c} {b}"),
                _ => writeln!(text, "f {a} {d} {c}\nf {a} {c} {b}"),
            }
            .expect("a string takes all");
        }
    }
    text
}

#[divan::bench(args = FORMS, sample_count = 10)]
fn million_triangles(bencher: Bencher<'_, '_>, form: Form) {
    let text = model(form, 500, 1000);
    bencher.counter(BytesCount::of_str(&text)).with_inputs(|| text.clone().into_bytes()).bench_values(|bytes| {
        let mut no_library = |name: &str, _: &mut Budget| Err(Error::new(ErrorKind::Forbidden, name, "no such file"));
        let mut budget = Budget::new(8 << 30);
        obj::read(bytes, Path::new("sphere.obj"), &mut no_library, &mut budget, &mut Report::default())
            .expect("a good model")
    });
}
