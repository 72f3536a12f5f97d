//! Everything that a person can make the window do. Panels queue commands; `studio` applies them, nothing else does.

use crate::dialogs::Dialog;
use crate::explain::ExplainCommand;
use crate::files::{ExportForm, FileQuestion, Purpose};
use crate::l10n::{Language, Texts};
use crate::placement::Addition;
use crate::selection::Part;
use crate::study::StudyCommand;
use crate::undo::Gesture;
use crate::view::Pose;
use egui::{Key, KeyboardShortcut, Modifiers, ThemePreference};
use luch_io::SceneSource;
use luch_render::Integrator;
use luch_scene::{Edit, Positive};
use std::path::PathBuf;

/// What the mouse does in the picture.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(crate) enum Tool {
    /// Select by click, look around by drag.
    #[default]
    Select,
    /// Also move what is selected by its handles.
    Move,
    /// Also turn it.
    Rotate,
    /// Also make it larger or smaller.
    Scale,
    /// A click sets the distance that is sharp.
    Focus,
    /// A click asks why a pixel has its colour.
    Explain,
}

impl Tool {
    /// All of them, in the order of the toolbar.
    pub(crate) const ALL: [Self; 6] = [Self::Select, Self::Move, Self::Rotate, Self::Scale, Self::Focus, Self::Explain];

    /// Whether a click selects.
    pub(crate) const fn selects(self) -> bool {
        !matches!(self, Self::Focus | Self::Explain)
    }
}

/// How large the picture is shown.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) enum Zoom {
    /// As large as fits.
    #[default]
    Fit,
    /// So many pixels of the screen for one of the picture.
    Factor(f32),
}

/// A thing to do.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Command {
    /// Start with an empty scene.
    New,
    /// Load a scene in place of the one at hand.
    Open(SceneSource),
    /// Ask for a scene or model to open.
    OpenDialog,
    /// Load the scene or model of a path that a dialog asked for.
    OpenPath(PathBuf),
    /// Write the scene to its file, or ask for one.
    Save,
    /// Ask for a file to write the scene to.
    SaveAs,
    /// Write the scene to a file.
    SaveTo {
        /// The file.
        path: PathBuf,
        /// Whether a file that is there may be replaced.
        replace: bool,
        /// What to do when it is written.
        then: Option<Box<Command>>,
    },
    /// Save the scene, then do something.
    SaveThen(Box<Command>),
    /// Do something although changes are lost by it.
    Discard(Box<Command>),
    /// Put something new into the scene.
    Add(Addition),
    /// Ask for a model to put into the scene.
    AddModelDialog,
    /// Make a camera of what is seen.
    AddCamera,
    /// Read models and put them into the scene.
    AddModels(Vec<PathBuf>),
    /// Take in files that were dropped on the window.
    Drop {
        /// The files.
        paths: Vec<PathBuf>,
        /// Whether a model is to be opened instead of added.
        alone: bool,
    },
    /// Ask what picture is to be made for a file.
    ExportDialog,
    /// Make a picture for a file.
    Export(Box<ExportForm>),
    /// Stop the picture for a file.
    CancelExport,
    /// Close the window although a picture for a file is under way.
    QuitWithoutExport,
    /// Bring back a scene that an earlier program had not saved.
    Recover(usize),
    /// Remove such a scene.
    DiscardRecovered(usize),
    /// Take a camera out of the scene.
    RemoveCamera(usize),
    /// Look what lies in a folder.
    ListFolder(PathBuf, Purpose),
    /// Open the system's dialog.
    Browse(FileQuestion),
    /// The answer of the system's dialog was taken.
    ForgetChosen,
    /// What was wrong with the last input has been typed over.
    ForgetComplaint,
    /// Change the scene.
    Edit(Edit, Gesture),
    /// Take back the gesture of this name that is going on, as if it had never been made.
    TakeBack(egui::Id),
    /// Take the last change back.
    Undo,
    /// Make it again.
    Redo,
    /// Select a part of the scene, or nothing.
    Select(Option<Part>),
    /// Copy what is selected.
    Duplicate,
    /// Take what is selected out of the scene.
    Delete,
    /// Leave what is selected out of the picture, or show it again.
    ToggleHidden,
    /// Look through a camera of the scene.
    ChooseCamera(usize),
    /// Look from elsewhere; `None`: from where the camera stands.
    SetPose(Option<Pose>),
    /// Look from where all of the selection is in the picture, or all of the scene.
    Frame,
    /// Make the scene's camera stand where the view is.
    StorePose,
    /// Make what lies at this distance along the view sharp; `None`: there is nothing.
    FocusAt(Option<Positive>),
    /// Start the picture, with all changes that wait for it.
    Render,
    /// Stop the picture.
    Cancel,
    /// Whether every change starts a picture by itself.
    SetLive(bool),
    /// Use so many threads; `None`: one per core.
    SetThreads(Option<usize>),
    /// Speak another language.
    SetLanguage(Language),
    /// Light, dark, or as the system is.
    SetTheme(ThemePreference),
    /// Give the mouse another job.
    SetTool(Tool),
    /// Show the picture larger or smaller.
    SetZoom(Zoom),
    /// Show light, or something else of what the rays meet.
    SetIntegrator(Integrator),
    /// Do something with the account of a pixel.
    Explain(ExplainCommand),
    /// Ask or tell something.
    Show(Dialog),
    /// Close what asks or tells.
    CloseDialog,
    /// Do not show the hints of the first run again.
    HintsRead,
    /// Take a notice away.
    DismissNotice(u64),
    /// Measure how long pictures take.
    Study(StudyCommand),
    /// Close the window.
    Quit,
    /// Leave the field that is typed into, and do something with what was typed.
    AfterTyping(Box<Command>),
}

const fn ctrl(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND, key)
}

const fn ctrl_shift(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), key)
}

const fn plain(key: Key) -> KeyboardShortcut {
    KeyboardShortcut::new(Modifiers::NONE, key)
}

impl Command {
    /// The commands with a key of their own, in the order of the shortcut sheet.
    pub(crate) fn with_shortcuts() -> Vec<Self> {
        vec![
            Self::New,
            Self::OpenDialog,
            Self::Save,
            Self::SaveAs,
            Self::ExportDialog,
            Self::Quit,
            Self::Undo,
            Self::Redo,
            Self::Duplicate,
            Self::Delete,
            Self::ToggleHidden,
            Self::Select(None),
            Self::Render,
            Self::Cancel,
            Self::Frame,
            Self::SetPose(None),
            Self::SetTool(Tool::Explain),
            Self::SetZoom(Zoom::Fit),
            Self::SetZoom(Zoom::Factor(1.0)),
            Self::SetTool(Tool::Select),
            Self::SetTool(Tool::Move),
            Self::SetTool(Tool::Rotate),
            Self::SetTool(Tool::Scale),
            Self::SetTool(Tool::Focus),
        ]
    }

    /// The key that does it.
    pub(crate) const fn shortcut(&self) -> Option<KeyboardShortcut> {
        Some(match self {
            Self::New => ctrl(Key::N),
            Self::OpenDialog => ctrl(Key::O),
            Self::Save => ctrl(Key::S),
            Self::SaveAs => ctrl_shift(Key::S),
            Self::ExportDialog => ctrl(Key::E),
            Self::Quit => ctrl(Key::Q),
            Self::Undo => ctrl(Key::Z),
            Self::Redo => ctrl_shift(Key::Z),
            Self::Duplicate => ctrl(Key::D),
            Self::Delete => plain(Key::Delete),
            Self::ToggleHidden => plain(Key::H),
            Self::Select(None) => plain(Key::Escape),
            Self::Render => plain(Key::F5),
            Self::Cancel => KeyboardShortcut::new(Modifiers::SHIFT, Key::F5),
            Self::Frame => plain(Key::F),
            Self::SetPose(None) => plain(Key::Home),
            Self::SetTool(Tool::Explain) => plain(Key::X),
            Self::SetZoom(Zoom::Fit) => ctrl(Key::Num0),
            Self::SetZoom(Zoom::Factor(_)) => ctrl(Key::Num1),
            Self::SetTool(Tool::Select) => plain(Key::Q),
            Self::SetTool(Tool::Move) => plain(Key::W),
            Self::SetTool(Tool::Rotate) => plain(Key::E),
            Self::SetTool(Tool::Scale) => plain(Key::R),
            Self::SetTool(Tool::Focus) => plain(Key::T),
            _ => return None,
        })
    }

    /// Whether its keys mean something else to whoever types: the text has changes of its own to take back.
    pub(crate) const fn is_about_text(&self) -> bool {
        matches!(self, Self::Undo | Self::Redo | Self::Duplicate)
    }

    /// Whether it works with the whole scene, that which is being typed included.
    pub(crate) const fn takes_what_is_typed(&self) -> bool {
        matches!(
            self,
            Self::New | Self::OpenDialog | Self::Save | Self::SaveAs | Self::ExportDialog | Self::Render | Self::Quit
        )
    }

    /// What a menu calls it.
    pub(crate) fn label(&self, texts: &Texts) -> String {
        match self {
            Self::New => texts.command_new(),
            Self::OpenDialog => texts.command_open(),
            Self::Save => texts.command_save(),
            Self::SaveAs => texts.command_save_as(),
            Self::Add(what) => what.name(texts),
            Self::AddModelDialog => texts.command_add_model(),
            Self::AddCamera => texts.command_add_camera(),
            Self::RemoveCamera(_) => texts.command_remove_camera(),
            Self::ExportDialog => texts.command_export(),
            Self::Quit => texts.command_quit(),
            Self::Undo => texts.command_undo(),
            Self::Redo => texts.command_redo(),
            Self::Duplicate => texts.command_duplicate(),
            Self::Delete => texts.command_delete(),
            Self::ToggleHidden => texts.command_toggle_hidden(),
            Self::Select(_) => texts.command_select_nothing(),
            Self::Render => texts.command_render(),
            Self::Cancel => texts.command_cancel(),
            Self::Frame => texts.command_frame(),
            Self::SetPose(_) => texts.command_return_to_camera(),
            Self::StorePose => texts.command_store_pose(),
            Self::SetZoom(Zoom::Fit) => texts.command_zoom_fit(),
            Self::SetZoom(Zoom::Factor(_)) => texts.command_zoom_one(),
            Self::SetTool(Tool::Select) => texts.tool_select(),
            Self::SetTool(Tool::Move) => texts.tool_move(),
            Self::SetTool(Tool::Rotate) => texts.tool_rotate(),
            Self::SetTool(Tool::Scale) => texts.tool_scale(),
            Self::SetTool(Tool::Focus) => texts.tool_focus(),
            Self::SetTool(Tool::Explain) => texts.tool_explain(),
            Self::Study(_) => texts.menu_study(),
            Self::Show(dialog) => dialog.label(texts),
            // The rest are gestures and widgets with labels of their own; no menu has them.
            _ => String::new(),
        }
    }
}
