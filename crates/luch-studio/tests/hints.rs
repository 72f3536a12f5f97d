//! The hints of the first run.

#[path = "support/mod.rs"]
mod support;

use egui_kittest::kittest::Queryable;
use luch_studio::Start;
use support::{Desk, LANGUAGES};

#[test]
fn the_hints_are_shown_until_they_are_read() {
    for (words, understood) in LANGUAGES.into_iter().zip(["Understood", "Понятно"]) {
        let mut desk = Desk::start(words, Start { hints: true, ..Start::default() });
        desk.harness.get_by_label(understood).click();
        desk.settle();
        assert!(desk.harness.query_by_label(understood).is_none());
        let desk = Desk::new(words);
        assert!(desk.harness.query_by_label(understood).is_none(), "nobody asked for hints");
    }
}
