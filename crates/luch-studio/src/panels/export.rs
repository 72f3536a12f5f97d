//! The picture on its way to a file: how far it is, how long it takes, and a button that stops it.

use super::render::{duration, percent, time_left};
use crate::command::Command;
use crate::files::shown;
use crate::state::Desk;
use egui::{Panel, ProgressBar, Ui};

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let Some(export) = desk.files.export.as_ref() else { return };
    let texts = desk.texts;
    let path = &export.form().path;
    let name = shown(path.file_name().unwrap_or_default());
    let share = export.share();
    let text = match share {
        None => texts.progress_preparing(),
        Some(share) if share >= 1.0 => texts.export_writing(),
        Some(share) => match time_left(share, export.elapsed()) {
            Some(left) => texts.progress_left(percent(share), duration(left, texts)),
            None => percent(share),
        },
    };
    Panel::bottom("export").show(ui, |ui| {
        ui.horizontal(|ui| {
            ui.label(texts.export_of(name)).on_hover_text(shown(path.as_os_str()));
            if ui.button(texts.export_cancel()).clicked() {
                desk.send(Command::CancelExport);
            }
            let bar = ui.add(ProgressBar::new(share.unwrap_or(0.0)).text(text.clone()).desired_height(18.0));
            let name = texts.export_progress();
            bar.widget_info(|| {
                let mut info = egui::WidgetInfo::labeled(egui::Role::ProgressIndicator, true, &name);
                info.current_text_value = Some(text.clone());
                info
            });
        });
    });
}
