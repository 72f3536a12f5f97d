//! Brings what gets the focus by key into sight: egui moves the focus, and leaves the scrolling to others.

use egui::{Id, Ui};

/// Free space around it, in points.
const MARGIN: f32 = 12.0;

/// Called at the end of what scrolls: shows the widget of it that has the focus since this frame.
pub(super) fn focused(ui: &Ui) {
    let id = Id::unique("focus in the panel");
    let now = ui.memory(egui::Memory::focused);
    let before = ui.data_mut(|d| std::mem::replace(d.get_temp_mut_or_default::<Option<Id>>(id), now));
    // What is clicked is in sight.
    if now == before || ui.input(|i| i.pointer.any_down() || i.pointer.any_released()) {
        return;
    }
    let Some(widget) = now.and_then(|now| ui.ctx().read_response(now)) else { return };
    let is_here = widget.layer_id == ui.layer_id() && ui.max_rect().x_range().contains(widget.rect.center().x);
    // The controls beside what scrolls are never cut.
    if is_here && !widget.interact_rect.contains_rect(widget.rect) {
        ui.scroll_to_rect(widget.rect.expand(MARGIN), None);
    }
}
