//! What was typed: a struct for each command, every number in its range already. What it means is `meaning`'s business.

mod explain;
mod study;

pub(crate) use explain::{ExplainArgs, FormArgs};
pub(crate) use study::{StudyArgs, StudyCommand};

use crate::text;
use crate::values::{self, Part, Rays};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, Parser, Subcommand, ValueEnum};
use luch_render::{Integrator, SimdLevel};
use luch_scene::{FieldOfView, ImageSize, NonNegative, Positive, Shading};
use std::path::PathBuf;

/// Luch, a ray-tracing studio: open a scene, make a true picture of it.
#[derive(Debug, Parser)]
#[command(
    name = "luch",
    version,
    max_term_width = 110,
    after_help = text::MAIN,
    subcommand_precedence_over_arg = true,
    args_conflicts_with_subcommands = true
)]
pub(crate) struct Cli {
    /// Open the studio with this scene: built in, a scene file (.toml) or a model (.obj) [default: two-spheres]
    #[arg(value_name = "SCENE")]
    pub(crate) scene: Option<PathBuf>,
    /// Tell on standard error how long the studio's window and its first pictures took to appear
    #[arg(long)]
    pub(crate) times: bool,
    #[command(subcommand)]
    pub(crate) command: Option<Command>,
}

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    /// Make a picture of a scene
    #[command(after_help = text::RENDER)]
    Render(Box<RenderArgs>),
    /// Tell why a pixel has its colour: every ray, every hit, every number of the lighting sum
    #[command(after_help = text::EXPLAIN)]
    Explain(Box<ExplainArgs>),
    /// List the built-in scenes
    #[command(after_help = text::SCENES)]
    Scenes(ScenesArgs),
    /// Tell what is in a scene or model
    #[command(after_help = text::INFO)]
    Info(InfoArgs),
    /// Study how long pictures take, and what that depends on
    #[command(subcommand, after_help = text::STUDY)]
    Study(StudyCommand),
    /// Measure the parts of the renderer
    #[command(subcommand, after_help = text::BENCH)]
    Bench(BenchCommand),
}

#[derive(Debug, Subcommand)]
pub(crate) enum BenchCommand {
    /// Measure ray queries against one mesh
    #[command(after_help = text::BENCH_RAYS)]
    Rays(BenchRaysArgs),
}

#[derive(Debug, Args)]
pub(crate) struct RenderArgs {
    /// A built-in scene (see `luch scenes`), a scene file (.toml) or a model (.obj)
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// The picture to write: .png, or .exr for linear 32-bit floats
    #[arg(short, long, value_name = "FILE")]
    pub(crate) output: PathBuf,

    #[command(flatten, next_help_heading = "Picture")]
    pub(crate) frame: FrameArgs,
    #[command(flatten, next_help_heading = "Picture")]
    pub(crate) picture: PictureArgs,
    #[command(flatten, next_help_heading = "Camera")]
    pub(crate) camera: CameraArgs,
    #[command(flatten, next_help_heading = "Scene")]
    pub(crate) edits: EditArgs,
    #[command(flatten, next_help_heading = "Work")]
    pub(crate) work: WorkArgs,
}

/// What every picture has, shown or explained.
#[derive(Debug, Args)]
pub(crate) struct FrameArgs {
    /// Width and height in pixels, 1 to 65535 each [default: the scene's]
    #[arg(long, value_name = "WxH", value_parser = values::size, allow_hyphen_values = true)]
    pub(crate) size: Option<ImageSize>,
    /// Rays over each pixel, 1 to 4096, or off [default: the scene's]
    #[arg(long, value_name = "N|off", value_parser = values::rays, allow_hyphen_values = true)]
    pub(crate) antialiasing: Option<Rays>,
    /// Rays over the lens for each pixel, 1 to 4096, or off; shared with antialiasing [default: the scene's]
    #[arg(long, value_name = "N|off", value_parser = values::rays, allow_hyphen_values = true)]
    pub(crate) depth_of_field: Option<Rays>,
    /// Surfaces along a path, mirrors included, 0 to 10000 [default: the scene's]
    #[arg(long, value_name = "N", value_parser = values::depth, allow_hyphen_values = true)]
    pub(crate) depth: Option<u32>,
}

#[derive(Debug, Args)]
pub(crate) struct PictureArgs {
    /// Make only this part of the picture, in pixels from the upper left corner: its pixels are those of the whole
    #[arg(long, value_name = "X,Y,W,H", value_parser = values::crop, allow_hyphen_values = true)]
    pub(crate) crop: Option<Part>,
    /// How light is worked out: classic is Whitted ray tracing, the others look behind the scenes
    #[arg(long, value_name = "NAME", value_parser = integrator(), default_value = Integrator::default().word())]
    pub(crate) integrator: Integrator,
    /// Draw the scale of the counts to the right of the picture: for --integrator nodes and triangles, PNG only
    #[arg(long)]
    pub(crate) color_bar: bool,
    /// Bits for each colour of a PNG
    #[arg(long, value_name = "8|16", value_enum)]
    pub(crate) bits: Option<Bits>,
}

#[derive(Debug, Args)]
pub(crate) struct CameraArgs {
    /// The camera's name, or its number from 1
    #[arg(long = "camera", value_name = "N|NAME", default_value = "1", allow_hyphen_values = true)]
    pub(crate) name: String,
    /// Vertical field of view in degrees, 0.01 to 179 [default: the camera's]
    #[arg(long, value_name = "DEG", value_parser = values::ranged::<FieldOfView>, allow_hyphen_values = true)]
    pub(crate) fov: Option<FieldOfView>,
    /// Distance along the view that is sharp, in scene units; needs depth of field [default: the camera's]
    #[arg(long, value_name = "D", value_parser = values::ranged::<Positive>, allow_hyphen_values = true)]
    pub(crate) focal_distance: Option<Positive>,
    /// Radius of the lens in scene units; needs depth of field [default: the camera's]
    #[arg(long, value_name = "R", value_parser = values::ranged::<NonNegative>, allow_hyphen_values = true)]
    pub(crate) lens_radius: Option<NonNegative>,
}

#[derive(Debug, Args)]
pub(crate) struct EditArgs {
    /// Shading model of every mesh of the scene: flat, gouraud or phong
    #[arg(long, value_name = "MODEL", value_parser = shading())]
    pub(crate) shading: Option<Shading>,
    /// Intensity of every light in percent, from 0
    #[arg(long, value_name = "PERCENT", value_parser = values::percent, allow_hyphen_values = true)]
    pub(crate) light_intensity: Option<NonNegative>,
    /// Change one thing of the scene, as in 'Cube.reflection=95%'; may be repeated (see below)
    #[arg(long, value_name = "OBJECT.key=value", allow_hyphen_values = true)]
    pub(crate) set: Vec<String>,
}

#[derive(Debug, Args)]
pub(crate) struct WorkArgs {
    #[command(flatten)]
    pub(crate) machine: MachineArgs,
    /// Write times, counts and the picture's hash as JSON to a file, or to standard output with -
    #[arg(long, value_name = "FILE|-", allow_hyphen_values = true)]
    pub(crate) stats: Option<PathBuf>,
    /// Show neither progress nor warnings
    #[arg(short, long)]
    pub(crate) quiet: bool,
}

/// What of the machine may be used.
#[derive(Debug, Args)]
pub(crate) struct MachineArgs {
    /// Threads, 1 to 1024; the picture does not depend on it [default: all of the machine]
    #[arg(long, value_name = "N", value_parser = values::threads, allow_hyphen_values = true)]
    pub(crate) threads: Option<u32>,
    /// Instruction set; the picture does not depend on it
    #[arg(long, value_name = "LEVEL", value_parser = simd(), default_value = SimdLevel::Auto.word())]
    pub(crate) simd: SimdLevel,
    /// The most memory that the scene and the picture may take, as in 8G [default: 3/4 of the machine's]
    #[arg(long, value_name = "SIZE", value_parser = values::memory, allow_hyphen_values = true)]
    pub(crate) memory: Option<u64>,
}

/// Bits for each colour of a PNG.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Bits {
    #[value(name = "8")]
    Eight,
    #[value(name = "16")]
    Sixteen,
}

#[derive(Debug, Args)]
pub(crate) struct ScenesArgs {
    /// Answer in JSON
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
pub(crate) struct InfoArgs {
    /// A built-in scene (see `luch scenes`), a scene file (.toml) or a model (.obj)
    #[arg(value_name = "SCENE")]
    pub(crate) scene: PathBuf,
    /// Answer in JSON
    #[arg(long)]
    pub(crate) json: bool,
    /// The most memory that the scene may take, as in 8G [default: 3/4 of the machine's]
    #[arg(long, value_name = "SIZE", value_parser = values::memory, allow_hyphen_values = true)]
    pub(crate) memory: Option<u64>,
}

#[derive(Debug, Args)]
pub(crate) struct BenchRaysArgs {
    /// The mesh (.obj)
    #[arg(long, value_name = "M.obj")]
    pub(crate) mesh: PathBuf,
    /// The rays: little-endian f32, eight for each ray: ox oy oz dx dy dz tmin tmax
    #[arg(long, value_name = "FILE")]
    pub(crate) rays: PathBuf,
    /// What is asked of each ray: its nearest hit, or whether it hits anything
    #[arg(long, value_enum)]
    pub(crate) query: Query,
    /// Neighbouring rays of the file go nearly the same way: a hint for speed, the hits are the same
    #[arg(long)]
    pub(crate) coherent: bool,
    /// Threads, 1 to 1024, for the build and the queries [default: all of the machine]
    #[arg(long, value_name = "N", value_parser = values::threads, allow_hyphen_values = true)]
    pub(crate) threads: Option<u32>,
    /// How often the rays are asked; the best time counts
    #[arg(long, value_name = "R", value_parser = values::repeats, default_value = "5", allow_hyphen_values = true)]
    pub(crate) repeat: u32,
    /// Instruction set
    #[arg(long, value_name = "LEVEL", value_parser = simd(), default_value = SimdLevel::Auto.word())]
    pub(crate) simd: SimdLevel,
    /// Answer in JSON
    #[arg(long)]
    pub(crate) json: bool,
}

/// What is asked of each ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Query {
    // The nearest hit.
    Closest,
    // Whether there is a hit.
    Any,
}

// Words of closed sets: clap lists them in the help and suggests the nearest.

pub(crate) fn simd() -> impl TypedValueParser<Value = SimdLevel> {
    one_of(SimdLevel::ALL.map(SimdLevel::word), |word| SimdLevel::from_word(word).unwrap_or_default())
}

fn integrator() -> impl TypedValueParser<Value = Integrator> {
    one_of(Integrator::ALL.map(Integrator::word), |word| Integrator::from_word(word).unwrap_or_default())
}

fn shading() -> impl TypedValueParser<Value = Shading> {
    one_of(Shading::ALL.map(Shading::word), |word| Shading::from_word(word).unwrap_or_default())
}

/// `read` is given nothing but the words.
fn one_of<T, const N: usize>(words: [&'static str; N], read: fn(&str) -> T) -> impl TypedValueParser<Value = T>
where
    T: Clone + Send + Sync + 'static,
{
    PossibleValuesParser::new(words).map(move |word| read(&word))
}
