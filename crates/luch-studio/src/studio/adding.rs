//! Puts new things into the scene: shapes, lights, models, cameras.

use super::Studio;
use crate::files::{Added, Purpose};
use crate::notices::Severity;
use crate::placement::{Addition, Spot};
use crate::undo::Gesture;
use egui::Context;
use luch_scene::{Aim, Camera, Direction, Edit};
use std::path::PathBuf;
use std::sync::Arc;

impl Studio {
    /// Puts a shape or a light before the camera.
    pub(super) fn add(&mut self, what: Addition) {
        let scene = Arc::clone(self.state.document.scene());
        let Some(camera) = self.state.camera() else { return };
        let picture = self.render.picture().map(|(snapshot, _)| Arc::clone(snapshot));
        let edit = Spot::of(&scene, &camera, picture.as_deref()).add(what, &scene, &self.texts);
        self.edit(edit, Gesture::Single);
    }

    /// Starts to read models that are to be put into the scene.
    pub(super) fn add_models(&mut self, paths: Vec<PathBuf>, ctx: &Context) {
        self.state.complaint = None;
        let started = self.files.add(paths, self.asks_for(Purpose::AddModel), ctx);
        self.tell_internal(started);
    }

    pub(super) fn take_added(&mut self, added: Result<Added, String>, ctx: &Context) {
        let Added { models, errors, warnings } = match added {
            Ok(added) => added,
            Err(message) => return self.complain(Purpose::AddModel, self.texts.notice_internal(), message),
        };
        if !errors.is_empty() {
            let text = errors.into_iter().map(|error| self.file_error(error)).collect::<Vec<_>>().join("\n");
            self.complain(Purpose::AddModel, self.texts.notice_model_not_added(), text);
        } else if self.asks_for(Purpose::AddModel) {
            self.close_dialog(ctx);
        }
        if !warnings.is_empty() {
            let title = self.texts.notice_loaded_with_warnings();
            self.state.notices.add(Severity::Warning, title, warnings.join("\n"));
        }
        for model in models {
            let scene = Arc::clone(self.state.document.scene());
            let Some(camera) = self.state.camera() else { return };
            let picture = self.render.picture().map(|(snapshot, _)| Arc::clone(snapshot));
            let edit = Spot::of(&scene, &camera, picture.as_deref()).add_model(model, &scene);
            self.edit(edit, Gesture::Single);
        }
    }

    /// Takes a camera out of the scene and looks through the one that takes its place.
    pub(super) fn remove_camera(&mut self, index: usize) {
        let count = self.state.scene().cameras.len();
        self.edit(Edit::RemoveCamera(index), Gesture::Single);
        if self.state.scene().cameras.len() < count {
            self.choose_camera(index);
        }
    }

    /// Makes a camera of the scene of what is seen now, and looks through it.
    pub(super) fn add_camera(&mut self) {
        let scene = Arc::clone(self.state.document.scene());
        let Some(seen) = self.state.camera() else { return };
        let base = self.texts.new_camera_name((scene.cameras.len() + 1).to_string());
        let camera = Camera { name: scene.free_camera_name(&base), ..seen };
        // Looking at its own place is no direction to keep.
        let aim = match camera.aim {
            Aim::At(point) if point == camera.position => {
                Direction::new(camera.direction()).map_or(camera.aim, Aim::Along)
            }
            aim => aim,
        };
        let last = scene.cameras.len();
        self.edit(Edit::AddCamera(last, Camera { aim, ..camera }), Gesture::Single);
        if self.state.scene().cameras.len() > last {
            self.choose_camera(last);
        }
    }
}
