//! Offers the scenes that an earlier program had not saved when it died.

use crate::command::Command;
use crate::files::shown;
use crate::l10n::Texts;
use crate::state::Desk;
use crate::widgets::row;
use egui::{RichText, ScrollArea, Ui};
use std::time::Duration;

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    ui.set_width(520.0);
    ui.label(texts.recover_what());
    ui.add_space(6.0);
    let busy = desk.files.recovery.is_recovering();
    let list = desk.files.recovery.found().to_vec();
    ScrollArea::vertical().max_height(300.0).show(ui, |ui| {
        for (index, scene) in list.iter().enumerate() {
            ui.push_id(index, |ui| {
                ui.strong(crate::notices::drawable(scene.name()));
                let age = scene.saved().elapsed().unwrap_or_default();
                ui.label(ago(age, texts));
                if let Some(path) = scene.source().and_then(luch_io::SceneSource::path) {
                    ui.label(RichText::new(shown(path.as_os_str())).monospace().small());
                }
                ui.horizontal(|ui| {
                    if ui.add_enabled(!busy, egui::Button::new(texts.button_recover())).clicked() {
                        desk.send(Command::Recover(index));
                    }
                    if ui.add_enabled(!busy, egui::Button::new(texts.button_discard())).clicked() {
                        desk.send(Command::DiscardRecovered(index));
                    }
                });
                ui.separator();
            });
        }
    });
    if let Some(complaint) = &desk.state.complaint {
        row::complaint(ui, complaint);
    }
    if busy {
        ui.weak(texts.files_reading());
    }
    if ui.button(texts.button_later()).on_hover_text(texts.button_later_tip()).clicked() {
        desk.send(Command::CloseDialog);
    }
}

/// How long ago something was, as people say it.
fn ago(age: Duration, texts: &Texts) -> String {
    let minutes = age.as_secs() / 60;
    match minutes {
        0 => texts.ago_moments(),
        1..60 => texts.ago_minutes(minutes),
        60..1440 => texts.ago_hours(minutes / 60),
        _ => texts.ago_days(minutes / 1440),
    }
}
