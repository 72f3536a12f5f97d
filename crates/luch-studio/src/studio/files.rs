//! What the studio does with files: opens and saves scenes, asks before anything is lost.

use super::{Studio, scenes};
use crate::command::Command;
use crate::dialogs::{self, Dialog};
use crate::document::Document;
use crate::files::{Purpose, SaveEnd, SaveOrder};
use crate::loader::{LoadFailure, Loaded};
use crate::notices::{Severity, drawable};
use crate::panels::scene_name;
use crate::told;
use egui::{Context, ViewportCommand};
use luch_io::SceneSource;
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl Studio {
    /// Does what would lose unsaved changes, or asks first.
    pub(super) fn unless_unsaved(&mut self, command: Command, ctx: &Context) {
        // What is being written is no more unsaved in a moment, or it is told why not.
        if self.files.is_saving() {
            self.files.after_saving(Some(command));
        } else if self.state.document.is_worth_asking() {
            self.open_dialog(Dialog::Unsaved(Box::new(command)), ctx);
        } else {
            self.replace_scene(command, ctx);
        }
    }

    /// Does what puts another scene in place of the one at hand, saved or not.
    pub(super) fn replace_scene(&mut self, command: Command, ctx: &Context) {
        match command {
            Command::New => {
                self.loader.stop();
                self.replace(Document::untitled(scenes::new(&self.texts), None, false), ctx);
            }
            Command::Open(source) => self.load(ctx, source),
            Command::OpenDialog => self.open_dialog(Dialog::Path { purpose: Purpose::Open, then: None }, ctx),
            Command::Recover(index) => {
                self.loader.stop();
                // Nothing can be changed until the scene is there.
                self.state.dialog = Some(Dialog::Recover);
                let started = self.files.recovery.recover(index, ctx);
                self.tell_internal(started);
            }
            Command::Quit if self.files.export.is_some() => self.open_dialog(Dialog::StopExport, ctx),
            Command::Quit => self.leave(ctx),
            // Nothing else is asked about.
            _ => {}
        }
    }

    /// Answers the wish to close the window.
    pub(super) fn answer_close(&mut self, ctx: &Context) {
        if !ctx.input(|i| i.viewport().close_requested()) || self.leaving {
            return;
        }
        let goes_on = self.files.export.is_some() || self.files.is_saving();
        if self.state.document.is_worth_asking() || goes_on {
            ctx.send_viewport_cmd(ViewportCommand::CancelClose);
            self.unless_unsaved(Command::Quit, ctx);
        }
    }

    pub(super) fn open_dialog(&mut self, dialog: Dialog, ctx: &Context) {
        self.close_dialog(ctx);
        self.state.dialog = Some(dialog);
    }

    pub(super) fn close_dialog(&mut self, ctx: &Context) {
        self.state.dialog = None;
        self.state.complaint = None;
        self.files.forget();
        dialogs::forget(ctx);
    }

    /// Closes the dialog because somebody wants nothing of it: what it waits for is stopped.
    pub(super) fn leave_dialog(&mut self, ctx: &Context) {
        match &self.state.dialog {
            // What was not decided about is offered at the next start.
            Some(Dialog::Recover) => self.files.recovery.leave(),
            Some(Dialog::Path { purpose: Purpose::Open, .. }) if self.loading_for_dialog => self.loader.stop(),
            Some(Dialog::Path { purpose: Purpose::AddModel, .. }) => self.files.stop_adding_for_dialog(),
            // The file may be half written: it is finished, but nothing follows.
            Some(Dialog::Path { purpose: Purpose::Save, .. }) => _ = self.files.after_saving(None),
            Some(Dialog::Export) => {
                if let Some(export) = self.files.export.as_mut().filter(|export| !export.dismissed) {
                    export.dismissed = true;
                    export.cancel();
                }
            }
            _ => {}
        }
        self.close_dialog(ctx);
    }

    /// Closes the window, whatever goes on.
    pub(super) fn leave(&mut self, ctx: &Context) {
        self.leaving = true;
        ctx.send_viewport_cmd(ViewportCommand::Close);
    }

    /// Closes what asks about a scene that is at hand no more.
    pub(super) fn close_dialog_of_scene(&mut self, ctx: &Context) {
        let of_scene = match &self.state.dialog {
            Some(Dialog::Path { purpose, .. } | Dialog::Replace { purpose, .. }) => purpose.writes(),
            Some(Dialog::Export | Dialog::RenameCamera(_) | Dialog::Unsaved(_)) => true,
            _ => false,
        };
        if of_scene {
            self.close_dialog(ctx);
        }
    }

    /// Whether the dialog asks for a path of that purpose.
    pub(super) fn asks_for(&self, purpose: Purpose) -> bool {
        match &self.state.dialog {
            Some(Dialog::Path { purpose: asked, .. } | Dialog::Replace { purpose: asked, .. }) => *asked == purpose,
            Some(Dialog::Export) => purpose == Purpose::Export,
            _ => false,
        }
    }

    pub(super) fn load(&mut self, ctx: &Context, source: SceneSource) {
        self.loading_for_dialog = self.asks_for(Purpose::Open);
        let (wake, over) = (ctx.clone(), self.state.document.stamp());
        let started = self.loader.start(source, over, move || wake.request_repaint());
        self.tell_internal(started);
    }

    /// Loads what a dialog asked for. What is neither scene nor model is told by the reader.
    pub(super) fn load_path(&mut self, ctx: &Context, path: PathBuf) {
        self.state.complaint = None;
        let source = SceneSource::of_path(&path).unwrap_or(SceneSource::File(path));
        self.load(ctx, source);
    }

    pub(super) fn take_scene(&mut self, loaded: Loaded, ctx: &Context) {
        let Loaded { source, scene, warnings, over, missing } = loaded;
        match scene {
            // Somebody went on working while a large file was read.
            Ok(_) if over != self.state.document.stamp() && self.state.document.is_worth_asking() => {
                self.unless_unsaved(Command::Open(source), ctx);
            }
            Ok(mut scene) => {
                if scene.cameras.is_empty() {
                    scene.cameras.push(scenes::default_camera(&scene, &self.texts));
                }
                if let Some(path) = source.path() {
                    self.state.preferences.remember(path);
                }
                if self.asks_for(Purpose::Open) {
                    self.close_dialog(ctx);
                }
                self.replace(Document::opened(scene, source), ctx);
                if !warnings.is_empty() {
                    let title = self.texts.notice_loaded_with_warnings();
                    self.state.notices.add(Severity::Warning, title, warnings.join("\n"));
                }
            }
            Err(failure) => {
                if let Some(path) = source.path().filter(|_| missing) {
                    self.state.preferences.forget(path);
                }
                let (title, text) = match failure {
                    LoadFailure::File(error) => (self.texts.notice_not_loaded(), self.file_error(error)),
                    LoadFailure::Internal(message) => (self.texts.notice_internal(), message),
                };
                self.complain(Purpose::Open, title, text);
            }
        }
    }

    /// An error of a file, as the window tells it.
    pub(super) fn file_error(&self, error: luch_io::Error) -> String {
        told::file_error(error, self.state.preferences.language, &self.texts)
    }

    /// Says what went wrong: in the dialog that led to it, or as a notice.
    pub(super) fn complain(&mut self, purpose: Purpose, title: String, text: String) {
        if self.asks_for(purpose) {
            self.state.complaint = Some(drawable(&text));
        } else {
            self.state.notices.error(title, text);
        }
    }

    /// Writes the scene to its file, or asks for one; then does what is to follow.
    pub(super) fn save(&mut self, then: Option<Box<Command>>, ctx: &Context) {
        match self.state.document.file().map(Path::to_owned) {
            Some(path) => self.save_to(path, true, then, ctx),
            None => self.open_dialog(Dialog::Path { purpose: Purpose::Save, then }, ctx),
        }
    }

    pub(super) fn save_to(&mut self, path: PathBuf, replace: bool, then: Option<Box<Command>>, ctx: &Context) {
        self.state.complaint = None;
        let document = &self.state.document;
        // One's own file is what "save" means.
        let replace = replace || document.file() == Some(&path);
        let order = SaveOrder { scene: Arc::clone(document.scene()), stamp: document.stamp(), path, replace, then };
        let started = self.files.save(order, ctx);
        self.tell_internal(started);
    }

    fn take_saved(&mut self, order: SaveOrder, end: SaveEnd, ctx: &Context) {
        let SaveOrder { scene, stamp, path, then, .. } = order;
        let (title, text) = match end {
            SaveEnd::Written(saved) => {
                if self.asks_for(Purpose::Save) {
                    self.close_dialog(ctx);
                }
                self.state.document.saved(stamp, &scene, &path, &saved);
                self.state.preferences.remember(&path);
                let lines = std::iter::once(path.display().to_string());
                let lines: Vec<_> = lines.chain(saved.copied.iter().map(|file| file.display().to_string())).collect();
                self.state.notices.add(Severity::Done, self.texts.notice_saved(), lines.join("\n"));
                if let Some(then) = then {
                    self.unless_unsaved(*then, ctx);
                }
                return;
            }
            // Who has closed the dialog does not want it any more.
            SaveEnd::Exists if !self.asks_for(Purpose::Save) => return,
            SaveEnd::Exists => {
                let purpose = Purpose::Save;
                let replace = Command::SaveTo { path: path.clone(), replace: true, then: then.clone() };
                let back = Command::Show(Dialog::Path { purpose, then });
                // What was typed stays: another name may differ in a letter.
                let (replace, back) = (Box::new(replace), Box::new(back));
                self.state.dialog = Some(Dialog::Replace { purpose, path, replace, back });
                return;
            }
            SaveEnd::Failed(error) => (self.texts.notice_not_saved(), self.file_error(error)),
            SaveEnd::Internal(message) => (self.texts.notice_internal(), message),
        };
        if self.asks_for(Purpose::Save) {
            self.state.dialog = Some(Dialog::Path { purpose: Purpose::Save, then });
        }
        self.complain(Purpose::Save, title, text);
    }

    /// Takes in what the threads for files have done.
    pub(super) fn take_files(&mut self, ctx: &Context) {
        self.files.poll();
        if let Some(loaded) = self.loader.poll() {
            self.take_scene(loaded, ctx);
        }
        if let Some((order, end)) = self.files.saved() {
            self.take_saved(order, end, ctx);
        }
        if let Some(added) = self.files.added() {
            self.take_added(added, ctx);
        }
        self.take_export(ctx);
        self.take_recovery(ctx);
    }

    /// Tells the window's frame what is selected in which scene.
    pub(super) fn show_title(&mut self, ctx: &Context) {
        let document = &self.state.document;
        let file = document.file().and_then(Path::file_name).map(|name| drawable(&name.to_string_lossy()));
        let name = file.unwrap_or_else(|| scene_name(document, &self.texts));
        let selected = self.state.selection.and_then(|part| part.name(document.scene()));
        let name = selected.map_or(name.clone(), |selected| format!("{} — {name}", drawable(selected)));
        let changed = document.is_changed();
        let title = if changed { self.texts.window_title_changed(name) } else { self.texts.window_title(name) };
        if self.title != title {
            ctx.send_viewport_cmd(ViewportCommand::Title(title.clone()));
            self.title = title;
        }
    }
}
