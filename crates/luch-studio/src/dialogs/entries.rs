//! The list of what a folder has, below a path field.

use crate::files::shown;
use egui::{Align, Button, Layout, ScrollArea, Ui, vec2};
use luch_io::folder::Entry;

/// What of the window's height is not the list's, in points.
const REST: f32 = 330.0;

/// Shows the entries, so many rows of them at once where the window has room, and answers which was clicked. `follow`
/// brings the marked one into sight.
pub(super) fn show(ui: &mut Ui, entries: &[Entry], rows: f32, marked: Option<usize>, follow: bool) -> Option<usize> {
    let height = ui.spacing().interact_size.y;
    let row_height = height + ui.spacing().item_spacing.y;
    let room = (ui.ctx().content_rect().height() - REST) / row_height;
    let rows = rows.min(room.max(2.0));
    let mut area = ScrollArea::vertical().id_salt("entries").auto_shrink([false, false]);
    area = area.max_height(rows * row_height).min_scrolled_height(rows * row_height);
    if let Some(row) = marked.filter(|_| follow) {
        area = area.vertical_scroll_offset((row as f32 - rows / 2.0).max(0.0) * row_height);
    }
    let mut clicked = None;
    area.show_rows(ui, height, entries.len(), |ui, range| {
        for (row, entry) in entries.iter().enumerate().take(range.end).skip(range.start) {
            let mut name = shown(&entry.name);
            if entry.is_folder {
                name.push(std::path::MAIN_SEPARATOR);
            }
            let button = Button::selectable(marked == Some(row), name).truncate();
            let size = vec2(ui.available_width(), height);
            let left = Layout::left_to_right(Align::Center).with_main_justify(true).with_main_align(Align::Min);
            if ui.allocate_ui_with_layout(size, left, |ui| ui.add(button)).inner.clicked() {
                clicked = Some(row);
            }
        }
    });
    clicked
}
