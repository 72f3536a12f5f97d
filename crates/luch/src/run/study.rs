//! `luch study`: plan, measure, write.

use crate::args::{StudyArgs, StudyCommand};
use crate::exit::{Code, Failure};
use crate::meaning;
use crate::progress::{Meter, Stages};
use crate::signals::Watch;
use crate::{output, source};
use luch_render::RenderError;
use luch_study::{
    Effort, Findings, Kind, Language, Plan, Study, StudyProgress, Subject, files, run as measure, sentences,
};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

pub(crate) fn run(command: StudyCommand, watch: &Watch) -> Result<(), Failure> {
    let (plan, args) = plan_of(command, watch)?;
    let study = Study::new(plan).map_err(|error| Failure::usage(error.to_string()))?;
    let folder = Folder::make(&args.output)?;
    let paths: Vec<PathBuf> =
        files::names(study.plan().kind()).into_iter().map(|name| args.output.join(name)).collect();
    paths.iter().try_for_each(|path| luch_io::check_writable(path))?;

    let stages = Stages::new(args.quiet);
    let progress = Arc::new(StudyProgress::new());
    let work = || measure(&study, &progress, &mut |_| {});
    let work = || stages.during("measuring", Some(Meter::Study(&progress)), work);
    let record = watch.studying(&progress, work)?.map_err(|error| failed(&error))?;
    if record.measurements.is_empty() {
        // Only a signal ends a study before its first result.
        watch.check()?;
    }

    let language = args.language.unwrap_or_else(|| Language::of_system(|name| std::env::var(name).ok()));
    let findings = Findings::of(&record);
    let write = || -> Result<(), Failure> {
        let contents = files::files(&findings, language).map_err(|text| Failure::new(Code::Internal, text))?;
        Ok(files::write(&args.output, &contents)?)
    };
    watch.writing_the_rest(paths.iter().map(PathBuf::as_path), || stages.during("writing", None, write))?;
    folder.keep();
    if record.partial {
        return Err(stopped(watch, &args.output));
    }
    if args.quiet { Ok(()) } else { output::result(&summary(&findings, language, &args.output)) }
}

/// The plan that was typed, its scenes loaded.
fn plan_of(command: StudyCommand, watch: &Watch) -> Result<(Plan, StudyArgs), Failure> {
    let all_threads = |asked| meaning::threads(asked) as u64;
    Ok(match command {
        StudyCommand::Threads(args) => {
            let effort = effort(Kind::Threads, &args.common)?;
            let threads = args.threads.map_or_else(|| Plan::THREADS.to_vec(), |list| list.0);
            let subjects = subjects(&args.scene, &Subject::SPHERES, &args.common, watch)?;
            (Plan::Threads { subjects, threads, effort }, args.common)
        }
        StudyCommand::Triangles(args) => {
            let effort = effort(Kind::Triangles, &args.common)?;
            let triangles = args.triangles.map_or_else(|| Plan::TRIANGLES.to_vec(), |list| list.0);
            (Plan::Triangles { triangles, threads: all_threads(args.threads), effort }, args.common)
        }
        StudyCommand::Rays(args) => {
            let effort = effort(Kind::Rays, &args.common)?;
            let rays = args.rays.map_or_else(|| Plan::RAYS.to_vec(), |list| list.0);
            let reference = args.reference.map_or(Plan::REFERENCE, u64::from);
            let (threads, effect) = (all_threads(args.threads), args.effect);
            let subjects = subjects(&args.scene, &["two-spheres"], &args.common, watch)?;
            (Plan::Rays { subjects, rays, reference, effect, threads, effort }, args.common)
        }
        StudyCommand::Tiles(args) => {
            let effort = effort(Kind::Tiles, &args.common)?;
            let tiles = args.tiles.map_or_else(|| Plan::TILES.to_vec(), |list| list.0);
            let subjects = subjects(&args.scene, &["two-spheres"], &args.common, watch)?;
            (Plan::Tiles { subjects, tiles, threads: all_threads(args.threads), effort }, args.common)
        }
    })
}

fn effort(kind: Kind, args: &StudyArgs) -> Result<Effort, Failure> {
    let usual = Effort::of(kind);
    Ok(Effort {
        runs: args.runs.unwrap_or(usual.runs),
        warm_up: args.warm_up.unwrap_or(usual.warm_up),
        size: args.size.unwrap_or(usual.size),
        simd: meaning::available(args.simd)?,
    })
}

/// The scenes that were named, or the usual ones.
fn subjects(named: &[PathBuf], usual: &[&str], args: &StudyArgs, watch: &Watch) -> Result<Vec<Subject>, Failure> {
    let usual = || usual.iter().map(PathBuf::from).collect();
    let names: Vec<PathBuf> = if named.is_empty() { usual() } else { named.to_vec() };
    let load = |name: &PathBuf| {
        let loaded = source::load(name, None, watch).map_err(|failure| watch.check().err().unwrap_or(failure))?;
        if !args.quiet {
            loaded.warnings.iter().for_each(|line| output::warning(line));
        }
        Ok(Subject { id: name.display().to_string(), scene: loaded.scene })
    };
    names.iter().map(load).collect()
}

fn failed(error: &RenderError) -> Failure {
    let code = if matches!(error, RenderError::Internal { .. }) { Code::Internal } else { Code::Render };
    Failure::new(code, error.to_string())
}

/// The failure of a study that was stopped and has written what it had.
fn stopped(watch: &Watch, folder: &Path) -> Failure {
    let code = watch.check().err().map_or(Code::Interrupted, |failure| failure.code);
    let by = if code == Code::Terminated { "SIGTERM" } else { "Ctrl-C" };
    let text = format!("stopped by {by}: the runs made until then are in {}, marked as partial", folder.display());
    Failure::new(code, text)
}

fn summary(findings: &Findings, language: Language, folder: &Path) -> String {
    let mut lines = sentences(findings, language);
    lines.push(folder.join("study.md").display().to_string());
    lines.join("\n") + "\n"
}

/// The folder of a study: if it was made for a run that fails, it goes again.
struct Folder<'a> {
    path: &'a Path,
    made: bool,
}

impl<'a> Folder<'a> {
    fn make(path: &'a Path) -> Result<Self, Failure> {
        Ok(Self { path, made: files::make_folder(path)? })
    }

    fn keep(mut self) {
        self.made = false;
    }
}

impl Drop for Folder<'_> {
    fn drop(&mut self) {
        if self.made {
            // Succeeds only if it is empty, and if not, somebody wants it.
            let _ = fs::remove_dir(self.path);
        }
    }
}
