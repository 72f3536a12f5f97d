//! A colour: a patch that opens a picker, and its hex code.

use super::left::Left;
use super::{picker, row};
use crate::l10n::Texts;
use crate::undo::Gesture;
use egui::{TextEdit, Ui, vec2};
use luch_scene::Color;

/// Shows a line with a colour; answers with a new one when there is one.
pub(crate) fn field(ui: &mut Ui, texts: &Texts, name: &str, tooltip: &str, value: Color) -> Option<(Color, Gesture)> {
    let id = ui.scope_id().with(("color", name));
    let (mut typed, mut error, mut left): (Option<String>, Option<String>, Left) =
        ui.data(|d| d.get_temp(id)).unwrap_or_default();
    if error.is_some() && left.has_gone_on(ui, id.with("code")) {
        error = None;
    }
    let changed = row::labelled(ui, name, tooltip, |ui, label| {
        let (patch, picked) = picker::button(ui, texts, name, value.to_srgb8());
        row::tip(&patch.labelled_by(label.id), tooltip);
        let picked = picked.map(|(rgb, gesture)| (Color::srgb8(rgb), gesture));

        // The code of a colour that eight bits cannot say is the nearest one, and changes nothing until it is typed over.
        let [r, g, b] = value.to_srgb8();
        let mut text = typed.clone().unwrap_or_else(|| format!("#{r:02x}{g:02x}{b:02x}"));
        let edit = TextEdit::singleline(&mut text).id(id.with("code")).char_limit(16);
        let code = ui.add_sized(vec2(80.0, ui.spacing().interact_size.y), edit).labelled_by(label.id);
        row::tip(&code, tooltip);
        if code.changed() {
            error = Color::from_hex(&text).is_none().then(|| texts.input_no_color(&text));
            typed = Some(text);
        }
        let mut entered = None;
        if code.lost_focus()
            && let Some(text) = typed.take()
        {
            if ui.input(|i| i.key_pressed(egui::Key::Escape)) {
                error = None;
            } else {
                entered = Color::from_hex(&text).map(|color| (color, Gesture::Single));
            }
        }
        picked.or(entered)
    });
    if let Some(error) = &error {
        row::complaint(ui, error);
    }
    ui.data_mut(|d| d.insert_temp(id, (typed, error, left)));
    changed.filter(|(color, _)| *color != value)
}
