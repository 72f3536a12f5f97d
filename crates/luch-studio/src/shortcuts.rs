//! Keys: each command's own, taken when no text is typed and no dialog is open.

use crate::command::Command;
use crate::state::Desk;
use crate::viewport;
use egui::{Context, Key, Modifiers};

pub(crate) fn take(ctx: &Context, desk: &mut Desk<'_>) {
    if desk.state.dialog.is_some() {
        return;
    }
    let typing = ctx.text_edit_focused();
    let mut keys: Vec<_> = Command::with_shortcuts().into_iter().filter_map(|c| Some((c.shortcut()?, c))).collect();
    // A key counts with Shift held, too: the one that wants it comes first.
    keys.sort_by_key(|(shortcut, _)| !shortcut.modifiers.shift);
    for (shortcut, command) in keys {
        // A plain key belongs to the field that is typed into.
        if typing && shortcut.modifiers == Modifiers::NONE && !is_function_key(shortcut.logical_key) {
            continue;
        }
        // Escape takes back what is being dragged, and only that.
        if command == Command::Select(None) && viewport::is_dragging(ctx) {
            continue;
        }
        if ctx.input_mut(|i| i.consume_shortcut(&shortcut)) {
            desk.send(command);
        }
    }
    if !typing {
        let cameras = desk.scene().cameras.len();
        for (index, key) in CAMERAS.into_iter().enumerate().take(cameras) {
            if ctx.input_mut(|i| i.consume_key(Modifiers::NONE, key)) {
                desk.send(Command::ChooseCamera(index));
            }
        }
    }
}

/// The keys of the first nine cameras.
const CAMERAS: [Key; 9] =
    [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];

fn is_function_key(key: Key) -> bool {
    key.name().starts_with('F') && key.name().len() > 1
}
