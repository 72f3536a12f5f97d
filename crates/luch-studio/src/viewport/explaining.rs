//! A click with the tool for it explains a pixel, and the arrow keys those beside it.

use super::frame::PictureFrame;
use crate::command::{Command, Tool};
use crate::explain::ExplainCommand;
use crate::state::Desk;
use egui::{CursorIcon, EventFilter, Key, Modifiers, Response, Ui};

/// Takes clicks and keys, before the camera gets those that are left.
pub(super) fn take_input(ui: &Ui, response: &Response, frame: &PictureFrame, desk: &mut Desk<'_>) {
    if desk.state.tool != Tool::Explain {
        return;
    }
    if response.hovered() {
        ui.set_cursor_icon(CursorIcon::Crosshair);
    }
    if response.clicked()
        && let Some(pixel) = response.interact_pointer_pos().and_then(|at| frame.pixel_at(at))
    {
        response.request_focus();
        desk.send(Command::Explain(ExplainCommand::Pixel(pixel)));
    }
    if !response.has_focus() || !desk.state.explain.is_open() {
        return;
    }
    let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
    ui.memory_mut(|m| m.set_focus_lock_filter(response.id, arrows));
    let keys =
        [(Key::ArrowLeft, [-1, 0]), (Key::ArrowRight, [1, 0]), (Key::ArrowUp, [0, -1]), (Key::ArrowDown, [0, 1])];
    for (key, [dx, dy]) in keys {
        for (modifiers, pixels) in [(Modifiers::SHIFT, 10), (Modifiers::NONE, 1)] {
            if ui.input_mut(|i| i.consume_key(modifiers, key)) {
                desk.send(Command::Explain(ExplainCommand::Step([dx * pixels, dy * pixels])));
            }
        }
    }
}
