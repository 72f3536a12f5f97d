//! What asks or tells: windows over the picture, one at a time.

mod about;
mod camera;
mod entries;
mod export;
mod path;
mod path_field;
mod recover;
mod shortcuts;
mod unsaved;

use crate::command::Command;
use crate::files::Purpose;
use crate::l10n::Texts;
use crate::state::Desk;
use egui::{Button, Context, Frame, Id, Modal, RichText};
use std::path::PathBuf;

/// A dialog. What is typed into it is its own business; only what is decided becomes a command.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Dialog {
    /// The version and the facts of the renderer.
    About,
    /// All keys and what the mouse does.
    Shortcuts,
    /// Asks for a path.
    Path {
        /// What it is for.
        purpose: Purpose,
        /// What to do when the file is written.
        then: Option<Box<Command>>,
    },
    /// Asks what picture is to be made for a file.
    Export,
    /// Offers scenes that an earlier program had not saved.
    Recover,
    /// Asks for another name of a camera.
    RenameCamera(usize),
    /// Asks before the window closes while a picture is made.
    StopExport,
    /// Asks what to do with unsaved changes before something is done.
    Unsaved(Box<Command>),
    /// Asks whether a file may be replaced.
    Replace {
        /// What the file is for.
        purpose: Purpose,
        /// The file.
        path: PathBuf,
        /// What replaces it.
        replace: Box<Command>,
        /// What asks for another name.
        back: Box<Command>,
    },
}

impl Dialog {
    /// What a menu calls it.
    pub(crate) fn label(&self, texts: &Texts) -> String {
        match self {
            Self::About => texts.dialog_about(),
            Self::Shortcuts => texts.dialog_shortcuts(),
            Self::Path { purpose, .. } => purpose.title(texts),
            Self::Export => texts.dialog_export(),
            Self::Recover => texts.dialog_recover(),
            Self::RenameCamera(_) => texts.dialog_rename_camera(),
            Self::StopExport => texts.dialog_stop_export(),
            Self::Unsaved(_) => texts.dialog_unsaved(),
            Self::Replace { .. } => texts.dialog_replace(),
        }
    }
}

/// Forgets what was typed into dialogs that are closed.
pub(crate) fn forget(ctx: &Context) {
    for purpose in [Purpose::Open, Purpose::Save, Purpose::AddModel, Purpose::Export] {
        path_field::forget(ctx, purpose);
    }
    export::forget(ctx);
    camera::forget(ctx);
}

/// Shows the dialog that is open.
pub(crate) fn show(ctx: &Context, desk: &mut Desk<'_>) {
    let Some(dialog) = desk.state.dialog.clone() else { return };
    let title = dialog.label(desk.texts);
    let frame = Frame::popup(&ctx.global_style()).inner_margin(14);
    let response = Modal::new(Id::unique("dialog")).frame(frame).show(ctx, |ui| {
        ui.set_max_width(if dialog == Dialog::Shortcuts { shortcuts::WIDTH } else { 560.0 });
        // In a menu the dots say that a dialog comes; here it is.
        ui.label(RichText::new(title.trim_end_matches('…')).heading().strong());
        ui.separator();
        match &dialog {
            Dialog::About => about::show(ui, desk),
            Dialog::Shortcuts => shortcuts::show(ui, desk),
            Dialog::Path { purpose, then } => path::show(ui, desk, *purpose, then.as_deref()),
            Dialog::Export => export::show(ui, desk),
            Dialog::Recover => recover::show(ui, desk),
            Dialog::RenameCamera(index) => camera::show(ui, desk, *index),
            Dialog::StopExport => unsaved::show_stop_export(ui, desk),
            Dialog::Unsaved(command) => unsaved::show(ui, desk, command),
            Dialog::Replace { path, replace, back, .. } => unsaved::show_replace(ui, desk, path, replace, back),
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

/// A button that does it and one that does not, at the right; answers which was pressed.
fn two_buttons(ui: &mut egui::Ui, yes: &str, enabled: bool, no: &str) -> Option<bool> {
    ui.add_space(8.0);
    ui.with_layout(egui::Layout::right_to_left(egui::Align::Min), |ui| {
        let size = egui::vec2(110.0, 0.0);
        let refused = ui.add(Button::new(no).min_size(size)).clicked();
        let agreed = ui.add_enabled(enabled, Button::new(RichText::new(yes).strong()).min_size(size)).clicked();
        if agreed { Some(true) } else { refused.then_some(false) }
    })
    .inner
}
