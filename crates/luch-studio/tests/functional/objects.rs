//! Tests 8 and 9: an object selected by a click in the picture, and one selected in the list.

use crate::everywhere;
use crate::support::Desk;
use crate::support::reference::Reference;
use egui::accesskit::{Role, Toggled};
use egui_kittest::kittest::{NodeT, Queryable};
use luch_scene::{Color, Scene, Unit};

const SIZE: [u32; 2] = [192, 108];

fn knight_scene(camera: usize, change: impl FnOnce(&mut Scene)) -> Reference {
    Reference::new("knight", camera, SIZE, change)
}

/// Opens the knight scene at a camera and shows its picture.
fn open_knight_scene(desk: &mut Desk, picture: &Reference, camera: usize) {
    desk.choose(desk.words.scene, desk.words.knight);
    desk.change(|desk| desk.resize(SIZE[0], SIZE[1]));
    desk.change(|desk| desk.choose(desk.words.camera, &picture.scene.cameras[camera - 1].name));
    desk.render();
    picture.assert_shown(desk);
}

/// The rows of the list that are lit up.
fn lit_rows(desk: &Desk) -> Vec<String> {
    let names: Vec<_> = desk.harness.state().scene().objects.iter().map(|o| o.name.clone()).collect();
    let is_lit = |name: &String| {
        let row = desk.harness.query_by_role_and_label(Role::Button, name);
        row.is_some_and(|row| row.accesskit_node().toggled() == Some(Toggled::True))
    };
    names.into_iter().filter(is_lit).collect()
}

/// Pixels of the window that have the colour of the outline.
fn outline_pixels(desk: &mut Desk) -> usize {
    let image = desk.harness.render().expect("a picture of the window");
    let is_outline = |rgba: [u8; 4]| rgba.iter().zip([255_u8, 170, 40]).all(|(a, b)| a.abs_diff(b) < 12);
    image.pixels().filter(|pixel| is_outline(pixel.0)).count()
}

#[test]
fn test_08_a_click_on_the_knight_selects_it_and_it_turns_yellow() {
    let before = knight_scene(3, |_| {});
    let expected = knight_scene(3, |scene| {
        let knight = scene.object_named("Knight").unwrap();
        scene.objects[knight].material.color = Some(Color::from_hex("#ffff00").unwrap());
    });
    let knight = expected.of("Knight");
    let is_yellow = |reference: &Reference, i: usize| {
        let [red, green, blue] = reference.picture.linear(i);
        (red - green).abs() < 0.2 * red && blue < 0.25 * green
    };
    let share = |r: &Reference| knight.iter().filter(|i| is_yellow(r, **i)).count() as f64 / knight.len() as f64;
    assert!(share(&expected) > 0.85, "{} of the knight is yellow", share(&expected));
    assert!(share(&before) < 0.02, "{} of the knight was yellow before", share(&before));
    let wall = expected.of("Back wall");
    assert_eq!(expected.picture.changed(&before.picture, &wall, 0), [0; 0], "the wall mirrors nothing");

    let [across, down] = before.inside("Knight");
    everywhere(|desk| {
        open_knight_scene(desk, &before, 3);
        assert_eq!((desk.harness.state().selected(), lit_rows(desk)), (None, vec![]));
        let unmarked = outline_pixels(desk);
        desk.click_picture(across, down);
        assert_eq!(desk.harness.state().selected(), Some("Knight"));
        assert_eq!(lit_rows(desk), ["Knight"]);
        let marked = outline_pixels(desk);
        assert!(marked > unmarked + 300, "the knight is outlined: {unmarked} and {marked} pixels");
        desk.change(|desk| desk.type_into(desk.words.color, "#ffff00"));
        desk.render();
        expected.assert_shown(desk);
    });
}

#[test]
fn test_09_the_cube_selected_in_the_list_becomes_a_mirror() {
    let before = knight_scene(2, |_| {});
    let reflecting = |share: f32| {
        knight_scene(2, |scene| {
            let cube = scene.object_named("Cube").unwrap();
            scene.objects[cube].material.reflection = Unit::new(share).unwrap();
        })
    };
    let (expected, whole) = (reflecting(0.95), reflecting(1.0));
    let cube = expected.of("Cube");
    assert!(expected.share("Cube") > 0.03);
    // The mean moves from the cube's own red to what is mirrored, and the picture on the cube gets richer.
    let away = |reference: &Reference| {
        let (a, b) = (reference.picture.mean_of(&cube), whole.picture.mean_of(&cube));
        a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    assert!(away(&expected) < 0.1 * away(&before), "{} {}", away(&expected), away(&before));
    let contrast = [&before, &expected].map(|r| r.picture.contrast(&cube));
    assert!(contrast[1] > 1.3 * contrast[0], "{contrast:?}");

    everywhere(|desk| {
        open_knight_scene(desk, &before, 2);
        desk.select_in_list("Cube");
        assert_eq!(desk.harness.state().selected(), Some("Cube"));
        assert_eq!(lit_rows(desk), ["Cube"]);
        desk.change(|desk| desk.type_into(desk.words.reflection, "95"));
        desk.render();
        expected.assert_shown(desk);
    });
}
