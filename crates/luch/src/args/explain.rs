//! What was typed after `luch explain`.

use super::{CameraArgs, EditArgs, FrameArgs, MachineArgs, one_of};
use crate::values::{self, PixelPlace, Shown};
use clap::Args;
use clap::builder::TypedValueParser;
use luch_explain::Language;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(crate) struct ExplainArgs {
    /// A built-in scene (see `luch scenes`), a scene file (.toml) or a model (.obj)
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// The pixel: its column and row, both from 0 at the upper left corner
    #[arg(long, value_name = "X,Y", value_parser = values::pixel, allow_hyphen_values = true)]
    pub(crate) pixel: PixelPlace,
    /// The file to write [default: standard output]
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,

    #[command(flatten, next_help_heading = "Form")]
    pub(crate) form: FormArgs,
    #[command(flatten, next_help_heading = "Picture")]
    pub(crate) frame: FrameArgs,
    #[command(flatten, next_help_heading = "Camera")]
    pub(crate) camera: CameraArgs,
    #[command(flatten, next_help_heading = "Scene")]
    pub(crate) edits: EditArgs,
    #[command(flatten, next_help_heading = "Work")]
    pub(crate) machine: MachineArgs,
    /// Show neither progress nor warnings
    #[arg(short, long, help_heading = "Work")]
    pub(crate) quiet: bool,
}

#[derive(Debug, Args)]
pub(crate) struct FormArgs {
    /// As JSON with every number (docs/explain.schema.json)
    #[arg(long, group = "form")]
    pub(crate) json: bool,
    /// As Markdown, formulas as mathematics
    #[arg(long, group = "form")]
    pub(crate) markdown: bool,
    /// As a LaTeX document
    #[arg(long, group = "form")]
    pub(crate) latex: bool,
    /// The language of text, Markdown and LaTeX
    #[arg(long, value_name = "en|ru", value_parser = language(), default_value = Language::English.word())]
    pub(crate) language: Language,
    /// With antialiasing or depth of field: whose rays to show, a sample's from 0 or all; JSON always has all
    #[arg(long, value_name = "N|all", value_parser = values::shown, default_value = "0", allow_hyphen_values = true)]
    pub(crate) sample: Shown,
    /// Also list the boxes that each ray enters and the shapes that it is tested against
    #[arg(long)]
    pub(crate) boxes: bool,
}

fn language() -> impl TypedValueParser<Value = Language> {
    one_of(Language::ALL.map(Language::word), |word| Language::from_word(word).unwrap_or_default())
}
