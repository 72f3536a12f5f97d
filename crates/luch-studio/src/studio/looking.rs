//! The commands that change from where and how sharply the scene is seen.

use super::Studio;
use crate::notices::Severity;
use crate::undo::Gesture;
use crate::view::{Pose, View};
use luch_scene::{CameraEdit, Edit, Positive};

impl Studio {
    pub(super) fn choose_camera(&mut self, index: usize) {
        self.state.view = View { index, pose: None };
        self.state.view.stay_within(self.state.document.scene());
        self.changed();
    }

    pub(super) fn set_pose(&mut self, pose: Option<Pose>) {
        self.state.view.pose = pose;
        self.changed();
    }

    pub(super) fn frame(&mut self) {
        if let Some(pose) = self.state.view.framing(self.state.scene(), self.state.selection) {
            self.set_pose(Some(pose));
        }
    }

    pub(super) fn store_pose(&mut self) {
        if let Some(edit) = self.state.view.store() {
            self.edit(edit, Gesture::Single);
            self.state.view.pose = None;
        }
    }

    /// Makes what lies at a distance sharp, and says so if nothing is blurred by that: no other setting is changed.
    pub(super) fn focus_at(&mut self, distance: Option<Positive>) {
        let Some(distance) = distance else {
            self.state.notices.add(Severity::Done, self.texts.notice_nothing_to_focus(), "");
            return;
        };
        let index = self.state.view.index;
        self.edit(Edit::Camera(index, CameraEdit::SetFocalDistance(Some(distance))), Gesture::Single);
        let scene = self.state.document.scene();
        let closed = scene.cameras.get(index).is_some_and(|camera| camera.lens_radius.get() == 0.0);
        let missing = [
            (!scene.settings.depth_of_field.on).then(|| self.texts.notice_focus_without_depth_of_field()),
            closed.then(|| self.texts.notice_focus_with_closed_lens()),
        ];
        let missing: Vec<_> = missing.into_iter().flatten().collect();
        if !missing.is_empty() {
            self.state.notices.add(Severity::Done, self.texts.notice_focus_is_set(), missing.join("\n"));
        }
    }
}
