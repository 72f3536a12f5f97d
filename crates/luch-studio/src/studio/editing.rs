//! Changes of the scene, and what must follow them.

use super::Studio;
use crate::document::Document;
use crate::selection::{Anchor, Part};
use crate::told;
use crate::undo::Gesture;
use luch_scene::{Edit, EditError};

impl Studio {
    pub(super) fn edit(&mut self, edit: Edit, gesture: Gesture) {
        let added = Part::added_by(&edit);
        self.change_scene(|document| document.apply(edit, gesture).map(|()| true));
        if let Some(part) = added.filter(|part| part.exists(self.state.scene())) {
            self.state.selection = Some(part);
        }
    }

    pub(super) fn edit_selected(&mut self, edit: impl FnOnce(Part) -> Edit) {
        if let Some(part) = self.state.selection {
            self.edit(edit(part), Gesture::Single);
        }
    }

    pub(super) fn turn(&mut self, turn: fn(&mut Document) -> Result<bool, EditError>) {
        self.change_scene(turn);
    }

    /// Changes the scene and keeps selection and view on what they were on.
    pub(super) fn change_scene(&mut self, change: impl FnOnce(&mut Document) -> Result<bool, EditError>) {
        let before = self.state.document.scene();
        let anchor = self.state.selection.and_then(|part| Anchor::of(part, before));
        let camera = self.state.view.anchor(before);
        match change(&mut self.state.document) {
            Ok(false) => {}
            Ok(true) => {
                let scene = self.state.document.scene();
                self.state.selection = anchor.and_then(|anchor| anchor.find(scene));
                self.state.view.follow(&camera, scene);
                self.changed();
            }
            Err(error) => {
                let why = told::edit_error(&error, &self.texts);
                self.state.notices.error(self.texts.notice_edit_refused(), why);
            }
        }
    }
}
