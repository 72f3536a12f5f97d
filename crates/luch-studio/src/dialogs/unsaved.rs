//! Asks before something would be lost: unsaved changes, or a file that is there already.

use crate::command::Command;
use crate::files::shown;
use crate::state::Desk;
use egui::{Button, Ui};
use std::path::Path;

/// Asks what to do with unsaved changes before `command` is done.
pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>, command: &Command) {
    let texts = desk.texts;
    ui.label(texts.unsaved_question(&desk.scene().name));
    ui.add_space(10.0);
    ui.horizontal_wrapped(|ui| {
        let then = || Box::new(command.clone());
        let save = ui.add_enabled(!desk.files.is_saving(), Button::new(texts.button_save()));
        if ui.ctx().memory(|m| m.focused().is_none()) {
            save.request_focus();
        }
        if save.clicked() {
            desk.send(Command::SaveThen(then()));
        }
        if ui.button(texts.button_do_not_save()).clicked() {
            desk.send(Command::Discard(then()));
        }
        if ui.button(texts.button_cancel()).clicked() {
            desk.send(Command::CloseDialog);
        }
    });
}

/// Asks whether a file may be replaced.
pub(super) fn show_replace(ui: &mut Ui, desk: &mut Desk<'_>, path: &Path, replace: &Command, back: &Command) {
    let texts = desk.texts;
    ui.label(texts.replace_question(shown(path.as_os_str())));
    ui.add_space(10.0);
    ui.horizontal_wrapped(|ui| {
        if ui.button(texts.button_replace()).clicked() {
            desk.send(replace.clone());
        }
        // The careful answer is the one that Enter gives.
        let other = ui.button(texts.button_other_name());
        if ui.ctx().memory(|m| m.focused().is_none()) {
            other.request_focus();
        }
        if other.clicked() {
            desk.send(back.clone());
        }
        if ui.button(texts.button_cancel()).clicked() {
            desk.send(Command::CloseDialog);
        }
    });
}

/// Asks whether the window is to be closed while a picture is made.
pub(super) fn show_stop_export(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    ui.label(texts.stop_export_question());
    ui.add_space(10.0);
    ui.horizontal_wrapped(|ui| {
        if ui.button(texts.button_quit()).clicked() {
            desk.send(Command::QuitWithoutExport);
        }
        let stay = ui.button(texts.button_cancel());
        if ui.ctx().memory(|m| m.focused().is_none()) {
            stay.request_focus();
        }
        if stay.clicked() {
            desk.send(Command::CloseDialog);
        }
    });
}
