//! Asks what picture is to be made for a file.

use super::path::{file_name, folder, with_ending};
use super::path_field::{self, Answer};
use super::two_buttons;
use crate::command::Command;
use crate::files::{ExportForm, PictureKind, Purpose, TypedPath};
use crate::l10n::Texts;
use crate::render_link;
use crate::state::{Desk, State};
use crate::told;
use crate::widgets::check::NumberFormat;
use crate::widgets::number::NumberField;
use crate::widgets::row;
use crate::widgets::size::size_field;
use egui::{Id, Ui};
use luch_render::RenderJob;
use luch_scene::{ImageSize, RayCount, Sampling};
use std::path::Path;

/// What was chosen so far.
#[derive(Debug, Clone, Copy)]
struct Choice {
    size: ImageSize,
    antialiasing: Sampling,
    depth_of_field: Sampling,
    sixteen_bits: bool,
}

/// Forgets what was chosen: the next dialog begins with what the scene says.
pub(super) fn forget(ctx: &egui::Context) {
    ctx.data_mut(|d| d.remove::<Choice>(id()));
}

fn id() -> Id {
    Id::unique("export choice")
}

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    ui.set_width(560.0);
    let state = desk.state;
    let Answer { path, done, .. } = path_field::show(ui, desk, Purpose::Export, 4.0, || start(state));
    let settings = desk.scene().settings;
    let mut choice = ui.data(|d| d.get_temp(id())).unwrap_or(Choice {
        size: settings.size,
        antialiasing: settings.antialiasing,
        depth_of_field: settings.depth_of_field,
        sixteen_bits: false,
    });
    let kind = kind_choice(ui, texts, &path, &mut choice);
    if let Some(size) = size_field(ui, choice.size, texts) {
        choice.size = size;
    }
    let effects = [
        (texts.antialiasing(), texts.rays_per_pixel(), &mut choice.antialiasing),
        (texts.depth_of_field(), texts.rays_over_the_lens(), &mut choice.depth_of_field),
    ];
    for (name, rays, sampling) in effects {
        sampling_fields(ui, texts, &name, &rays, sampling);
    }
    ui.data_mut(|d| d.insert_temp(id(), choice));

    let busy = desk.files.export.is_some();
    let too_large = job(desk, &choice).and_then(|job| ExportForm::too_large(kind, &job));
    if let Some(bytes) = too_large {
        let [needed, limit] = bytes.map(|bytes| told::bytes(bytes, desk.state.preferences.language));
        row::complaint(ui, &texts.export_too_large(needed, limit));
    } else if let Some(export) = &desk.files.export {
        ui.weak(if export.dismissed { texts.export_busy() } else { texts.progress_preparing() });
    }
    let ready = !busy && too_large.is_none() && path.file_name().is_some();
    let pressed = two_buttons(ui, &texts.button_export(), ready, &texts.button_cancel());
    if pressed == Some(false) {
        desk.send(Command::CloseDialog);
    } else if (done || pressed == Some(true)) && ready {
        let path = if PictureKind::of(&path, false).is_some() { path } else { with_ending(path, kind.ending()) };
        let Choice { size, antialiasing, depth_of_field, .. } = choice;
        let form = ExportForm { path, kind, size, antialiasing, depth_of_field, replace: false };
        desk.send(Command::Export(Box::new(form)));
    }
}

fn start(state: &State) -> TypedPath {
    let file = state.document.file().and_then(|file| file.file_stem()).map(|stem| stem.to_string_lossy().into_owned());
    let name = file.unwrap_or_else(|| file_name(&state.scene().name));
    let folder = state.exported_to.clone().unwrap_or_else(|| folder(state));
    TypedPath::new(&folder, &format!("{name}.png"))
}

/// The job of the picture, for what it needs.
fn job(desk: &Desk<'_>, choice: &Choice) -> Option<RenderJob> {
    let job = render_link::job(desk.scene(), desk.state.camera()?, desk.state.integrator, 1);
    Some(RenderJob { size: choice.size, ..job })
}

/// The kinds of files: the one that the path's ending names, and the number of bits.
fn kind_choice(ui: &mut Ui, texts: &Texts, path: &Path, choice: &mut Choice) -> PictureKind {
    let kind = PictureKind::of(path, choice.sixteen_bits);
    let kind = kind.unwrap_or(if choice.sixteen_bits { PictureKind::Png16 } else { PictureKind::Png8 });
    ui.add_space(4.0);
    ui.horizontal(|ui| {
        for other in PictureKind::ALL {
            let name = match other {
                PictureKind::Png8 => texts.export_png_8(),
                PictureKind::Png16 => texts.export_png_16(),
                PictureKind::Exr => texts.export_exr(),
            };
            if ui.radio(kind == other, name).clicked() {
                choice.sixteen_bits = other == PictureKind::Png16;
                path_field::set_ending(ui.ctx(), Purpose::Export, other.ending());
            }
        }
    });
    kind
}

fn sampling_fields(ui: &mut Ui, texts: &Texts, name: &str, rays: &str, sampling: &mut Sampling) {
    ui.checkbox(&mut sampling.on, name);
    if !sampling.on {
        return;
    }
    let format = NumberFormat { range: 1.0..=f64::from(RayCount::MAX), decimals: 0, suffix: "" };
    let field = NumberField::new(rays, f64::from(sampling.rays.get()), format).slider(1.0..=1024.0).logarithmic();
    if let Some((count, _)) = field.show(ui, texts)
        && let Ok(count) = RayCount::new(count as u32)
    {
        sampling.rays = count;
    }
}
