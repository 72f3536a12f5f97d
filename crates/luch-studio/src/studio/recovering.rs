//! Keeps the scene safe, and brings back what an earlier program left when it died.

use super::{Studio, scenes};
use crate::dialogs::Dialog;
use crate::document::Document;
use crate::files::Recovered;
use crate::notices::Severity;
use egui::Context;

impl Studio {
    /// Takes in what was kept, found and read back.
    pub(super) fn take_recovery(&mut self, ctx: &Context) {
        if let Some(error) = self.files.recovery.poll() {
            self.state.notices.error(self.texts.notice_not_kept(), error);
        }
        let undecided = !self.files.recovery.found().is_empty() && !self.files.recovery.is_recovering();
        if undecided && self.state.dialog.is_none() {
            self.state.dialog = Some(Dialog::Recover);
        }
        if let Some(recovered) = self.files.recovery.recovered() {
            self.take_recovered(recovered, ctx);
        }
    }

    fn take_recovered(&mut self, recovered: Result<Recovered, String>, ctx: &Context) {
        let Recovered { from, scene, warnings } = match recovered {
            Ok(recovered) => recovered,
            Err(message) => return self.state.notices.error(self.texts.notice_internal(), message),
        };
        match scene {
            Ok(mut scene) => {
                if scene.cameras.is_empty() {
                    scene.cameras.push(scenes::default_camera(&scene, &self.texts));
                }
                let source = from.source().cloned();
                self.close_dialog(ctx);
                self.replace(Document::untitled(scene, source, true), ctx);
                self.files.recovery.adopt(from);
                if !warnings.is_empty() {
                    let title = self.texts.notice_loaded_with_warnings();
                    self.state.notices.add(Severity::Warning, title, warnings.join("\n"));
                }
            }
            // It stays where it is: the file that it needs may come back.
            Err(error) => self.state.complaint = Some(crate::notices::drawable(&self.file_error(error))),
        }
    }

    /// Removes one of the scenes that were found, and closes the dialog when it was the last.
    pub(super) fn discard_recovered(&mut self, index: usize, ctx: &Context) {
        self.files.recovery.discard(index);
        self.state.complaint = None;
        if self.files.recovery.found().is_empty() {
            self.close_dialog(ctx);
        }
    }

    /// Keeps the scene safe when that is due.
    pub(super) fn keep_safe(&mut self, ctx: &Context) {
        let started = self.files.recovery.watch(&self.state.document, ctx);
        self.tell_internal(started);
    }
}

impl Drop for Studio {
    fn drop(&mut self) {
        if std::thread::panicking() {
            self.files.recovery.rescue(&self.state.document);
        } else {
            self.files.recovery.end();
        }
    }
}
