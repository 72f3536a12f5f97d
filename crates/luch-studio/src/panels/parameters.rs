//! What belongs to the scene as a whole and to all its pictures.

use crate::command::Command;
use crate::state::Desk;
use crate::undo::Gesture;
use crate::widgets::check::NumberFormat;
use crate::widgets::number::NumberField;
use crate::widgets::{color, row, text};
use egui::Ui;
use luch_scene::{Edit, LightEdit, NonNegative, Positive, RayCount, Sampling, Scene, SceneEdit, SettingsEdit, Shading};

pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    scene_name(ui, desk);
    light_intensity(ui, desk);
    let settings = desk.scene().settings;
    let texts = desk.texts;
    let names = [texts.antialiasing(), texts.rays_per_pixel()];
    let tips = [texts.antialiasing_tip(), texts.rays_per_pixel_tip()];
    if let Some((changed, gesture)) = effect(ui, desk, names, tips, settings.antialiasing) {
        desk.send(Command::Edit(Edit::Settings(SettingsEdit::SetAntialiasing(changed)), gesture));
    }
    let names = [texts.depth_of_field(), texts.rays_over_the_lens()];
    let tips = [texts.depth_of_field_tip(), texts.rays_over_the_lens_tip()];
    if let Some((changed, gesture)) = effect(ui, desk, names, tips, settings.depth_of_field) {
        desk.send(Command::Edit(Edit::Settings(SettingsEdit::SetDepthOfField(changed)), gesture));
    }
    shading_choice(ui, desk);
    surroundings(ui, desk);
}

/// What the scene is called.
fn scene_name(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let check = |typed: &str| Scene::check_form(typed).map_err(|_| texts.name_form());
    let name = text::field(ui, &texts.scene_name(), &texts.scene_name_tip(), &desk.scene().name, check);
    if let Some(name) = name {
        desk.send(Command::Edit(Edit::Scene(SceneEdit::Rename(name)), Gesture::Single));
    }
}

/// One slider for all lights: the strongest is shown, and all are set to what is chosen.
fn light_intensity(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let strongest = desk.scene().lights.iter().map(|light| light.intensity.get()).reduce(f32::max);
    let Some(strongest) = strongest else {
        ui.weak(texts.no_lights());
        return;
    };
    let (name, tip) = (texts.light_intensity(), texts.light_intensity_tip());
    let format = NumberFormat { range: 0.0..=100_000.0, decimals: 1, suffix: " %" };
    let field = NumberField::new(&name, f64::from(strongest) * 100.0, format).tooltip(&tip).slider(0.0..=100.0);
    if let Some((percent, gesture)) = field.show(ui, texts)
        && let Ok(intensity) = NonNegative::try_from(percent / 100.0)
    {
        let set = |index| Edit::Light(index, LightEdit::SetIntensity(intensity));
        desk.send(Command::Edit(Edit::Group((0..desk.scene().lights.len()).map(set).collect()), gesture));
    }
}

/// A box to switch an effect and the number of its rays.
fn effect(
    ui: &mut Ui,
    desk: &Desk<'_>,
    [name, rays_name]: [String; 2],
    [tip, rays_tip]: [String; 2],
    effect: Sampling,
) -> Option<(Sampling, Gesture)> {
    let mut on = effect.on;
    let switched = ui.checkbox(&mut on, &name).on_hover_text(tip).changed();
    let mut answer = switched.then_some((Sampling { on, ..effect }, Gesture::Single));
    ui.indent(&name, |ui| {
        ui.add_enabled_ui(on, |ui| {
            let format = NumberFormat { range: 1.0..=f64::from(RayCount::MAX), decimals: 0, suffix: "" };
            let field = NumberField::new(&rays_name, f64::from(effect.rays.get()), format).tooltip(&rays_tip);
            let field = field.slider(1.0..=256.0).logarithmic();
            if let Some((rays, gesture)) = field.show(ui, desk.texts)
                && let Ok(rays) = RayCount::new(rays as u32)
            {
                answer = Some((Sampling { on, rays }, gesture));
            }
        });
    });
    answer
}

fn shading_choice(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let current = desk.scene().settings.shading;
    row::labelled(ui, &texts.shading(), &texts.shading_tip(), |ui, _| {
        ui.vertical(|ui| {
            for shading in Shading::ALL {
                let choice = ui.radio(current == shading, shading_name(texts, shading));
                if choice.on_hover_text(texts.shading_tip()).clicked() && current != shading {
                    desk.send(Command::Edit(Edit::Settings(SettingsEdit::SetShading(shading)), Gesture::Single));
                }
            }
        });
    });
}

/// What a shading model is called.
pub(super) fn shading_name(texts: &crate::l10n::Texts, shading: Shading) -> String {
    match shading {
        Shading::Flat => texts.shading_flat(),
        Shading::Gouraud => texts.shading_gouraud(),
        Shading::Phong => texts.shading_phong(),
    }
}

/// The light that comes from nowhere, how light weakens, and the colour of nothing.
fn surroundings(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let scene = desk.scene();
    let (ambient, attenuation, background) = (scene.ambient, scene.attenuation, scene.background);
    let format = NumberFormat { range: 0.0..=1e6, decimals: 3, suffix: "" };
    let (name, tip) = (texts.ambient(), texts.ambient_tip());
    let field = NumberField::new(&name, f64::from(ambient.get()), format).tooltip(&tip).slider(0.0..=1.0);
    if let Some((value, gesture)) = field.show(ui, texts)
        && let Ok(value) = NonNegative::try_from(value)
    {
        desk.send(Command::Edit(Edit::Scene(SceneEdit::SetAmbient(value)), gesture));
    }
    let format = NumberFormat { range: 1e-9..=1e9, decimals: 3, suffix: "" };
    let (name, tip) = (texts.attenuation(), texts.attenuation_tip());
    let field = NumberField::new(&name, f64::from(attenuation.get()), format).tooltip(&tip);
    if let Some((value, gesture)) = field.slider(0.1..=1000.0).logarithmic().show(ui, texts)
        && let Ok(value) = Positive::try_from(value)
    {
        desk.send(Command::Edit(Edit::Scene(SceneEdit::SetAttenuation(value)), gesture));
    }
    if let Some((value, gesture)) = color::field(ui, texts, &texts.background(), &texts.background_tip(), background) {
        desk.send(Command::Edit(Edit::Scene(SceneEdit::SetBackground(value)), gesture));
    }
}
