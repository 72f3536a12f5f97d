//! Asks before something would be lost: unsaved changes, or a file that is there already.

use crate::command::Command;
use crate::files::shown;
use crate::panels::scene_name;
use crate::state::Desk;
use egui::{Align, Button, Layout, Ui, vec2};
use std::path::Path;

/// Asks what to do with unsaved changes before `command` is done.
pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>, command: &Command) {
    let texts = desk.texts;
    ui.label(texts.unsaved_question(scene_name(&desk.state.document, texts)));
    let idle = !desk.files.is_saving();
    let answers = [
        (texts.button_cancel(), true, Command::CloseDialog),
        (texts.button_do_not_save(), true, Command::Discard(Box::new(command.clone()))),
        (texts.button_save(), idle, Command::SaveThen(Box::new(command.clone()))),
    ];
    buttons(ui, desk, answers, 2);
}

/// Asks whether a file may be replaced.
pub(super) fn show_replace(ui: &mut Ui, desk: &mut Desk<'_>, path: &Path, replace: &Command, back: &Command) {
    let texts = desk.texts;
    ui.label(texts.replace_question(shown(path.as_os_str())));
    let answers = [
        (texts.button_cancel(), true, Command::CloseDialog),
        (texts.button_other_name(), true, back.clone()),
        (texts.button_replace(), true, replace.clone()),
    ];
    // The careful answer is the one that Enter gives.
    buttons(ui, desk, answers, 1);
}

/// The answers from the right to the left; one of them has the focus at first.
fn buttons<const N: usize>(ui: &mut Ui, desk: &mut Desk<'_>, answers: [(String, bool, Command); N], first: usize) {
    ui.add_space(12.0);
    ui.with_layout(Layout::right_to_left(Align::Min), |ui| {
        for (place, (name, enabled, command)) in answers.into_iter().enumerate() {
            let button = ui.add_enabled(enabled, Button::new(name).min_size(vec2(110.0, 0.0)));
            if place == first && ui.ctx().memory(|m| m.focused().is_none()) {
                button.request_focus();
            }
            if button.clicked() {
                desk.send(command);
            }
        }
    });
}

/// Asks whether the window is to be closed while a picture is made.
pub(super) fn show_stop_export(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    ui.label(texts.stop_export_question());
    let answers =
        [(texts.button_cancel(), true, Command::CloseDialog), (texts.button_quit(), true, Command::QuitWithoutExport)];
    buttons(ui, desk, answers, 0);
}
