//! Tests 10, 13 and 14: the light's intensity, mirrors and highlights.

use crate::everywhere;
use crate::support::reference::Reference;
use luch_scene::{Color, NonNegative, Scene, Unit};

const SIZE: [u32; 2] = [160, 120];
const BOTH: [&str; 2] = ["Left sphere", "Right sphere"];

fn spheres(change: impl FnOnce(&mut Scene)) -> Reference {
    Reference::new("two-spheres", 1, SIZE, change)
}

#[test]
fn test_10_at_80_percent_the_picture_is_brighter() {
    let before = spheres(|_| {});
    let expected = spheres(|scene| scene.lights[0].intensity = NonNegative::new(0.8).unwrap());
    let dark = spheres(|scene| scene.lights[0].intensity = NonNegative::ZERO);
    assert_eq!(before.scene.lights.len(), 1);
    let growth = 0.8 / f64::from(before.scene.lights[0].intensity.get());
    assert!(growth > 1.05, "the scene leaves room to make it brighter: {growth}");
    // What the lamp adds grows in proportion, where eight bits can say it and nothing is cut off at white.
    let mut lit = 0;
    for i in 0..expected.picture.pixels.len() {
        let [ambient, before, after] = [&dark, &before, &expected].map(|r| r.picture.luminance(i));
        assert!(after >= before, "pixel {i} is darker");
        let cut_off = expected.picture.pixels[i][..3].contains(&255);
        if before > ambient + 0.05 && !cut_off {
            let ratio = (after - ambient) / (before - ambient);
            assert!((ratio / growth - 1.0).abs() < 0.1, "pixel {i}: {ratio}, not {growth}");
            lit += 1;
        }
    }
    assert!(lit > expected.picture.pixels.len() / 4, "the lamp reaches much of the picture: {lit} pixels");

    everywhere(|desk| {
        desk.change(|desk| desk.resize(SIZE[0], SIZE[1]));
        desk.render();
        before.assert_shown(desk);
        desk.change(|desk| desk.type_into(desk.words.light_intensity, "80"));
        desk.render();
        expected.assert_shown(desk);
    });
}

/// Sets gloss and reflection of both spheres in percent.
fn look(scene: &mut Scene, gloss: u8, reflection: u8) {
    for name in BOTH {
        let sphere = scene.object_named(name).unwrap();
        let material = &mut scene.objects[sphere].material;
        material.gloss = Some(Unit::new(f32::from(gloss) / 100.0).unwrap());
        material.reflection = Unit::new(f32::from(reflection) / 100.0).unwrap();
    }
}

/// Types gloss and reflection of both spheres into the panel and expects the picture.
fn set_in_the_window(gloss: u8, reflection: u8, expected: &Reference) {
    let before = spheres(|_| {});
    everywhere(|desk| {
        desk.change(|desk| desk.resize(SIZE[0], SIZE[1]));
        desk.render();
        before.assert_shown(desk);
        for name in BOTH {
            desk.select_in_list(name);
            desk.change(|desk| {
                desk.type_into(desk.words.gloss, &gloss.to_string());
                desk.type_into(desk.words.reflection, &reflection.to_string());
            });
        }
        desk.render();
        expected.assert_shown(desk);
    });
}

/// How much of one sphere changes when the other is painted magenta: what it mirrors.
fn mirrored(gloss: u8, reflection: u8, mirror: &str, other: &str) -> usize {
    let plain = spheres(|scene| look(scene, gloss, reflection));
    let painted = spheres(|scene| {
        look(scene, gloss, reflection);
        let other = scene.object_named(other).unwrap();
        scene.objects[other].material.color = Some(Color::from_hex("#ff00ff").unwrap());
    });
    plain.picture.changed(&painted.picture, &plain.of(mirror), 2).len()
}

#[test]
fn test_13_without_gloss_and_reflection_the_spheres_are_matt() {
    let expected = spheres(|scene| look(scene, 0, 0));
    for [mirror, other] in [BOTH, [BOTH[1], BOTH[0]]] {
        assert_eq!(mirrored(0, 0, mirror, other), 0, "{mirror} mirrors {other}");
        assert!(mirrored(85, 50, mirror, other) >= 20, "{mirror} mirrored {other} before");
    }
    // No highlight: nothing is brighter than diffuse light from straight ahead can make it.
    let scene = &expected.scene;
    let most = f64::from(scene.ambient.get() + scene.lights[0].intensity.get());
    for name in BOTH {
        let color = scene.objects[scene.object_named(name).unwrap()].material.color.unwrap().get().to_array();
        for i in expected.of(name) {
            for (seen, base) in expected.picture.linear(i).into_iter().zip(color) {
                assert!(seen <= f64::from(base) * most + 0.01, "{name}, pixel {i}: {seen} is a highlight");
            }
        }
    }
    set_in_the_window(0, 0, &expected);
}

#[test]
fn test_14_full_gloss_is_a_small_bright_highlight() {
    let [expected, little, none] = [100, 30, 0].map(|gloss| spheres(|scene| look(scene, gloss, 20)));
    for name in BOTH {
        let pixels = expected.of(name);
        let highlight = |with: &Reference| {
            let added = |i: &usize| with.picture.luminance(*i) - none.picture.luminance(*i);
            let peak = pixels.iter().map(added).fold(0.0, f64::max);
            (peak, pixels.iter().filter(|i| added(i) > 0.5 * peak).count())
        };
        let ((bright, small), (dim, large)) = (highlight(&expected), highlight(&little));
        assert!(bright > 1.5 * dim, "{name}: {bright} {dim}");
        assert!(small >= 2 && small * 4 < large, "{name}: {small} and {large} pixels");
    }
    // One fifth of a mirror is still one.
    assert!(mirrored(100, 20, BOTH[0], BOTH[1]) >= 20);
    set_in_the_window(100, 20, &expected);
}
