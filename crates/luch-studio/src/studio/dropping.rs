//! Files that are dropped on the window.

use super::Studio;
use crate::command::Command;
use crate::files::shown;
use crate::notices::Severity;
use egui::Context;
use luch_io::SceneSource;
use std::path::PathBuf;

impl Studio {
    /// Opens a scene, adds models (or opens one `alone`), and tells what is neither.
    pub(super) fn take_dropped(&mut self, paths: Vec<PathBuf>, alone: bool, ctx: &Context) {
        let (mut scenes, mut models, mut others) = (Vec::new(), Vec::new(), Vec::new());
        for path in paths {
            match SceneSource::of_path(&path) {
                Some(SceneSource::File(_)) => scenes.push(path),
                Some(_) => models.push(path),
                None => others.push(path),
            }
        }
        if !scenes.is_empty() {
            // There is one scene at a time; models that came with it are most likely its own.
            let first = scenes.remove(0);
            others.append(&mut scenes);
            others.append(&mut models);
            self.unless_unsaved(Command::Open(SceneSource::File(first)), ctx);
        } else if alone && !models.is_empty() {
            let first = models.remove(0);
            others.append(&mut models);
            self.unless_unsaved(Command::Open(SceneSource::Model(first)), ctx);
        } else if !models.is_empty() {
            self.add_models(models, ctx);
        }
        if !others.is_empty() {
            let names: Vec<String> = others.iter().map(|path| shown(path.as_os_str())).collect();
            self.state.notices.add(Severity::Warning, self.texts.notice_not_opened(), names.join("\n"));
        }
    }
}
