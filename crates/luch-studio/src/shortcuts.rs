//! Keys: each command's own, taken when no text is typed and no dialog is open.

use crate::command::Command;
use crate::explain::{self, ExplainCommand};
use crate::panels::list_has_focus;
use crate::state::Desk;
use crate::viewport;
use egui::{Context, Id, Key, KeyboardShortcut, Modifiers, Popup};

pub(crate) fn take(ctx: &Context, desk: &mut Desk<'_>) {
    if desk.state.dialog.is_some() {
        return;
    }
    // Escape has taken the focus from the field already: what counts is where it was when the key was pressed.
    let typing = ctx.text_edit_focused() || ctx.data(|d| d.get_temp(typing_id())).unwrap_or(false);
    let in_menu = Popup::is_any_open(ctx);
    for (command, shortcut) in longest_first() {
        if typing && command.is_about_text() {
            continue;
        }
        // A plain key belongs to the field that is typed into, or to the menu that is open.
        if (typing || in_menu) && shortcut.modifiers == Modifiers::NONE && !is_function_key(shortcut.logical_key) {
            continue;
        }
        // Escape takes back what is being dragged, and only that.
        if command == Command::Select(None) && viewport::is_dragging(ctx) {
            continue;
        }
        // A list and a tree go to their first rows by the key that returns the view.
        if command == Command::SetPose(None) && (explain::tree_has_focus(ctx) || list_has_focus(ctx)) {
            continue;
        }
        if ctx.input_mut(|i| i.consume_shortcut(&shortcut)) {
            // Escape closes what is open before it lets go of what is selected.
            let closes = command == Command::Select(None) && desk.state.explain.is_open();
            desk.send(match command {
                _ if closes => Command::Explain(ExplainCommand::Close),
                command if typing && command.takes_what_is_typed() => Command::AfterTyping(Box::new(command)),
                command => command,
            });
        }
    }
    if !typing && !in_menu {
        let cameras = desk.scene().cameras.len();
        for (index, key) in CAMERAS.into_iter().enumerate().take(cameras) {
            if ctx.input_mut(|i| i.consume_key(Modifiers::NONE, key)) {
                desk.send(Command::ChooseCamera(index));
            }
        }
    }
}

/// Notes at the end of a frame whether a field is typed into.
pub(crate) fn note_typing(ctx: &Context) {
    let typing = ctx.text_edit_focused();
    ctx.data_mut(|d| d.insert_temp(typing_id(), typing));
}

fn typing_id() -> Id {
    Id::unique("typing")
}

/// The commands with keys, those with more modifiers first: a shortcut without Shift is taken with it too, and redo, which
/// has it, must not end as undo.
fn longest_first() -> Vec<(Command, KeyboardShortcut)> {
    let with_keys = Command::with_shortcuts().into_iter();
    let mut list: Vec<_> = with_keys.filter_map(|command| command.shortcut().map(|keys| (command, keys))).collect();
    list.sort_by_key(|(_, keys)| std::cmp::Reverse(u8::from(keys.modifiers.shift) + u8::from(keys.modifiers.alt)));
    list
}

/// The keys of the first nine cameras.
const CAMERAS: [Key; 9] =
    [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];

fn is_function_key(key: Key) -> bool {
    key.name().starts_with('F') && key.name().len() > 1
}
