//! Keys: each command's own, taken when no text is typed and no dialog is open.

use crate::command::Command;
use crate::state::Desk;
use egui::{Context, Modifiers};

pub(crate) fn take(ctx: &Context, desk: &mut Desk<'_>) {
    if desk.state.dialog.is_some() {
        return;
    }
    let typing = ctx.text_edit_focused();
    for command in Command::with_shortcuts() {
        let Some(shortcut) = command.shortcut() else { continue };
        // A plain key belongs to the field that is typed into.
        if typing && shortcut.modifiers == Modifiers::NONE && !is_function_key(shortcut.logical_key) {
            continue;
        }
        if ctx.input_mut(|i| i.consume_shortcut(&shortcut)) {
            desk.send(command);
        }
    }
}

fn is_function_key(key: egui::Key) -> bool {
    key.name().starts_with('F') && key.name().len() > 1
}
