//! What is typed is taken when its field is left. Who saves, or closes the window, means what stands in the field as well.

use super::Studio;
use crate::command::Command;
use egui::{Context, ViewportCommand};

impl Studio {
    /// Leaves the field that is typed into, and does something once it has told what was typed.
    pub(super) fn after_typing(&mut self, command: Command, ctx: &Context) {
        if let Some(field) = ctx.memory(egui::Memory::focused) {
            ctx.memory_mut(|memory| memory.surrender_focus(field));
        }
        self.later.push(command);
        ctx.request_repaint();
    }

    /// Answers the wish to close the window: at once, unless a field is typed into.
    pub(super) fn take_close(&mut self, ctx: &Context) {
        let asked = ctx.input(|i| i.viewport().close_requested()) && !self.leaving;
        // What is typed into a dialog is nothing until it is agreed to.
        if asked && ctx.text_edit_focused() && self.state.dialog.is_none() {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.commands.push(Command::AfterTyping(Box::new(Command::Quit)));
        } else {
            self.answer_close(ctx);
        }
    }
}
