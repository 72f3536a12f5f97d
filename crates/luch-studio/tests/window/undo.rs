//! Undo and redo bring back the scene and the very bytes of its picture, whatever was changed.

use crate::support::{Desk, LANGUAGES, Words};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

/// One change that a person can make.
type Change<'a> = (&'a str, Box<dyn Fn(&mut Desk) + 'a>);

fn typing<'a>(field: &'a str, text: &'a str) -> Change<'a> {
    (field, Box::new(move |desk| desk.type_into(field, text)))
}

fn ticking(name: &str) -> Change<'_> {
    (name, Box::new(move |desk| desk.tick(name)))
}

/// What is done, and undone, with the knight selected.
fn changes<'a>(words: &'a Words, more: &'a More) -> Vec<Change<'a>> {
    vec![
        typing(words.field_of_view, "50"),
        typing(words.color, "#ffff00"),
        typing(words.reflection, "70"),
        typing(words.gloss, "5"),
        ticking(more.checker),
        (more.shading, Box::new(|desk| desk.choose(more.shading, more.flat))),
        typing(more.position, "0.3"),
        typing(more.rotation, "100"),
        typing(more.scale, "1.2"),
        typing(words.light_intensity, "30"),
        ticking(words.antialiasing),
        ticking(words.depth_of_field),
        (more.flat, Box::new(|desk| desk.choose_radio(more.flat))),
        typing(more.ambient, "0.9"),
        typing(more.attenuation, "3"),
        typing(more.depth, "1"),
        typing(words.picture_width, "50"),
        typing(words.picture_height, "40"),
        (more.hide, Box::new(|desk| desk.press_in_list(more.hide))),
        ("delete", Box::new(|desk| desk.key(Modifiers::NONE, Key::Delete))),
    ]
}

/// Words that only these tests need.
struct More {
    checker: &'static str,
    shading: &'static str,
    flat: &'static str,
    position: &'static str,
    rotation: &'static str,
    scale: &'static str,
    ambient: &'static str,
    attenuation: &'static str,
    depth: &'static str,
    hide: &'static str,
    name: &'static str,
    background: &'static str,
}

const WORDS: [More; 2] = [
    More {
        checker: "Squares of a second color",
        shading: "Shading of the object",
        flat: "Flat",
        position: "Position X",
        rotation: "Rotation Y",
        scale: "Scale",
        ambient: "Ambient light",
        attenuation: "Attenuation K",
        depth: "Depth",
        hide: "Hide: Knight",
        name: "Name",
        background: "Background",
    },
    More {
        checker: "Клетки второго цвета",
        shading: "Закраска объекта",
        flat: "Плоская",
        position: "Положение X",
        rotation: "Поворот Y",
        scale: "Масштаб",
        ambient: "Рассеянный свет",
        attenuation: "Затухание K",
        depth: "Глубина",
        hide: "Скрыть: Knight",
        name: "Имя",
        background: "Фон",
    },
];

const REDO: Modifiers = Modifiers::COMMAND.plus(Modifiers::SHIFT);

/// The knight scene with the knight selected and nothing to undo but its size.
fn desk(words: Words) -> Desk {
    let mut desk = Desk::new(words);
    desk.choose(words.scene, words.knight);
    desk.resize(64, 36);
    desk.select_in_list("Knight");
    desk
}

#[test]
fn each_kind_of_change_is_taken_back_and_made_again_to_the_last_byte() {
    for (words, more) in LANGUAGES.into_iter().zip(&WORDS) {
        let mut desk = desk(words);
        let before = desk.moment();
        for (name, change) in changes(&words, more) {
            change(&mut desk);
            let after = desk.moment();
            assert!(after.picture != before.picture, "{name} is not seen");
            desk.key(Modifiers::COMMAND, Key::Z);
            assert!(desk.moment() == before, "{name} is not taken back");
            desk.key(REDO, Key::Z);
            assert!(desk.moment() == after, "{name} is not made again");
            desk.key(Modifiers::COMMAND, Key::Z);
            assert!(desk.moment() == before, "{name} is not taken back again");
            if desk.harness.state().selected() != Some("Knight") {
                desk.select_in_list("Knight");
            }
        }
    }
}

#[test]
fn changes_that_no_picture_shows_are_taken_back_too() {
    for (words, more) in LANGUAGES.into_iter().zip(&WORDS) {
        let mut desk = desk(words);
        let before = desk.moment();
        let quiet: [Change<'_>; 4] = [
            typing(more.name, "Конь"),
            // The background is hidden behind the floor and the wall, but for what mirrors may show.
            typing(more.background, "#2a313b"),
            // No effect without depth of field.
            typing(words.focal_distance, "2"),
            ("duplicate", Box::new(|desk| desk.key(Modifiers::COMMAND, Key::D))),
        ];
        for (name, change) in quiet {
            change(&mut desk);
            let after = desk.moment();
            assert!(after.scene != before.scene, "{name} changes nothing");
            desk.key(Modifiers::COMMAND, Key::Z);
            assert!(desk.moment() == before, "{name} is not taken back");
            desk.key(REDO, Key::Z);
            assert!(desk.moment() == after, "{name} is not made again");
            desk.key(Modifiers::COMMAND, Key::Z);
            assert!(desk.moment() == before, "{name} is not taken back again");
        }
    }
}

#[test]
fn a_long_history_leads_back_to_the_first_picture() {
    for (words, more) in LANGUAGES.into_iter().zip(&WORDS) {
        let mut desk = desk(words);
        let before = desk.moment();
        let all = changes(&words, more);
        let mut moments = Vec::new();
        // All but hiding and deleting, after which there is no knight to change.
        let count = all.len() - 2;
        for (_, change) in &all[..count] {
            moments.push(desk.moment());
            change(&mut desk);
        }
        let last = desk.moment();
        for moment in moments.iter().rev() {
            desk.key(Modifiers::COMMAND, Key::Z);
            assert!(desk.moment() == *moment);
        }
        assert!(desk.moment() == before);
        for _ in 0..count {
            desk.key(REDO, Key::Z);
        }
        assert!(desk.moment() == last);
    }
}

#[test]
fn a_key_that_is_held_on_a_slider_is_one_step_and_pressed_again_is_another() {
    for words in LANGUAGES {
        let mut desk = desk(words);
        let mut moments = vec![desk.moment()];
        desk.harness.get_by_role_and_label(Role::Slider, words.field_of_view).focus();
        desk.settle();
        for _ in 0..2 {
            for _ in 0..5 {
                desk.harness.key_down(Key::ArrowRight);
                desk.settle();
            }
            desk.harness.key_up(Key::ArrowRight);
            desk.settle();
            moments.push(desk.moment());
        }
        assert!(moments[0] != moments[1] && moments[1] != moments[2]);
        for moment in moments[..2].iter().rev() {
            desk.key(Modifiers::COMMAND, Key::Z);
            assert!(desk.moment() == *moment, "the held key is one step");
        }
    }
}

#[test]
fn a_scene_is_renamed_and_the_name_is_taken_back() {
    for (words, [field, form]) in
        LANGUAGES.into_iter().zip([["Scene name", "A name needs"], ["Имя сцены", "В имени должно быть"]])
    {
        let mut desk = desk(words);
        let before = desk.moment();
        desk.type_into(field, "  ");
        assert!(desk.says(form) && desk.moment() == before);
        desk.type_into(field, "Мой конь");
        assert_eq!(desk.harness.state().scene().name, "Мой конь");
        assert!(desk.picture() == before.picture);
        desk.key(Modifiers::COMMAND, Key::Z);
        assert!(desk.moment() == before);
    }
}
