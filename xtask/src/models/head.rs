//! Setting a carved head (a field) onto a turned body (a lathe mesh) without a seam.

use std::collections::BTreeMap;

use glam::DVec3;

use super::contour::{Grid, Surface, contour};
use super::field::Field;
use super::lathe::Turned;
use super::mesh::{Face, Mesh, index};
use super::simplify::{Budget, simplify};
use super::zip::{Corner, zip};

/// Contours `field` above the body's rim, zips it on, simplifies it and gives it normals.
///
/// Where a face leans more than `crease` degrees from the field's normal the edge is sharp.
///
/// The field must continue the body's outline around the rim, and the rim must lie one cell or more below `grid.min.y`.
#[must_use]
pub fn attach(body: Turned, field: &dyn Field, grid: &Grid, budget: Budget, crease: f64) -> Mesh {
    let Turned { mut mesh, rim } = body;
    let head = contour(field, grid);

    // Number the rim first, then the head, and close the gap between them.
    let rim_count = rim.len();
    let mut positions: Vec<DVec3> = rim.iter().map(|c| mesh.positions[c.v as usize]).collect();
    let mut triangles: Vec<[u32; 3]> = head.triangles.iter().map(|t| t.map(|i| i + index(rim_count))).collect();
    let above: Vec<Corner> = boundary(&triangles, &head.positions, index(rim_count));
    positions.extend(head.positions);
    let below: Vec<Corner> = rim.iter().enumerate().map(|(i, c)| Corner { v: index(i), n: 0, turn: c.turn }).collect();
    let mut strip = Vec::new();
    zip(&below, &above, &mut strip);
    triangles.extend(strip.iter().map(|f| f.v));

    let simple = simplify(field, Surface { positions, triangles }, rim_count, budget);

    // Move the result into the mesh.
    let ids: Vec<u32> = (0..simple.positions.len())
        .map(|i| if i < rim_count { rim[i].v } else { mesh.add_position(simple.positions[i]) })
        .collect();
    let corners = normals(field, &simple, crease, &rim, &mut mesh);
    mesh.faces.extend(simple.triangles.iter().zip(corners).map(|(t, n)| Face { v: t.map(|i| ids[i as usize]), n }));
    mesh
}

/// The open loop of the head, sorted by angle.
fn boundary(triangles: &[[u32; 3]], positions: &[DVec3], first: u32) -> Vec<Corner> {
    let mut edges: BTreeMap<(u32, u32), u32> = BTreeMap::new();
    for t in triangles {
        for i in 0..3 {
            *edges.entry((t[i], t[(i + 1) % 3])).or_insert(0) += 1;
        }
    }
    let next: BTreeMap<u32, u32> =
        edges.keys().filter(|(a, b)| !edges.contains_key(&(*b, *a))).map(|(a, b)| (*b, *a)).collect();
    let turn = |v: u32| {
        let p = positions[(v - first) as usize];
        let turn = libm::atan2(p.z, p.x) / std::f64::consts::TAU;
        if turn < 0.0 { turn + 1.0 } else { turn }
    };
    let Some(start) = next.keys().copied().min_by(|a, b| turn(*a).total_cmp(&turn(*b))) else { return Vec::new() };
    // Seen from outside the loop's edges run towards smaller angles, so `next` runs backwards along them. The loop is
    // followed as the mesh has it, so that a small step back in angle does no harm.
    let mut ring = Vec::new();
    let mut v = start;
    let (mut previous, mut wraps) = (turn(start), 0.0);
    loop {
        let raw = turn(v);
        if previous - raw > 0.5 {
            wraps += 1.0;
        } else if raw - previous > 0.5 {
            wraps -= 1.0;
        }
        previous = raw;
        ring.push(Corner { v, n: 0, turn: raw + wraps });
        v = next[&v];
        if v == start || ring.len() > next.len() {
            break;
        }
    }
    assert_eq!(ring.len(), next.len(), "the head must be open along one loop");
    ring
}

/// A normal for every corner: the field's gradient, or, at a crease, the mean of the faces on the same side of it.
fn normals(field: &dyn Field, surface: &Surface, crease: f64, rim: &[Corner], mesh: &mut Mesh) -> Vec<[u32; 3]> {
    let rim_count = rim.len();
    let crease = libm::cos(crease.to_radians());
    let area = |t: &[u32; 3]| {
        let [a, b, c] = t.map(|i| surface.positions[i as usize]);
        (b - a).cross(c - a)
    };
    let sides: Vec<DVec3> = surface.triangles.iter().map(area).collect();
    let mut faces_of: Vec<Vec<(u32, u8)>> = vec![Vec::new(); surface.positions.len()];
    for (f, t) in surface.triangles.iter().enumerate() {
        for k in 0..3u8 {
            faces_of[t[usize::from(k)] as usize].push((index(f), k));
        }
    }
    let mut corners = vec![[0; 3]; surface.triangles.len()];
    for (v, faces) in faces_of.iter().enumerate() {
        let smooth = if v < rim_count {
            mesh.normals[rim[v].n as usize]
        } else {
            field.gradient(surface.positions[v]).normalize_or_zero()
        };
        let agrees = |f: u32| sides[f as usize].normalize_or_zero().dot(smooth) > crease;
        if faces.iter().all(|(f, _)| agrees(*f)) {
            let n = if v < rim_count { rim[v].n } else { mesh.add_normal(smooth) };
            for (f, k) in faces {
                corners[*f as usize][usize::from(*k)] = n;
            }
            continue;
        }
        for (f, k) in faces {
            let side = sides[*f as usize].normalize_or_zero();
            let mean: DVec3 = faces
                .iter()
                .map(|(g, _)| sides[*g as usize])
                .filter(|s| s.normalize_or_zero().dot(side) > crease)
                .sum();
            corners[*f as usize][usize::from(*k)] = mesh.add_normal(mean.normalize_or_zero());
        }
    }
    corners
}
