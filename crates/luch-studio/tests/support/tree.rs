//! What a screen reader would find in the window: names, values, texts, menus.

use super::Desk;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT, Queryable};
use luch_scene::Scene;

/// A scene and the bytes of its picture.
#[derive(Clone, PartialEq)]
pub struct Moment {
    pub scene: Scene,
    pub picture: super::Picture,
}

impl Desk {
    /// The scene and the picture as they are.
    pub fn moment(&self) -> Moment {
        Moment { scene: self.harness.state().scene().clone(), picture: self.picture() }
    }

    /// The names of the fields that can be typed into now.
    pub fn fields(&self) -> Vec<String> {
        let nodes = self.harness.root().children_recursive();
        let fields = nodes.filter(|node| {
            let node = node.accesskit_node();
            node.role() == Role::TextInput && !node.is_disabled()
        });
        fields.map(|field| field.accesskit_node().label().expect("a field without a name")).collect()
    }

    /// What stands in a field.
    pub fn value(&self, field: &str) -> String {
        self.harness.get_by_role_and_label(Role::TextInput, field).value().unwrap_or_default()
    }

    /// Every name, value and description in the window.
    pub fn texts(&self) -> Vec<String> {
        let nodes = self.harness.root().children_recursive();
        let texts = nodes.flat_map(|node| {
            let node = node.accesskit_node();
            [node.label(), node.value(), node.data().description().map(str::to_owned)]
        });
        texts.flatten().filter(|text| !text.is_empty()).collect()
    }

    /// Whether a text of the window has these words in it.
    pub fn says(&self, words: &str) -> bool {
        self.texts().iter().any(|text| text.contains(words))
    }

    /// Clicks a button, wherever it is.
    pub fn press(&mut self, name: &str) {
        self.harness.get_by_role_and_label(Role::Button, name).click();
        self.settle();
    }

    /// Opens a menu of the bar, and menus of it, and clicks the last entry.
    pub fn menu(&mut self, path: &[&str]) {
        for name in path {
            let is_entry = |node: &egui_kittest::Node<'_>| {
                let role = node.accesskit_node().role();
                matches!(role, Role::Button | Role::RadioButton | Role::MenuItem | Role::CheckBox)
            };
            // What a menu shows lies over everything else and comes last.
            let entry = self.harness.get_all_by_label(name).rfind(is_entry);
            entry.unwrap_or_else(|| panic!("no entry {name}")).click();
            for _ in 0..4 {
                self.harness.step();
            }
        }
        self.settle();
    }

    /// Presses a key.
    pub fn key(&mut self, modifiers: Modifiers, key: Key) {
        self.harness.key_press_modifiers(modifiers, key);
        self.settle();
    }
}
