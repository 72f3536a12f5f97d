//! Everything by keys alone, and what has the keys is in sight.

use crate::support::{Desk, LANGUAGES};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Rect};
use egui_kittest::kittest::{NodeT, Queryable};

const LIST: [&str; 2] = ["Scene objects", "Список объектов сцены"];

/// The place of the list, and of the row that is selected, if that is there.
fn places(desk: &Desk, list: &str) -> (Rect, Option<Rect>) {
    let selected = desk.harness.state().selected().expect("a selection");
    let row = desk.harness.query_by_role_and_label(Role::Button, selected).map(|row| row.rect());
    (desk.harness.get_by_role_and_label(Role::ListBox, list).rect(), row)
}

#[test]
fn keys_go_through_the_whole_list_and_keep_the_selection_in_sight() {
    for (words, list) in LANGUAGES.into_iter().zip(LIST) {
        let mut desk = Desk::new(words);
        desk.choose(words.scene, words.chess);
        let scene = desk.harness.state().scene().clone();
        let names = scene.objects.iter().map(|o| &o.name).chain(scene.lights.iter().map(|l| &l.name));
        let names: Vec<_> = names.cloned().collect();
        assert!(names.len() > 30);
        let list_box = desk.harness.get_by_role_and_label(Role::ListBox, list);
        // Rows of 27 points; a page is one less than are seen.
        let page = (list_box.rect().height() / 27.0).round() as usize - 1;
        list_box.focus();
        desk.settle();
        let mut expect = |key: Key, place: usize| {
            desk.key(Modifiers::NONE, key);
            let selected = desk.harness.state().selected().map(str::to_owned);
            assert_eq!(selected.as_ref(), Some(&names[place]), "{key:?}");
            let (list, row) = places(&desk, list);
            let row = row.unwrap_or_else(|| panic!("{key:?}: {selected:?} is not drawn"));
            assert!(list.expand(1.0).contains_rect(row), "{key:?}: {row:?} is not in {list:?}");
        };
        for place in 0..14 {
            expect(Key::ArrowDown, place);
        }
        expect(Key::ArrowUp, 12);
        expect(Key::PageDown, 12 + page);
        expect(Key::PageUp, 12);
        expect(Key::End, names.len() - 1);
        expect(Key::ArrowDown, names.len() - 1);
        expect(Key::PageUp, names.len() - 1 - page);
        expect(Key::Home, 0);
        expect(Key::ArrowUp, 0);
        // The view has not been returned by Home, nor turned by the arrows.
        assert_eq!(desk.harness.state().camera().as_ref(), scene.cameras.first());
    }
}

#[test]
fn a_click_in_the_list_gives_it_the_keys() {
    for words in LANGUAGES {
        let mut desk = Desk::new(words);
        desk.choose(words.scene, words.knight);
        desk.select_in_list("Knight");
        let names: Vec<_> = desk.harness.state().scene().objects.iter().map(|o| o.name.clone()).collect();
        let knight = names.iter().position(|name| name == "Knight").unwrap();
        desk.key(Modifiers::NONE, Key::ArrowDown);
        assert_eq!(desk.harness.state().selected(), Some(&*names[knight + 1]));
        // The keys of the scene go on working, and the list goes on where the selection is.
        desk.key(Modifiers::NONE, Key::Delete);
        assert_eq!(desk.harness.state().scene().objects.len(), names.len() - 1);
        desk.key(Modifiers::NONE, Key::End);
        assert!(desk.harness.state().selected().is_some());
    }
}

#[test]
fn what_gets_the_focus_by_tab_comes_into_sight() {
    for words in LANGUAGES {
        // So low that much of the panel lies below the fold.
        let mut desk = Desk::in_window(words, luch_studio::Start::default(), [1000.0, 560.0], 1.0);
        desk.select_in_list("Left sphere");
        desk.harness.get_by_role_and_label(Role::TextInput, words.find_by_name).focus();
        desk.settle();
        let below = desk.harness.get_by_role_and_label(Role::Button, words.render).rect().bottom();
        let mut seen = 0;
        for _ in 0..60 {
            desk.key(Modifiers::NONE, Key::Tab);
            // Scrolling is seen to move.
            for _ in 0..12 {
                desk.harness.step();
            }
            let focused = desk.harness.root().children_recursive().find(|node| node.accesskit_node().is_focused());
            let Some(focused) = focused else { continue };
            let (name, rect) = (focused.accesskit_node().label(), focused.rect());
            assert!(rect.top() >= 0.0 && rect.bottom() <= below + 40.0, "{name:?} has the focus at {rect:?}");
            seen += 1;
            if name.as_deref() == Some(words.focal_distance) {
                break;
            }
        }
        assert!(seen > 20, "only {seen} controls have had the focus");
        let focal = desk.harness.get_by_role_and_label(Role::TextInput, words.focal_distance).rect();
        assert!(focal.bottom() < below, "the focal distance is out of sight: {focal:?}");
    }
}
