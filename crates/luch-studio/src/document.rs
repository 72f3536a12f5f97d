//! The scene at hand: where it came from, how it was changed, and whether the changes are saved.

use crate::undo::{Gesture, History};
use luch_io::{Saved, SceneSource};
use luch_scene::{Edit, EditError, Scene};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

/// Names a state of a document: equal stamps, equal scenes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Stamp {
    document: u64,
    state: u64,
}

/// The scene that is edited.
#[derive(Debug)]
pub(crate) struct Document {
    id: u64,
    scene: Arc<Scene>,
    /// The scene as it was opened or saved.
    kept: Arc<Scene>,
    history: History,
    /// Where it came from; `None` for a new scene.
    pub(crate) source: Option<SceneSource>,
    saved_state: Option<u64>,
}

impl Document {
    /// A scene as it was read: nothing to undo, nothing to save.
    pub(crate) fn opened(scene: Scene, source: SceneSource) -> Self {
        Self::of(scene, Some(source), false)
    }

    /// A scene that no file holds. One that was recovered counts as changed.
    pub(crate) fn untitled(scene: Scene, source: Option<SceneSource>, changed: bool) -> Self {
        Self::of(scene, source, changed)
    }

    fn of(scene: Scene, source: Option<SceneSource>, changed: bool) -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(0);
        let (scene, history) = (Arc::new(scene), History::default());
        let saved_state = (!changed).then(|| history.state());
        let id = NEXT.fetch_add(1, Ordering::Relaxed);
        Self { id, kept: Arc::clone(&scene), scene, history, source, saved_state }
    }

    /// Names the document and its state.
    pub(crate) fn stamp(&self) -> Stamp {
        Stamp { document: self.id, state: self.history.state() }
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

    /// Whether the scene differs from what was opened or saved.
    pub(crate) fn is_changed(&self) -> bool {
        self.saved_state != Some(self.history.state())
    }

    /// Whether something would be lost that somebody might miss. Who walks through the built-in scenes and tries sizes and
    /// numbers of rays has made nothing yet.
    pub(crate) fn is_worth_asking(&self) -> bool {
        let tried_out = || matches!(self.source, Some(SceneSource::BuiltIn(_))) && self.saved_state.is_some();
        self.is_changed() && !(tried_out() && same_but_settings(&self.scene, &self.kept))
    }

    /// The scene file that "save" writes to: built-in scenes and bare models have none.
    pub(crate) fn file(&self) -> Option<&Path> {
        match &self.source {
            Some(SceneSource::File(path)) => Some(path),
            _ => None,
        }
    }

    /// Notes that a state of this or another document is in this file, with its models under the names it has there.
    pub(crate) fn saved(&mut self, stamp: Stamp, scene: &Arc<Scene>, path: &Path, saved: &Saved) {
        if stamp.document != self.id {
            return;
        }
        self.history.end_gesture();
        self.saved_state = Some(stamp.state);
        self.source = Some(SceneSource::File(path.to_owned()));
        self.kept = Arc::clone(scene);
        if !saved.renamed.is_empty() {
            saved.rename(Arc::make_mut(&mut self.kept));
            saved.rename(Arc::make_mut(&mut self.scene));
        }
    }
}

/// Whether two scenes differ at most in how their pictures are made.
fn same_but_settings(a: &Scene, b: &Scene) -> bool {
    let shell = |scene: &Scene| (scene.name.clone(), scene.background, scene.ambient, scene.attenuation);
    shell(a) == shell(b) && a.lights == b.lights && a.cameras == b.cameras && a.objects == b.objects
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::{ImageSize, NonNegative, SceneEdit, SettingsEdit};

    fn resize() -> Edit {
        Edit::Settings(SettingsEdit::SetSize(ImageSize::new(8, 8).unwrap()))
    }

    fn dim() -> Edit {
        Edit::Scene(SceneEdit::SetAmbient(NonNegative::clamped(0.01)))
    }

    #[test]
    fn a_size_tried_on_a_built_in_scene_is_not_worth_a_question() {
        let sources = [SceneSource::BuiltIn("chess"), SceneSource::File("a.toml".into())];
        for (source, size_matters) in sources.into_iter().zip([false, true]) {
            let mut document = Document::opened(Scene::new("s"), source);
            assert!(!document.is_worth_asking());
            document.apply(resize(), Gesture::Single).unwrap();
            assert_eq!((document.is_changed(), document.is_worth_asking()), (true, size_matters));
            document.apply(dim(), Gesture::Single).unwrap();
            assert!(document.is_worth_asking());
            document.undo().unwrap();
            document.undo().unwrap();
            assert!(!document.is_changed());
        }
    }

    #[test]
    fn what_changed_while_it_was_written_is_still_unsaved() {
        let mut document = Document::opened(Scene::new("s"), SceneSource::BuiltIn("chess"));
        document.apply(dim(), Gesture::Single).unwrap();
        let (stamp, scene) = (document.stamp(), Arc::clone(document.scene()));
        document.apply(resize(), Gesture::Single).unwrap();
        document.saved(stamp, &scene, Path::new("a.toml"), &Saved::default());
        assert!(document.is_changed());
        assert_eq!(document.file(), Some(Path::new("a.toml")));
        document.undo().unwrap();
        assert!(!document.is_changed());
        // Another document has been opened meanwhile: it is not what was saved.
        let mut other = Document::untitled(Scene::new("t"), None, true);
        other.saved(stamp, &scene, Path::new("a.toml"), &Saved::default());
        assert!(other.is_changed() && other.file().is_none());
    }
}
