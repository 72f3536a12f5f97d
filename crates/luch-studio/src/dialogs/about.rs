//! The version and the facts of the renderer.

use super::close_button;
use crate::preferences::cores;
use crate::state::Desk;
use egui::Ui;
use luch_render::SimdLevel;

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    ui.label(texts.about_what());
    ui.add_space(6.0);
    let scene = desk.scene();
    let facts = [
        (texts.about_version(), env!("CARGO_PKG_VERSION").to_owned()),
        (texts.about_simd(), SimdLevel::Auto.resolved().word().to_owned()),
        (texts.about_cores(), cores().to_string()),
        (texts.about_triangles(), scene.triangle_count().to_string()),
        (texts.about_license(), env!("CARGO_PKG_LICENSE").to_owned()),
    ];
    egui::Grid::new("about").num_columns(2).spacing([16.0, 4.0]).show(ui, |ui| {
        for (name, value) in facts {
            ui.label(name);
            ui.strong(value);
            ui.end_row();
        }
    });
    ui.add_space(6.0);
    ui.label(texts.about_bits());
    close_button(ui, desk);
}
