//! The lens of the camera: how far it is sharp and how wide it is open.

use crate::command::{Command, Tool};
use crate::state::Desk;
use crate::viewport::focus;
use crate::widgets::check::NumberFormat;
use crate::widgets::icon::{self, Icon};
use crate::widgets::number::NumberField;
use egui::{Id, Ui};
use luch_scene::{CameraEdit, Edit, NonNegative, Positive};

pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let controls = ui.scope(|ui| controls(ui, desk)).response;
    // The pointer may leave a slider that it drags.
    let used = ui.data(|d| d.get_temp::<bool>(id())).unwrap_or(false);
    let pressed = ui.input(|i| i.pointer.any_down());
    let used = if pressed { used } else { ui.rect_contains_pointer(controls.rect) };
    ui.data_mut(|d| d.insert_temp(id(), used));
    if used {
        focus::show_while_used(ui.ctx());
    }
}

fn id() -> Id {
    Id::unique("lens is used")
}

fn controls(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let Some(camera) = desk.state.camera() else { return };
    let index = desk.state.view.index;
    let format = NumberFormat { range: 1e-9..=1e9, decimals: 3, suffix: "" };
    let (name, tip) = (texts.focal_distance(), texts.focal_distance_tip());
    let focus = f64::from(camera.focus());
    let field = NumberField::new(&name, focus, format).tooltip(&tip).slider(0.1..=100.0).logarithmic();
    let room = icon::WIDTH + ui.spacing().item_spacing.x;
    let mut clicked = false;
    let click = |ui: &mut Ui| clicked = icon::button(ui, Icon::Target, &texts.lens_click()).clicked();
    let changed = field.show_with(ui, texts, room, click);
    if clicked {
        desk.send(Command::SetTool(Tool::Focus));
    }
    if let Some((value, gesture)) = changed
        && let Ok(distance) = Positive::try_from(value)
    {
        desk.send(Command::Edit(Edit::Camera(index, CameraEdit::SetFocalDistance(Some(distance))), gesture));
    }
    let format = NumberFormat { range: 0.0..=1e9, decimals: 4, suffix: "" };
    let (name, tip) = (texts.lens_radius(), texts.lens_radius_tip());
    let field = NumberField::new(&name, f64::from(camera.lens_radius.get()), format).tooltip(&tip);
    if let Some((value, gesture)) = field.slider(0.0..=1.0).show(ui, texts)
        && let Ok(radius) = NonNegative::try_from(value)
    {
        desk.send(Command::Edit(Edit::Camera(index, CameraEdit::SetLensRadius(radius)), gesture));
    }
}
