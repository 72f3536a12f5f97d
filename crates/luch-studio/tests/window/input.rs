//! Wrong input: the field says what is wrong, the last good value stays, scene and picture are as they were.

use crate::support::{Desk, LANGUAGES, Words};
use egui::{Key, Modifiers, accesskit::Role};
use egui_kittest::kittest::Queryable;
use std::collections::HashSet;

/// What the fields say, in a language: a number is missing; this is no number; no whole number; out of range; no color.
struct Complaints {
    missing: &'static str,
    no_number: &'static str,
    no_whole: &'static str,
    range: &'static str,
    no_color: &'static str,
    name_taken: &'static str,
    name_form: &'static str,
    name: &'static str,
    scene_name: &'static str,
    filter: &'static str,
    second_color: &'static str,
    background: &'static str,
    bounded: &'static str,
    checker: &'static str,
}

const ENGLISH: Complaints = Complaints {
    missing: "A number is missing",
    no_number: "is not a number",
    no_whole: "is not a whole number",
    range: "Must be from",
    no_color: "is not a color",
    name_taken: "is taken",
    name_form: "A name needs",
    name: "Name",
    scene_name: "Scene name",
    filter: "Find by name",
    second_color: "Second color",
    background: "Background",
    bounded: "Bounded",
    checker: "Squares of a second color",
};

const RUSSIAN: Complaints = Complaints {
    missing: "Не хватает числа",
    no_number: "не число",
    no_whole: "не целое число",
    range: "Допустимо от",
    no_color: "не цвет",
    name_taken: "занято",
    name_form: "В имени должно быть",
    name: "Имя",
    scene_name: "Имя сцены",
    filter: "Найти по имени",
    second_color: "Второй цвет",
    background: "Фон",
    bounded: "Ограниченная",
    checker: "Клетки второго цвета",
};

fn complaints(words: &Words) -> &'static Complaints {
    if words.language == "en" { &ENGLISH } else { &RUSSIAN }
}

/// The knight scene, small, with every control enabled.
fn desk(words: Words) -> Desk {
    let mut desk = Desk::new(words);
    desk.choose(words.scene, words.knight);
    desk.resize(48, 27);
    desk.tick(words.antialiasing);
    desk.tick(words.depth_of_field);
    for field in [words.rays_per_pixel, words.rays_over_the_lens] {
        desk.type_into(field, "2");
    }
    desk
}

/// Types what is wrong into a field and expects to be told so, and nothing else to happen.
fn assert_refused(desk: &mut Desk, field: &str, typed: &str, complaint: &str) {
    let (before, value) = (desk.moment(), desk.value(field));
    desk.type_into(field, typed);
    assert!(desk.says(complaint), "{field}: nothing is said about {typed:?}");
    assert_eq!(desk.value(field), value, "{field}: {typed:?} stays in it");
    assert!(desk.moment() == before, "{field}: {typed:?} changed the scene or its picture");
}

fn assert_no_complaint(desk: &Desk, field: &str) {
    let words = complaints(&desk.words);
    for complaint in [words.missing, words.no_number, words.no_whole, words.range, words.no_color, words.name_form] {
        assert!(!desk.says(complaint), "{field}: {complaint}");
    }
}

#[test]
fn every_field_for_a_number_refuses_what_is_none_and_says_why() {
    for words in LANGUAGES {
        let told = complaints(&words);
        let mut desk = desk(words);
        let mut done = HashSet::new();
        for part in ["Knight", "Cube", "Sphere", "Floor", "Lamp"] {
            desk.select_in_list(part);
            if part == "Floor" {
                desk.tick(told.bounded);
            }
            let colors = [words.color, told.second_color, told.background];
            for field in desk.fields() {
                if colors.contains(&&*field)
                    || [told.name, told.scene_name, told.filter].contains(&&*field)
                    || !done.insert(field.clone())
                {
                    continue;
                }
                for (typed, complaint) in
                    [("abc", told.no_number), ("", told.missing), ("NaN", told.no_number), ("1e300", told.range)]
                {
                    assert_refused(&mut desk, &field, typed, complaint);
                }
            }
        }
        assert!(done.len() >= 29, "only {} fields: {done:?}", done.len());
    }
}

#[test]
fn each_kind_of_field_refuses_all_that_people_mistype() {
    for words in LANGUAGES {
        let told = complaints(&words);
        let mut desk = desk(words);
        desk.select_in_list("Knight");
        let wrong = [
            ("   ", told.missing),
            ("восемь", told.no_number),
            ("8o", told.no_number),
            ("--3", told.no_number),
            ("1 2", told.no_number),
            ("1,2,3", told.no_number),
            ("0x10", told.no_number),
            ("50 $", told.no_number),
            ("inf", told.no_number),
            ("-Infinity", told.no_number),
            ("1e400", told.range),
            ("-1e300", told.range),
        ];
        // A share in percent, an angle, a length, a whole number.
        let kinds = [words.gloss, words.field_of_view, words.focal_distance, words.rays_per_pixel];
        for field in kinds {
            for (typed, complaint) in wrong {
                assert_refused(&mut desk, field, typed, complaint);
            }
        }
        // The ends of the ranges, and units where they do not belong.
        let more = [
            (words.gloss, "100.5", told.range),
            (words.gloss, "-1", told.range),
            (words.gloss, "50°", told.no_number),
            (words.gloss, "%", told.missing),
            (words.field_of_view, "0", told.range),
            (words.field_of_view, "180", told.range),
            (words.field_of_view, "90 %", told.no_number),
            (words.focal_distance, "0", told.range),
            (words.focal_distance, "5 %", told.no_number),
            (words.rays_per_pixel, "0", told.range),
            (words.rays_per_pixel, "4097", told.range),
            (words.rays_per_pixel, "2.5", told.no_whole),
            (words.rays_per_pixel, "2,5", told.no_whole),
            (words.picture_width, "0", told.range),
            (words.picture_height, "65536", told.range),
            (words.picture_height, "12.5", told.no_whole),
        ];
        for (field, typed, complaint) in more {
            assert_refused(&mut desk, field, typed, complaint);
        }
    }
}

#[test]
fn numbers_are_taken_as_people_write_them() {
    for words in LANGUAGES {
        let mut desk = desk(words);
        desk.select_in_list("Knight");
        let good = [
            (words.gloss, "12,5", "12.5 %"),
            (words.gloss, " 80 % ", "80 %"),
            (words.gloss, "7%", "7 %"),
            (words.field_of_view, "33,25°", "33.25°"),
            (words.field_of_view, "4e1", "40°"),
            (words.focal_distance, "  2,75", "2.75"),
            (words.rays_per_pixel, " 3 ", "3"),
        ];
        for (field, typed, written) in good {
            // What was wrong before is forgotten.
            assert_refused(&mut desk, field, "?", complaints(&words).no_number);
            let before = desk.moment();
            desk.type_into(field, typed);
            assert_eq!(desk.value(field), written, "{field}: {typed:?}");
            assert!(desk.moment() != before, "{field}: {typed:?} changed nothing");
            assert_no_complaint(&desk, field);
        }
        let knight = &desk.harness.state().scene().objects[2];
        assert_eq!(knight.material.gloss.map(luch_scene::Unit::get), Some(0.07));
    }
}

#[test]
fn what_is_wrong_is_said_while_it_is_typed_and_escape_brings_the_value_back() {
    for words in LANGUAGES {
        let told = complaints(&words);
        let mut desk = desk(words);
        let before = desk.moment();
        desk.begin_typing(words.field_of_view, "ab");
        assert!(desk.says(told.no_number), "before Enter");
        assert_eq!(desk.value(words.field_of_view), "ab");
        desk.key(Modifiers::NONE, Key::Escape);
        assert_eq!(desk.value(words.field_of_view), "36°");
        assert_no_complaint(&desk, words.field_of_view);
        // A good value is not taken before Enter, and not at all after Escape.
        desk.begin_typing(words.field_of_view, "50");
        assert!(desk.moment() == before);
        desk.key(Modifiers::NONE, Key::Escape);
        assert!(desk.moment() == before);
        // A field that is left is done, as with Enter.
        desk.begin_typing(words.field_of_view, "50");
        desk.key(Modifiers::NONE, Key::Tab);
        assert_eq!(desk.harness.state().scene().cameras[0].fov.get(), 50.0);
    }
}

#[test]
fn a_complaint_is_read_where_the_field_is_left_to_and_goes_when_one_goes_on() {
    for words in LANGUAGES {
        let told = complaints(&words);
        let mut desk = desk(words);
        desk.select_in_list("Knight");
        let fields = [
            (words.field_of_view, "-", told.no_number),
            (words.color, "#12", told.no_color),
            (words.gloss, "", told.missing),
        ];
        for (field, typed, complaint) in fields {
            desk.begin_typing(field, typed);
            desk.key(Modifiers::NONE, Key::Tab);
            assert!(desk.says(complaint), "{field}: nothing is said after Tab");
            desk.key(Modifiers::NONE, Key::Tab);
            desk.key(Modifiers::NONE, Key::Tab);
            assert_no_complaint(&desk, field);
        }
        desk.type_into(words.gloss, "");
        assert!(desk.says(told.missing), "nothing is said after Enter");
        desk.select_in_list("Cube");
        assert_no_complaint(&desk, words.gloss);
    }
}

#[test]
fn a_code_that_is_no_color_is_refused() {
    for words in LANGUAGES {
        let told = complaints(&words);
        let mut desk = desk(words);
        desk.select_in_list("Knight");
        desk.tick(told.checker);
        for field in [words.color, told.second_color, told.background] {
            for typed in ["", "#", "red", "красный", "#12", "#gggggg", "#1234567", "ffff00", "# ffff00", "#ффффффф"]
            {
                assert_refused(&mut desk, field, typed, told.no_color);
            }
            desk.type_into(field, "#0f8");
            assert_eq!(desk.value(field), "#00ff88");
            assert_no_complaint(&desk, field);
        }
    }
}

#[test]
fn a_name_that_is_taken_or_no_name_is_refused() {
    for words in LANGUAGES {
        let told = complaints(&words);
        let mut desk = desk(words);
        desk.select_in_list("Cube");
        let long = "имя".repeat(50);
        for (typed, complaint) in [
            ("Knight", told.name_taken),
            ("Lamp", told.name_taken),
            ("", told.name_form),
            ("a\u{7f}b", told.name_form),
            ("a\u{1b}b", told.name_form),
            (&long, told.name_form),
        ] {
            assert_refused(&mut desk, told.name, typed, complaint);
        }
        let before = desk.moment();
        desk.type_into(told.name, "Кубик 2");
        assert_no_complaint(&desk, told.name);
        assert_eq!(desk.harness.state().selected(), Some("Кубик 2"));
        assert!(desk.picture() == before.picture, "a name is not seen");
    }
}

#[test]
fn sliders_stand_numbers_from_outside_their_range() {
    for words in LANGUAGES {
        let mut desk = desk(words);
        desk.select_in_list("Knight");
        for slider in [words.gloss, words.field_of_view, words.focal_distance, words.rays_per_pixel] {
            for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300, -1e300] {
                desk.harness.get_by_role_and_label(Role::Slider, slider).set_value_accesskit(value);
                desk.settle();
                assert_no_complaint(&desk, slider);
            }
            desk.key(Modifiers::COMMAND, Key::Z);
        }
    }
}

#[test]
fn escape_in_a_menu_closes_the_menu_and_nothing_else() {
    for (words, [menu, entry]) in LANGUAGES.into_iter().zip([["Edit", "Duplicate"], ["Правка", "Дублировать"]])
    {
        let mut desk = desk(words);
        desk.select_in_list("Knight");
        desk.menu(&[menu]);
        assert!(desk.says(entry));
        desk.key(Modifiers::NONE, Key::Escape);
        assert!(!desk.says(entry), "the menu is still open");
        assert_eq!(desk.harness.state().selected(), Some("Knight"));
        desk.key(Modifiers::NONE, Key::Escape);
        assert_eq!(desk.harness.state().selected(), None);
    }
}
