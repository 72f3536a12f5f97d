//! A name or other short text that is taken at Enter or when the field is left.

use super::left::Left;
use super::row;
use egui::{TextEdit, Ui, vec2};

/// Shows a line with a text; `check` says what is wrong with one. Answers with a new text when there is one.
pub(crate) fn field(
    ui: &mut Ui,
    name: &str,
    tooltip: &str,
    value: &str,
    check: impl Fn(&str) -> Result<(), String>,
) -> Option<String> {
    let id = ui.scope_id().with(("text", name));
    let (mut text, mut error, mut left): (Option<String>, Option<String>, Left) =
        ui.data(|d| d.get_temp(id)).unwrap_or_default();
    if error.is_some() && left.has_gone_on(ui, id.with("field")) {
        error = None;
    }
    let changed = row::labelled(ui, name, tooltip, |ui, label| {
        let mut shown = text.clone().unwrap_or_else(|| value.to_owned());
        let width = ui.available_width();
        let edit = TextEdit::singleline(&mut shown).id(id.with("field")).char_limit(256);
        let response = ui.add_sized(vec2(width, ui.spacing().interact_size.y), edit).labelled_by(label.id);
        row::tip(&response, tooltip);
        if response.changed() {
            error = if shown == value { None } else { check(&shown).err() };
            text = Some(shown.clone());
        }
        if !response.lost_focus() {
            return None;
        }
        let typed = text.take()?;
        if ui.input(|i| i.key_pressed(egui::Key::Escape)) || typed == value {
            error = None;
            return None;
        }
        error = check(&typed).err();
        error.is_none().then_some(typed)
    });
    if let Some(error) = &error {
        row::complaint(ui, error);
    }
    ui.data_mut(|d| d.insert_temp(id, (text, error, left)));
    changed
}
