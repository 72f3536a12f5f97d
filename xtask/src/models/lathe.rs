//! Turning an outline into a mesh: rings around the y axis, with fewer segments where the radius is small.

use glam::DVec3;

use super::mesh::Mesh;
use super::profile::{Profile, Sample};
use super::zip::{Corner, zip};

/// A turned mesh that is still open at its last ring unless the outline ends on the axis.
pub struct Turned {
    /// The mesh so far.
    pub mesh: Mesh,
    /// The last ring, smooth normals of the outline's end.
    pub rim: Vec<Corner>,
}

/// Segments of a ring of this radius (millimetres): the chord stays within 0.01 mm of the circle.
fn segments(radius: f64) -> usize {
    match radius {
        r if r < 1e-6 => 1,
        r if r < 0.4 => 12,
        r if r < 1.6 => 24,
        r if r < 4.2 => 48,
        r if r < 9.0 => 72,
        _ => 96,
    }
}

/// Turns `profile` about the y axis. An outline that starts on the axis is closed there, likewise at its end.
#[must_use]
pub fn turn(profile: &Profile) -> Turned {
    let mut mesh = Mesh::default();
    let mut rim: Vec<Corner> = Vec::new();
    for (k, sample) in profile.samples().iter().enumerate() {
        let (before, after) = ring(&mut mesh, sample);
        if k > 0 {
            zip(&rim, &before, &mut mesh.faces);
        }
        rim = after;
    }
    Turned { mesh, rim }
}

/// Adds the ring of a sample: its corners as the part before and the part after see them.
fn ring(mesh: &mut Mesh, sample: &Sample) -> (Vec<Corner>, Vec<Corner>) {
    let count = segments(sample.point.x);
    let smooth = sample.normal_before == sample.normal_after;
    let mut before = Vec::with_capacity(count);
    let mut after = Vec::with_capacity(count);
    for i in 0..count {
        let turn = i as f64 / count as f64;
        let (sin, cos) = libm::sincos(turn * std::f64::consts::TAU);
        let around = |r: f64, y: f64| DVec3::new(r * cos, y, r * sin);
        let v = mesh.add_position(around(sample.point.x, sample.point.y));
        let unit = |n: glam::DVec2| if count == 1 { DVec3::new(0.0, n.y.signum(), 0.0) } else { around(n.x, n.y) };
        let n = mesh.add_normal(unit(sample.normal_before));
        before.push(Corner { v, n, turn });
        let n = if smooth { n } else { mesh.add_normal(unit(sample.normal_after)) };
        after.push(Corner { v, n, turn });
    }
    (before, after)
}
