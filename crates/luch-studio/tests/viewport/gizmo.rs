//! The handles that move, turn and scale what is selected.

use crate::mouse::{Held, key, press};
use crate::support::{Desk, LANGUAGES, Picture};
use egui::{Key, Modifiers, PointerButton, Pos2, Vec2, vec2};
use glam::Vec3;
use luch_scene::{Camera, Scene, Shape, Size};

/// A studio with the knight scene, looked at from the front, and a thing selected.
fn desk(selected: &str, tool: Key) -> Desk {
    let mut desk = Desk::new(LANGUAGES[0]);
    desk.choose(desk.words.scene, desk.words.knight);
    desk.select_in_list(selected);
    key(&mut desk, tool);
    desk
}

fn shape(desk: &Desk, name: &str) -> Shape {
    let scene: &Scene = desk.harness.state().scene();
    scene.objects[scene.object_named(name).expect("the object")].shape.clone()
}

/// Where a point of the scene is seen in the window.
fn seen(desk: &Desk, point: Vec3) -> Pos2 {
    let camera: Camera = desk.harness.state().camera().expect("a camera");
    let [x, y, z] = camera.frame().map(|axis| axis.dot(point - camera.position.get()));
    let slope = (f64::from(camera.fov.get()).to_radians() * 0.5).tan() as f32;
    let size = desk.harness.state().scene().settings.size;
    let aspect = size.width() as f32 / size.height() as f32;
    desk.point_of_picture(0.5 + x / z / slope / aspect * 0.5, 0.5 - y / z / slope * 0.5)
}

/// The direction in the window of an axis at a point.
fn way(desk: &Desk, point: Vec3, axis: Vec3) -> Vec2 {
    (seen(desk, point + axis * 0.01) - seen(desk, point)).normalized()
}

fn hold(desk: &mut Desk, at: Pos2) -> Held {
    press(desk, at, PointerButton::Primary, Modifiers::NONE)
}

fn undo(desk: &mut Desk) {
    desk.harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    desk.settle();
}

#[test]
fn the_x_handle_moves_along_x_only_and_one_undo_brings_back_the_very_picture() {
    let mut desk = desk("Sphere", Key::W);
    let first: Picture = desk.picture();
    let before = shape(&desk, "Sphere").position().get();
    let along = way(&desk, before, Vec3::X);
    let handle = seen(&desk, before) + along * 60.0;
    hold(&mut desk, handle).drag(&mut desk, along * 100.0).release(&mut desk);
    let after = shape(&desk, "Sphere").position().get();
    assert!((after.x - before.x).abs() > 0.2, "{before} {after}");
    assert_eq!((after.y, after.z), (before.y, before.z));
    assert!(desk.picture().differences(&first, 0) > 5000);
    // The place that was grasped is still under the pointer: it moved as far as the pointer did.
    let moved = seen(&desk, after) - seen(&desk, before);
    assert!((moved.length() - 100.0).abs() < 12.0, "{moved}");
    undo(&mut desk);
    assert_eq!(shape(&desk, "Sphere").position().get(), before);
    assert!(desk.picture() == first, "one undo brings back the very picture");
    assert_eq!(desk.harness.state().selected(), Some("Sphere"));
}

#[test]
fn escape_takes_a_drag_back_and_leaves_nothing_to_undo() {
    let mut desk = desk("Sphere", Key::W);
    let first = desk.picture();
    let before = shape(&desk, "Sphere");
    let along = way(&desk, before.position().get(), Vec3::Y);
    let handle = seen(&desk, before.position().get()) + along * 60.0;
    let held = hold(&mut desk, handle).drag(&mut desk, along * 50.0);
    assert_ne!(shape(&desk, "Sphere"), before);
    desk.harness.key_press(Key::Escape);
    desk.harness.step();
    let held = held.drag(&mut desk, along * 50.0);
    assert_eq!(shape(&desk, "Sphere"), before, "a drag that was taken back does not go on");
    held.release(&mut desk);
    assert!(desk.picture() == first);
    assert_eq!(desk.harness.state().selected(), Some("Sphere"));
    undo(&mut desk);
    assert_eq!(shape(&desk, "Sphere"), before);
}

#[test]
fn ctrl_snaps_to_quarters_and_15_degrees() {
    let mut desk = desk("Cube", Key::W);
    let before = shape(&desk, "Cube");
    let center = before.position().get();
    let along = way(&desk, center, Vec3::Y);
    let handle = seen(&desk, center) + along * 60.0;
    press(&mut desk, handle, PointerButton::Primary, Modifiers::COMMAND)
        .drag(&mut desk, along * 70.0)
        .release(&mut desk);
    let moved = shape(&desk, "Cube").position().get() - center;
    assert!(moved.y > 0.0, "{moved}");
    assert_eq!((moved.x, moved.z), (0.0, 0.0));
    assert!((moved.y * 4.0 - (moved.y * 4.0).round()).abs() < 1e-5, "{moved}");
    undo(&mut desk);

    key(&mut desk, Key::E);
    let Shape::Cuboid { rotation: old, .. } = shape(&desk, "Cube") else { panic!("a cube") };
    // The ring about y, at its near side, which goes to the right.
    let camera = desk.harness.state().camera().unwrap();
    let toward = ((camera.position.get() - center) * Vec3::new(1.0, 0.0, 1.0)).normalize_or_zero();
    let unit = (seen(&desk, center + Vec3::Y * 0.01) - seen(&desk, center)).length() / 0.01;
    let near = center + toward * (84.0 / unit);
    let right = Vec3::Y.cross(toward);
    let handle = seen(&desk, near);
    let along = way(&desk, near, right);
    press(&mut desk, handle, PointerButton::Primary, Modifiers::COMMAND)
        .drag(&mut desk, along * 40.0)
        .release(&mut desk);
    let Shape::Cuboid { rotation, size, center: still, .. } = shape(&desk, "Cube") else { panic!("a cube") };
    let turned = rotation.degrees() - old.degrees();
    assert!(turned.y > 0.0, "{turned}");
    assert_eq!((turned.x, turned.z), (0.0, 0.0), "{turned}");
    assert!((turned.y / 15.0 - (turned.y / 15.0).round()).abs() < 1e-4, "{turned}");
    let Shape::Cuboid { size: sides, .. } = before else { panic!("a cube") };
    assert_eq!((still.get(), size), (center, sides));
}

#[test]
fn the_circle_scales_and_axes_scale_a_cube_along_themselves() {
    let mut desk = desk("Sphere", Key::R);
    let Shape::Sphere { center, radius } = shape(&desk, "Sphere") else { panic!("a sphere") };
    let middle = seen(&desk, center.get());
    hold(&mut desk, middle + vec2(66.0, 0.0)).drag(&mut desk, vec2(33.0, 0.0)).release(&mut desk);
    let Shape::Sphere { center: still, radius: larger } = shape(&desk, "Sphere") else { panic!("a sphere") };
    assert_eq!(still, center);
    assert!((larger.get() / radius.get() - 1.5).abs() < 0.01, "{} {}", radius.get(), larger.get());

    desk.select_in_list("Cube");
    let Shape::Cuboid { center, size, rotation } = shape(&desk, "Cube") else { panic!("a cube") };
    let own = rotation.matrix().y_axis;
    let along = way(&desk, center.get(), own);
    let handle = seen(&desk, center.get()) + along * 80.0;
    hold(&mut desk, handle).drag(&mut desk, along * 40.0).release(&mut desk);
    let Shape::Cuboid { size: sides, .. } = shape(&desk, "Cube") else { panic!("a cube") };
    assert_eq!((sides[0], sides[2]), (size[0], size[2]));
    assert!(sides[1] > Size::new(size[1].get() * 1.3).unwrap(), "{sides:?}");
}

#[test]
fn a_knight_turns_and_a_lamp_moves() {
    let mut desk = desk("Knight", Key::E);
    let Shape::Mesh(before) = shape(&desk, "Knight") else { panic!("a mesh") };
    let base = before.position.get();
    let camera = desk.harness.state().camera().unwrap();
    let toward = ((camera.position.get() - base) * Vec3::new(1.0, 0.0, 1.0)).normalize_or_zero();
    let unit = (seen(&desk, base + Vec3::Y * 0.01) - seen(&desk, base)).length() / 0.01;
    let near = base + toward * (84.0 / unit);
    let along = way(&desk, near, Vec3::Y.cross(toward));
    let handle = seen(&desk, near);
    hold(&mut desk, handle).drag(&mut desk, along * 30.0).release(&mut desk);
    let Shape::Mesh(after) = shape(&desk, "Knight") else { panic!("a mesh") };
    let turned = after.rotation.degrees() - before.rotation.degrees();
    assert!(turned.y > 5.0 && turned.x == 0.0 && turned.z == 0.0, "{turned}");
    assert_eq!((after.position, after.scale), (before.position, before.scale));

    // A lamp is far away from the camera's middle: it is brought into sight first.
    desk.select_in_list("Lamp");
    key(&mut desk, Key::F);
    key(&mut desk, Key::W);
    let lamp = |desk: &Desk| desk.harness.state().scene().lights[0].position.get();
    let before = lamp(&desk);
    let from = seen(&desk, before);
    hold(&mut desk, from).drag(&mut desk, vec2(30.0, -20.0)).release(&mut desk);
    assert!((seen(&desk, lamp(&desk)) - (from + vec2(30.0, -20.0))).length() < 2.0, "it stays under the pointer");
}

#[test]
fn a_click_on_a_handle_selects_nothing_else_and_a_drag_beside_it_looks_around() {
    let mut desk = desk("Sphere", Key::W);
    let center = shape(&desk, "Sphere").position().get();
    let at = seen(&desk, center) + way(&desk, center, Vec3::Y) * 70.0;
    hold(&mut desk, at).release(&mut desk);
    assert_eq!(desk.harness.state().selected(), Some("Sphere"));
    let before = desk.harness.state().camera();
    let beside = desk.point_of_picture(0.05, 0.05);
    hold(&mut desk, beside).drag(&mut desk, vec2(40.0, 0.0)).release(&mut desk);
    assert_ne!(desk.harness.state().camera(), before);
    assert_eq!(shape(&desk, "Sphere").position().get(), center);
}

#[test]
fn what_is_deleted_while_it_is_dragged_drags_nothing_else() {
    let mut desk = desk("Cube", Key::W);
    let count = desk.harness.state().scene().objects.len();
    let center = shape(&desk, "Cube").position().get();
    let along = way(&desk, center, Vec3::Y);
    let at = seen(&desk, center) + along * 60.0;
    let held = hold(&mut desk, at).drag(&mut desk, along * 30.0);
    desk.harness.key_press(Key::Delete);
    desk.harness.step();
    let rest = desk.harness.state().scene().clone();
    assert_eq!(rest.objects.len(), count - 1);
    held.drag(&mut desk, along * 60.0).release(&mut desk);
    assert_eq!(*desk.harness.state().scene(), rest);
}
