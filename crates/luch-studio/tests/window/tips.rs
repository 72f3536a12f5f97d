//! Every control of the panel says what it drives: to the pointer that rests on it, and to a screen reader.

use crate::support::{Desk, LANGUAGES};
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT, Queryable};
use std::collections::HashSet;

/// What has to say something. Buttons are called by what they do.
const ROLES: [Role; 6] =
    [Role::TextInput, Role::Slider, Role::CheckBox, Role::RadioButton, Role::ComboBox, Role::ColorWell];
/// Says in itself what it is for.
const SELF_EVIDENT: [&str; 2] = ["Find by name", "Найти по имени"];
/// Switched on there are more controls.
const SWITCHES: [&str; 4] = ["Bounded", "Ограниченная", "Squares of a second color", "Клетки второго цвета"];

/// The controls with their names and what they say.
fn controls(desk: &Desk) -> Vec<(Role, String, String)> {
    let nodes = desk.harness.root().children_recursive();
    let controls = nodes.filter_map(|node| {
        let node = node.accesskit_node();
        let name = node.label().filter(|_| ROLES.contains(&node.role()))?;
        Some((node.role(), name, node.data().description().unwrap_or_default().to_owned()))
    });
    controls.collect()
}

#[test]
fn every_control_says_what_it_drives() {
    for words in LANGUAGES {
        let mut desk = Desk::new(words);
        desk.choose(words.scene, words.knight);
        desk.resize(32, 24);
        let (mut done, mut said) = (HashSet::new(), HashSet::new());
        for part in ["Knight", "Cube", "Sphere", "Floor", "Lamp"] {
            desk.select_in_list(part);
            for name in SWITCHES {
                if ["Floor", "Knight"].contains(&part)
                    && desk.harness.query_by_role_and_label(Role::CheckBox, name).is_some()
                {
                    desk.tick(name);
                }
            }
            for (role, name, says) in controls(&desk) {
                let evident = SELF_EVIDENT.contains(&&*name);
                assert!(evident || says.chars().count() > 12, "{role:?} {name} of {part} says {says:?}");
                done.insert((role, name));
                said.insert(says);
            }
        }
        assert!(done.len() > 50, "only {} controls", done.len());
        assert!(said.len() > 30, "they say only {} things", said.len());
    }
}

#[test]
fn the_intensity_of_one_light_is_not_that_of_all() {
    for (words, [name, one]) in
        LANGUAGES.into_iter().zip([["Intensity", "I_l of this light"], ["Интенсивность", "I_l этого источника"]])
    {
        let mut desk = Desk::new(words);
        desk.select_in_list("Lamp");
        for (_, control, says) in controls(&desk) {
            assert!(control != name || says.starts_with(one), "{says}");
            assert!(control != words.light_intensity || !says.starts_with(one), "{says}");
        }
    }
}

#[test]
fn the_kind_of_each_thing_in_the_list_has_a_name() {
    for (words, kinds) in LANGUAGES
        .into_iter()
        .zip([["Model", "Cube", "Sphere", "Wall", "Lamp"], ["Модель", "Куб", "Сфера", "Стена", "Лампа"]])
    {
        let mut desk = Desk::new(words);
        desk.choose(words.scene, words.knight);
        for kind in kinds {
            let found = desk.harness.query_all_by_role_and_label(Role::Image, kind).count();
            assert!(found > 0, "nothing in the list is called {kind}");
        }
    }
}
