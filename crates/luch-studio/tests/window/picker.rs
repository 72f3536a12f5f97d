//! The picker of colours, by mouse and by keyboard.

use crate::support::{Desk, LANGUAGES, Words};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use luch_scene::Color;

const SHADE: [&str; 2] = ["Saturation and brightness", "Насыщенность и яркость"];
const HUE: [&str; 2] = ["Hue", "Оттенок"];

/// The knight scene with the knight selected and its picker open.
fn desk(words: Words) -> Desk {
    let mut desk = Desk::new(words);
    desk.choose(words.scene, words.knight);
    desk.resize(48, 27);
    desk.select_in_list("Knight");
    desk.scroll_to(Role::ColorWell, words.color);
    desk.harness.get_by_role_and_label(Role::ColorWell, words.color).click();
    desk.settle();
    desk
}

fn knight_color(desk: &Desk) -> [u8; 3] {
    desk.harness.state().scene().objects[2].material.color.map_or([0; 3], Color::to_srgb8)
}

#[test]
fn a_drag_in_the_picker_changes_the_picture_and_is_one_step_of_undo() {
    for ((words, shade), hue) in LANGUAGES.into_iter().zip(SHADE).zip(HUE) {
        let mut desk = desk(words);
        let before = desk.moment();
        let square = desk.harness.get_by_role_and_label(Role::Slider, shade).rect();
        desk.harness.drag_at(square.center());
        desk.harness.step();
        for part in [0.6_f32, 0.8, 1.0] {
            desk.harness.hover_at(square.lerp_inside(egui::vec2(part, 1.0 - part)));
            desk.settle();
        }
        desk.harness.drop_at(square.right_top());
        desk.settle();
        let vivid = knight_color(&desk);
        assert_eq!(vivid.iter().max(), Some(&255), "full brightness: {vivid:?}");
        assert_eq!(vivid.iter().min(), Some(&0), "full saturation: {vivid:?}");
        assert!(vivid[0] == 255 && vivid[2] == 0, "still the knight's hue: {vivid:?}");
        assert!(desk.picture() != before.picture);

        let strip = desk.harness.get_by_role_and_label(Role::Slider, hue).rect();
        desk.harness.drag_at(strip.lerp_inside(egui::vec2(2.0 / 3.0, 0.5)));
        desk.harness.step();
        desk.harness.drop_at(strip.lerp_inside(egui::vec2(2.0 / 3.0, 0.5)));
        desk.settle();
        let blue = knight_color(&desk);
        assert!(blue[2] == 255 && blue[0] < 8 && blue[1] < 8, "{blue:?}");

        desk.key(Modifiers::COMMAND, Key::Z);
        assert_eq!(knight_color(&desk), vivid);
        desk.key(Modifiers::COMMAND, Key::Z);
        assert!(desk.moment() == before, "the drag is one step");
    }
}

#[test]
fn the_arrow_keys_pick_and_escape_closes() {
    for (words, shade) in LANGUAGES.into_iter().zip(SHADE) {
        let mut desk = desk(words);
        let before = knight_color(&desk);
        desk.harness.get_by_role_and_label(Role::Slider, shade).focus();
        desk.settle();
        for _ in 0..5 {
            desk.key(Modifiers::NONE, Key::ArrowDown);
        }
        let darker = knight_color(&desk);
        assert!(before.iter().zip(darker).all(|(before, after)| after < *before), "{before:?} {darker:?}");
        for _ in 0..5 {
            desk.key(Modifiers::NONE, Key::ArrowRight);
        }
        let richer = knight_color(&desk);
        assert!(richer[2] < darker[2] && richer[0] == darker[0], "{darker:?} {richer:?}");
        desk.key(Modifiers::NONE, Key::Escape);
        assert!(desk.harness.query_by_role_and_label(Role::Slider, shade).is_none());
        assert_eq!((desk.harness.state().selected(), knight_color(&desk)), (Some("Knight"), richer));
    }
}
