//! The account on the clipboard.

use crate::clicks::{explained, pixel};
use crate::support::Desk;
use egui::OutputCommand;
use egui_kittest::kittest::Queryable;

/// Chooses an entry of the menu and answers with what comes to the clipboard.
fn copy(desk: &mut Desk, entry: &str) -> String {
    desk.harness.get_by_label("Copy").click();
    desk.harness.step();
    desk.harness.step();
    desk.harness.get_by_label(entry).click();
    loop {
        desk.harness.step();
        let commands = desk.harness.output().platform_output.commands.iter();
        let mut texts = commands.filter_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        });
        if let Some(text) = texts.next() {
            desk.settle();
            return text;
        }
        std::thread::yield_now();
    }
}

#[test]
fn the_account_is_copied_in_every_form() {
    let mut desk = explained(0.36, 0.5);
    let [x, y] = pixel(&desk);
    let text = copy(&mut desk, "As text");
    assert!(text.contains(&format!("{x},{y}")) && text.contains("cos θ = N · L"), "{text}");
    let markdown = copy(&mut desk, "As Markdown");
    assert!(markdown.contains("$$") && markdown.contains("Left sphere"), "{markdown}");
    let latex = copy(&mut desk, "As LaTeX");
    assert!(latex.contains("\\begin{document}") && latex.contains("\\frac"), "{latex}");
    let json = copy(&mut desk, "As JSON");
    let value: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert!(value["pixel"].is_array() && value["rays"].is_array(), "{json}");
    desk.harness.get_by_label("The explanation is copied");
}
