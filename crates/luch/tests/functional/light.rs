//! Tests 10, 13 and 14: intensity and gloss obey the lighting sum.

use crate::geometry::{Ray, View, first_sphere, spheres, terms};
use crate::lab::{Lab, scene};
use crate::picture::Picture;

const SIZE: [usize; 2] = [160, 120];
const BOTH: [&str; 2] = ["Left sphere", "Right sphere"];

#[test]
fn test_10_at_80_percent_what_the_lamp_adds_grows_in_proportion() {
    let lab = Lab::new(SIZE);
    let (first, png) = (lab.png(1), lab.png(10));
    for i in first.all() {
        assert!((0..3).all(|c| png.pixels[i][c] >= first.pixels[i][c]), "nothing is darker");
    }

    let (ambient, before, after) = (lab.linear(1, "--light-intensity 0"), lab.linear(1, ""), lab.linear(10, ""));
    let scene = scene("two-spheres");
    assert_eq!(scene.lights.len(), 1);
    let growth = 0.8 / f64::from(scene.lights[0].intensity.get());
    assert!(growth > 1.05, "the scene leaves room to make it brighter: {growth}");
    let mut lit = 0;
    for i in before.all() {
        for c in 0..3 {
            let [ambient, before, after] = [&ambient, &before, &after].map(|p| f64::from(p.pixels[i][c]));
            let (added, expected) = (after - ambient, (before - ambient) * growth);
            assert!((added - expected).abs() < 1e-5, "pixel {i}: {added}, not {expected}");
            lit += u32::from(before > ambient + 0.01);
        }
    }
    assert!(lit as usize > before.pixels.len(), "the lamp reaches a third of the picture at least");
    let mirrors = BOTH.iter().flat_map(|name| lab.objects(1).of(name)).count();
    assert!(mirrors > 2000, "mirrors are in it");
}

#[test]
fn test_13_without_gloss_and_reflection_the_spheres_are_matt() {
    let lab = Lab::new(SIZE);
    let (png, picture, objects) = (lab.png(13), lab.linear(13, ""), lab.objects(13));
    let scene = scene("two-spheres");
    let view = View::new(&scene.cameras[0], SIZE);
    let light = &scene.lights[0];
    let (mut lit, mut dark) = (0, 0);
    for sphere in spheres(&scene) {
        let object = &scene.objects[sphere.object];
        let base = object.material.color.unwrap().get().as_dvec3();
        let (ambient, color) = (f64::from(scene.ambient.get()), light.color.get().as_dvec3());
        for i in objects.of(&object.name) {
            let ray = view.ray(i);
            // At the silhouette rounding may decide otherwise.
            let Some(hit) = sphere.point(ray) else { continue };
            let terms = terms(&scene, light, ray, hit);
            // Lambert's law and nothing else: ambient light, and the lamp's where nothing stands before it.
            let diffuse = color * base * (terms.strength * terms.cos_theta.max(0.0));
            let away = light.position.get().as_dvec3() - hit.0;
            let to_lamp = Ray { origin: hit.0 + hit.1 * 1e-9, direction: away / away.length() };
            let shadow = terms.cos_theta <= 0.0 || first_sphere(&spheres(&scene), to_lamp).is_some();
            let expected = base * ambient + if shadow { diffuse * 0.0 } else { diffuse };
            for c in 0..3 {
                let (linear, png) = (f64::from(picture.pixels[i][c]), f64::from(png.pixels[i][c]));
                assert!(linear <= base[c] * ambient + diffuse[c] + 1e-4, "pixel {i} is brighter than matt");
                assert!((linear - expected[c]).abs() < 2e-3, "pixel {i}: {linear}, not {}", expected[c]);
                assert!((png - linear.min(1.0)).abs() < 1e-4);
            }
            if shadow { dark += 1 } else { lit += 1 }
        }
    }
    assert!(lit > 1500 && dark > 200, "{lit} lit, {dark} dark");

    // No mirror image: a sphere does not know the other's colour. It did before.
    let glossy = lab.linear(1, "");
    for [mirror, other] in [BOTH, [BOTH[1], BOTH[0]]] {
        let recolor = format!("--set '{other}.color=#ff00ff'");
        let pixels = objects.of(mirror);
        assert_eq!(picture.changed(&lab.linear(13, &recolor), &pixels, 0.0), [0; 0]);
        assert!(glossy.changed(&lab.linear(1, &recolor), &pixels, 0.01).len() >= 20);
    }
}

#[test]
fn test_14_full_gloss_is_a_brighter_and_smaller_highlight() {
    let size = [320, 240];
    let lab = Lab::new(size);
    let objects = lab.objects(14);
    let with = |gloss: &str| lab.linear(14, &BOTH.map(|name| format!("--set '{name}.gloss={gloss}'")).join(" "));
    let (full, little, none) = (lab.linear(14, ""), with("30%"), with("0"));
    let scene = scene("two-spheres");
    let view = View::new(&scene.cameras[0], size);
    for sphere in spheres(&scene) {
        let name = scene.objects[sphere.object].name.as_str();
        let pixels = objects.of(name);
        let highlight = |picture: &Picture| {
            let added = |i: &usize| picture.luminance(*i) - none.luminance(*i);
            let top = *pixels.iter().max_by(|a, b| added(a).total_cmp(&added(b))).unwrap();
            let peak = added(&top);
            (top, peak, pixels.iter().filter(|i| added(i) > 0.5 * peak).count())
        };
        let ((top, bright, small), (_, dim, large)) = (highlight(&full), highlight(&little));
        // k_s is the gloss itself; pixels beside the peak see a little less of it.
        assert!(bright > 2.5 * dim && bright < 3.5 * dim, "{name}: {bright} {dim}");
        assert!(small >= 4 && small * 5 < large, "{name}: {small} and {large} pixels");
        let ray = view.ray(top);
        let cos_alpha = terms(&scene, &scene.lights[0], ray, sphere.point(ray).unwrap()).cos_alpha;
        assert!(cos_alpha > 0.998, "{name}: the highlight is elsewhere: {cos_alpha}");
        // The highlight is the brightest place of the sphere in the PNG too.
        let png = lab.png(14);
        let brightest = pixels.iter().map(|&i| png.luminance(i)).fold(0.0, f64::max);
        assert!(png.luminance(top) >= 0.99 * brightest, "{name}");
    }

    // One fifth of a mirror: each sphere shows the other, less than with one half.
    let recolor = |test: usize| lab.linear(test, "--set 'Right sphere.color=#ff00ff'");
    let left = objects.of("Left sphere");
    let change = |test: usize, plain: &Picture| {
        let recolored = recolor(test);
        left.iter().map(|&i| f64::from(plain.difference(&recolored, i))).sum::<f64>()
    };
    let ratio = change(14, &full) / change(1, &lab.linear(1, ""));
    assert!(ratio > 0.3 && ratio < 0.7, "{ratio}");
}
