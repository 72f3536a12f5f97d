//! A line of a panel: the name of a control to the left, the control to the right.

use egui::{Align, Layout, Response, Ui, vec2};

/// Where the controls begin, in points from the left edge of the panel: below each other, however far in the names stand.
const CONTROLS: f32 = 158.0;

/// Shows a name and beside it what `control` adds. The control gets the response of the name to be labelled by it.
pub(crate) fn labelled<R>(ui: &mut Ui, name: &str, tooltip: &str, control: impl FnOnce(&mut Ui, &Response) -> R) -> R {
    ui.horizontal(|ui| {
        let room = ui.available_width();
        let names = ui.clip_rect().left() + CONTROLS - ui.spacing().item_spacing.x - ui.cursor().left();
        let width = names.clamp(room * 0.3, room * 0.48);
        let label = ui
            .allocate_ui_with_layout(
                vec2(width, ui.spacing().interact_size.y),
                Layout::left_to_right(Align::Center).with_main_wrap(true),
                |ui| {
                    ui.set_width(width);
                    ui.label(name)
                },
            )
            .inner;
        tip(&label, tooltip);
        control(ui, &label)
    })
    .inner
}

/// Says of a control what it drives: to who reads the screen always, to the pointer unless somebody types, for the words
/// would cover what is below.
pub(crate) fn tip(control: &Response, tooltip: &str) {
    if tooltip.is_empty() {
        return;
    }
    control.ctx.accesskit_node_builder(control.id, |node| node.set_description(tooltip));
    if !control.has_focus() {
        control.clone().on_hover_text(tooltip).on_disabled_hover_text(tooltip);
    }
}

/// A line below a control that says what is wrong with its input.
pub(crate) fn complaint(ui: &mut Ui, text: &str) {
    let color = ui.visuals().error_fg_color;
    ui.label(egui::RichText::new(text).color(color).small());
}
