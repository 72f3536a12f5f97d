//! The controls around the picture: menu above, status below, everything else to the right.

mod drop;
mod export;
mod hints;
mod lens;
mod menu;
mod notices;
mod objects;
mod parameters;
mod properties;
mod render;
mod reveal;
mod scene;
mod status;

pub(crate) use objects::has_focus as list_has_focus;
pub(crate) use render::duration;
pub(crate) use scene::{built_in_name, scene_name};

use crate::state::Desk;
use egui::{CollapsingHeader, Frame, Margin, Panel, ScrollArea, Ui};

/// The least, the first and the greatest width of the panel to the right, in points.
const WIDTH: [f32; 3] = [320.0, 360.0, 640.0];
/// What the panel leaves of the window to the picture, in points.
const PICTURE: f32 = 360.0;

/// Shows all panels; what is left of the window is the picture's.
pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    Panel::top("menu").show(ui, |ui| menu::show(ui, desk));
    Panel::bottom("status").show(ui, |ui| status::show(ui, desk));
    export::show(ui, desk);
    let most = (ui.available_width() - PICTURE).clamp(WIDTH[0], WIDTH[2]);
    Panel::right("controls").min_size(WIDTH[0]).default_size(WIDTH[1]).max_size(most).show(ui, |ui| {
        // Always in sight, whatever is scrolled.
        let frame = Frame::side_top_panel(ui.style()).inner_margin(Margin { left: 8, right: 6, top: 2, bottom: 2 });
        Panel::bottom("render").resizable(false).frame(frame).show(ui, |ui| render::show(ui, desk));
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
            // The same left edge as below, from which the column of controls is counted.
            ui.set_clip_rect(ui.clip_rect().with_min_x(ui.max_rect().left()));
            ui.add_space(4.0);
            let texts = desk.texts;
            section(ui, "scene", &texts.panel_scene(), desk, scene::show);
            section(ui, "objects", &texts.panel_objects(), desk, objects::show);
            section(ui, "properties", &texts.panel_properties(), desk, properties::show);
            section(ui, "parameters", &texts.panel_parameters(), desk, parameters::show);
            section(ui, "lens", &texts.panel_lens(), desk, lens::show);
            ui.add_space(8.0);
            reveal::focused(ui);
        });
    });
    // egui gives the handle between picture and panel an English name only.
    let handle = ui.scope_id().with("controls").with("__resize");
    ui.ctx().accesskit_node_builder(handle, |node| node.set_label(desk.texts.panel_resize()));
    crate::explain::show_panel(ui, desk);
    hints::show(ui, desk);
    notices::show(ui.ctx(), ui.available_rect_before_wrap(), desk);
    drop::show(ui.ctx(), desk);
}

/// A part of the panel that can be folded away.
fn section(ui: &mut Ui, id: &str, title: &str, desk: &mut Desk<'_>, show: fn(&mut Ui, &mut Desk<'_>)) {
    CollapsingHeader::new(egui::RichText::new(title).strong()).id_salt(id).default_open(true).show(ui, |ui| {
        show(ui, desk);
    });
}
