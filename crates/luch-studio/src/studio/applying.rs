//! What each command does.

use super::Studio;
use crate::command::Command;
use crate::dialogs::Dialog;
use crate::document::Document;
use crate::files::Purpose;
use crate::selection::Part;
use crate::study::StudyCommand;
use egui::Context;

impl Studio {
    /// The one place where the window's state changes.
    pub(super) fn apply(&mut self, command: Command, ctx: &Context) {
        match command {
            Command::New | Command::Open(_) | Command::OpenDialog | Command::Recover(_) | Command::Quit => {
                self.unless_unsaved(command, ctx);
            }
            Command::Drop { paths, alone } => self.take_dropped(paths, alone, ctx),
            Command::ExportDialog => self.open_dialog(Dialog::Export, ctx),
            Command::Export(form) => self.export(*form, ctx),
            Command::CancelExport => {
                if let Some(export) = &self.files.export {
                    export.cancel();
                }
            }
            Command::QuitWithoutExport => {
                self.close_dialog(ctx);
                self.leave(ctx);
            }
            Command::DiscardRecovered(index) => self.discard_recovered(index, ctx),
            Command::RemoveCamera(index) => self.remove_camera(index),
            Command::Discard(command) => {
                self.close_dialog(ctx);
                self.replace_scene(*command, ctx);
            }
            Command::OpenPath(path) => self.load_path(ctx, path),
            Command::Save => self.save(None, ctx),
            Command::SaveAs => self.open_dialog(Dialog::Path { purpose: Purpose::Save, then: None }, ctx),
            Command::SaveTo { path, replace, then } => self.save_to(path, replace, then, ctx),
            Command::SaveThen(command) => {
                self.close_dialog(ctx);
                self.save(Some(command), ctx);
            }
            Command::Add(what) => self.add(what),
            Command::AddModelDialog => {
                self.open_dialog(Dialog::Path { purpose: Purpose::AddModel, then: None }, ctx);
            }
            Command::AddModels(paths) => self.add_models(paths, ctx),
            Command::AddCamera => self.add_camera(),
            Command::ListFolder(folder, purpose) => {
                let started = self.files.list(folder, purpose, ctx);
                self.tell_internal(started);
            }
            Command::Browse(question) => {
                let started = self.files.choose(question, ctx);
                self.tell_internal(started);
            }
            Command::ForgetChosen => self.files.forget_chosen(),
            Command::ForgetComplaint => self.state.complaint = None,
            Command::Edit(edit, gesture) => self.edit(edit, gesture),
            Command::TakeBack(gesture) => self.change_scene(|document| document.take_back(gesture)),
            Command::Undo => self.turn(Document::undo),
            Command::Redo => self.turn(Document::redo),
            Command::Select(part) => self.state.selection = part.filter(|part| part.exists(self.state.scene())),
            Command::Duplicate => self.edit_selected(Part::duplicate),
            Command::Delete => self.edit_selected(Part::remove),
            Command::ToggleHidden => {
                let scene = self.state.document.scene().clone();
                self.edit_selected(|part| part.set_hidden(!part.is_hidden(&scene)));
            }
            Command::ChooseCamera(index) => self.choose_camera(index),
            Command::SetPose(pose) => self.set_pose(pose),
            Command::Frame => self.frame(),
            Command::StorePose => self.store_pose(),
            Command::FocusAt(distance) => self.focus_at(distance),
            Command::Render => self.show_anew(),
            Command::Cancel => {
                self.loader.stop();
                self.files.stop_adding();
                self.render.stop();
            }
            Command::SetLive(live) => {
                self.state.preferences.live = live;
                if live && self.state.pending {
                    self.show_anew();
                }
            }
            Command::SetThreads(threads) => {
                self.state.preferences.threads = threads;
                self.changed();
            }
            Command::SetLanguage(language) => {
                self.state.preferences.language = language;
                self.texts = language.load();
            }
            Command::SetTheme(theme) => {
                self.state.preferences.theme = theme;
                ctx.set_theme(theme);
            }
            Command::SetTool(tool) => self.state.tool = tool,
            Command::SetZoom(zoom) => self.state.zoom = zoom,
            Command::SetIntegrator(integrator) => {
                self.state.integrator = integrator;
                self.changed();
            }
            Command::Explain(command) => self.apply_explain(command, ctx),
            Command::AfterTyping(command) => self.after_typing(*command, ctx),
            Command::Show(dialog) => {
                self.state.dialog = Some(dialog);
                self.state.complaint = None;
            }
            Command::CloseDialog => self.leave_dialog(ctx),
            Command::HintsRead => self.state.preferences.hints_read = true,
            Command::DismissNotice(id) => self.state.notices.dismiss(id),
            Command::Study(command) => self.study(command, ctx),
        }
    }

    /// Tells that the system gave no thread.
    pub(super) fn tell_internal(&mut self, started: std::io::Result<()>) {
        if let Err(error) = started {
            self.state.notices.error(self.texts.notice_internal(), error.to_string());
        }
    }

    fn study(&mut self, command: StudyCommand, ctx: &Context) {
        let wake = ctx.clone();
        let wake = move || wake.request_repaint();
        let begun = match command {
            StudyCommand::Open(open) => {
                self.state.study.open = open;
                Ok(())
            }
            StudyCommand::Start(plan) => self.state.study.start(*plan, wake),
            StudyCommand::Cancel => {
                self.state.study.cancel();
                Ok(())
            }
            StudyCommand::Save(folder) => self.state.study.save(folder, self.state.preferences.language, wake),
        };
        self.tell_internal(begun);
    }
}
