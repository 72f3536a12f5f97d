//! What the window shows and remembers. Panels read it; `studio` alone changes it.

use crate::command::{Command, Tool, Zoom};
use crate::dialogs::Dialog;
use crate::document::Document;
use crate::explain::Explain;
use crate::figures::Figures;
use crate::files::Files;
use crate::l10n::Texts;
use crate::notices::Notices;
use crate::preferences::Preferences;
use crate::render_link::RenderLink;
use crate::selection::Part;
use crate::study::StudyDesk;
use crate::view::View;
use luch_io::SceneSource;
use luch_render::Integrator;
use luch_scene::{Camera, Scene};
use std::path::PathBuf;

/// The state of the window.
#[derive(Debug)]
pub(crate) struct State {
    pub(crate) document: Document,
    pub(crate) view: View,
    pub(crate) selection: Option<Part>,
    pub(crate) tool: Tool,
    pub(crate) zoom: Zoom,
    /// What the picture shows of what the rays meet.
    pub(crate) integrator: Integrator,
    /// The pixel that is explained, and what is looked at of its account.
    pub(crate) explain: Explain,
    pub(crate) preferences: Preferences,
    pub(crate) notices: Notices,
    pub(crate) study: StudyDesk,
    pub(crate) dialog: Option<Dialog>,
    /// What was wrong with the last input of the dialog.
    pub(crate) complaint: Option<String>,
    /// The folder that a picture was written to last.
    pub(crate) exported_to: Option<PathBuf>,
    /// Whether a person who has not read the hints of the first run is to see them.
    pub(crate) hints: bool,
    pub(crate) figures: Figures,
    /// Whether there are changes that no picture shows, because live update is off.
    pub(crate) pending: bool,
}

impl State {
    pub(crate) fn scene(&self) -> &Scene {
        self.document.scene()
    }

    /// The camera to look through; `None` only for a scene without cameras.
    pub(crate) fn camera(&self) -> Option<Camera> {
        self.view.camera(self.scene())
    }
}

/// What a panel gets: the state to read, the texts, and the list to put its commands on.
pub(crate) struct Desk<'a> {
    pub(crate) state: &'a State,
    pub(crate) texts: &'a Texts,
    pub(crate) render: &'a RenderLink,
    pub(crate) files: &'a Files,
    /// The scene that is being loaded.
    pub(crate) loading: Option<&'a SceneSource>,
    pub(crate) commands: &'a mut Vec<Command>,
}

impl Desk<'_> {
    pub(crate) fn send(&mut self, command: Command) {
        self.commands.push(command);
    }

    pub(crate) fn scene(&self) -> &Scene {
        self.state.scene()
    }
}
