//! The window of Luch: a scene, its picture, and every control of both.
//!
//! Panels read the `state` and queue `command`s; `studio` applies them in one place. What is slow happens
//! elsewhere: the renderer behind `render_link`, files behind `loader`. The window draws, it does not compute.

#![forbid(unsafe_code)]

mod command;
mod dialogs;
mod document;
mod explain;
mod figures;
mod files;
mod l10n;
mod loader;
mod milestone;
mod notices;
mod panels;
mod panics;
mod placement;
mod preferences;
mod render_link;
mod selection;
mod shortcuts;
mod state;
mod studio;
mod study;
mod style;
mod texture;
mod told;
mod undo;
mod view;
mod viewport;
mod widgets;

pub use files::{ChooseFile, FileQuestion};
pub use milestone::Milestone;
pub use studio::{Start, Studio};

/// The name under which the system keeps the window's preferences.
const APP_ID: &str = "luch";

/// Opens the window and answers when it is closed.
///
/// # Errors
/// Why there is no window: no display, no OpenGL.
pub fn run(mut start: Start) -> Result<(), String> {
    start.data_dir = start.data_dir.or_else(|| eframe::storage_dir(APP_ID));
    let viewport = egui::ViewportBuilder::default()
        .with_app_id(APP_ID)
        .with_title("Luch")
        .with_inner_size([1280.0, 800.0])
        .with_min_inner_size([720.0, 480.0])
        .with_drag_and_drop(true);
    let options = eframe::NativeOptions { viewport, ..Default::default() };
    let create: eframe::AppCreator<'_> =
        Box::new(|creation| Ok(Box::new(Studio::new(creation, start)?) as Box<dyn eframe::App>));
    eframe::run_native(APP_ID, options, create).map_err(|error| words_of_system(&error.to_string()).to_owned())
}

/// What the system said of an error. The window library puts the place in its own source before it.
fn words_of_system(error: &str) -> &str {
    let after_place = error.split_once("os error at ").and_then(|(_, rest)| rest.split_once(": "));
    after_place.map_or(error, |(_, words)| words)
}
