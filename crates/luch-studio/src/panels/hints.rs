//! Hints for the first run: what to do first, over the picture, until they are read.

use crate::command::Command;
use crate::state::Desk;
use egui::{Align, Area, Frame, Grid, Id, Layout, RichText, Ui, vec2};

/// The least width of a hint, and what is between two, in points.
const HINT: f32 = 280.0;
const GAP: f32 = 24.0;

/// Shows the hints over the upper left of what the panels have left of the window.
pub(crate) fn show(ui: &Ui, desk: &mut Desk<'_>) {
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
    // Low and wide, over the back wall of the first scene: the spheres stay free to be clicked.
    let room = ui.available_rect_before_wrap();
    let (columns, below): (u8, f32) = if room.width() > 2.0 * HINT + GAP + 64.0 { (2, 48.0) } else { (1, 72.0) };
    let gaps = GAP * f32::from(columns - 1);
    let width = ((room.width() - 64.0 - gaps) / f32::from(columns)).min(400.0);
    Area::new(Id::unique("hints")).fixed_pos(room.min + vec2(20.0, below)).show(ui.ctx(), |ui| {
        Frame::popup(ui.style()).inner_margin(12).show(ui, |ui| {
            ui.set_width(width * f32::from(columns) + gaps);
            ui.horizontal(|ui| {
                ui.label(RichText::new(texts.hints_title()).heading().strong());
                ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
                    if ui.button(texts.hints_read()).clicked() {
                        desk.send(Command::HintsRead);
                    }
                });
            });
            ui.add_space(2.0);
            Grid::new("hints").num_columns(columns.into()).spacing([GAP, 6.0]).show(ui, |ui| {
                for (place, (what, how)) in (1_u8..).zip(hints) {
                    ui.vertical(|ui| {
                        ui.set_width(width);
                        ui.spacing_mut().item_spacing.y = 2.0;
                        ui.strong(what);
                        ui.label(how);
                    });
                    if place % columns == 0 {
                        ui.end_row();
                    }
                }
            });
        });
    });
}
