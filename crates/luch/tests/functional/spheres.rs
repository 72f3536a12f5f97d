//! Tests 1, 4, 5 and 7: the two spheres through their cameras.

use crate::geometry::{View, first_sphere, spheres, terms};
use crate::lab::{Lab, Objects, scene};
use crate::picture::Picture;

const SIZE: [usize; 2] = [160, 120];
const BOTH: [&str; 2] = ["Left sphere", "Right sphere"];

/// Both spheres are seen where the scene's numbers put them, whole, and neither is flat.
fn assert_both_spheres(objects: &Objects, picture: &Picture, camera: usize, fov: Option<f64>) {
    let scene = scene("two-spheres");
    let camera = &scene.cameras[camera - 1];
    let view = View::with_fov(camera, fov.unwrap_or(f64::from(camera.fov.get())), SIZE);
    let spheres = spheres(&scene);
    let wrong = (0..objects.seen.len()).filter(|&pixel| {
        let seen = objects.seen[pixel].filter(|k| spheres.iter().any(|s| s.object == *k));
        seen != first_sphere(&spheres, view.ray(pixel))
    });
    // The silhouettes may round otherwise.
    let wrong = wrong.count();
    assert!(wrong <= 2, "{wrong} pixels show another sphere than the scene's numbers say");
    for name in BOTH {
        assert!(objects.share(name) > 0.01, "{name}: {}", objects.share(name));
        let contrast = picture.contrast(&objects.of(name));
        assert!(contrast > 0.2, "{name} is flat: {contrast}");
    }
}

#[test]
fn test_01_the_first_picture_shows_two_spheres_in_a_room() {
    let lab = Lab::new(SIZE);
    let (picture, objects) = (lab.png(1), lab.objects(1));
    assert_both_spheres(&objects, &picture, 1, None);
    let [left, right] = BOTH.map(|name| objects.middle(name));
    assert!(left[0] + 40.0 < right[0], "{left:?} {right:?}");

    // The room: a floor of dark and light squares, and walls that differ.
    for (name, least) in [("Floor", 0.1), ("Back wall", 0.1), ("Left wall", 0.02), ("Right wall", 0.02)] {
        assert!(objects.share(name) > least, "{name}: {}", objects.share(name));
    }
    let floor = objects.of("Floor");
    let (dark, light) = (picture.quantile(&floor, 0.2), picture.quantile(&floor, 0.8));
    assert!(light > 3.0 * dark, "{dark} {light}");
    let [red, _, blue] = picture.mean(&objects.of("Left wall"));
    assert!(red > 2.0 * blue, "the left wall is red");
    let [red, _, blue] = picture.mean(&objects.of("Right wall"));
    assert!(blue > 2.0 * red, "the right wall is blue");

    // The PNG is the linear picture, cut off at 1.
    let linear = lab.linear(1, "");
    for (a, b) in picture.pixels.iter().flatten().zip(linear.pixels.iter().flatten()) {
        assert!((a - b.min(1.0)).abs() < 1e-4, "{a} {b}");
    }

    // A highlight on each sphere, where the lamp's mirror direction meets the eye.
    let matt = lab.linear(1, "--set 'Left sphere.gloss=0' --set 'Right sphere.gloss=0'");
    let scene = scene("two-spheres");
    let view = View::new(&scene.cameras[0], SIZE);
    for sphere in spheres(&scene) {
        let name = &scene.objects[sphere.object].name;
        let highlight = |i: &usize| linear.luminance(*i) - matt.luminance(*i);
        let pixels = objects.of(name);
        let top = *pixels.iter().max_by(|a, b| highlight(a).total_cmp(&highlight(b))).unwrap();
        let ray = view.ray(top);
        let cos_alpha = terms(&scene, &scene.lights[0], ray, sphere.point(ray).unwrap()).cos_alpha;
        assert!(cos_alpha > 0.995, "{name}: the highlight is elsewhere: {cos_alpha}");
        assert!(highlight(&top) > 0.1, "{name}: {}", highlight(&top));
    }

    // Each mirrors the other.
    for [mirror, other] in [BOTH, [BOTH[1], BOTH[0]]] {
        let recolored = lab.linear(1, &format!("--set '{other}.color=#ff00ff'"));
        let changed = linear.changed(&recolored, &objects.of(mirror), 0.01).len();
        assert!(changed >= 20, "{other} is not in {mirror}: {changed} pixels");
    }
}

/// The picture is another one than that of test 1.
fn assert_another_view(picture: &Picture, lab: &Lab) {
    let first = lab.png(1);
    let changed = picture.changed(&first, &first.all(), 0.01).len() as f64 / first.pixels.len() as f64;
    assert!(changed > 0.5, "only {changed} of the picture changed");
}

#[test]
fn test_04_camera_2_sees_them_from_the_left() {
    let lab = Lab::new(SIZE);
    let (picture, objects) = (lab.png(4), lab.objects(4));
    assert_both_spheres(&objects, &picture, 2, None);
    assert_another_view(&picture, &lab);
    let [left, right] = BOTH.map(|name| objects.share(name));
    assert!(left > 1.3 * right, "the left one is nearer: {left} {right}");
}

#[test]
fn test_05_camera_3_sees_them_from_above() {
    let lab = Lab::new(SIZE);
    let (picture, objects) = (lab.png(5), lab.objects(5));
    assert_both_spheres(&objects, &picture, 3, None);
    assert_another_view(&picture, &lab);
    let (above, ahead) = (objects.share("Floor"), lab.objects(1).share("Floor"));
    assert!(above > 1.2 * ahead, "more floor from above: {above} {ahead}");
}

#[test]
fn test_07_at_90_degrees_the_spheres_shrink_by_the_tangent() {
    let lab = Lab::new(SIZE);
    let (picture, objects) = (lab.png(7), lab.objects(7));
    assert_both_spheres(&objects, &picture, 3, Some(90.0));
    let before = lab.objects(5);
    let fov = f64::from(scene("two-spheres").cameras[2].fov.get()).to_radians();
    let shrink = (fov / 2.0).tan() / 45.0_f64.to_radians().tan();
    assert!(shrink < 0.6, "the camera's own field of view is far from 90 degrees");
    for name in BOTH {
        assert!(!before.is_cut_off(name), "{name} must be whole before");
        let ratio = objects.share(name) / before.share(name);
        assert!((ratio / shrink.powi(2) - 1.0).abs() < 0.03, "{name}: {ratio}, not {}", shrink.powi(2));
        let from_middle = |o: &Objects| {
            let [x, y] = o.middle(name);
            [x - SIZE[0] as f64 / 2.0, y - SIZE[1] as f64 / 2.0]
        };
        for (after, before) in from_middle(&objects).into_iter().zip(from_middle(&before)) {
            assert!((after - before * shrink).abs() < 0.3, "{name}: {after}, not {}", before * shrink);
        }
    }
}
