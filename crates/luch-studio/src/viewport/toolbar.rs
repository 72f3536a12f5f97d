//! The strip over the picture: what the mouse does, how large the picture is shown.

use crate::command::{Command, Tool, Zoom};
use crate::state::Desk;
use egui::{Frame, Ui};

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    Frame::new().inner_margin(egui::Margin::symmetric(8, 4)).show(ui, |ui| {
        ui.horizontal(|ui| {
            let tools = [
                (Tool::Select, texts.tool_select(), texts.tool_select_tip()),
                (Tool::Focus, texts.tool_focus(), texts.tool_focus_tip()),
            ];
            for (tool, name, tip) in tools {
                if ui.selectable_label(desk.state.tool == tool, name).on_hover_text(tip).clicked() {
                    desk.send(Command::SetTool(tool));
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
