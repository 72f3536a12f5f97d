//! Things put into the scene: where they stand, what they are called.

use crate::desk::{Folder, studio_with};
use crate::support::{Desk, LANGUAGES};
use egui::{Key, Modifiers};
use luch_scene::Scene;
use luch_studio::Start;

/// A floor at height 2, and a camera that looks down at it.
const FLOOR: &str = "luch = 1\nname = \"Floor\"\n[[light]]\nname = \"Lamp\"\nposition = [3.0, 9.0, 4.0]\n\
    [[camera]]\nname = \"Camera 1\"\nposition = [0.0, 5.0, 8.0]\nlook_at = [0.0, 2.0, 0.0]\n\
    [[object]]\nname = \"Floor\"\nwall = { point = [0.0, 2.0, 0.0], normal = [0.0, 1.0, 0.0] }\n\
    [render]\nsize = [64, 48]\n";

fn bounds(scene: &Scene, name: &str) -> [glam::Vec3; 2] {
    let object = scene.object_named(name).unwrap_or_else(|| panic!("no {name}"));
    scene.objects[object].shape.bounds().unwrap()
}

#[test]
fn new_things_stand_on_the_floor_where_the_camera_looks_and_are_selected() {
    let folder = Folder::new();
    let mut desk = studio_with(&folder.write("floor.toml", FLOOR));
    let before = desk.picture();
    for what in ["Cube", "Wall", "Sphere"] {
        desk.open_menu("Add", what);
        assert_eq!(desk.harness.state().selected(), Some(what));
        let [lo, hi] = bounds(desk.harness.state().scene(), what);
        assert!((lo.y - 2.0).abs() < 1e-3, "{what} stands on the floor: {lo}");
        let middle = (lo + hi) * 0.5;
        assert!(middle.x.abs() < 0.2 && middle.z.abs() < 1.5, "{what} is where the camera looks: {middle}");
        let size = (hi - lo).max_element();
        assert!((0.5..4.0).contains(&size), "{what} is as large as is seen well: {size}");
        assert!(desk.picture().differences(&before, 8) > 10, "{what} is seen");
        desk.key(Modifiers::COMMAND, Key::Z);
        assert!(desk.harness.state().scene().object_named(what).is_none(), "one step takes it back");
    }
    // The next of a kind has a name of its own, and stands on the one before or beside it.
    desk.open_menu("Add", "Cube");
    desk.open_menu("Add", "Cube");
    assert_eq!(desk.harness.state().selected(), Some("Cube 2"));
    let [first, second] = ["Cube", "Cube 2"].map(|name| bounds(desk.harness.state().scene(), name));
    let overlap = (first[1].min(second[1]) - first[0].max(second[0])).min_element();
    assert!(overlap < 1e-3, "they do not stand in each other: {overlap}");
    desk.open_menu("Add", "Lamp");
    let lights = &desk.harness.state().scene().lights;
    assert_eq!((desk.harness.state().selected(), lights.len()), (Some("Lamp 2"), 2));
    assert!(lights[1].position.get().y > 2.0, "above the floor");
}

#[test]
fn the_size_follows_the_scene() {
    let folder = Folder::new();
    for scale in [1e-3_f32, 1.0, 1e4] {
        let scaled = FLOOR.replace("[0.0, 5.0, 8.0]", &format!("[0.0, {:?}, {:?}]", 5.0 * scale, 8.0 * scale));
        let scaled = scaled.replace("[0.0, 2.0, 0.0]", &format!("[0.0, {:?}, 0.0]", 2.0 * scale));
        let mut desk = studio_with(&folder.write("floor.toml", scaled));
        desk.open_menu("Add", "Cube");
        let [lo, hi] = bounds(desk.harness.state().scene(), "Cube");
        assert!((lo.y / scale - 2.0).abs() < 1e-3, "{lo}");
        assert!((0.5..4.0).contains(&((hi - lo).x / scale)), "{}", (hi - lo).x);
    }
}

#[test]
fn a_model_of_any_size_stands_on_the_floor() {
    let folder = Folder::new();
    let floor = folder.write("floor.toml", FLOOR);
    for size in [0.001, 1.0, 5000.0] {
        let mut desk = studio_with(&floor);
        let up = 7.0 * size;
        let text =
            format!("v 0 {up} 0\nv {size} {up} 0\nv 0 {up} {size}\nv 0 {} 0\nf 1 2 3\nf 1 4 2\nf 1 3 4\n", up + size);
        let model = folder.write("tent.obj", text);
        desk.open_menu("Add", "Model…");
        desk.enter_path(&model);
        let [lo, hi] = bounds(desk.harness.state().scene(), "tent");
        assert!((lo.y - 2.0).abs() < 2e-3, "{lo}");
        assert!((0.3..5.0).contains(&(hi - lo).max_element()), "{}", hi - lo);
    }
}

#[test]
fn names_are_in_the_language_of_the_window() {
    let mut desk = Desk::start(LANGUAGES[1], Start::default());
    desk.open_menu("Добавить", "Сфера");
    assert_eq!(desk.harness.state().selected(), Some("Сфера"));
    desk.open_menu("Добавить", "Лампа");
    assert_eq!(desk.harness.state().selected(), Some("Лампа"));
    let [lo, _] = bounds(desk.harness.state().scene(), "Сфера");
    assert!(lo.is_finite());
}

#[test]
fn an_empty_scene_says_that_it_is_empty() {
    let mut desk = crate::desk::studio();
    desk.open_menu("File", "New scene");
    desk.begin_typing("Find by name", "nobody");
    assert!(desk.says("Nothing has such a name"));
    desk.begin_typing("Find by name", "");
    desk.select_in_list("Lamp");
    desk.key(Modifiers::NONE, Key::Delete);
    assert!(desk.says("The scene has no objects and no lights"));
    desk.open_menu("Add", "Sphere");
    assert!(!desk.says("The scene has no objects and no lights"));
}
