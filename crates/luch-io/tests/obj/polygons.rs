//! Polygons in triangles: they cover the polygon, once, and nothing else.

use super::{good, read};
use luch_io::obj::triangulate::{self, EFFORT, Triangulation};
use proptest::prelude::*;
use std::fmt::Write;
use std::time::Instant;

fn cut(outline: &[[f32; 3]]) -> Triangulation {
    let mut effort = EFFORT;
    triangulate::polygon(outline, &mut effort)
}

fn flat(points: &[[f64; 2]]) -> Vec<[f32; 3]> {
    points.iter().map(|[x, y]| [*x as f32, *y as f32, 0.0]).collect()
}

fn area(points: impl IntoIterator<Item = [f32; 3]>) -> f64 {
    let points: Vec<[f64; 2]> = points.into_iter().map(|[x, y, _]| [x as f64, y as f64]).collect();
    let next = points.iter().cycle().skip(1);
    points.iter().zip(next).map(|([ax, ay], [bx, by])| (ax * by - ay * bx) * 0.5).sum()
}

/// Every triangle counter-clockwise, their areas the polygon's: then they overlap nowhere and stick out nowhere.
fn assert_covers(outline: &[[f32; 3]], what: &str) {
    let result = cut(outline);
    assert!(!result.is_tangled, "{what}");
    assert_eq!(result.triangles.len(), outline.len() - 2, "{what}");
    let areas = result.triangles.iter().map(|t| area(t.map(|i| outline[i as usize])));
    let whole = area(outline.iter().copied());
    assert!(areas.clone().all(|a| a >= 0.0), "{what}: no triangle is turned over");
    assert!((areas.sum::<f64>() - whole).abs() < 1e-6 * whole, "{what}");
    let mut seen = vec![false; outline.len()];
    result.triangles.iter().flatten().for_each(|i| seen[*i as usize] = true);
    assert!(seen.iter().all(|s| *s), "{what}: every corner is used");
}

/// A star-shaped outline about the origin with the given radii.
fn star(radii: &[f64]) -> Vec<[f64; 2]> {
    let step = std::f64::consts::TAU / radii.len() as f64;
    radii.iter().enumerate().map(|(i, r)| [r * (i as f64 * step).cos(), r * (i as f64 * step).sin()]).collect()
}

fn comb(teeth: usize) -> Vec<[f64; 2]> {
    let mut points = vec![[0.0, 0.0], [teeth as f64, 0.0]];
    for i in (0..teeth).rev() {
        points.extend([[i as f64 + 0.9, 10.0], [i as f64 + 0.1, 1.0]]);
    }
    points
}

fn spiral(corners: usize) -> Vec<[f64; 2]> {
    let half = corners / 2;
    let at = |i: usize, r: f64| {
        let angle = i as f64 * 0.05;
        [(angle + r) * angle.cos(), (angle + r) * angle.sin()]
    };
    let outer = (0..half).map(|i| at(i + 200, 1.5));
    outer.chain((0..half).rev().map(|i| at(i + 200, 0.0))).collect()
}

#[test]
fn concave_outlines_are_covered() {
    let arrow = [[0.0, 0.0], [2.0, 1.0], [0.0, 2.0], [1.0, 1.0]];
    for turn in 0..4 {
        let mut arrow = arrow;
        arrow.rotate_left(turn);
        assert_covers(&flat(&arrow), "arrow");
    }
    assert_covers(&flat(&[[0.0, 0.0], [3.0, 0.0], [3.0, 1.0], [1.0, 1.0], [1.0, 3.0], [0.0, 3.0]]), "L");
    assert_covers(&flat(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 2.0], [1.0, 2.0], [0.0, 2.0]]), "straight corners");
    assert_covers(&flat(&star(&[1.0, 0.3].repeat(50))), "star");
    assert_covers(&flat(&comb(40)), "comb");
    assert_covers(&flat(&spiral(400)), "spiral");
}

#[test]
fn a_hole_joined_by_a_bridge_stays_a_hole() {
    // A square with a square hole: the bridge runs from corner (0, 0) to (1, 1) and back.
    let outline = [
        [0.0, 0.0],
        [3.0, 0.0],
        [3.0, 3.0],
        [0.0, 3.0],
        [0.0, 0.0],
        [1.0, 1.0],
        [1.0, 2.0],
        [2.0, 2.0],
        [2.0, 1.0],
        [1.0, 1.0],
    ];
    assert_covers(&flat(&outline), "bridge");
    let mut text = String::new();
    for [x, y] in &outline[..4] {
        writeln!(text, "v {x} {y} 0").unwrap();
    }
    text.push_str("v 1 1 0\nv 1 2 0\nv 2 2 0\nv 2 1 0\nf 1 2 3 4 1 5 6 7 8 5\n");
    let (mesh, report) = good(&text);
    let areas = mesh.triangles().iter().map(|t| area(t.map(|i| mesh.positions()[i as usize])));
    assert!((areas.sum::<f64>() - 8.0).abs() < 1e-9);
    assert!(report.is_empty(), "{:?}", report.lines());
}

#[test]
fn outlines_that_cross_themselves_end_with_a_warning() {
    let pentagram = star(&[1.0; 5]);
    let crossed: Vec<[f64; 2]> = [0, 2, 4, 1, 3].map(|i: usize| pentagram[i]).to_vec();
    assert_eq!(cut(&flat(&crossed)).triangles.len(), 3);
    let bow_tie = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0], [-1.0, 0.5]];
    assert_eq!(cut(&flat(&bow_tie)).triangles.len(), 3);
    for same in [[[0.0, 0.0]; 6], [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [2.0, 0.0], [1.0, 0.0]]] {
        assert_eq!(cut(&flat(&same)).triangles.len(), 4, "without area, and without an end to wait for");
    }
    let (_, report) = read("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n").unwrap();
    assert_eq!(report.count("polygons that cross themselves are filled as well as can be"), 1);
}

#[test]
fn the_largest_polygons_take_seconds_at_most() {
    let n = 20_000;
    let noise = |i: usize| 1.0 + ((i * 7919) % 1000) as f64 / 500.0;
    let random: Vec<f64> = (0..n).map(noise).collect();
    let tangled: Vec<[f64; 2]> =
        (0..n).map(|i| [((i * 7919) % 10_007) as f64, ((i * 104_729) % 10_009) as f64]).collect();
    for (what, points, simple) in [
        ("convex", star(&vec![1000.0; n]), false),
        ("star", star(&random), true),
        ("needles", star(&[1.0, 1000.0].repeat(n / 2)), true),
        ("comb", comb(n / 2 - 1), true),
        ("spiral", spiral(n), true),
        ("tangled", tangled, false),
    ] {
        let outline = flat(&points);
        let start = Instant::now();
        if simple {
            assert_covers(&outline, what);
        } else {
            assert_eq!(cut(&outline).triangles.len(), n - 2);
        }
        assert!(start.elapsed().as_secs_f32() < 5.0, "{what}: {:?}", start.elapsed());
    }
}

proptest! {
    #[test]
    fn any_star_in_any_plane(
        radii in proptest::collection::vec(0.1_f64..1.0, 5..80),
        scale in prop_oneof![Just(1e-3_f64), Just(1.0), Just(1e6)],
        axis in 0_usize..3, slope in -1.0_f32..1.0, back in any::<bool>(),
    ) {
        let points: Vec<[f64; 2]> = star(&radii).into_iter().map(|p| p.map(|c| c * scale)).collect();
        // Lifted to a sloping plane, with the axes changed round.
        let lift = |[x, y]: [f64; 2]| {
            let (x, y) = (x as f32, y as f32);
            let mut p = [x, y, slope * x];
            p.rotate_right(axis);
            p
        };
        let mut outline: Vec<[f32; 3]> = points.iter().copied().map(lift).collect();
        let mut in_plane = flat(&points);
        if back {
            outline.reverse();
            in_plane.reverse();
        }
        let result = cut(&outline);
        prop_assert!(!result.is_tangled);
        prop_assert_eq!(result.triangles.len(), radii.len() - 2);
        let sign = if back { -1.0 } else { 1.0 };
        let areas: Vec<f64> = result.triangles.iter().map(|t| sign * area(t.map(|i| in_plane[i as usize]))).collect();
        let whole = sign * area(in_plane.iter().copied());
        prop_assert!(areas.iter().all(|a| *a >= -1e-6 * whole));
        prop_assert!((areas.iter().sum::<f64>() - whole).abs() < 1e-5 * whole);
    }

    #[test]
    fn any_points_at_all_end(points in proptest::collection::vec(
        (prop_oneof![-1e9_f32..1e9, Just(0.0), Just(1.0)], prop_oneof![-1.0_f32..1.0, Just(0.0)]), 4..60,
    )) {
        let points: Vec<[f32; 3]> = points.into_iter().map(|(x, y)| [x, y, 0.5]).collect();
        let result = cut(&points);
        prop_assert_eq!(result.triangles.len(), points.len() - 2);
        prop_assert!(result.triangles.iter().flatten().all(|i| (*i as usize) < points.len()));
    }
}
