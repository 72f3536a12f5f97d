//! The list of the scene's objects and lights.

use crate::command::Command;
use crate::document::Stamp;
use crate::selection::Part;
use crate::state::Desk;
use crate::undo::Gesture;
use crate::widgets::icon::{self, Icon};
use egui::{Align, Button, Id, Layout, ScrollArea, TextEdit, Ui, vec2};
use std::sync::Arc;

/// The least and the most rows that are seen at once, and the share of the window that they may take.
const ROWS: [f32; 2] = [3.0, 12.0];
const SHARE: f32 = 0.2;

pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let filter = filter_field(ui, desk);
    let rows = Rows::of(ui, desk, &filter);
    if rows.len() == 0 {
        ui.weak(desk.texts.objects_none_found());
        return;
    }
    let height = ui.spacing().interact_size.y;
    let row_height = height + ui.spacing().item_spacing.y;
    // Whole rows: the last one is not cut.
    let seen = (ui.ctx().content_rect().height() * SHARE / row_height).floor().clamp(ROWS[0], ROWS[1]);
    let most = seen * row_height - ui.spacing().item_spacing.y;
    let newly = newly_selected(ui, desk);
    let mut area = ScrollArea::vertical().id_salt("objects").max_height(most).auto_shrink([false, true]);
    // A selection made in the picture is brought into sight in the list.
    if let Some(row) = newly.and_then(|part| rows.place_of(part)) {
        let offset = (row as f32 - (seen / 2.0).floor()).max(0.0) * row_height;
        area = area.vertical_scroll_offset(offset);
    }
    area.show_rows(ui, height, rows.len(), |ui, range| {
        for part in range.filter_map(|place| rows.at(place)) {
            row(ui, desk, part);
        }
    });
}

fn filter_field(ui: &mut Ui, desk: &Desk<'_>) -> String {
    let id = Id::unique("objects filter");
    let mut filter: String = ui.data(|d| d.get_temp(id)).unwrap_or_default();
    let name = desk.texts.objects_filter();
    let edit = TextEdit::singleline(&mut filter).hint_text(name.clone()).desired_width(f32::INFINITY).id(id);
    let response = ui.add(edit);
    // The hint goes away with the first letter; the name stays.
    response.widget_info(|| {
        let mut info = egui::WidgetInfo::text_edit(ui.is_enabled(), &filter, &filter, &name);
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

fn row(ui: &mut Ui, desk: &mut Desk<'_>, part: Part) {
    let Some(name) = part.name(desk.scene()).map(str::to_owned) else { return };
    let hidden = part.is_hidden(desk.scene());
    let selected = desk.state.selection == Some(part);
    ui.push_id(part, |ui| {
        ui.horizontal(|ui| {
            icon::label(ui, Icon::of(part, desk.scene()));
            let width = ui.available_width() - 24.0 - ui.spacing().item_spacing.x;
            let text = egui::RichText::new(&name);
            let text = if hidden { text.weak() } else { text };
            let size = vec2(width, ui.spacing().interact_size.y);
            let left = Layout::left_to_right(Align::Center).with_main_justify(true).with_main_align(Align::Min);
            let button = Button::selectable(selected, text).truncate();
            let response = ui.allocate_ui_with_layout(size, left, |ui| ui.add(button)).inner;
            if response.clicked() {
                desk.send(Command::Select(Some(part)));
            }
            let (eye, does) = if hidden {
                (Icon::Hidden, desk.texts.objects_show(&name))
            } else {
                (Icon::Shown, desk.texts.objects_hide(&name))
            };
            if icon::button(ui, eye, &does, hidden).clicked() {
                desk.send(Command::Edit(part.set_hidden(!hidden), Gesture::Single));
            }
        });
    });
}
