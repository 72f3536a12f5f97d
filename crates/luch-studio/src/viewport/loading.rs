//! Says over the picture that another scene is being read: the picture is still that of the scene at hand.

use super::label;
use crate::files::shown;
use crate::state::Desk;
use egui::{Id, Painter, Rect};

/// How long it takes until it is said, in seconds: what is soon there needs no words.
const FADES_IN: f32 = 0.6;

pub(super) fn draw(painter: &Painter, area: Rect, desk: &Desk<'_>) {
    let id = Id::unique("a scene is read");
    let strength = painter.ctx().animate_bool_with_time(id, desk.loading.is_some(), FADES_IN);
    let Some(source) = desk.loading else { return };
    let name = source.path().and_then(std::path::Path::file_name).map(shown);
    let text = [Some(desk.texts.scene_loading()), name].into_iter().flatten().collect::<Vec<_>>().join("\n");
    label::above(painter, area, &text, strength * strength);
}
