//! What a person is asked for a path for, and the dialog of the system that may be asked instead.

use crate::l10n::Texts;
use std::path::PathBuf;

/// What a path is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Purpose {
    /// A scene or model to look at.
    Open,
    /// Where the scene is to be written.
    Save,
    /// A model to put into the scene.
    AddModel,
    /// Where a picture is to be written.
    Export,
}

impl Purpose {
    /// The endings of the files that serve.
    pub(crate) const fn endings(self) -> &'static [&'static str] {
        match self {
            Self::Open => &["toml", "obj"],
            Self::Save => &["toml"],
            Self::AddModel => &["obj"],
            Self::Export => &["png", "exr"],
        }
    }

    /// Whether the file is to be written, and need not exist.
    pub(crate) const fn writes(self) -> bool {
        matches!(self, Self::Save | Self::Export)
    }

    pub(crate) fn title(self, texts: &Texts) -> String {
        match self {
            Self::Open => texts.dialog_open(),
            Self::Save => texts.dialog_save_as(),
            Self::AddModel => texts.dialog_add_model(),
            Self::Export => texts.dialog_export(),
        }
    }

    /// What the button says that does it.
    pub(crate) fn button(self, texts: &Texts) -> String {
        match self {
            Self::Open => texts.button_open(),
            Self::Save => texts.button_save(),
            Self::AddModel => texts.button_add(),
            Self::Export => texts.button_export(),
        }
    }

    /// What the system's dialog calls the files that serve.
    pub(crate) fn files(self, texts: &Texts) -> String {
        match self {
            Self::Open => texts.files_scenes_and_models(),
            Self::Save => texts.files_scenes(),
            Self::AddModel => texts.files_models(),
            Self::Export => texts.files_pictures(),
        }
    }
}

/// What the system's dialog is asked.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct FileQuestion {
    /// The title of the dialog.
    pub title: String,
    /// What the files that serve are called.
    pub files: String,
    /// Their endings, in small letters, without the dot.
    pub endings: &'static [&'static str],
    /// The folder to begin in.
    pub folder: PathBuf,
    /// The name to begin with, for a file to be written; else empty.
    pub name: String,
    /// Whether the file is to be written.
    pub writes: bool,
}

/// Asks the system for a path and waits for the answer; `None` if there is none.
pub type ChooseFile = fn(&FileQuestion) -> Option<PathBuf>;

/// The dialog of the desktop, where there is one.
pub(crate) fn ask_system(question: &FileQuestion) -> Option<PathBuf> {
    let FileQuestion { title, files, endings, folder, name, writes } = question;
    let dialog = rfd::FileDialog::new().set_title(title).set_directory(folder).add_filter(files, endings);
    if *writes { dialog.set_file_name(name).save_file() } else { dialog.pick_file() }
}
