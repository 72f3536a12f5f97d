//! A light: how bright, which colour.

use crate::command::Command;
use crate::state::Desk;
use crate::widgets::check::NumberFormat;
use crate::widgets::color;
use crate::widgets::number::NumberField;
use egui::Ui;
use luch_scene::{Edit, LightEdit, NonNegative};

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>, index: usize) {
    let texts = desk.texts;
    let Some(light) = desk.scene().lights.get(index).cloned() else { return };
    let (name, tip) = (texts.intensity(), texts.intensity_tip());
    let format = NumberFormat { range: 0.0..=100_000.0, decimals: 1, suffix: " %" };
    let field = NumberField::new(&name, f64::from(light.intensity.get()) * 100.0, format).tooltip(&tip);
    if let Some((percent, gesture)) = field.slider(0.0..=100.0).show(ui, texts)
        && let Ok(intensity) = NonNegative::try_from(percent / 100.0)
    {
        desk.send(Command::Edit(Edit::Light(index, LightEdit::SetIntensity(intensity)), gesture));
    }
    if let Some((value, gesture)) = color::field(ui, texts, &texts.color(), &texts.light_color_tip(), light.color) {
        desk.send(Command::Edit(Edit::Light(index, LightEdit::SetColor(value)), gesture));
    }
}
