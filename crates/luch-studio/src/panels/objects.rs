//! The list of the scene's objects and lights. Rows come and go with scrolling: the list has the focus for them.

use crate::command::Command;
use crate::document::Stamp;
use crate::selection::Part;
use crate::state::Desk;
use crate::undo::Gesture;
use crate::widgets::icon::{self, Icon};
use egui::{
    Align, Button, Context, EventFilter, Id, Key, Layout, Modifiers, Response, Role, ScrollArea, Sense, StrokeKind,
    TextEdit, Ui, WidgetInfo, vec2,
};
use std::sync::Arc;

/// The least and the most rows that are seen at once, and the share of the window that they may take.
const ROWS: [f32; 2] = [3.0, 12.0];
const SHARE: f32 = 0.2;

pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let filter = filter_field(ui, desk);
    let rows = Rows::of(ui, desk, &filter);
    if rows.len() == 0 {
        let is_filtered = !filter.is_empty();
        ui.weak(if is_filtered { desk.texts.objects_none_found() } else { desk.texts.objects_none() });
        return;
    }
    let id = list_id();
    take_keys(ui, desk, &rows);
    let height = ui.spacing().interact_size.y;
    let row_height = row_height(ui);
    let rows_seen = rows_seen(ui);
    // Whole rows: the last one is not cut.
    let most = rows_seen * row_height - ui.spacing().item_spacing.y;
    let mut area = ScrollArea::vertical().id_salt("objects").max_height(most).auto_shrink([false, true]);
    // A selection made elsewhere, or by key, is brought into sight in the list.
    if let Some(row) = newly_selected(ui, desk).and_then(|part| rows.place_of(part)) {
        let seen: Option<[f32; 2]> = ui.data(|d| d.get_temp(id.with("seen")));
        if let Some(offset) = offset_to(row as f32 * row_height, height, seen.unwrap_or([0.0, most])) {
            area = area.vertical_scroll_offset(offset);
        }
    }
    let (mut clicked, mut active) = (false, None);
    let output = area.show_rows(ui, height, rows.len(), |ui, range| {
        for part in range.filter_map(|place| rows.at(place)) {
            let Some(row) = row(ui, desk, part) else { continue };
            clicked |= row.clicked();
            if desk.state.selection == Some(part) {
                active = Some(row.id.accesskit_id());
            }
        }
    });
    let seen = [output.state.clamped_offset().y, output.inner_rect.height()];
    ui.data_mut(|d| d.insert_temp(id.with("seen"), seen));
    let list = ui.interact(output.inner_rect, id, Sense::focusable_noninteractive());
    if clicked {
        list.request_focus();
    }
    let name = desk.texts.panel_objects();
    list.widget_info(|| WidgetInfo::labeled(Role::ListBox, true, &name));
    if let Some(active) = active {
        ui.ctx().accesskit_node_builder(id, |node| node.set_active_descendant(active));
    }
    if list.has_focus() {
        let frame = output.inner_rect.expand2(vec2(4.0, 2.0));
        ui.painter().rect_stroke(frame, 2.0, ui.visuals().selection.stroke, StrokeKind::Inside);
    }
}

/// From one row to the next, in points.
fn row_height(ui: &Ui) -> f32 {
    ui.spacing().interact_size.y + ui.spacing().item_spacing.y
}

/// How many rows are seen at once where there are enough.
fn rows_seen(ui: &Ui) -> f32 {
    (ui.ctx().content_rect().height() * SHARE / row_height(ui)).floor().clamp(ROWS[0], ROWS[1])
}

fn list_id() -> Id {
    Id::unique("objects of the scene")
}

/// Whether the keys are the list's.
pub(crate) fn has_focus(ctx: &Context) -> bool {
    ctx.memory(|m| m.has_focus(list_id()))
}

/// Where to scroll so that a row at `top` is in sight; `None` if it is. A step goes no further than it must, a leap
/// shows what is around.
fn offset_to(top: f32, height: f32, [offset, room]: [f32; 2]) -> Option<f32> {
    let (above, below) = (offset - top, top + height - (offset + room));
    let beyond = above.max(below);
    if beyond <= 0.0 {
        None
    } else if beyond > room {
        Some((top - (room - height) * 0.5).max(0.0))
    } else {
        Some(if above > 0.0 { top } else { top + height - room })
    }
}

/// The keys of the list, while it has the focus: they move the selection.
fn take_keys(ui: &Ui, desk: &mut Desk<'_>, rows: &Rows) {
    if !has_focus(ui.ctx()) {
        return;
    }
    let arrows = EventFilter { vertical_arrows: true, ..Default::default() };
    ui.memory_mut(|m| m.set_focus_lock_filter(list_id(), arrows));
    let pressed = |key: Key| ui.input_mut(|i| i.count_and_consume_key(Modifiers::NONE, key));
    let page = rows_seen(ui) as usize - 1;
    let forward = pressed(Key::ArrowDown) + page * pressed(Key::PageDown);
    let back = pressed(Key::ArrowUp) + page * pressed(Key::PageUp);
    let (first, last) = (pressed(Key::Home) > 0, pressed(Key::End) > 0);
    let end = rows.len() - 1;
    let place = desk.state.selection.and_then(|part| rows.place_of(part));
    let to = match place {
        _ if first => 0,
        _ if last => end,
        _ if forward == back => return,
        Some(place) => (place + forward).saturating_sub(back).min(end),
        // With nothing selected, the row at the side that the key comes from.
        None => {
            if forward > back {
                0
            } else {
                end
            }
        }
    };
    if let Some(part) = rows.at(to) {
        desk.send(Command::Select(Some(part)));
    }
}

fn filter_field(ui: &mut Ui, desk: &Desk<'_>) -> String {
    let id = Id::unique("objects filter");
    let mut filter: String = ui.data(|d| d.get_temp(id)).unwrap_or_default();
    let name = desk.texts.objects_filter();
    let edit = TextEdit::singleline(&mut filter).hint_text(name.clone()).desired_width(f32::INFINITY).id(id);
    let response = ui.add(edit);
    // The hint goes away with the first letter; the name stays.
    response.widget_info(|| {
        let mut info = WidgetInfo::text_edit(ui.is_enabled(), &filter, &filter, &name);
        info.label = Some(name.clone());
        info
    });
    ui.data_mut(|d| d.insert_temp(id, filter.clone()));
    filter.to_lowercase()
}

/// The rows of the list. A frame costs as much for a million objects as for ten.
enum Rows {
    /// All objects, then all lights.
    All { objects: usize, lights: usize },
    /// Those whose names have the words of the filter.
    Found(Arc<Vec<Part>>),
}

/// What was found last: with which words, in which state of the scene.
type Found = (String, Stamp, Arc<Vec<Part>>);

impl Rows {
    fn of(ui: &Ui, desk: &Desk<'_>, filter: &str) -> Self {
        let scene = desk.scene();
        if filter.is_empty() {
            return Self::All { objects: scene.objects.len(), lights: scene.lights.len() };
        }
        let (id, state) = (Id::unique("objects found"), desk.state.document.stamp());
        let known: Option<Found> = ui.data(|d| d.get_temp(id));
        if let Some((words, of, found)) = known
            && (words.as_str(), of) == (filter, state)
        {
            return Self::Found(found);
        }
        let matches = |name: &str| name.to_lowercase().contains(filter);
        let objects = scene.objects.iter().enumerate().filter(|(_, o)| matches(&o.name)).map(|(i, _)| Part::Object(i));
        let lights = scene.lights.iter().enumerate().filter(|(_, l)| matches(&l.name)).map(|(i, _)| Part::Light(i));
        let found: Arc<Vec<Part>> = Arc::new(objects.chain(lights).collect());
        ui.data_mut(|d| d.insert_temp::<Found>(id, (filter.to_owned(), state, Arc::clone(&found))));
        Self::Found(found)
    }

    fn len(&self) -> usize {
        match self {
            Self::All { objects, lights } => objects + lights,
            Self::Found(found) => found.len(),
        }
    }

    fn at(&self, place: usize) -> Option<Part> {
        match self {
            Self::All { objects, .. } if place < *objects => Some(Part::Object(place)),
            Self::All { objects, lights } => (place - objects < *lights).then(|| Part::Light(place - objects)),
            Self::Found(found) => found.get(place).copied(),
        }
    }

    fn place_of(&self, part: Part) -> Option<usize> {
        match (self, part) {
            (Self::All { .. }, Part::Object(index)) => Some(index),
            (Self::All { objects, .. }, Part::Light(index)) => Some(objects + index),
            (Self::Found(found), part) => found.iter().position(|known| *known == part),
        }
    }
}

/// What is selected, if it was not when the list was drawn last.
fn newly_selected(ui: &Ui, desk: &Desk<'_>) -> Option<Part> {
    let id = Id::unique("objects selection");
    let before: Option<Part> = ui.data(|d| d.get_temp(id)).flatten();
    let now = desk.state.selection;
    ui.data_mut(|d| d.insert_temp(id, now));
    now.filter(|_| now != before)
}

/// Shows a row; answers with the button that selects.
fn row(ui: &mut Ui, desk: &mut Desk<'_>, part: Part) -> Option<Response> {
    let name = part.name(desk.scene()).map(str::to_owned)?;
    let hidden = part.is_hidden(desk.scene());
    let selected = desk.state.selection == Some(part);
    let row = ui.push_id(part, |ui| {
        ui.horizontal(|ui| {
            icon::kind(ui, Icon::of(part, desk.scene()), desk.texts);
            let width = ui.available_width() - 24.0 - ui.spacing().item_spacing.x;
            let text = egui::RichText::new(&name);
            let text = if hidden { text.weak() } else { text };
            let size = vec2(width, ui.spacing().interact_size.y);
            let left = Layout::left_to_right(Align::Center).with_main_justify(true).with_main_align(Align::Min);
            let button = Button::selectable(selected, text).truncate().sense(Sense::CLICK);
            let response = ui.allocate_ui_with_layout(size, left, |ui| ui.add(button)).inner;
            if response.clicked() {
                desk.send(Command::Select(Some(part)));
            }
            let (eye, does) = if hidden {
                (Icon::Hidden, desk.texts.objects_show(&name))
            } else {
                (Icon::Shown, desk.texts.objects_hide(&name))
            };
            if icon::button_in_row(ui, eye, &does, hidden).clicked() {
                desk.send(Command::Edit(part.set_hidden(!hidden), Gesture::Single));
            }
            response
        })
        .inner
    });
    Some(row.inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_scrolled_to_no_further_than_it_must() {
        let seen = [100.0, 180.0];
        assert_eq!(offset_to(100.0, 20.0, seen), None);
        assert_eq!(offset_to(260.0, 20.0, seen), None);
        assert_eq!(offset_to(80.0, 20.0, seen), Some(80.0));
        assert_eq!(offset_to(270.0, 20.0, seen), Some(110.0));
        // Far away, into the middle; never above the first.
        assert_eq!(offset_to(1000.0, 20.0, seen), Some(920.0));
        assert_eq!(offset_to(0.0, 20.0, [500.0, 180.0]), Some(0.0));
    }
}
