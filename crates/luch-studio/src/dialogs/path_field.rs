//! A field for a path, with what the folder has that the typed text may become listed below it.
//!
//! Arrow keys go through the list, Enter takes the marked entry or, with none marked, ends the input. Beside the field a
//! button asks the dialog of the system, where there is one.

use super::entries;
use crate::command::Command;
use crate::files::{Chosen, FileQuestion, Purpose, TypedPath, shown};
use crate::state::Desk;
use crate::widgets::row;
use egui::{Button, Id, Key, Modifiers, Response, ScrollArea, TextEdit, Ui, text::CCursor, text::CCursorRange};
use luch_io::folder::Entry;
use std::path::{Path, PathBuf};

/// What the field remembers while its dialog is open.
#[derive(Debug, Clone, Default)]
struct Field {
    typed: TypedPath,
    marked: Option<usize>,
    begun: bool,
}

/// What stands in the field now.
pub(super) struct Answer {
    pub(super) path: PathBuf,
    /// Whether Enter was pressed, or the system's dialog closed with a file.
    pub(super) done: bool,
}

/// Forgets what was typed: the next dialog begins anew.
pub(super) fn forget(ctx: &egui::Context, purpose: Purpose) {
    ctx.data_mut(|d| d.remove_temp::<Field>(id(purpose)));
}

fn id(purpose: Purpose) -> Id {
    Id::unique(("path field", purpose))
}

/// Gives the file another ending.
pub(super) fn set_ending(ctx: &egui::Context, purpose: Purpose, ending: &str) {
    ctx.data_mut(|d| d.get_temp_mut_or_default::<Field>(id(purpose)).typed.set_ending(ending));
}

/// Shows the field and so many rows of the list; `start` is where it begins.
pub(super) fn show(
    ui: &mut Ui,
    desk: &mut Desk<'_>,
    purpose: Purpose,
    list_rows: f32,
    start: impl FnOnce() -> TypedPath,
) -> Answer {
    let id = id(purpose);
    let mut field: Field = ui.data(|d| d.get_temp(id)).unwrap_or_default();
    let first = !field.begun;
    if first {
        field = Field { typed: start(), marked: None, begun: true };
    }
    let home = desk.files.home.clone();
    let home = home.as_deref();
    let mut answer = Answer { path: PathBuf::new(), done: false };

    answer.done |= take_chosen(desk, &mut field);
    let text_id = id.with("text");
    let folder = field.typed.folder(home);
    let entries: Vec<Entry> = match desk.files.listed(&folder, purpose) {
        Some(Ok(entries)) => entries.to_vec(),
        _ => Vec::new(),
    };
    let rows: Vec<Entry> = field.typed.matches(&entries).into_iter().cloned().collect();
    let keys = take_keys(ui, text_id);
    match keys {
        Keys::Down => field.marked = Some(field.marked.map_or(0, |row| row + 1)).filter(|_| !rows.is_empty()),
        Keys::Up => field.marked = field.marked.and_then(|row| row.checked_sub(1)),
        _ => {}
    }
    field.marked = field.marked.map(|row| row.min(rows.len().saturating_sub(1)));

    let response = text_field(ui, desk, purpose, &mut field, text_id, &folder);
    if first {
        response.request_focus();
        mark_name(ui, text_id, &field.typed.text, purpose);
    }
    if response.changed() {
        (field.marked, field.typed.edited) = (None, true);
        desk.send(Command::ForgetComplaint);
    }
    if response.lost_focus() && ui.input(|i| i.key_pressed(Key::Enter)) {
        match field.marked.take().and_then(|row| rows.get(row)) {
            Some(entry) => {
                take_entry(ui, &mut field, &entry.name, entry.is_folder, home, text_id);
                answer.done |= !entry.is_folder && !purpose.writes();
            }
            None => answer.done = true,
        }
    }
    show_state(ui, desk, &folder, purpose);
    let mut taken = false;
    if folder.parent().is_some_and(|above| !above.as_os_str().is_empty())
        && ui.button(desk.texts.folder_above()).clicked()
    {
        field.typed.leave(home);
        to_end(ui, text_id, &field.typed.text);
        taken = true;
    }
    let follow = keys != Keys::None;
    if let Some(entry) = entries::show(ui, &rows, list_rows, field.marked, follow).and_then(|row| rows.get(row)) {
        take_entry(ui, &mut field, &entry.name, entry.is_folder, home, text_id);
        taken = true;
    }
    if taken {
        field.marked = None;
        desk.send(Command::ForgetComplaint);
    }
    let folder = field.typed.folder(home);
    if !desk.files.is_listing(&folder, purpose) {
        desk.send(Command::ListFolder(folder, purpose));
    }
    answer.path = field.typed.path(home);
    ui.data_mut(|d| d.insert_temp(id, field));
    answer
}

/// The text and the button beside it.
fn text_field(
    ui: &mut Ui,
    desk: &mut Desk<'_>,
    purpose: Purpose,
    field: &mut Field,
    id: Id,
    folder: &Path,
) -> Response {
    let texts = desk.texts;
    let name = texts.path_field();
    ui.horizontal(|ui| {
        let button = 110.0;
        let width = ui.available_width() - button - ui.spacing().item_spacing.x;
        let edit = TextEdit::singleline(&mut field.typed.text).id(id).desired_width(width).char_limit(4096);
        let response = ui.add_sized(egui::vec2(width, ui.spacing().interact_size.y), edit);
        response.ctx.accesskit_node_builder(response.id, |node| node.set_label(name.clone()));
        let browse = Button::new(texts.button_browse()).min_size(egui::vec2(button, 0.0));
        let idle = !desk.files.is_choosing();
        if ui.add_enabled(idle, browse).on_hover_text(texts.button_browse_tip()).clicked() {
            let file = field.typed.path(desk.files.home.as_deref());
            let name = if purpose.writes() {
                file.file_name().unwrap_or_default().to_string_lossy().into_owned()
            } else {
                String::new()
            };
            desk.send(Command::Browse(FileQuestion {
                title: purpose.title(texts),
                files: purpose.files(texts),
                endings: purpose.endings(),
                folder: folder.to_owned(),
                name,
                writes: purpose.writes(),
            }));
        }
        response
    })
    .inner
}

/// Takes over what the system's dialog answered; answers whether that is a file to go on with.
fn take_chosen(desk: &mut Desk<'_>, field: &mut Field) -> bool {
    match desk.files.chosen() {
        Some(Chosen::Path(path)) => {
            field.typed = TypedPath::of_file(path);
            desk.send(Command::ForgetChosen);
            true
        }
        Some(Chosen::Nothing) => {
            desk.send(Command::ForgetChosen);
            false
        }
        // Told below the field, until something is typed.
        Some(Chosen::NoDialog) | None => false,
    }
}

/// Keys that the list takes before the text does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Keys {
    None,
    Up,
    Down,
}

fn take_keys(ui: &Ui, text: Id) -> Keys {
    if !ui.memory(|m| m.has_focus(text)) {
        return Keys::None;
    }
    ui.input_mut(|i| {
        if i.consume_key(Modifiers::NONE, Key::ArrowDown) {
            Keys::Down
        } else if i.consume_key(Modifiers::NONE, Key::ArrowUp) {
            Keys::Up
        } else {
            Keys::None
        }
    })
}

/// What is wrong with the folder, or with the system's dialog.
fn show_state(ui: &mut Ui, desk: &Desk<'_>, folder: &Path, purpose: Purpose) {
    if desk.files.chosen() == Some(&Chosen::NoDialog) {
        row::complaint(ui, &desk.texts.no_system_dialog());
    }
    if let Some(complaint) = &desk.state.complaint {
        ScrollArea::vertical().id_salt("complaint").max_height(110.0).show(ui, |ui| row::complaint(ui, complaint));
    } else if let Some(Err(why)) = desk.files.listed(folder, purpose) {
        row::complaint(ui, &desk.texts.folder_not_read(shown(folder.as_os_str()), why));
    }
}

fn take_entry(ui: &Ui, field: &mut Field, name: &std::ffi::OsStr, is_folder: bool, home: Option<&Path>, text: Id) {
    field.typed.take(name, is_folder, home);
    to_end(ui, text, &field.typed.text);
}

/// Puts the cursor behind the text, to go on typing.
fn to_end(ui: &Ui, id: Id, text: &str) {
    ui.memory_mut(|m| m.request_focus(id));
    let end = CCursor::new(text.chars().count());
    select(ui, id, CCursorRange::one(end));
}

/// Marks the name of a file to be written, without its ending, so that another one can be typed over it.
fn mark_name(ui: &Ui, id: Id, text: &str, purpose: Purpose) {
    let from = text.rfind(std::path::is_separator).map_or(0, |at| at + 1);
    let to = if purpose.writes() { text.rfind('.').filter(|&at| at > from).unwrap_or(text.len()) } else { from };
    let place = |byte: usize| CCursor::new(text.get(..byte).map_or(0, |head| head.chars().count()));
    let from = if purpose.writes() { place(from) } else { place(text.len()) };
    let to = if purpose.writes() { place(to) } else { place(text.len()) };
    select(ui, id, CCursorRange::two(from, to));
}

fn select(ui: &Ui, id: Id, range: CCursorRange) {
    let mut state = TextEdit::load_state(ui.ctx(), id).unwrap_or_default();
    state.cursor.set_char_range(Some(range));
    state.store(ui.ctx(), id);
}
