//! The width and height of a picture, in one row.

use super::check::NumberFormat;
use super::number::{field_of, show_complaint};
use super::row;
use crate::l10n::Texts;
use egui::{Label, Response, Ui, vec2};
use luch_scene::ImageSize;

/// The least and the greatest width of each of the two fields, in points.
const FIELD: [f32; 2] = [48.0, 120.0];
/// The room of the sign between them.
const TIMES: f32 = 10.0;

/// Shows the size and answers with the one that was typed.
pub(crate) fn size_field(ui: &mut Ui, size: ImageSize, texts: &Texts) -> Option<ImageSize> {
    let format = NumberFormat { range: 1.0..=f64::from(ImageSize::MAX_SIDE), decimals: 0, suffix: "" };
    let ids = ["width", "height"].map(|side| ui.scope_id().with(("size", side)));
    let sides = [size.width(), size.height()].map(f64::from);
    let tip = texts.picture_size_tip();
    let typed = row::labelled(ui, &texts.picture_size(), &tip, |ui, _| {
        let gap = ui.spacing().item_spacing.x;
        let side = ((ui.available_width() - TIMES - 2.0 * gap) / 2.0).clamp(FIELD[0], FIELD[1]);
        let (width, typed_width) = field_of(ui, ids[0], sides[0], &format, side, texts);
        name(&width, &texts.picture_width());
        row::tip(&width, &tip);
        ui.add_sized(vec2(TIMES, ui.spacing().interact_size.y), Label::new("×"));
        let (height, typed_height) = field_of(ui, ids[1], sides[1], &format, side, texts);
        name(&height, &texts.picture_height());
        row::tip(&height, &tip);
        (typed_width.is_some() || typed_height.is_some())
            .then(|| [typed_width.unwrap_or(sides[0]), typed_height.unwrap_or(sides[1])])
    });
    show_complaint(ui, ids[0], sides[0]);
    show_complaint(ui, ids[1], sides[1]);
    let [width, height] = typed?;
    ImageSize::new(width as u32, height as u32).ok()
}

/// Gives a field the name that a screen reader says.
fn name(response: &Response, name: &str) {
    response.ctx.accesskit_node_builder(response.id, |node| node.set_label(name));
}
