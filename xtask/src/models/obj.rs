//! Writing a mesh as Wavefront OBJ text, in board squares.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use super::SQUARE;
use super::mesh::Mesh;

/// Decimals of a coordinate: 1e-5 of a square is 0.6 micrometres of a tournament set.
const POSITION_DIGITS: i32 = 5;
/// Decimals of a normal: the length stays within 1e-4 of one.
const NORMAL_DIGITS: i32 = 4;

/// The text of the OBJ file. Normals that agree in all their digits share a line.
#[must_use]
pub fn write(name: &str, mesh: &Mesh) -> String {
    let mut out = String::new();
    let _ = writeln!(out, "# Luch chess set: {name}. Made by `cargo xtask models`; do not edit.");
    let _ = writeln!(
        out,
        "# Unit: one board square (57 mm of a tournament set). +y up, bottom face centred on the origin."
    );
    let _ = writeln!(out, "o {name}");
    for p in &mesh.positions {
        let [x, y, z] = (*p / SQUARE).to_array().map(|c| fixed(c, POSITION_DIGITS));
        let _ = writeln!(
            out,
            "v {} {} {}",
            decimal(x, POSITION_DIGITS),
            decimal(y, POSITION_DIGITS),
            decimal(z, POSITION_DIGITS)
        );
    }
    let mut lines: BTreeMap<[i64; 3], usize> = BTreeMap::new();
    let mut line_of = Vec::with_capacity(mesh.normals.len());
    for n in &mesh.normals {
        let key = n.to_array().map(|c| fixed(c, NORMAL_DIGITS));
        let next = lines.len() + 1;
        let line = *lines.entry(key).or_insert(next);
        if line == next {
            let [x, y, z] = key.map(|c| decimal(c, NORMAL_DIGITS));
            let _ = writeln!(out, "vn {x} {y} {z}");
        }
        line_of.push(line);
    }
    for face in &mesh.faces {
        out.push('f');
        for (v, n) in face.v.iter().zip(face.n) {
            let _ = write!(out, " {}//{}", v + 1, line_of[n as usize]);
        }
        out.push('\n');
    }
    out
}

/// The nearest multiple of 10^-digits, as an integer.
fn fixed(value: f64, digits: i32) -> i64 {
    #[allow(clippy::cast_possible_truncation, reason = "a few metres in micrometres fit i64")]
    let rounded = libm::round(value * 10f64.powi(digits)) as i64;
    rounded
}

/// A fixed-point number as the shortest decimal text: no trailing zeros, no minus zero.
fn decimal(value: i64, digits: i32) -> String {
    let scale = 10u64.pow(digits.unsigned_abs());
    let magnitude = value.unsigned_abs();
    let sign = if value < 0 { "-" } else { "" };
    let fraction = format!("{:0width$}", magnitude % scale, width = digits.unsigned_abs() as usize);
    let fraction = fraction.trim_end_matches('0');
    if fraction.is_empty() {
        format!("{sign}{}", magnitude / scale)
    } else {
        format!("{sign}{}.{fraction}", magnitude / scale)
    }
}

#[cfg(test)]
mod tests {
    use super::{decimal, fixed};

    #[test]
    fn decimals_are_short_and_exact() {
        assert_eq!(decimal(fixed(-0.500_001, 5), 5), "-0.5");
        assert_eq!(decimal(fixed(-0.000_001, 5), 5), "0");
        assert_eq!(decimal(fixed(12.030_04, 5), 5), "12.03004");
        assert_eq!(decimal(fixed(1.0, 4), 4), "1");
    }
}
