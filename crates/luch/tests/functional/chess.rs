//! Tests 2 and 6: the chess board.

use crate::geometry::View;
use crate::lab::{Lab, Objects, scene};
use glam::DVec3;
use luch_scene::{Scene, Shape};

const SIZE: [usize; 2] = [240, 180];

fn is_piece(name: &str) -> bool {
    name.starts_with("White ") || name.starts_with("Black ")
}

/// The names of the pieces of which at least `least` pixels are seen.
fn pieces_seen<'s>(scene: &'s Scene, objects: &Objects, least: usize) -> Vec<&'s str> {
    let names = scene.objects.iter().map(|o| o.name.as_str()).filter(|n| is_piece(n));
    names.filter(|name| objects.of(name).len() >= least).collect()
}

/// Every pixel of a piece lies where the piece stands: inside the picture of a box over its square, two squares high.
fn assert_pieces_in_place(scene: &Scene, objects: &Objects, camera: usize) {
    let view = View::new(&scene.cameras[camera - 1], SIZE);
    for name in pieces_seen(scene, objects, 1) {
        let Shape::Mesh(piece) = &scene.objects[scene.object_named(name).unwrap()].shape else { panic!("{name}") };
        let foot = piece.position.get().as_dvec3();
        let corners = [[-0.5, -0.5], [-0.5, 0.5], [0.5, -0.5], [0.5, 0.5]].into_iter();
        let corners = corners.flat_map(|[x, z]| [0.0, 2.0].map(|y| view.project(foot + DVec3::new(x, y, z))));
        let (mut low, mut high) = ([f64::MAX; 2], [f64::MIN; 2]);
        for (corner, axis) in corners.flat_map(|corner| [(corner, 0), (corner, 1)]) {
            low[axis] = low[axis].min(corner[axis]);
            high[axis] = high[axis].max(corner[axis]);
        }
        for i in objects.of(name) {
            let place = [i % SIZE[0], i / SIZE[0]].map(|at| at as f64 + 0.5);
            let inside = (0..2).all(|axis| (low[axis]..high[axis]).contains(&place[axis]));
            assert!(inside, "{name}: {place:?} is not in {low:?}..{high:?}");
        }
    }
}

#[test]
fn test_02_the_chess_scene_shows_all_pieces_on_the_board() {
    let lab = Lab::new(SIZE);
    let (picture, objects, scene) = (lab.png(2), lab.objects(2), scene("chess"));
    let all = scene.objects.iter().filter(|o| is_piece(&o.name)).count();
    assert_eq!(all, 32);
    let seen = pieces_seen(&scene, &objects, 12).len();
    assert!(seen >= 30, "{seen} pieces are seen");
    assert_pieces_in_place(&scene, &objects, 1);

    // Ivory and ebony, dark and light squares.
    let [white, black] = ["White ", "Black "].map(|side| objects.pixels(|n| n.starts_with(side)));
    assert!(picture.quantile(&white, 0.5) > 4.0 * picture.quantile(&black, 0.5), "ivory and ebony differ");
    assert!(picture.mean(&white)[0] > 4.0 * picture.mean(&black)[0], "ivory and ebony differ");
    for side in [&white, &black] {
        assert!(side.len() > objects.seen.len() / 50 && picture.contrast(side) > 0.2, "pieces are round");
    }
    let squares = |light: bool| {
        objects.pixels(|name| {
            let Some([file, rank]) = name.strip_prefix("Square ").map(|s| [s.as_bytes()[0], s.as_bytes()[1]]) else {
                return false;
            };
            // a1 is dark, by the rules of the game.
            ((file - b'a' + rank - b'1') % 2 == 1) == light
        })
    };
    let [dark, light] = [false, true].map(|kind| picture.quantile(&squares(kind), 0.5));
    assert!(light > 2.0 * dark, "{light} {dark}");
}

#[test]
fn test_06_camera_2_looks_along_the_rank() {
    let lab = Lab::new(SIZE);
    let (picture, objects, scene) = (lab.png(6), lab.objects(6), scene("chess"));
    let first = lab.png(2);
    let changed = picture.changed(&first, &first.all(), 0.01).len() as f64 / first.pixels.len() as f64;
    assert!(changed > 0.5, "only {changed} of the picture changed");
    let seen = pieces_seen(&scene, &objects, 12).len();
    assert!(seen >= 10, "{seen} pieces are seen");
    assert_pieces_in_place(&scene, &objects, 2);

    // The nearest piece is the rook of the corner where the camera stands, and it is large.
    let largest = |o: &Objects| {
        let names = pieces_seen(&scene, o, 1).into_iter();
        names.max_by_key(|name| o.of(name).len()).map(|name| (name, o.share(name))).unwrap()
    };
    let (near, far) = (largest(&objects), largest(&lab.objects(2)));
    assert_eq!(near.0, "White rook a1");
    assert!(near.1 > 4.0 * far.1, "{near:?} {far:?}");
}
