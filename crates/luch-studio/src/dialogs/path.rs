//! Asks for the path of a scene or model to open, or of a file to write the scene to.

use super::path_field::{self, Answer};
use super::two_buttons;
use crate::command::Command;
use crate::files::{Purpose, TypedPath};
use crate::state::{Desk, State};
use egui::Ui;
use luch_io::SceneSource;
use std::path::{Path, PathBuf};

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>, purpose: Purpose, then: Option<&Command>) {
    let texts = desk.texts;
    ui.set_width(560.0);
    let state = desk.state;
    let Answer { path, done, .. } = path_field::show(ui, desk, purpose, 9.0, || start(state, purpose));
    let busy = desk.loading.is_some() || desk.files.is_saving() || desk.files.is_adding();
    if busy {
        ui.weak(if purpose.writes() { texts.files_saving() } else { texts.files_reading() });
    }
    let pressed = two_buttons(ui, &purpose.button(texts), !busy && path.file_name().is_some(), &texts.button_cancel());
    if pressed == Some(false) {
        desk.send(Command::CloseDialog);
    } else if (done || pressed == Some(true)) && !busy && path.file_name().is_some() {
        submit(desk, purpose, path, then);
    }
}

fn submit(desk: &mut Desk<'_>, purpose: Purpose, path: PathBuf, then: Option<&Command>) {
    match purpose {
        Purpose::Open => desk.send(Command::OpenPath(path)),
        Purpose::AddModel => desk.send(Command::AddModels(vec![path])),
        Purpose::Save => {
            let (path, replace) = (with_ending(path, "toml"), false);
            desk.send(Command::SaveTo { path, replace, then: then.cloned().map(Box::new) });
        }
        // The export has a dialog of its own.
        Purpose::Export => {}
    }
}

/// The path with an ending, if it has another or none.
pub(super) fn with_ending(path: PathBuf, ending: &str) -> PathBuf {
    if path.extension().is_some_and(|known| known.eq_ignore_ascii_case(ending)) {
        return path;
    }
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(".");
    name.push(ending);
    path.with_file_name(name)
}

/// Where the field begins: in the folder of the scene at hand, or of the file that was used last.
fn start(state: &State, purpose: Purpose) -> TypedPath {
    let folder = folder(state);
    match purpose {
        Purpose::Save => TypedPath::new(&folder, &format!("{}.toml", file_name(&state.scene().name))),
        _ => TypedPath::new(&folder, ""),
    }
}

/// The folder that a person most likely means.
pub(super) fn folder(state: &State) -> PathBuf {
    let own = state.document.source.as_ref().and_then(SceneSource::path);
    let last = state.preferences.recent.first().map(PathBuf::as_path);
    let of_file = |path: &Path| path.parent().filter(|folder| !folder.as_os_str().is_empty()).map(Path::to_owned);
    let here = std::env::current_dir().unwrap_or_default();
    // Relative paths are what the command line was given, seen from the working folder.
    own.or(last).and_then(of_file).map_or_else(|| here.clone(), |folder| here.join(folder))
}

/// A scene's name as the name of a file: without what some system would not take.
pub(super) fn file_name(name: &str) -> String {
    let taken = |c: char| c.is_control() || matches!(c, '/' | '\\' | ':' | '*' | '?' | '"' | '<' | '>' | '|');
    let name: String = name.chars().map(|c| if taken(c) { '_' } else { c }).take(80).collect();
    let name = name.trim().trim_matches('.');
    if name.is_empty() { "scene".to_owned() } else { name.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_of_scenes_become_names_of_files() {
        for (scene, file) in
            [("Two spheres", "Two spheres"), ("a/b: c?", "a_b_ c_"), (" .. ", "scene"), ("Конь", "Конь")]
        {
            assert_eq!(file_name(scene), file);
        }
    }

    #[test]
    fn an_ending_is_added_where_it_lacks() {
        for (typed, path) in [("a", "a.toml"), ("a.TOML", "a.TOML"), ("a.b", "a.b.toml"), ("d/a.toml", "d/a.toml")] {
            assert_eq!(with_ending(typed.into(), "toml"), Path::new(path));
        }
    }
}
