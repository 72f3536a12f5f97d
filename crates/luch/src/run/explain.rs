//! `luch explain`: load, change, build, trace one pixel, tell.

use crate::args::{ExplainArgs, FormArgs};
use crate::exit::{Code, Failure};
use crate::meaning::{available, threads};
use crate::output;
use crate::progress::Stages;
use crate::shot::Shot;
use crate::signals::Watch;
use crate::source::{self, Loaded};
use crate::values::{PixelPlace, Shown};
use luch_explain::{Explanation, Options, Role, Samples, plain};
use luch_io::atomic_save::{STDOUT, save};
use luch_io::check_writable;
use luch_render::explain::{ExplainError, explain_unless};
use luch_render::{MeshTrees, RenderJob, compile};
use luch_scene::ImageSize;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;

/// How an explanation is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Form {
    Text,
    Json,
    Markdown,
    Latex,
}

impl Form {
    /// What was asked for, or what the file's name says.
    fn of(args: &FormArgs, output: Option<&Path>) -> Self {
        match (args.json, args.markdown, args.latex) {
            (true, ..) => Self::Json,
            (_, true, _) => Self::Markdown,
            (.., true) => Self::Latex,
            _ => match output.and_then(Path::extension).and_then(|extension| extension.to_str()) {
                Some("json") => Self::Json,
                Some("md") => Self::Markdown,
                Some("tex") => Self::Latex,
                _ => Self::Text,
            },
        }
    }
}

pub(crate) fn run(args: ExplainArgs, watch: &Watch) -> Result<(), Failure> {
    let ExplainArgs { scene: name, pixel, output, form, frame, camera, edits, machine, quiet } = args;
    let output = output.filter(|path| path.as_os_str() != STDOUT);
    output.as_deref().map_or(Ok(()), check_writable)?;
    let (simd, threads) = (available(machine.simd)?, threads(machine.threads));
    let shot = Shot { frame, camera, edits };
    let stages = Stages::new(quiet);

    let load = || source::load(&name, machine.memory, watch);
    let loaded = stages.during("loading", None, load).map_err(|failure| watch.check().err().unwrap_or(failure));
    let Loaded { mut scene, warnings, .. } = loaded?;
    let camera = shot.apply(&mut scene)?;
    let job = RenderJob { simd, threads, ..RenderJob::of_scene(&scene, camera) };
    let [x, y] = within(pixel, job.size)?;
    let samples = shown(form.sample, job.rays_per_pixel())?;
    if !quiet {
        warnings.iter().chain(&shot.advice(&job)).for_each(|line| output::warning(line));
    }

    let compiled = stages.during("building", None, || compile(&scene, &mut MeshTrees::new(), threads));
    let flag = watch.flag();
    let trace = || explain_unless(&compiled, &job, [x, y], &|| flag.load(Ordering::Relaxed));
    let account = stages.during("tracing", None, trace);
    watch.check()?;
    let account = account.map_err(failed)?;
    let explanation = Explanation { account: &account, scene: &scene, compiled: &compiled, camera: &job.camera.name };
    let options = Options { language: form.language, samples, boxes: form.boxes };
    write(&explanation, &options, Form::of(&form, output.as_deref()), output, watch)
}

fn write(
    explanation: &Explanation<'_>,
    options: &Options,
    form: Form,
    output: Option<PathBuf>,
    watch: &Watch,
) -> Result<(), Failure> {
    let all = |to: &mut dyn io::Write, paint: &dyn Fn(Role, &str) -> String| match form {
        Form::Json => explanation.json(options, to),
        Form::Text => to.write_all(explanation.text(options, paint).as_bytes()),
        Form::Markdown => to.write_all(explanation.markdown(options).as_bytes()),
        Form::Latex => to.write_all(explanation.latex(options).as_bytes()),
    };
    match output {
        None => output::streamed(|to, colored| all(to, if colored { &in_color } else { &plain })),
        Some(path) => {
            let files = [path.as_path()];
            watch.writing(files.into_iter(), || save(&path, |to| all(&mut &mut *to, &plain)))??;
            Ok(())
        }
    }
}

/// The colours of text on a terminal.
fn in_color(role: Role, text: &str) -> String {
    let code = match role {
        Role::Heading => "1",
        Role::Label => "2",
        Role::Formula => "36",
        Role::Bright => "32",
        Role::Dark => "33",
    };
    format!("\x1b[{code}m{text}\x1b[0m")
}

/// The pixel, if the picture has it.
fn within(PixelPlace { x, y }: PixelPlace, size: ImageSize) -> Result<[u32; 2], Failure> {
    let inside = |place: i64, side: u32| u32::try_from(place).ok().filter(|place| *place < side);
    if let (Some(x), Some(y)) = (inside(x, size.width()), inside(y, size.height())) {
        return Ok([x, y]);
    }
    let (width, height) = (size.width(), size.height());
    let (right, bottom) = (width - 1, height - 1);
    Err(Failure::usage(format!("--pixel {x},{y} lies outside the picture of {width}x{height} pixels"))
        .hint(format!("columns go from 0 to {right}, rows from 0 to {bottom}; --size WxH makes another picture")))
}

/// The samples to show, if there are such.
fn shown(asked: Shown, rays: u32) -> Result<Samples, Failure> {
    match asked {
        Shown::All => Ok(Samples::All),
        Shown::One(number) if number < rays => Ok(Samples::One(number)),
        Shown::One(number) => {
            let last = rays - 1;
            let text = format!("--sample {number}: the pixel has {rays} samples, 0 to {last}");
            Err(Failure::usage(text).hint("--antialiasing N or --depth-of-field N makes more"))
        }
    }
}

fn failed(error: ExplainError) -> Failure {
    let code = match error {
        ExplainError::OutsidePicture { .. } => Code::Usage,
        ExplainError::TooManyRays => Code::Limit,
        ExplainError::Stopped => Code::Interrupted,
    };
    Failure::new(code, error.to_string())
}
