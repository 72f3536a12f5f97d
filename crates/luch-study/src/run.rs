//! Carries a study out: warm-up, then round after round in a balanced order, one run at a time.

use crate::case::Case;
use crate::clock::{Stopwatch, utc_now};
use crate::machine::Machine;
use crate::order::order;
use crate::plan::{Effect, Effort, Plan};
use crate::progress::StudyProgress;
use crate::study::Study;
use crate::subject::Subject;
use luch_render::{CompiledScene, Film, MeshTrees, RenderError, RenderJob, compile, render};
use luch_scene::{RayCount, Sampling, Scene};

/// One run of one case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measurement {
    /// Which case, by its place in [`Study::cases`].
    pub case: usize,
    /// Which round, from 0.
    pub round: u32,
    /// Milliseconds that the render took.
    pub render_ms: f64,
    /// Milliseconds that the threads of this process worked meanwhile, if the system tells.
    pub cpu_ms: Option<f64>,
    /// Milliseconds that making the scene ready took, where that is measured.
    pub build_ms: Option<f64>,
    /// Rays traced.
    pub rays: u64,
    /// Threads that took part: those beyond the cores begin only when a picture takes long enough to be worth it.
    pub threads_started: u64,
    /// Root of the mean squared difference of linear light from the reference, over all pixels and colours; in the first
    /// round, where noise is measured: all runs of a case make the same picture, bit for bit.
    pub noise_rmse: Option<f64>,
}

/// All that came of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Record {
    /// What was asked for.
    pub study: Study,
    /// On what.
    pub machine: Machine,
    /// When it began, as `2026-08-02T17:05:09Z`.
    pub began: String,
    /// Whether it was stopped before its end.
    pub partial: bool,
    /// The counted runs, in the order in which they were made.
    pub measurements: Vec<Measurement>,
}

impl Record {
    /// The record of a study that begins now, on this machine. Partial until somebody says otherwise.
    #[must_use]
    pub fn begin(study: &Study) -> Self {
        let machine = Machine::this(study.plan().effort().simd);
        Self { study: study.clone(), machine, began: utc_now(), partial: true, measurements: Vec::new() }
    }
}

/// Carries out a study and answers with what was measured; after [`StudyProgress::cancel`], with what was measured so far.
///
/// `on_result` is called on this thread, between two runs, with each counted run: what it does is not measured, but it
/// delays the next. To show results as they come, add them to a [`Record::begin`] of one's own.
///
/// # Errors
/// A bug of the renderer; nothing else goes wrong.
pub fn run(
    study: &Study,
    progress: &StudyProgress,
    on_result: &mut dyn FnMut(&Measurement),
) -> Result<Record, RenderError> {
    let mut record = Record::begin(study);
    progress.begin(samples(study));
    match measure(study, progress, &mut |measurement| {
        on_result(&measurement);
        record.measurements.push(measurement);
    }) {
        Ok(()) => record.partial = false,
        Err(RenderError::Cancelled) => {}
        Err(error) => return Err(error),
    }
    Ok(record)
}

/// Samples of pixels that a study makes.
fn samples(study: &Study) -> u64 {
    let effort = study.plan().effort();
    let rounds = u64::from(effort.runs) + u64::from(effort.warm_up);
    let per_pixel: u64 = study.cases().iter().map(|case| u64::from(case.rays_per_pixel)).sum();
    let reference = match study.plan() {
        Plan::Rays { subjects, reference, .. } => subjects.len() as u64 * reference,
        _ => 0,
    };
    effort.size.pixels().saturating_mul(rounds.saturating_mul(per_pixel).saturating_add(reference))
}

/// Measures to the end or the wish to stop.
fn measure(study: &Study, progress: &StudyProgress, told: &mut dyn FnMut(Measurement)) -> Result<(), RenderError> {
    let scenes = Prepared::all(study, progress)?;
    let (cases, Effort { runs, warm_up, .. }) = (study.cases(), *study.plan().effort());
    let one = |number: usize| {
        let case = &cases[number];
        scenes[case.subject].run(study, case, progress)
    };
    for round in 0..warm_up {
        for number in order(cases.len(), round as usize) {
            one(number)?;
        }
    }
    for round in 0..runs {
        for number in order(cases.len(), round as usize) {
            let Run { film, render_ms, cpu_ms, build_ms, rays, threads_started } = one(number)?;
            let reference = scenes[cases[number].subject].reference.as_ref().filter(|_| round == 0);
            let noise_rmse = reference.map(|truth| rmse(&film.linear(), truth));
            // Given back before the next run, which may want the same memory.
            drop(film);
            told(Measurement { case: number, round, render_ms, cpu_ms, build_ms, rays, threads_started, noise_rmse });
        }
    }
    Ok(())
}

/// A scene that is ready to be measured.
struct Prepared {
    scene: Scene,
    /// `None` where making it ready is measured with every run.
    compiled: Option<CompiledScene>,
    /// The picture that stands for the truth, where noise is measured.
    reference: Option<Vec<f32>>,
}

/// What one run gave.
struct Run {
    film: Film,
    render_ms: f64,
    cpu_ms: Option<f64>,
    build_ms: Option<f64>,
    rays: u64,
    threads_started: u64,
}

impl Prepared {
    /// Makes every scene of the study ready.
    fn all(study: &Study, progress: &StudyProgress) -> Result<Vec<Self>, RenderError> {
        let plain = |subject: &Subject| {
            let compiled = compile(&subject.scene, &mut MeshTrees::new(), usable_threads());
            Self { scene: subject.scene.clone(), compiled: Some(compiled), reference: None }
        };
        match study.plan() {
            Plan::Threads { subjects, .. } | Plan::Tiles { subjects, .. } => Ok(subjects.iter().map(plain).collect()),
            Plan::Triangles { triangles, .. } => {
                let make = |&about: &u64| {
                    // Making millions of triangles takes a while.
                    if progress.is_cancelled() {
                        return Err(RenderError::Cancelled);
                    }
                    Ok(Self { scene: Subject::bumpy_sphere(about).scene, compiled: None, reference: None })
                };
                triangles.iter().map(make).collect()
            }
            Plan::Rays { subjects, reference, threads, .. } => {
                let make = |(subject, own): (usize, &Subject)| {
                    let mut prepared = plain(own);
                    let [threads, rays_per_pixel] = [*threads, *reference].map(|n| u32::try_from(n).unwrap_or(1));
                    let case = Case { subject, threads, triangles: 0, rays_per_pixel, tile_size: RenderJob::TILE_SIZE };
                    prepared.reference = Some(prepared.run(study, &case, progress)?.film.linear());
                    Ok(prepared)
                };
                subjects.iter().enumerate().map(make).collect()
            }
        }
    }

    /// One run of a case.
    fn run(&self, study: &Study, case: &Case, progress: &StudyProgress) -> Result<Run, RenderError> {
        let job = job(&self.scene, study.plan(), case);
        let current = progress.begin_render().ok_or(RenderError::Cancelled)?;
        let building = Stopwatch::start();
        let fresh;
        let (compiled, build_ms) = match &self.compiled {
            Some(compiled) => (compiled, None),
            None => {
                fresh = compile(&self.scene, &mut MeshTrees::new(), job.threads);
                (&fresh, Some(building.wall_ms()))
            }
        };
        let rendering = Stopwatch::start();
        let outcome = render(compiled, &job, &current);
        let (render_ms, cpu_ms) = (rendering.wall_ms(), rendering.cpu_ms());
        progress.end_render();
        let (rays, threads_started) = (current.rays(), current.threads());
        Ok(Run { film: outcome?, render_ms, cpu_ms, build_ms, rays, threads_started })
    }
}

/// The job of a case: the scene's own settings, but for what the study varies.
fn job(scene: &Scene, plan: &Plan, case: &Case) -> RenderJob {
    let Effort { size, simd, .. } = *plan.effort();
    let mut job = RenderJob::of_scene(scene, 0);
    (job.size, job.simd, job.tile_size, job.threads) = (size, simd, case.tile_size, case.threads as usize);
    if let Plan::Rays { effect, .. } = plan {
        // Checked with the plan.
        let rays = RayCount::new(case.rays_per_pixel).unwrap_or(RayCount::ONE);
        let sampling = |on| Sampling { on, rays };
        job.antialiasing = sampling(*effect != Effect::DepthOfField);
        job.depth_of_field = sampling(*effect != Effect::Antialiasing);
    }
    job
}

fn usable_threads() -> usize {
    std::thread::available_parallelism().map_or(1, std::num::NonZero::get)
}

/// Root of the mean squared difference.
fn rmse(picture: &[f32], truth: &[f32]) -> f64 {
    let squares = picture.iter().zip(truth).map(|(a, b)| (f64::from(*a) - f64::from(*b)).powi(2)).sum::<f64>();
    (squares / picture.len().max(1) as f64).sqrt()
}
