//! Hints for the first run: what to do first, over the picture, until they are read.

use crate::command::Command;
use crate::state::Desk;
use egui::{Align2, Area, Context, Frame, Id, RichText, vec2};

pub(crate) fn show(ctx: &Context, desk: &mut Desk<'_>) {
    if !desk.state.hints || desk.state.preferences.hints_read || desk.state.dialog.is_some() {
        return;
    }
    let texts = desk.texts;
    let hints = [
        (texts.hint_select(), texts.hint_select_how()),
        (texts.hint_look(), texts.hint_look_how()),
        (texts.hint_change(), texts.hint_change_how()),
        (texts.hint_undo(), texts.hint_undo_how()),
    ];
    // In the upper left, over the back wall of the first scene: the spheres stay free to be clicked.
    Area::new(Id::unique("hints")).anchor(Align2::LEFT_TOP, vec2(28.0, 92.0)).show(ctx, |ui| {
        Frame::popup(ui.style()).inner_margin(12).show(ui, |ui| {
            ui.set_max_width(340.0);
            ui.label(RichText::new(texts.hints_title()).heading());
            ui.add_space(4.0);
            for (what, how) in hints {
                ui.strong(what);
                ui.label(how);
                ui.add_space(2.0);
            }
            if ui.button(texts.hints_read()).clicked() {
                desk.send(Command::HintsRead);
            }
        });
    });
}
