//! The focus, set by a click.

use crate::mouse::key;
use crate::support::{Desk, LANGUAGES, Words};
use egui::Key;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;
use glam::DVec3;

/// What the tool and its notices are called.
struct Terms {
    words: Words,
    tool: &'static str,
    is_set: &'static str,
    nothing: &'static str,
}

/// In the order of `LANGUAGES`.
const TERMS: [Terms; 2] = [
    Terms {
        words: LANGUAGES[0],
        tool: "Focus",
        is_set: "The focal distance is set",
        nothing: "There is nothing to focus on",
    },
    Terms {
        words: LANGUAGES[1],
        tool: "Фокус",
        is_set: "Фокусное расстояние задано",
        nothing: "Здесь не на чем сфокусироваться",
    },
];

fn desk(terms: &Terms) -> Desk {
    let mut desk = Desk::new(terms.words);
    desk.harness.get_by_role_and_label(Role::Button, terms.tool).click();
    desk.settle();
    desk
}

fn focus(desk: &Desk) -> f64 {
    f64::from(desk.harness.state().camera().expect("a camera").focus())
}

/// The left sphere of the first scene.
const SPHERE: DVec3 = DVec3::new(-1.25, 1.0, -0.5);

/// The eye, right, up and forward of the first scene's first camera.
fn axes() -> [DVec3; 4] {
    let (eye, target) = (DVec3::new(0.0, 1.9, 5.7), DVec3::new(0.0, 0.98, 0.0));
    let forward = (target - eye) / (target - eye).length();
    let right = forward.cross(DVec3::Y) / forward.cross(DVec3::Y).length();
    [eye, right, right.cross(forward), forward]
}

/// The part of the picture's width and height at which the middle of the sphere is seen. There its depth hardly changes
/// from pixel to pixel.
fn middle_of_sphere() -> [f32; 2] {
    let [eye, right, up, forward] = axes();
    let [x, y, z] = [right, up, forward].map(|axis| axis.dot(SPHERE - eye));
    let half = z * 22.5_f64.to_radians().tan();
    [(0.5 + x / half * 0.375) as f32, (0.5 - y / half * 0.5) as f32]
}

/// Where the ray through the middle of the sphere meets it, along the view.
fn depth_of_sphere() -> f64 {
    let [eye, _, _, forward] = axes();
    let way = SPHERE - eye;
    (way * (1.0 - 1.0 / way.length())).dot(forward)
}

#[test]
fn a_click_focuses_on_what_is_there_and_says_if_that_is_not_seen() {
    for terms in TERMS {
        let mut desk = desk(&terms);
        let before = focus(&desk);
        let [across, down] = middle_of_sphere();
        desk.click_picture(across, down);
        let expected = depth_of_sphere();
        assert!((focus(&desk) - expected).abs() < 1e-3, "{} {expected}", focus(&desk));
        assert_ne!(focus(&desk), before);
        assert!(!desk.harness.state().scene().settings.depth_of_field.on, "nothing is switched on silently");
        assert_eq!(desk.harness.state().selected(), None, "the tool does not select");
        desk.harness.get_by_label(terms.is_set);
        desk.harness.key_press_modifiers(egui::Modifiers::COMMAND, Key::Z);
        desk.settle();
        assert_eq!(focus(&desk), before, "one undo takes it back");
    }
}

#[test]
fn with_depth_of_field_the_click_is_the_same_and_needs_no_notice() {
    let mut desk = desk(&TERMS[0]);
    desk.resize(240, 180);
    desk.tick(desk.words.depth_of_field);
    let before = desk.picture();
    // The middle of a pixel of the floor in front, where the rays through the lens are spread.
    let [across, down] = [(60.0 + 0.5) / 240.0, (170.0 + 0.5) / 180.0];
    desk.click_picture(across, down);
    let [eye, right, up, forward] = axes();
    let tall = 22.5_f64.to_radians().tan();
    let (x, y) = (f64::from(across) * 2.0 - 1.0, 1.0 - f64::from(down) * 2.0);
    let way = forward + right * (x * tall * 4.0 / 3.0) + up * (y * tall);
    // The way goes forward by 1: what it takes to reach the floor is the distance along the view.
    let expected = eye.y / -way.y;
    assert!((focus(&desk) - expected).abs() < 1e-3, "{} {expected}: through the middle of the lens", focus(&desk));
    assert!(desk.harness.query_by_label(TERMS[0].is_set).is_none());
    assert!(desk.picture().differences(&before, 2) > 500, "the picture is focused anew");
}

#[test]
fn a_click_beside_everything_changes_nothing_and_says_so() {
    for terms in TERMS {
        let mut desk = desk(&terms);
        // Out of the room: nothing but the background.
        for wall in ["Back wall", "Ceiling", "Left wall", "Right wall"] {
            desk.select_in_list(wall);
            key(&mut desk, Key::H);
        }
        let before = focus(&desk);
        desk.click_picture(0.5, 0.05);
        assert_eq!(focus(&desk), before);
        desk.harness.get_by_label(terms.nothing);
    }
}

#[test]
fn the_tool_is_at_hand_beside_the_focal_distance() {
    let buttons = ["Click in the picture what is to be sharp", "Щёлкнуть на изображении то, что должно быть резким"];
    for (terms, button) in TERMS.iter().zip(buttons) {
        let mut desk = Desk::new(terms.words);
        let before = focus(&desk);
        desk.scroll_to(Role::Button, button);
        desk.press(button);
        let [across, down] = middle_of_sphere();
        desk.click_picture(across, down);
        assert!(desk.says(terms.is_set));
        assert_ne!(focus(&desk), before);
    }
}
