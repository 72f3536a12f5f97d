//! Tests 11 and 12: antialiasing and depth of field.

use crate::geometry::View;
use crate::lab::{Lab, scene};
use crate::picture::Picture;

#[test]
fn test_11_antialiasing_makes_edges_smooth_and_leaves_areas_alone() {
    let size = [160, 120];
    let lab = Lab::new(size);
    let (png, smooth, rough) = (lab.png(11), lab.linear(11, ""), lab.linear(4, ""));
    let objects = lab.objects(11);
    let is_sphere = |i: usize| objects.name_at(i).ends_with(" sphere");

    // Edges: where two neighbours show a sphere and a wall of clearly another brightness, at least one of them now lies
    // between; and the PNG shows it.
    let (mut edges, mut between, mut beyond) = (0, 0, 0);
    for a in (0..size[0] * size[1]).filter(|i| (i + 1) % size[0] != 0) {
        let b = a + 1;
        let contrast = rough.luminance(b) - rough.luminance(a);
        if is_sphere(a) == is_sphere(b) || contrast.abs() < 0.05 {
            continue;
        }
        edges += 1;
        let places = [a, b].map(|i| (smooth.luminance(i) - rough.luminance(a)) / contrast);
        between += u32::from(places.iter().any(|p| (0.1..0.9).contains(p)));
        beyond += u32::from(places.iter().any(|p| !(-0.3..1.3).contains(p)));
        assert!((png.luminance(a) - smooth.luminance(a).min(1.0)).abs() < 1e-3);
    }
    assert!(edges > 40, "{edges} edges");
    assert!(between * 10 >= edges * 9, "{between} of {edges} edges are smooth");
    assert!(beyond * 10 <= edges, "{beyond} of {edges} edges overshoot");

    // Areas: where one object of one shade fills the surroundings, nothing changes.
    let mut flat = 0;
    for y in 2..size[1] - 2 {
        for x in 2..size[0] - 2 {
            let around = || (y - 2..=y + 2).flat_map(move |y| (x - 2..=x + 2).map(move |x| y * size[0] + x));
            let i = y * size[0] + x;
            let range = around().map(|j| (rough.luminance(j) - rough.luminance(i)).abs()).fold(0.0, f64::max);
            if range > 0.01 || around().any(|j| objects.seen[j] != objects.seen[i]) {
                continue;
            }
            flat += 1;
            assert!(smooth.difference(&rough, i) < 0.01, "{x}, {y}: {}", smooth.difference(&rough, i));
        }
    }
    assert!(flat > 2000, "{flat} flat pixels");
}

#[test]
fn test_12_depth_of_field_is_sharp_at_distance_4_and_blurs_elsewhere() {
    let size = [320, 240];
    let lab = Lab::new(size);
    let (blurred, sharp, objects) = (lab.linear(12, ""), lab.linear(3, ""), lab.objects(12));
    let scene = scene("knight");
    let view = View::new(&scene.cameras[0], size);

    // The depth view is s / (s + t): s from the floor at y = 0, whose t is known.
    let depth = lab.linear(3, "--integrator depth");
    let scales = objects.of("Floor").into_iter().map(|i| {
        let (ray, v) = (view.ray(i), f64::from(depth.pixels[i][0]));
        -ray.origin.y / ray.direction.y * v / (1.0 - v)
    });
    let scales: Vec<f64> = scales.collect();
    let s = scales[scales.len() / 2];
    assert!(scales.iter().all(|other| (other / s - 1.0).abs() < 1e-3), "the depth view measures along the ray");
    let z = |i: usize| {
        let v = f64::from(depth.pixels[i][0]);
        view.depth(i, s * (1.0 / v - 1.0))
    };

    // What is left of the steps between neighbours, where both are in a range of distances.
    let kept = |in_range: &dyn Fn(f64) -> bool| {
        let pairs = (0..size[0] * size[1]).filter(|i| (i + 1) % size[0] != 0);
        let pairs: Vec<usize> = pairs.filter(|&i| in_range(z(i)) && in_range(z(i + 1))).collect();
        let energy = |p: &Picture| pairs.iter().map(|&i| (p.luminance(i + 1) - p.luminance(i)).powi(2)).sum::<f64>();
        assert!(pairs.len() > 1000 && energy(&sharp) > 0.5, "{} pairs, {}", pairs.len(), energy(&sharp));
        energy(&blurred) / energy(&sharp)
    };
    let focus = kept(&|z| (z - 4.0).abs() < 0.15);
    let near = kept(&|z| z < 3.55);
    let far = kept(&|z| z > 5.5);
    assert!(focus > 0.75, "sharp at 4: {focus}");
    assert!(near < 0.4 && far < 0.4, "blurred before and behind: {near} {far}");

    let png = lab.png(12);
    let same = |i: usize| (0..3).all(|c| (png.pixels[i][c] - blurred.pixels[i][c].min(1.0)).abs() < 1e-4);
    assert!((0..png.pixels.len()).all(same), "the PNG is the linear picture");
}
