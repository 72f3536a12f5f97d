//! Which scene, through which camera, how wide.

use super::menu::item;
use crate::command::Command;
use crate::dialogs::Dialog;
use crate::document::Document;
use crate::l10n::Texts;
use crate::state::Desk;
use crate::widgets::check::NumberFormat;
use crate::widgets::number::NumberField;
use crate::widgets::row;
use egui::{ComboBox, Ui};
use luch_io::{SceneSource, builtin};
use luch_scene::{CameraEdit, Edit, FieldOfView};

pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    scene_choice(ui, desk);
    camera_choice(ui, desk);
    field_of_view(ui, desk);
}

fn scene_choice(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let name = texts.scene_choice();
    row::labelled(ui, &name, &texts.scene_choice_tip(), |ui, label| {
        let shown = match desk.loading {
            Some(_) => texts.scene_loading(),
            None => scene_name(&desk.state.document, texts),
        };
        let current = desk.loading.or(desk.state.document.source.as_ref()).cloned();
        let combo = ComboBox::from_id_salt("scene").width(ui.available_width()).selected_text(shown).truncate();
        let response = combo.show_ui(ui, |ui| {
            for id in builtin::ids() {
                let source = SceneSource::BuiltIn(id);
                let selected = current.as_ref() == Some(&source);
                if ui.selectable_label(selected, built_in_name(id, desk.texts)).clicked() {
                    desk.send(Command::Open(source));
                }
            }
        });
        row::tip(&response.response.labelled_by(label.id), &texts.scene_choice_tip());
    });
}

/// What the scene at hand is called: a built-in one in the language of the window.
pub(crate) fn scene_name(document: &Document, texts: &Texts) -> String {
    match document.source {
        Some(SceneSource::BuiltIn(id)) => built_in_name(id, texts),
        _ => document.scene().name.clone(),
    }
}

/// What a built-in scene is called in the language of the window.
pub(crate) fn built_in_name(id: &str, texts: &Texts) -> String {
    match id {
        "two-spheres" => texts.scene_two_spheres(),
        "one-sphere" => texts.scene_one_sphere(),
        "knight" => texts.scene_knight(),
        "chess" => texts.scene_chess(),
        other => other.to_owned(),
    }
}

fn camera_choice(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let names: Vec<String> = desk.scene().cameras.iter().map(|camera| camera.name.clone()).collect();
    let index = desk.state.view.index;
    let moved = desk.state.view.pose.is_some();
    row::labelled(ui, &texts.camera_choice(), &texts.camera_choice_tip(), |ui, label| {
        let mut shown = names.get(index).cloned().unwrap_or_default();
        if moved {
            shown.push_str(" *");
        }
        let combo = ComboBox::from_id_salt("camera").width(ui.available_width()).selected_text(shown).truncate();
        let response = combo.show_ui(ui, |ui| {
            for (other, name) in names.iter().enumerate() {
                if ui.selectable_label(other == index && !moved, name).clicked() {
                    desk.send(Command::ChooseCamera(other));
                }
            }
            ui.separator();
            let padding = ui.spacing().button_padding;
            egui::containers::menu::menu_style(ui.style_mut());
            ui.spacing_mut().button_padding = padding;
            item(ui, desk, Command::AddCamera, true);
            item(ui, desk, Command::Show(Dialog::RenameCamera(index)), true);
            item(ui, desk, Command::RemoveCamera(index), names.len() > 1);
        });
        row::tip(&response.response.labelled_by(label.id), &texts.camera_choice_tip());
    });
}

fn field_of_view(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let Some(camera) = desk.state.camera() else { return };
    let index = desk.state.view.index;
    let format = NumberFormat { range: 0.01..=179.0, decimals: 2, suffix: "°" };
    let (name, tip) = (texts.field_of_view(), texts.field_of_view_tip());
    let field = NumberField::new(&name, f64::from(camera.fov.get()), format).tooltip(&tip).slider(5.0..=120.0);
    if let Some((value, gesture)) = field.show(ui, texts)
        && let Ok(fov) = FieldOfView::try_from(value)
    {
        desk.send(Command::Edit(Edit::Camera(index, CameraEdit::SetFov(fov)), gesture));
    }
}
