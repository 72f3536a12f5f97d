//! All keys, and what the mouse does in the picture.

use super::close_button;
use crate::command::Command;
use crate::state::Desk;
use egui::{ScrollArea, Ui};

/// The width of the dialog, of the column of keys, and what is between the columns, in points.
pub(super) const WIDTH: f32 = 626.0;
const KEYS: f32 = 190.0;
const GAP: f32 = 16.0;

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let mouse = [
        (texts.mouse_click(), texts.mouse_click_does()),
        (texts.mouse_drag(), texts.mouse_drag_does()),
        (texts.mouse_handle(), texts.mouse_handle_does()),
        (texts.mouse_handle_snap(), texts.mouse_handle_snap_does()),
        (texts.key_escape_drag(), texts.key_escape_drag_does()),
        (texts.mouse_pan(), texts.mouse_pan_does()),
        (texts.mouse_wheel(), texts.mouse_wheel_does()),
        (texts.mouse_zoom(), texts.mouse_zoom_does()),
        (texts.mouse_pan_pixels(), texts.mouse_pan_pixels_does()),
    ];
    let keys = Command::with_shortcuts().into_iter().filter_map(|command| {
        let shortcut = command.shortcut()?;
        Some((ui.ctx().format_shortcut(&shortcut), command.label(texts)))
    });
    let keys: Vec<_> = keys.chain([(texts.key_cameras(), texts.key_cameras_does())]).collect();
    let keys_of_picture = vec![
        (texts.key_orbit(), texts.key_orbit_does()),
        (texts.key_pan(), texts.key_pan_does()),
        (texts.key_dolly(), texts.key_dolly_does()),
    ];
    let parts = [
        (texts.shortcuts_mouse(), mouse.to_vec()),
        (texts.shortcuts_keys(), keys),
        (texts.shortcuts_keys_of_picture(), keys_of_picture),
    ];
    let height = (ui.ctx().content_rect().height() - 160.0).min(460.0);
    ScrollArea::vertical().max_height(height).auto_shrink([false, true]).show(ui, |ui| {
        for (title, rows) in parts {
            ui.strong(&title);
            egui::Grid::new(("shortcuts", title))
                .num_columns(2)
                .min_col_width(KEYS)
                .striped(true)
                .spacing([GAP, 3.0])
                .show(ui, |ui| {
                    for (key, does) in rows {
                        ui.label(key);
                        ui.horizontal(|ui| {
                            // The stripes of all parts are equally wide.
                            ui.set_width(WIDTH - KEYS - GAP - 14.0);
                            ui.label(does);
                        });
                        ui.end_row();
                    }
                });
            ui.add_space(8.0);
        }
    });
    close_button(ui, desk);
}
