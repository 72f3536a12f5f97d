//! The scene at hand: where it came from, how it was changed, and whether the changes are saved.

use crate::undo::{Gesture, History};
use luch_io::SceneSource;
use luch_scene::{Edit, EditError, Scene};
use std::path::Path;
use std::sync::Arc;

/// The scene that is edited.
#[derive(Debug)]
pub(crate) struct Document {
    scene: Arc<Scene>,
    history: History,
    /// Where it came from; `None` for a new scene.
    pub(crate) source: Option<SceneSource>,
    saved_state: Option<u64>,
}

impl Document {
    /// A scene as it was read: nothing to undo, nothing to save.
    pub(crate) fn opened(scene: Scene, source: SceneSource) -> Self {
        let history = History::default();
        let saved_state = Some(history.state());
        Self { scene: Arc::new(scene), history, source: Some(source), saved_state }
    }

    /// A scene that no file holds. One that was recovered counts as changed.
    pub(crate) fn untitled(scene: Scene, source: Option<SceneSource>, changed: bool) -> Self {
        let history = History::default();
        let saved_state = (!changed).then(|| history.state());
        Self { scene: Arc::new(scene), history, source, saved_state }
    }

    /// The scene as it is now.
    pub(crate) const fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// Changes the scene.
    ///
    /// # Errors
    /// What the edit answers; the scene is then as it was.
    pub(crate) fn apply(&mut self, edit: Edit, gesture: Gesture) -> Result<(), EditError> {
        self.history.apply(edit, gesture, Arc::make_mut(&mut self.scene))
    }

    /// Takes back the gesture of that name, if it is going on.
    pub(crate) fn take_back(&mut self, gesture: egui::Id) -> Result<bool, EditError> {
        self.history.take_back(gesture, Arc::make_mut(&mut self.scene))
    }

    pub(crate) fn undo(&mut self) -> Result<bool, EditError> {
        self.history.undo(Arc::make_mut(&mut self.scene))
    }

    pub(crate) fn redo(&mut self) -> Result<bool, EditError> {
        self.history.redo(Arc::make_mut(&mut self.scene))
    }

    pub(crate) fn end_gesture(&mut self) {
        self.history.end_gesture();
    }

    pub(crate) fn can_undo(&self) -> bool {
        self.history.can_undo()
    }

    pub(crate) fn can_redo(&self) -> bool {
        self.history.can_redo()
    }

    /// Whether something would be lost without saving.
    pub(crate) fn is_changed(&self) -> bool {
        self.saved_state != Some(self.history.state())
    }

    /// The scene file that "save" writes to: built-in scenes and bare models have none.
    pub(crate) fn file(&self) -> Option<&Path> {
        match &self.source {
            Some(SceneSource::File(path)) => Some(path),
            _ => None,
        }
    }

    /// Notes that the scene as it is now is in this file.
    pub(crate) fn saved(&mut self, path: &Path) {
        self.history.end_gesture();
        self.saved_state = Some(self.history.state());
        self.source = Some(SceneSource::File(path.to_owned()));
    }
}
