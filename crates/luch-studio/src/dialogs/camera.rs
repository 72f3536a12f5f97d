//! Gives a camera another name.

use super::two_buttons;
use crate::command::Command;
use crate::state::Desk;
use crate::undo::Gesture;
use crate::widgets::row;
use egui::{Id, Key, TextEdit, Ui};
use luch_scene::{CameraEdit, Edit, Scene};

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>, index: usize) {
    let texts = desk.texts;
    ui.set_width(360.0);
    let Some(old) = desk.scene().cameras.get(index).map(|camera| camera.name.clone()) else {
        return desk.send(Command::CloseDialog);
    };
    let id = id();
    let known: Option<String> = ui.data(|d| d.get_temp(id));
    let mut name = known.clone().unwrap_or_else(|| old.clone());
    let response = row::labelled(ui, &texts.name(), "", |ui, label| {
        let width = ui.available_width();
        let edit = TextEdit::singleline(&mut name).desired_width(width).char_limit(Scene::MAX_NAME);
        ui.add(edit).labelled_by(label.id)
    });
    if known.is_none() {
        response.request_focus();
    }
    let taken = name != old && desk.scene().camera_named(&name).is_some();
    let formed = Scene::check_form(&name).is_ok();
    if taken {
        row::complaint(ui, &texts.name_taken(&name));
    } else if !formed {
        row::complaint(ui, &texts.name_form());
    }
    let entered = response.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter));
    let pressed = two_buttons(ui, &texts.button_rename(), !taken && formed, &texts.button_cancel());
    ui.data_mut(|d| d.insert_temp(id, name.clone()));
    if pressed == Some(false) {
        desk.send(Command::CloseDialog);
    } else if (entered || pressed == Some(true)) && !taken && formed {
        if name != old {
            desk.send(Command::Edit(Edit::Camera(index, CameraEdit::Rename(name)), Gesture::Single));
        }
        desk.send(Command::CloseDialog);
    }
}

/// Forgets what was typed.
pub(super) fn forget(ctx: &egui::Context) {
    ctx.data_mut(|d| d.remove_temp::<String>(id()));
}

fn id() -> Id {
    Id::unique("camera name")
}
