//! The studio: takes in what happened, shows the panels, applies the commands that they queued.

mod adding;
mod applying;
mod dropping;
mod editing;
mod explaining;
mod exporting;
mod files;
mod looking;
mod recovering;
mod scenes;
mod typing;

pub(crate) use explaining::PATIENCE;

use crate::command::Command;
use crate::dialogs;
use crate::document::Document;
use crate::explain::{Copier, Explain, Explainer};
use crate::figures::Figures;
use crate::files::{ChooseFile, Files, Recovery};
use crate::l10n::{self, Texts};
use crate::loader::Loader;
use crate::milestone::{Milestone, Milestones};
use crate::notices::{Notices, Severity};
use crate::panels;
use crate::preferences::Preferences;
use crate::render_link::RenderLink;
use crate::shortcuts;
use crate::state::{Desk, State};
use crate::study::{self, Outcome, StudyDesk};
use crate::view::View;
use crate::viewport;
use egui::{Context, Ui};
use luch_io::SceneSource;
use luch_render::session::live::{LivePhase, LiveSession};
use luch_scene::{Camera, Scene};
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// How often progress is drawn while a picture is made.
const PROGRESS_EVERY: Duration = Duration::from_millis(100);

/// How long the first picture waits for the scene that the window was opened with.
const FIRST_WAITS: Duration = Duration::from_millis(300);

/// How a studio starts.
#[derive(Debug, Clone, Default)]
pub struct Start {
    /// What to show; `None`: the first built-in scene.
    pub scene: Option<SceneSource>,
    /// The tag of the language to speak, `en` or `ru`; `None`: the one used last, or the system's.
    pub language: Option<String>,
    /// Whether to greet who opens the window for the first time.
    pub hints: bool,
    /// Asks for a file in place of the system's dialog.
    pub choose_file: Option<ChooseFile>,
    /// The folder to keep changed scenes safe in; `None`: they are not kept.
    pub data_dir: Option<PathBuf>,
    /// How long a change may wait until it is safe; `None`: 20 seconds.
    pub keep_every: Option<Duration>,
    /// Whether to show the same times and figures of the machine every time: for pictures of the window.
    pub still: bool,
    /// Is told when the window and its first pictures are there.
    pub milestone: Option<fn(Milestone)>,
}

/// The window's application.
pub struct Studio {
    state: State,
    texts: Texts,
    render: RenderLink,
    loader: Loader,
    explainer: Explainer,
    copier: Copier,
    files: Files,
    /// Whether a dialog waits for the scene that is being loaded.
    loading_for_dialog: bool,
    commands: Vec<Command>,
    /// What waits for a field that was just left to tell what was typed.
    later: Vec<Command>,
    /// Whether what is seen differs from what was asked for last.
    stale: bool,
    /// Since when the first picture waits.
    waits: Option<Instant>,
    /// Whether the window is to be closed, whatever is unsaved.
    leaving: bool,
    /// What the window's frame says.
    title: String,
    milestones: Milestones,
}

impl Studio {
    /// A studio with its first scene.
    ///
    /// # Errors
    /// If the system gives no thread to render on.
    pub fn new(creation: &eframe::CreationContext<'_>, start: Start) -> std::io::Result<Self> {
        let mut preferences = Preferences::load(creation.storage);
        if let Some(language) = start.language.as_deref().and_then(l10n::of_tag) {
            preferences.language = language;
        }
        let figures = if start.still { Figures::Still } else { Figures::Measured };
        if start.still {
            preferences.threads = Some(Figures::STILL_CORES);
        }
        creation.egui_ctx.set_theme(preferences.theme);
        crate::style::apply(&creation.egui_ctx);
        let first = scenes::first();
        let state = State {
            document: Document::opened(first, SceneSource::BuiltIn(scenes::FIRST)),
            view: View::default(),
            selection: None,
            tool: crate::command::Tool::default(),
            zoom: crate::command::Zoom::default(),
            integrator: luch_render::Integrator::default(),
            explain: Explain::default(),
            notices: Notices::default(),
            dialog: None,
            complaint: None,
            exported_to: None,
            hints: start.hints,
            figures,
            pending: false,
            study: StudyDesk::default(),
            preferences,
        };
        let texts = state.preferences.language.load();
        let render = RenderLink::start(&creation.egui_ctx)?;
        let loader = Loader::new();
        let recovery = Recovery::new(start.data_dir, start.keep_every, loader.library(), &creation.egui_ctx);
        let files = Files::new(loader.library(), start.choose_file, recovery);
        let mut studio = Self {
            state,
            texts,
            render,
            loader,
            files,
            loading_for_dialog: false,
            explainer: Explainer::default(),
            copier: Copier::default(),
            commands: Vec::new(),
            later: Vec::new(),
            stale: true,
            waits: None,
            leaving: false,
            title: String::new(),
            milestones: Milestones::new(start.milestone),
        };
        if let Some(source) = start.scene.filter(|source| *source != SceneSource::BuiltIn(scenes::FIRST)) {
            studio.load(&creation.egui_ctx, source);
        }
        Ok(studio)
    }

    /// Whether nothing is under way: no load, no picture, no study, no command.
    #[must_use]
    pub fn is_settled(&self) -> bool {
        let idle = self.loader.source().is_none() && self.files.is_idle() && !self.state.study.is_busy();
        idle && !self.explainer.is_busy()
            && !self.copier.is_busy()
            && self.commands.is_empty()
            && self.later.is_empty()
            && !self.stale
            && self.render.is_settled()
    }

    /// The picture that is shown: width, height, red, green, blue and alpha of each pixel, rows from the top.
    #[must_use]
    pub fn picture(&self) -> Option<(u32, u32, &[[u8; 4]])> {
        self.render.picture().map(|(snapshot, _)| (snapshot.width, snapshot.height, snapshot.pixels.as_slice()))
    }

    /// The scene as it is now.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        self.state.scene()
    }

    /// The camera that is looked through, where the mouse has moved it.
    #[must_use]
    pub fn camera(&self) -> Option<Camera> {
        self.state.camera()
    }

    /// The name of what is selected.
    #[must_use]
    pub fn selected(&self) -> Option<&str> {
        self.state.selection.and_then(|part| part.name(self.state.scene()))
    }

    /// How many rays the account of the pixel has that is explained.
    #[must_use]
    pub fn explained_rays(&self) -> usize {
        self.state.explain.answer.as_ref().map_or(0, |answer| answer.account.rays.len())
    }

    /// Takes in what the loader and the renderer have done since the last frame.
    fn take_in(&mut self, ctx: &Context) {
        self.take_files(ctx);
        self.render.poll(ctx);
        if let Some(message) = self.render.failure() {
            let is_too_large = self.state.scene().settings.size.pixels() > LiveSession::MAX_PIXELS;
            let millions = LiveSession::MAX_PIXELS / 1_000_000;
            let message = if is_too_large { self.texts.render_too_large(millions) } else { message };
            self.state.notices.error(self.texts.notice_render_failed(), message);
        }
        self.follow_explained(ctx);
        match self.state.study.poll() {
            None => {}
            Some(Outcome::Saved(folder)) => {
                let (title, details) = (self.texts.study_saved(), folder.display().to_string());
                self.state.notices.add(Severity::Done, title, details);
            }
            Some(Outcome::NotSaved(error)) => self.state.notices.error(self.texts.study_not_saved(), error),
            Some(Outcome::Failed(error)) => self.state.notices.error(self.texts.study_failed(), error),
        }
        if let Some(next) = self.state.notices.expire(Instant::now()) {
            ctx.request_repaint_after(next);
        }
    }

    /// Shows another document in place of the one at hand.
    fn replace(&mut self, document: Document, ctx: &Context) {
        self.close_dialog_of_scene(ctx);
        self.state.document = document;
        self.state.view = View::default();
        self.state.selection = None;
        self.show_anew();
    }

    /// Notes that what is seen has changed: a new picture starts, or waits for the button.
    fn changed(&mut self) {
        if self.state.preferences.live {
            self.show_anew();
        } else {
            self.state.pending = true;
        }
    }

    fn show_anew(&mut self) {
        self.stale = true;
    }

    /// Asks for the picture of what is seen now, also while another scene is read: that may take minutes, and what is
    /// changed meanwhile is to be seen. Only the very first picture waits for a moment, as most scenes are soon there.
    fn ask(&mut self) {
        if !self.stale || self.awaits_first_scene() {
            return;
        }
        self.stale = false;
        self.state.pending = false;
        if let Some(camera) = self.state.camera() {
            let threads = self.state.preferences.threads_in_use();
            self.render.ask(self.state.document.scene(), camera, self.state.integrator, threads);
        }
    }

    fn awaits_first_scene(&mut self) -> bool {
        let loads = self.loader.source().is_some() && !self.render.has_asked();
        loads && self.waits.get_or_insert_with(Instant::now).elapsed() < FIRST_WAITS
    }

    /// Draws again in time for progress to be seen, and not at all when nothing goes on.
    fn schedule(&self, ctx: &Context) {
        let waits = self.loader.source().is_some() || self.files.is_busy();
        if waits || self.render.status().phase != LivePhase::Idle {
            ctx.request_repaint_after(PROGRESS_EVERY);
        }
    }
}

impl eframe::App for Studio {
    fn logic(&mut self, ctx: &Context, _frame: &mut eframe::Frame) {
        self.milestones.tell();
        self.take_in(ctx);
        self.take_close(ctx);
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        let ctx = ui.ctx().clone();
        let mut commands = std::mem::take(&mut self.commands);
        let later = std::mem::take(&mut self.later);
        let desk = &mut Desk {
            state: &self.state,
            texts: &self.texts,
            render: &self.render,
            files: &self.files,
            loading: self.loader.source(),
            commands: &mut commands,
        };
        shortcuts::take(&ctx, desk);
        panels::show(ui, desk);
        viewport::show(ui, desk);
        study::show(&ctx, desk);
        dialogs::show(&ctx, desk);
        shortcuts::note_typing(&ctx);
        for command in commands.into_iter().chain(later) {
            self.apply(command, &ctx);
        }
        // A key that is held repeats: all of it is one gesture, as a drag is.
        if ctx.input(|i| !i.pointer.any_down() && i.keys_down.is_empty()) {
            self.state.document.end_gesture();
        }
        self.ask();
        self.keep_safe(&ctx);
        self.show_title(&ctx);
        self.milestones.note(&self.render, &ctx);
        self.schedule(&ctx);
    }

    fn save(&mut self, storage: &mut dyn eframe::Storage) {
        self.state.preferences.store(storage);
    }

    fn on_exit(&mut self, _gl: Option<&eframe::glow::Context>) {
        self.files.recovery.end();
    }
}
