//! The version and the facts of the renderer.

use super::close_button;
use crate::state::Desk;
use egui::Ui;

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    ui.label(texts.about_what());
    ui.add_space(6.0);
    let (scene, figures) = (desk.scene(), desk.state.figures);
    let facts = [
        (texts.about_version(), env!("CARGO_PKG_VERSION").to_owned()),
        (texts.about_simd(), figures.simd().to_owned()),
        (texts.about_cores(), figures.cores().to_string()),
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
