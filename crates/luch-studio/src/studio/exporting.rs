//! Pictures for files, and what was made of them.

use super::Studio;
use crate::command::Command;
use crate::dialogs::Dialog;
use crate::files::{Export, ExportEnd, ExportForm, Purpose, shown};
use crate::notices::Severity;
use crate::render_link;
use egui::Context;
use luch_render::RenderJob;
use std::path::Path;
use std::sync::Arc;

impl Studio {
    /// Starts to make the picture of what is seen now.
    pub(super) fn export(&mut self, form: ExportForm, ctx: &Context) {
        self.state.complaint = None;
        let Some(camera) = self.state.camera().filter(|_| self.files.export.is_none()) else { return };
        let scene = Arc::clone(self.state.document.scene());
        let threads = self.state.preferences.threads_in_use();
        let job = render_link::job(&scene, camera, self.state.integrator, threads);
        let job =
            RenderJob { size: form.size, antialiasing: form.antialiasing, depth_of_field: form.depth_of_field, ..job };
        self.state.exported_to = form.path.parent().map(Path::to_owned);
        match Export::start(scene, job, form, ctx) {
            Ok(export) => self.files.export = Some(export),
            Err(error) => self.tell_internal(Err(error)),
        }
    }

    /// Takes in what became of the picture.
    pub(super) fn take_export(&mut self, ctx: &Context) {
        let Some(export) = &mut self.files.export else { return };
        let dismissed = export.dismissed;
        // As soon as there is something to watch, the dialog is done; later ones are about something else.
        export.dismissed |= export.share().is_some();
        let done = export.dismissed;
        let asks = self.asks_for(Purpose::Export) && !dismissed;
        if asks && done {
            self.close_dialog(ctx);
        }
        let asks = asks && !done;
        let Some(export) = self.files.export.take_if(|export| export.is_done()) else { return };
        let form = export.form().clone();
        let path = shown(form.path.as_os_str());
        let (title, text) = match export.into_end() {
            ExportEnd::Written => {
                return self.state.notices.add(Severity::Done, self.texts.notice_exported(), path);
            }
            ExportEnd::Cancelled => {
                return self.state.notices.add(Severity::Done, self.texts.notice_export_cancelled(), path);
            }
            ExportEnd::Exists if !asks => return,
            ExportEnd::Exists => {
                let purpose = Purpose::Export;
                let replace = Command::Export(Box::new(ExportForm { replace: true, ..form.clone() }));
                let back = Command::Show(Dialog::Export);
                let (replace, back) = (Box::new(replace), Box::new(back));
                self.state.dialog = Some(Dialog::Replace { purpose, path: form.path, replace, back });
                return;
            }
            ExportEnd::Failed(error) => (self.texts.notice_not_exported(), self.file_error(error)),
            ExportEnd::Internal(message) => (self.texts.notice_internal(), message),
        };
        if asks {
            self.state.dialog = Some(Dialog::Export);
            self.complain(Purpose::Export, title, text);
        } else {
            self.state.notices.error(title, text);
        }
    }
}
