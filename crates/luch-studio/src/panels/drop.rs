//! What is dragged over the window: what will become of it, and the drop itself.

use crate::command::Command;
use crate::state::Desk;
use egui::{Align2, Area, Context, Frame, Id, Order, RichText};
use luch_io::SceneSource;

pub(super) fn show(ctx: &Context, desk: &mut Desk<'_>) {
    // A dialog is answered first.
    if desk.state.dialog.is_some() {
        return;
    }
    let (dropped, alone) = ctx.input(|i| {
        let paths: Vec<_> = i.raw.dropped_files.iter().map(|file| file.path().to_owned()).collect();
        (paths, i.modifiers.shift)
    });
    if !dropped.is_empty() {
        desk.send(Command::Drop { paths: dropped, alone });
        return;
    }
    let hovered = ctx.input(|i| i.raw.hovered_files.clone());
    if hovered.is_empty() {
        return;
    }
    let texts = desk.texts;
    let kind = hovered.iter().find_map(|file| SceneSource::of_path(file.path.as_deref()?));
    let text = match kind {
        Some(SceneSource::Model(_)) if alone => texts.drop_model_alone(),
        Some(SceneSource::Model(_)) => texts.drop_model(),
        Some(_) => texts.drop_scene(),
        // Some systems do not say what it is before it is dropped.
        None if hovered.iter().all(|file| file.path.is_none()) => texts.drop_anything(),
        None => texts.drop_nothing(),
    };
    let screen = ctx.content_rect();
    let painter = ctx.layer_painter(egui::LayerId::new(Order::Foreground, Id::unique("drop shade")));
    painter.rect_filled(screen, 0.0, egui::Color32::from_black_alpha(140));
    let area = Area::new(Id::unique("drop")).order(Order::Tooltip).default_width(760.0);
    area.anchor(Align2::CENTER_CENTER, egui::Vec2::ZERO).show(ctx, |ui| {
        Frame::popup(ui.style()).inner_margin(20).show(ui, |ui| ui.label(RichText::new(text).heading()));
    });
}
