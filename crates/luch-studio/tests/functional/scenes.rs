//! Tests 1 to 3: the built-in scenes.

use crate::everywhere;
use crate::support::reference::Reference;

/// Both spheres are in the picture, orange and teal, neither of them flat.
pub(crate) fn assert_both_spheres(reference: &Reference) {
    let picture = &reference.picture;
    for (name, [high, low]) in [("Left sphere", [0, 2]), ("Right sphere", [1, 0])] {
        assert!(reference.share(name) > 0.01, "{name}: {}", reference.share(name));
        let color = picture.mean_of(&reference.of(name));
        assert!(color[high] > 1.1 * color[low], "{name}: {color:?}");
        assert!(picture.contrast(&reference.of(name)) > 0.2, "{name} is flat");
    }
}

#[test]
fn test_01_a_fresh_start_renders_two_spheres() {
    let expected = Reference::new("two-spheres", 1, [960, 720], |_| {});
    assert_both_spheres(&expected);
    everywhere(|desk| {
        desk.render();
        expected.assert_shown(desk);
    });
}

#[test]
fn test_02_the_chess_scene_shows_white_and_black_pieces() {
    let expected = Reference::new("chess", 1, [240, 135], |_| {});
    let pieces = |side: &'static str| expected.pixels(move |name| name.starts_with(side));
    let [white, black] = ["White ", "Black "].map(pieces);
    for side in [&white, &black] {
        assert!(side.len() > 240 * 135 / 50 && expected.picture.contrast(side) > 0.2, "pieces are round");
    }
    let [white, black] = [white, black].map(|side| expected.picture.mean_of(&side)[0]);
    assert!(white > 4.0 * black, "ivory and ebony: {white} {black}");
    everywhere(|desk| {
        desk.choose(desk.words.scene, desk.words.chess);
        desk.change(|desk| desk.resize(240, 135));
        desk.render();
        expected.assert_shown(desk);
    });
}

#[test]
fn test_03_the_knight_scene_shows_knight_cube_and_sphere() {
    let expected = Reference::new("knight", 1, [320, 180], |_| {});
    // Each in its own colour: cream, red, blue.
    for (name, least, [high, low]) in [("Knight", 0.05, [0, 2]), ("Cube", 0.02, [0, 1]), ("Sphere", 0.02, [2, 0])] {
        assert!(expected.share(name) > least, "{name}: {}", expected.share(name));
        let color = expected.picture.mean_of(&expected.of(name));
        assert!(color[high] > 1.3 * color[low], "{name}: {color:?}");
        assert!(expected.picture.contrast(&expected.of(name)) > 0.15, "{name} is flat");
    }
    everywhere(|desk| {
        desk.choose(desk.words.scene, desk.words.knight);
        desk.change(|desk| desk.resize(320, 180));
        desk.render();
        expected.assert_shown(desk);
    });
}
