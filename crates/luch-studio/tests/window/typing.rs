//! The keys of whoever types are the text's: undo, redo, delete and the rest do nothing to the scene meanwhile.

use crate::support::{Desk, LANGUAGES};
use egui::{Key, Modifiers};

/// What somebody presses who changes a text, and expects to be about the text.
const KEYS: [(Modifiers, Key); 8] = [
    (Modifiers::COMMAND, Key::Z),
    (Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z),
    (Modifiers::COMMAND, Key::D),
    (Modifiers::NONE, Key::Delete),
    (Modifiers::NONE, Key::Home),
    (Modifiers::NONE, Key::H),
    (Modifiers::NONE, Key::Num2),
    (Modifiers::COMMAND, Key::A),
];

/// Presses them all, and expects that nothing happens to the scene.
fn press_all(desk: &mut Desk, field: &str) {
    let before = desk.moment();
    for (modifiers, key) in KEYS {
        desk.key(modifiers, key);
        assert!(desk.moment() == before, "{key:?} in {field} changed the scene");
    }
}

#[test]
fn keys_are_the_texts_while_somebody_types() {
    for words in LANGUAGES {
        let mut desk = Desk::new(words);
        desk.resize(64, 48);
        desk.select_in_list("Left sphere");
        desk.type_into(words.field_of_view, "40");
        let before = desk.moment();
        for field in [words.field_of_view, words.color, words.find_by_name] {
            desk.begin_typing(field, "5");
            press_all(&mut desk, field);
            desk.key(Modifiers::NONE, Key::Escape);
            assert_eq!(desk.harness.state().selected(), Some("Left sphere"));
        }
        // Left again, they are the scene's.
        desk.key(Modifiers::COMMAND, Key::Z);
        assert!(desk.moment() != before, "undo");
    }
}

#[test]
fn a_text_takes_its_own_changes_back() {
    for words in LANGUAGES {
        let mut desk = Desk::new(words);
        let before = desk.value(words.field_of_view);
        desk.begin_typing(words.field_of_view, "55");
        for _ in 0..4 {
            desk.key(Modifiers::COMMAND, Key::Z);
        }
        assert_eq!(desk.value(words.field_of_view), before);
    }
}

#[test]
fn keys_are_the_texts_in_the_study_window_too() {
    for (words, [menu, entry, field]) in
        LANGUAGES.into_iter().zip([["View", "Study…", "Runs of each"], ["Вид", "Исследование…", "Повторов каждого"]])
    {
        let mut desk = Desk::new(words);
        desk.type_into(words.field_of_view, "40");
        desk.menu(&[menu, entry]);
        desk.begin_typing(field, "7");
        press_all(&mut desk, field);
    }
}
