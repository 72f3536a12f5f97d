//! What was typed after `luch study`.

use crate::values::{self, List};
use crate::{args, text};
use clap::builder::TypedValueParser;
use clap::{Args, Subcommand};
use luch_render::SimdLevel;
use luch_scene::ImageSize;
use luch_study::{Effect, Language};
use std::path::PathBuf;

#[derive(Debug, Subcommand)]
pub(crate) enum StudyCommand {
    /// Time against the number of threads, for one sphere and two, beside the published study
    #[command(after_help = text::STUDY_THREADS)]
    Threads(StudyThreadsArgs),
    /// Time to build and to render against the number of triangles of a mesh
    #[command(after_help = text::STUDY_TRIANGLES)]
    Triangles(StudyTrianglesArgs),
    /// Time and noise against rays per pixel
    #[command(after_help = text::STUDY_RAYS)]
    Rays(StudyRaysArgs),
    /// Time against the size of the tiles that pictures are made in
    #[command(after_help = text::STUDY_TILES)]
    Tiles(StudyTilesArgs),
}

#[derive(Debug, Args)]
pub(crate) struct StudyThreadsArgs {
    /// Numbers of threads, 1 to 1024 each [default: 1,2,4,8,12,16,20,32,64]
    #[arg(long, value_name = "N,N,...", value_parser = values::thread_counts, allow_hyphen_values = true)]
    pub(crate) threads: Option<List>,
    /// A scene, built in or a file; may be repeated, the first is what the others are compared with
    /// [default: one-sphere, two-spheres]
    #[arg(long, value_name = "SCENE")]
    pub(crate) scene: Vec<PathBuf>,
    #[command(flatten)]
    pub(crate) common: StudyArgs,
}

#[derive(Debug, Args)]
pub(crate) struct StudyTrianglesArgs {
    /// Numbers of triangles, 8 to 10000000 each, met as nearly as the mesh can [default: 1000,3000,...,1000000]
    #[arg(long, value_name = "N,N,...", value_parser = values::triangle_counts, allow_hyphen_values = true)]
    pub(crate) triangles: Option<List>,
    /// Threads, 1 to 1024 [default: all of the machine]
    #[arg(long, value_name = "N", value_parser = values::threads, allow_hyphen_values = true)]
    pub(crate) threads: Option<u32>,
    #[command(flatten)]
    pub(crate) common: StudyArgs,
}

#[derive(Debug, Args)]
pub(crate) struct StudyRaysArgs {
    /// Numbers of rays per pixel, 1 to 4096 each [default: 1,2,4,...,256]
    #[arg(long, value_name = "N,N,...", value_parser = values::ray_counts, allow_hyphen_values = true)]
    pub(crate) rays: Option<List>,
    /// Rays per pixel of the picture that stands for the truth, more than any other [default: 4096]
    #[arg(long, value_name = "N", value_parser = values::reference, allow_hyphen_values = true)]
    pub(crate) reference: Option<u32>,
    /// What the rays of a pixel are spread over
    #[arg(long, value_name = "NAME", value_parser = effect(), default_value = Effect::Antialiasing.word())]
    pub(crate) effect: Effect,
    /// A scene, built in or a file; may be repeated [default: two-spheres]
    #[arg(long, value_name = "SCENE")]
    pub(crate) scene: Vec<PathBuf>,
    /// Threads, 1 to 1024 [default: all of the machine]
    #[arg(long, value_name = "N", value_parser = values::threads, allow_hyphen_values = true)]
    pub(crate) threads: Option<u32>,
    #[command(flatten)]
    pub(crate) common: StudyArgs,
}

#[derive(Debug, Args)]
pub(crate) struct StudyTilesArgs {
    /// Sides of tiles in pixels, 1 to 1024 each [default: 4,8,16,24,32,48,64,128,256]
    #[arg(long, value_name = "N,N,...", value_parser = values::tile_sides, allow_hyphen_values = true)]
    pub(crate) tiles: Option<List>,
    /// A scene, built in or a file; may be repeated [default: two-spheres]
    #[arg(long, value_name = "SCENE")]
    pub(crate) scene: Vec<PathBuf>,
    /// Threads, 1 to 1024 [default: all of the machine]
    #[arg(long, value_name = "N", value_parser = values::threads, allow_hyphen_values = true)]
    pub(crate) threads: Option<u32>,
    #[command(flatten)]
    pub(crate) common: StudyArgs,
}

/// What every study takes.
#[derive(Debug, Args)]
pub(crate) struct StudyArgs {
    /// The folder to write to; made if it is missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// Counted runs of each case, 1 to 10000 [default: see below]
    #[arg(long, value_name = "N", value_parser = values::runs, allow_hyphen_values = true)]
    pub(crate) runs: Option<u32>,
    /// Runs of each case before, which are not counted, 0 to 1000 [default: see below]
    #[arg(long, value_name = "N", value_parser = values::warm_up, allow_hyphen_values = true)]
    pub(crate) warm_up: Option<u32>,
    /// Width and height of the pictures in pixels, at most 7680x4320 [default: see below]
    #[arg(long, value_name = "WxH", value_parser = values::size, allow_hyphen_values = true)]
    pub(crate) size: Option<ImageSize>,
    /// Instruction set
    #[arg(long, value_name = "LEVEL", value_parser = args::simd(), default_value = SimdLevel::Auto.word())]
    pub(crate) simd: SimdLevel,
    /// Language of the report and the plots [default: the system's, of LC_ALL, LC_MESSAGES, LANG]
    #[arg(long, value_name = "LANGUAGE", value_parser = language())]
    pub(crate) language: Option<Language>,
    /// Show neither progress nor what was found
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

fn effect() -> impl TypedValueParser<Value = Effect> {
    let of = |word: &str| Effect::ALL.into_iter().find(|e| e.word() == word).unwrap_or(Effect::Antialiasing);
    args::one_of(Effect::ALL.map(Effect::word), of)
}

fn language() -> impl TypedValueParser<Value = Language> {
    args::one_of(Language::ALL.map(Language::word), |word| Language::from_word(word).unwrap_or_default())
}
