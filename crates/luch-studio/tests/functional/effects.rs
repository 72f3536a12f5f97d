//! Tests 11 and 12: antialiasing and depth of field.

use crate::everywhere;
use crate::support::reference::Reference;
use luch_scene::{Positive, RayCount, Sampling};

/// An effect with 64 rays.
fn with_64_rays() -> Sampling {
    Sampling { on: true, rays: RayCount::new(64).unwrap() }
}

#[test]
fn test_11_antialiasing_makes_edges_smooth() {
    let size = [160, 120];
    let rough = Reference::new("two-spheres", 2, size, |_| {});
    let expected = Reference::new("two-spheres", 2, size, |scene| scene.settings.antialiasing = with_64_rays());
    // Where two neighbours show a sphere and a wall of clearly another brightness, at least one of them now lies between.
    let is_sphere = |i: usize| rough.name_at(i).ends_with(" sphere");
    let (mut edges, mut between) = (0, 0);
    for a in (0..rough.picture.pixels.len()).filter(|i| (i + 1) % size[0] as usize != 0) {
        let before = [a, a + 1].map(|i| rough.picture.luminance(i));
        let contrast = before[1] - before[0];
        if is_sphere(a) == is_sphere(a + 1) || contrast.abs() < 0.05 {
            continue;
        }
        let after = [a, a + 1].map(|i| (expected.picture.luminance(i) - before[0]) / contrast);
        edges += 1;
        between += u32::from(after.iter().any(|part| (0.1..0.9).contains(part)));
    }
    assert!(edges > 40, "{edges} edges");
    assert!(between * 10 >= edges * 9, "{between} of {edges} edges are smooth");

    let name = &rough.scene.cameras[1].name;
    everywhere(|desk| {
        desk.change(|desk| desk.resize(size[0], size[1]));
        desk.change(|desk| desk.choose(desk.words.camera, name));
        desk.render();
        rough.assert_shown(desk);
        desk.change(|desk| {
            desk.tick(desk.words.antialiasing);
            desk.type_into(desk.words.rays_per_pixel, "64");
        });
        desk.render();
        expected.assert_shown(desk);
    });
}

#[test]
fn test_12_depth_of_field_blurs_what_is_not_at_distance_4() {
    let size = [240, 135];
    let focused = |distance: Option<f32>| {
        Reference::new("knight", 1, size, |scene| {
            scene.cameras[0].focal_distance = distance.map(|d| Positive::new(d).unwrap());
            scene.settings.depth_of_field = with_64_rays();
        })
    };
    let sharp = Reference::new("knight", 1, size, |_| {});
    let (elsewhere, expected) = (focused(Some(2.5)), focused(Some(4.0)));
    // What is left of the steps between neighbours, where both are in a range of distances.
    let kept = |in_range: &dyn Fn(f32) -> bool| {
        let both = |i: usize| in_range(sharp.distance(i)) && in_range(sharp.distance(i + 1));
        let pairs: Vec<usize> =
            (0..sharp.picture.pixels.len() - 1).filter(|i| (i + 1) % 240 != 0 && both(*i)).collect();
        let energy = |r: &Reference| {
            pairs.iter().map(|&i| (r.picture.luminance(i + 1) - r.picture.luminance(i)).powi(2)).sum::<f64>()
        };
        assert!(pairs.len() > 500, "{} pairs", pairs.len());
        energy(&expected) / energy(&sharp)
    };
    let (focus, near, far) = (kept(&|z| (z - 4.0).abs() < 0.15), kept(&|z| z < 3.55), kept(&|z| z > 5.5));
    assert!(focus > 0.6, "sharp at 4: {focus}");
    assert!(near < 0.5 && far < 0.5, "blurred before and behind: {near} {far}");

    everywhere(|desk| {
        desk.choose(desk.words.scene, desk.words.knight);
        desk.change(|desk| desk.resize(size[0], size[1]));
        desk.render();
        sharp.assert_shown(desk);
        desk.change(|desk| desk.tick(desk.words.depth_of_field));
        // The scene's own distance is 4 already: only another one before shows that it is set.
        desk.change(|desk| desk.type_into(desk.words.focal_distance, "2.5"));
        desk.render();
        elsewhere.assert_shown(desk);
        desk.change(|desk| desk.type_into(desk.words.focal_distance, "4"));
        desk.render();
        expected.assert_shown(desk);
    });
}
