//! The strip over the picture: what the mouse does, how large the picture is shown.

use crate::command::{Command, Tool, Zoom};
use crate::state::Desk;
use egui::{Frame, Ui};

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    Frame::new().inner_margin(egui::Margin::symmetric(8, 4)).show(ui, |ui| {
        ui.horizontal_wrapped(|ui| {
            for tool in Tool::ALL {
                let command = Command::SetTool(tool);
                let tip = match tool {
                    Tool::Select => texts.tool_select_tip(),
                    Tool::Move => texts.tool_move_tip(),
                    Tool::Rotate => texts.tool_rotate_tip(),
                    Tool::Scale => texts.tool_scale_tip(),
                    Tool::Focus => texts.tool_focus_tip(),
                    Tool::Explain => texts.tool_explain_tip(),
                };
                let key = command.shortcut().map(|key| ui.ctx().format_shortcut(&key)).unwrap_or_default();
                let button = ui.selectable_label(desk.state.tool == tool, command.label(texts));
                if button.on_hover_text(format!("{tip} ({key})")).clicked() {
                    desk.send(command);
                }
            }
            ui.separator();
            let zooms = [
                (Zoom::Fit, texts.zoom_fit(), texts.zoom_fit_tip()),
                (Zoom::Factor(1.0), texts.zoom_one(), texts.zoom_one_tip()),
            ];
            for (zoom, name, tip) in zooms {
                if ui.selectable_label(desk.state.zoom == zoom, name).on_hover_text(tip).clicked() {
                    desk.send(Command::SetZoom(zoom));
                }
            }
            if let Zoom::Factor(factor) = desk.state.zoom {
                ui.weak(format!("{:.0} %", factor * 100.0));
            }
        });
    });
}
