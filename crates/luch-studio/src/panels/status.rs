//! The line below: what is shown, how fast it came, what is under the pointer.

use super::render::duration;
use crate::state::Desk;
use egui::{Layout, Ui};

pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let mut facts = Vec::new();
    if let Some((snapshot, _)) = desk.render.picture() {
        let size = snapshot.job.size;
        facts.push(texts.status_size(size.width().to_string(), size.height().to_string()));
        facts.push(texts.status_rays(snapshot.samples));
        facts.push(texts.status_threads(snapshot.job.threads));
        let figures = desk.state.figures;
        facts.push(duration(figures.elapsed(snapshot.elapsed), texts));
        if let Some(speed) = figures.mrays_per_s(snapshot.rays, snapshot.elapsed) {
            facts.push(texts.status_speed(format!("{speed:.1}")));
        }
    }
    let under = crate::viewport::under_pointer(ui.ctx()).and_then(|part| part.name(desk.scene()).map(str::to_owned));
    ui.horizontal(|ui| {
        for (index, fact) in facts.into_iter().enumerate() {
            if index > 0 {
                ui.separator();
            }
            ui.label(fact);
        }
        ui.with_layout(Layout::right_to_left(egui::Align::Center), |ui| {
            if let Some(name) = under {
                ui.strong(name);
            }
        });
    });
}
