//! The properties of what is selected.

mod light;
mod look;
mod place;

use crate::command::Command;
use crate::l10n::Texts;
use crate::selection::Part;
use crate::state::Desk;
use crate::undo::Gesture;
use crate::widgets::text;
use egui::Ui;
use luch_scene::{NameError, Scene};

pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let Some(part) = desk.state.selection else {
        ui.weak(desk.texts.properties_nothing());
        return;
    };
    // What is typed for one thing is not meant for the next.
    ui.push_id(part, |ui| {
        name_field(ui, desk, part);
        match part {
            Part::Object(index) => {
                look::show(ui, desk, index);
                place::show(ui, desk, part);
                place::show_shape(ui, desk, index);
            }
            Part::Light(index) => {
                light::show(ui, desk, index);
                place::show(ui, desk, part);
            }
        }
    });
}

fn name_field(ui: &mut Ui, desk: &mut Desk<'_>, part: Part) {
    let texts = desk.texts;
    let Some(name) = part.name(desk.scene()).map(str::to_owned) else { return };
    let scene = desk.state.scene();
    let check = |typed: &str| check_name(scene, &name, typed, texts);
    if let Some(new) = text::field(ui, &texts.name(), &texts.name_tip(), &name, check) {
        desk.send(Command::Edit(part.rename(new), Gesture::Single));
    }
}

fn check_name(scene: &Scene, old: &str, new: &str, texts: &Texts) -> Result<(), String> {
    if new == old {
        return Ok(());
    }
    scene.check_new_name(new).map_err(|error| match error {
        NameError::Taken(name) => texts.name_taken(name),
        _ => texts.name_form(),
    })
}
