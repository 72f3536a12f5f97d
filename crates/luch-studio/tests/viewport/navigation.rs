//! The camera by mouse and keys.

use crate::mouse::{drag, key, press, scroll};
use crate::support::{Desk, LANGUAGES};
use egui::{Key, Modifiers, PointerButton, vec2};
use glam::Vec3;
use luch_scene::{Aim, Camera, Shape};

fn desk() -> Desk {
    Desk::new(LANGUAGES[0])
}

fn camera(desk: &Desk) -> Camera {
    desk.harness.state().camera().expect("a camera")
}

/// Half the picture's height at distance 1.
fn slope(camera: &Camera) -> f32 {
    (f64::from(camera.fov.get()).to_radians() * 0.5).tan() as f32
}

/// Where a camera sees a point: right and up as parts of half the picture's height, and the distance along the view.
fn seen(camera: &Camera, point: Vec3) -> Vec3 {
    let [x, y, z] = camera.frame().map(|axis| axis.dot(point - camera.position.get()));
    let half = z * slope(camera);
    Vec3::new(x / half, y / half, z)
}

fn center_of(desk: &Desk, name: &str) -> Vec3 {
    let scene = desk.harness.state().scene();
    let index = scene.object_named(name).expect("the object");
    scene.objects[index].shape.position().get()
}

#[test]
fn an_orbit_goes_around_the_selection_and_home_leads_back_to_the_very_picture() {
    let mut desk = desk();
    let first = desk.picture();
    let name = "Left sphere";
    desk.select_in_list(name);
    let (before, center) = (camera(&desk), center_of(&desk, name));
    let from = desk.point_of_picture(0.5, 0.1);
    drag(&mut desk, from, vec2(120.0, 40.0), PointerButton::Primary, Modifiers::NONE);
    let after = camera(&desk);
    assert!((after.position.get() - before.position.get()).length() > 0.5);
    let moved = (seen(&after, center) - seen(&before, center)).truncate();
    assert!(moved.length() < 1e-4, "the pivot stays where it is seen: {moved}");
    assert!(after.frame()[0].y.abs() < 1e-6, "the horizon stays level");
    assert!(desk.picture().differences(&first, 0) > 10_000);
    assert_eq!(desk.harness.state().selected(), Some(name), "a drag selects nothing");
    key(&mut desk, Key::Home);
    assert_eq!(camera(&desk), before);
    assert!(desk.picture() == first, "the very picture");
}

#[test]
fn an_orbit_never_leaves_the_room() {
    let mut desk = desk();
    desk.select_in_list("Left sphere");
    let from = desk.point_of_picture(0.5, 0.3);
    for by in [vec2(400.0, 0.0), vec2(-400.0, 0.0), vec2(0.0, 250.0), vec2(150.0, -250.0)] {
        let held = press(&mut desk, from, PointerButton::Primary, Modifiers::NONE).drag(&mut desk, by);
        held.release(&mut desk);
        let at = camera(&desk).position.get();
        assert!(at.x.abs() < 4.0 && at.y > 0.0 && at.z > -4.0, "{at}");
        desk.harness.hover_at(from);
    }
}

#[test]
fn an_orbit_without_a_selection_goes_around_what_is_under_the_pointer() {
    let mut desk = desk();
    let before = camera(&desk);
    let at = desk.point_of_picture(0.4, 0.55);
    drag(&mut desk, at, vec2(-60.0, 10.0), PointerButton::Primary, Modifiers::NONE);
    let after = camera(&desk);
    // The point under the pointer stays under the place where the drag began: the same object is seen there still.
    assert_ne!(after.position, before.position);
    let [x, y] = [(0.4 - 0.5) * 2.0 * 4.0 / 3.0, (0.5 - 0.55) * 2.0];
    let along = |camera: &Camera, depth: f32| {
        let [right, up, forward] = camera.frame();
        camera.position.get() + (forward + (right * x + up * y) * slope(camera)) * depth
    };
    let nearest = (1..4000).map(|step| step as f32 * 0.005);
    let apart = nearest.map(|depth| (along(&before, depth) - along(&after, depth)).length()).fold(f32::MAX, f32::min);
    assert!(apart < 0.02, "the rays through the pointer before and after meet: {apart}");
}

#[test]
fn a_pan_keeps_what_is_grasped_under_the_pointer() {
    for (button, modifiers) in [(PointerButton::Secondary, Modifiers::NONE), (PointerButton::Primary, Modifiers::SHIFT)]
    {
        let mut desk = desk();
        let before = camera(&desk);
        let center = center_of(&desk, "Right sphere");
        let from = desk.point_of_picture(0.65, 0.5);
        drag(&mut desk, from, vec2(-90.0, 30.0), button, modifiers);
        let after = camera(&desk);
        assert!((after.direction() - before.direction()).length() < 1e-6, "{button:?}");
        let way = after.position.get() - before.position.get();
        let [right, up, forward] = before.frame();
        assert!(way.dot(right) > 0.0 && way.dot(up) > 0.0 && way.dot(forward).abs() < 1e-5, "{way}");
        // What is as far away as the surface that was grasped moves by as many pixels as the pointer.
        let picture = desk.picture();
        let scale = (desk.point_of_picture(0.0, 1.0) - desk.point_of_picture(0.0, 0.0)).y / picture.height as f32;
        let half = picture.height as f32 * scale * 0.5;
        let moved = (seen(&after, center) - seen(&before, center)) * half;
        // The centre is a little farther than the surface.
        assert!(moved.x < -50.0 && moved.x >= -90.0 && moved.y < -15.0 && moved.y >= -30.0, "{moved}");
    }
}

#[test]
fn the_wheel_moves_towards_what_is_under_the_pointer_and_never_through_it() {
    let mut desk = desk();
    let before = camera(&desk);
    let sphere = desk.harness.state().scene().object_named("Left sphere").unwrap();
    let Shape::Sphere { center, radius } = desk.harness.state().scene().objects[sphere].shape else {
        panic!("a sphere")
    };
    let at = desk.point_of_picture(0.36, 0.55);
    scroll(&mut desk, at, 2.0);
    let once = camera(&desk);
    assert!((once.direction() - before.direction()).length() < 1e-6);
    let way = |camera: &Camera| (camera.position.get() - center.get()).length() - radius.get();
    assert!(way(&once) < way(&before) * 0.8, "{} {}", way(&once), way(&before));
    scroll(&mut desk, at, 200.0);
    let near = camera(&desk);
    assert!(way(&near) > 0.0 && way(&near) < 0.1, "{}", way(&near));
    desk.harness.hover_at(at);
    desk.click_picture(0.36, 0.55);
    assert_eq!(desk.harness.state().selected(), Some("Left sphere"));
    scroll(&mut desk, at, -90.0);
    assert!(way(&camera(&desk)) > way(&once));
}

#[test]
fn escape_takes_a_drag_of_the_view_back() {
    let mut desk = desk();
    let (first, before) = (desk.picture(), camera(&desk));
    desk.select_in_list("Left sphere");
    let from = desk.point_of_picture(0.5, 0.1);
    let held = press(&mut desk, from, PointerButton::Primary, Modifiers::NONE).drag(&mut desk, vec2(80.0, 0.0));
    assert_ne!(camera(&desk), before);
    desk.harness.key_press(Key::Escape);
    desk.harness.step();
    let held = held.drag(&mut desk, vec2(80.0, 0.0));
    held.release(&mut desk);
    assert_eq!(camera(&desk), before);
    assert!(desk.picture() == first);
    assert_eq!(desk.harness.state().selected(), Some("Left sphere"), "Escape took back the drag, not the selection");
    key(&mut desk, Key::Escape);
    assert_eq!(desk.harness.state().selected(), None);
}

#[test]
fn f_frames_the_selection_and_without_one_everything() {
    let mut desk = desk();
    let before = camera(&desk);
    desk.select_in_list("Left sphere");
    key(&mut desk, Key::F);
    let center = center_of(&desk, "Left sphere");
    let framed = seen(&camera(&desk), center);
    assert!(framed.x.abs() < 1e-3 && framed.y.abs() < 1e-3, "{framed}");
    assert!((camera(&desk).direction() - before.direction()).length() < 1e-6);
    desk.click_picture(0.5, 0.5);
    assert_eq!(desk.harness.state().selected(), Some("Left sphere"), "it is in the middle");
    for (across, down) in [(0.02, 0.5), (0.98, 0.5)] {
        desk.click_picture(across, down);
        assert_ne!(desk.harness.state().selected(), Some("Left sphere"), "all of it is in the picture");
    }
    key(&mut desk, Key::Escape);
    key(&mut desk, Key::F);
    for name in ["Left sphere", "Right sphere"] {
        let seen = seen(&camera(&desk), center_of(&desk, name));
        assert!(seen.x.abs() < 4.0 / 3.0 && seen.y.abs() < 1.0 && seen.z > 0.0, "{name}: {seen}");
    }
}

#[test]
fn digits_choose_cameras_and_those_that_are_missing_none() {
    let mut desk = desk();
    let scene = desk.harness.state().scene().clone();
    for (digit, index) in [(Key::Num2, 1), (Key::Num3, 2), (Key::Num9, 2), (Key::Num1, 0)] {
        key(&mut desk, digit);
        assert_eq!(camera(&desk), scene.cameras[index], "{digit:?}");
    }
}

#[test]
fn keys_look_around_when_the_picture_has_the_focus() {
    let mut desk = desk();
    let before = camera(&desk);
    key(&mut desk, Key::ArrowRight);
    assert_eq!(camera(&desk), before, "without the focus, arrows are not the picture's");
    desk.click_picture(0.02, 0.02);
    for (pressed, modifiers) in [
        (Key::ArrowLeft, Modifiers::NONE),
        (Key::ArrowUp, Modifiers::NONE),
        (Key::ArrowDown, Modifiers::SHIFT),
        (Key::Plus, Modifiers::NONE),
    ] {
        let last = camera(&desk);
        desk.harness.key_press_modifiers(modifiers, pressed);
        desk.settle();
        assert_ne!(camera(&desk).position, last.position, "{pressed:?}");
    }
    desk.harness.key_press(Key::Minus);
    desk.settle();
    assert!(matches!(camera(&desk).aim, Aim::At(_)));
    key(&mut desk, Key::Home);
    assert_eq!(camera(&desk), before);
}
