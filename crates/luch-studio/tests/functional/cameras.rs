//! Tests 4 to 7: cameras and the field of view.

use crate::everywhere;
use crate::scenes::assert_both_spheres;
use crate::support::reference::{Reference, scene};
use luch_scene::FieldOfView;

const SIZE: [u32; 2] = [160, 120];

/// More than half of the picture is another one.
fn assert_another_view(after: &Reference, before: &Reference) {
    let share = after.picture.differences(&before.picture, 3) as f64 / after.picture.pixels.len() as f64;
    assert!(share > 0.5, "only {share} of the picture changed");
}

fn name_of_camera(id: &'static str, number: usize) -> String {
    scene(id).cameras[number - 1].name.clone()
}

/// Chooses a camera of the two spheres in the list and expects its picture.
fn look_at_spheres_through(camera: usize) -> [Reference; 2] {
    let [first, expected] = [1, camera].map(|camera| Reference::new("two-spheres", camera, SIZE, |_| {}));
    assert_both_spheres(&expected);
    assert_another_view(&expected, &first);
    let name = name_of_camera("two-spheres", camera);
    everywhere(|desk| {
        desk.change(|desk| desk.resize(SIZE[0], SIZE[1]));
        desk.render();
        first.assert_shown(desk);
        desk.change(|desk| desk.choose(desk.words.camera, &name));
        desk.render();
        expected.assert_shown(desk);
    });
    [first, expected]
}

#[test]
fn test_04_camera_2_sees_the_spheres_from_the_left() {
    let [_, expected] = look_at_spheres_through(2);
    assert!(expected.share("Left sphere") > 1.3 * expected.share("Right sphere"), "the left one is nearer");
}

#[test]
fn test_05_camera_3_sees_the_spheres_from_above() {
    let [first, expected] = look_at_spheres_through(3);
    assert!(expected.share("Floor") > 1.2 * first.share("Floor"), "more floor from above");
}

#[test]
fn test_06_camera_2_looks_along_the_chess_board() {
    let [first, expected] = [1, 2].map(|camera| Reference::new("chess", camera, SIZE, |_| {}));
    assert_another_view(&expected, &first);
    let rook = "White rook a1";
    assert!(expected.share(rook) > 4.0 * first.share(rook), "the rook of the near corner is large");
    let name = name_of_camera("chess", 2);
    everywhere(|desk| {
        desk.choose(desk.words.scene, desk.words.chess);
        desk.change(|desk| desk.resize(SIZE[0], SIZE[1]));
        desk.render();
        first.assert_shown(desk);
        desk.change(|desk| desk.choose(desk.words.camera, &name));
        desk.render();
        expected.assert_shown(desk);
    });
}

#[test]
fn test_07_at_90_degrees_the_spheres_shrink_by_the_tangent() {
    let before = Reference::new("two-spheres", 3, SIZE, |_| {});
    let expected = Reference::new("two-spheres", 3, SIZE, |scene| {
        scene.cameras[2].fov = FieldOfView::new(90.0).unwrap();
    });
    assert_both_spheres(&expected);
    let shrink = (f64::from(before.scene.cameras[2].fov.get()).to_radians() / 2.0).tan();
    for name in ["Left sphere", "Right sphere"] {
        let ratio = expected.share(name) / before.share(name);
        assert!((ratio / shrink.powi(2) - 1.0).abs() < 0.05, "{name}: {ratio}, not {}", shrink.powi(2));
    }
    let name = name_of_camera("two-spheres", 3);
    everywhere(|desk| {
        desk.change(|desk| desk.resize(SIZE[0], SIZE[1]));
        desk.change(|desk| desk.choose(desk.words.camera, &name));
        desk.render();
        before.assert_shown(desk);
        desk.change(|desk| desk.type_into(desk.words.field_of_view, "90"));
        desk.render();
        expected.assert_shown(desk);
    });
}
