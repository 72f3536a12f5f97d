//! What asks or tells: windows over the picture, one at a time.

mod about;
mod shortcuts;

use crate::command::Command;
use crate::l10n::Texts;
use crate::state::Desk;
use egui::{Context, Id, Modal};

/// A dialog. What is typed into it is its own business; only what is decided becomes a command.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Dialog {
    /// The version and the facts of the renderer.
    About,
    /// All keys and what the mouse does.
    Shortcuts,
}

impl Dialog {
    /// What a menu calls it.
    pub(crate) fn label(&self, texts: &Texts) -> String {
        match self {
            Self::About => texts.dialog_about(),
            Self::Shortcuts => texts.dialog_shortcuts(),
        }
    }
}

/// Shows the dialog that is open.
pub(crate) fn show(ctx: &Context, desk: &mut Desk<'_>) {
    let Some(dialog) = desk.state.dialog.clone() else { return };
    let title = dialog.label(desk.texts);
    let response = Modal::new(Id::unique("dialog")).show(ctx, |ui| {
        ui.set_max_width(520.0);
        ui.heading(title);
        ui.separator();
        match &dialog {
            Dialog::About => about::show(ui, desk),
            Dialog::Shortcuts => shortcuts::show(ui, desk),
        }
    });
    if response.should_close() {
        desk.send(Command::CloseDialog);
    }
}

/// The button that closes a dialog which only tells.
fn close_button(ui: &mut egui::Ui, desk: &mut Desk<'_>) {
    ui.add_space(8.0);
    ui.vertical_centered(|ui| {
        if ui.button(desk.texts.dialog_close()).clicked() {
            desk.send(Command::CloseDialog);
        }
    });
}
