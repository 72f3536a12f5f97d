//! What the measurements say: plain data, the one source of reports, files, plots and panels.

mod compare;

use crate::amdahl::Amdahl;
use crate::machine::Machine;
use crate::plan::{Effect, Effort, Kind, Plan};
use crate::published::Published;
use crate::run::Record;
use crate::statistics::Summary;
use compare::decimals;
use serde::{Deserialize, Serialize};

/// Everything that came of a study. As JSON it is the content of `study.json`; docs/study.md explains each key.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Findings {
    /// The version of this form, [`Findings::FORMAT`].
    pub luch_study: u32,
    /// The question.
    pub study: Kind,
    /// Whether it was stopped before its end.
    pub partial: bool,
    /// When it began, as `2026-08-02T17:05:09Z`.
    pub began: String,
    /// On what.
    pub machine: Machine,
    /// How.
    pub setting: Setting,
    /// What was measured, in the order of the plan; cases without a counted run are left out.
    pub cases: Vec<CaseFindings>,
    /// For threads: the law of each scene.
    pub amdahl: Vec<Amdahl>,
    /// For threads: what each scene costs more than the first.
    pub growth: Vec<Growth>,
    /// For triangles and rays: how times and noise grow.
    pub exponents: Vec<Exponent>,
    /// For threads: the published study.
    pub published: Option<Published>,
}

/// How a study was made.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Setting {
    /// The scenes.
    pub scenes: Vec<SceneName>,
    /// Width and height of the pictures in pixels.
    pub size: [u32; 2],
    /// Counted runs that each case was to have.
    pub runs: u32,
    /// Runs of each case before.
    pub warm_up: u32,
    /// For rays: what they are spread over.
    pub effect: Option<Effect>,
    /// For rays: those of the picture that stands for the truth.
    pub reference_rays: Option<u32>,
}

/// What a scene is called.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SceneName {
    /// The id of a built-in scene, or the path of a file.
    pub id: String,
    /// Its name for people.
    pub name: String,
}

/// What was found for one case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CaseFindings {
    /// The scene, by its id.
    pub scene: String,
    /// Threads.
    pub threads: u32,
    /// Triangles of the scene.
    pub triangles: u64,
    /// Rays through each pixel.
    pub rays_per_pixel: u32,
    /// Side of the tiles in pixels.
    pub tile_size: u32,
    /// The time to render.
    pub render: Times,
    /// The median of the CPU time that all threads took together, in milliseconds.
    pub cpu_ms: Option<f64>,
    /// For triangles: the time to make the scene ready.
    pub build: Option<Times>,
    /// The most threads that took part in a run: those beyond the cores begin only when a picture takes long enough to be
    /// worth it.
    pub threads_started: u32,
    /// Rays traced for one picture.
    pub rays: u64,
    /// Rays a second, in the median run.
    pub rays_per_s: f64,
    /// For rays: the noise, a difference of linear light.
    pub noise_rmse: Option<f64>,
    /// For threads: how many times as fast as with one thread.
    pub speed_up: Option<f64>,
    /// For threads: the speed-up for each thread, 1 being perfect.
    pub efficiency: Option<f64>,
    /// For threads, where there are more than cores: how much longer it takes than with the most that were measured and have a
    /// core each, in percent.
    pub over_cores_percent: Option<f64>,
    /// For threads: how much longer it takes than the first scene with as many threads, in percent.
    pub growth_percent: Option<f64>,
    /// For tiles: how much longer it takes than with the best side, in percent.
    pub over_best_percent: Option<f64>,
}

/// Times of several runs, in milliseconds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Times {
    /// What they are like.
    pub summary_ms: Summary,
    /// Each, in the order of the rounds.
    pub runs_ms: Vec<f64>,
}

/// What a scene costs more than the first.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Growth {
    /// The first scene, by its id.
    pub from: String,
    /// The other.
    pub to: String,
    /// The mean over all numbers of threads, in percent.
    pub mean_percent: f64,
}

/// What grows by a power of what is varied.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Grows {
    /// The time to render.
    Render,
    /// The time to make the scene ready.
    Build,
    /// The noise.
    Noise,
}

/// The exponent e of the power law y = c x^e that fits best where both axes are logarithmic.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Exponent {
    /// The scene, by its id; `None` where each value has a scene of its own.
    pub scene: Option<String>,
    /// What grows.
    pub of: Grows,
    /// The exponent.
    pub exponent: f64,
}

impl Findings {
    /// The form that this program writes and reads.
    pub const FORMAT: u32 = 1;

    /// What a record says, finished or not.
    #[must_use]
    pub fn of(record: &Record) -> Self {
        let plan = record.study.plan();
        let kind = plan.kind();
        let setting = Setting::of(plan);
        let mut cases = compare::measured(record, &setting);
        let cores = record.machine.cores_for_threads();
        match kind {
            Kind::Threads => compare::with_cores_and_first(&mut cases, &setting, cores),
            Kind::Tiles => compare::with_best(&mut cases),
            Kind::Triangles | Kind::Rays => {}
        }
        let threads_only = kind == Kind::Threads;
        Self {
            luch_study: Self::FORMAT,
            study: kind,
            partial: record.partial,
            began: record.began.clone(),
            machine: record.machine.clone(),
            amdahl: if threads_only { compare::laws(&cases, &setting, cores) } else { Vec::new() },
            growth: if threads_only { compare::growths(&cases, &setting) } else { Vec::new() },
            exponents: compare::exponents(kind, &cases, &setting),
            published: threads_only.then(Published::study),
            setting,
            cases,
        }
    }

    /// The cases of one scene, in the order of the plan.
    pub fn cases_of<'a>(&'a self, scene: &'a str) -> impl Iterator<Item = &'a CaseFindings> {
        compare::cases_of(&self.cases, scene)
    }

    /// The largest number of threads that was measured and has a core for each; what more threads cost is told against it.
    #[must_use]
    pub fn most_threads_with_cores(&self) -> Option<u32> {
        let cores = self.machine.cores_for_threads();
        self.cases.iter().map(|case| case.threads).filter(|threads| *threads <= cores).max()
    }

    /// The largest cost of more threads than cores, in percent, over all scenes; `None` if none was measured.
    #[must_use]
    pub fn worst_over_cores_percent(&self) -> Option<f64> {
        self.cases.iter().filter_map(|case| case.over_cores_percent).max_by(f64::total_cmp)
    }
}

impl Setting {
    fn of(plan: &Plan) -> Self {
        let Effort { runs, warm_up, size, .. } = *plan.effort();
        let (effect, reference_rays) = match plan {
            Plan::Rays { effect, reference, .. } => (Some(*effect), u32::try_from(*reference).ok()),
            _ => (None, None),
        };
        let name = |s: &crate::Subject| SceneName { id: s.id.clone(), name: s.scene.name.clone() };
        let scenes = match plan {
            Plan::Triangles { .. } => vec![SceneName { id: MESHES.to_owned(), name: "Bumpy sphere".to_owned() }],
            _ => plan.subjects().iter().map(name).collect(),
        };
        Self { scenes, size: [size.width(), size.height()], runs, warm_up, effect, reference_rays }
    }
}

/// The id of the meshes that the study of triangles makes.
const MESHES: &str = "bumpy-sphere";

impl Times {
    fn of(runs_ms: Vec<f64>) -> Option<Self> {
        let Summary { median, lower_quartile, upper_quartile, minimum, maximum } = Summary::of(&runs_ms)?;
        let summary_ms = Summary {
            median: decimals(median),
            lower_quartile: decimals(lower_quartile),
            upper_quartile: decimals(upper_quartile),
            minimum: decimals(minimum),
            maximum: decimals(maximum),
        };
        Some(Self { summary_ms, runs_ms })
    }
}

impl CaseFindings {
    /// The median time to render, in milliseconds.
    #[must_use]
    pub const fn median_ms(&self) -> f64 {
        self.render.summary_ms.median
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn threads_are_set_beside_one_thread_the_cores_and_the_first_scene() {
        // Medians: one sphere 100, 50, 60; two spheres 110, 60, 90, on a machine of two cores.
        let findings = Findings::of(&samples::threads());
        let medians: Vec<f64> = findings.cases.iter().map(CaseFindings::median_ms).collect();
        assert_eq!(medians, [100.0, 50.0, 60.0, 110.0, 60.0, 90.0]);
        let two = &findings.cases[4];
        assert_eq!((two.scene.as_str(), two.threads), ("two-spheres", 2));
        assert_eq!((two.speed_up, two.efficiency), (Some(1.8333), Some(0.9167)));
        assert_eq!((two.growth_percent, two.over_cores_percent), (Some(20.0), None));
        assert_eq!(findings.cases[2].over_cores_percent, Some(20.0));
        assert_eq!(findings.cases[2].growth_percent, None, "the first scene is what the others are set beside");
        assert_eq!(findings.worst_over_cores_percent(), Some(50.0));
        // 10, 20 and 50 percent.
        assert_eq!(findings.growth[0].mean_percent, 26.6667);
        // Exact through two points: 100 = a + b, 50 = a + b / 2.
        assert_eq!((findings.amdahl[0].serial_share, findings.amdahl[0].one_thread_ms), (0.0, 100.0));
        // 110 = a + b, 60 = a + b / 2: a = 10.
        assert_eq!(findings.amdahl[1].serial_share, 0.0909);
    }

    #[test]
    fn cases_without_a_run_are_left_out_of_partial_findings() {
        let mut record = samples::threads();
        record.partial = true;
        record.measurements.retain(|m| m.case == 1);
        let findings = Findings::of(&record);
        assert!(findings.partial);
        assert_eq!(findings.cases.len(), 1);
        let case = &findings.cases[0];
        assert_eq!((case.threads, case.speed_up, case.over_cores_percent), (2, None, None));
        assert!(findings.amdahl.is_empty() && findings.growth.is_empty());
        record.measurements.clear();
        assert!(Findings::of(&record).cases.is_empty());
    }

    #[test]
    fn tiles_are_set_beside_the_best() {
        let findings = Findings::of(&samples::tiles());
        let over: Vec<Option<f64>> = findings.cases.iter().map(|c| c.over_best_percent).collect();
        assert_eq!(over, [Some(25.0), Some(0.0), Some(10.0)]);
        assert!(findings.published.is_none());
    }

    #[test]
    fn times_and_noise_have_their_exponents() {
        let of = |findings: &Findings, of: Grows| findings.exponents.iter().find(|e| e.of == of).unwrap().exponent;
        // Noise halves with four times the rays; the time grows as they do.
        let findings = Findings::of(&samples::rays());
        assert_eq!((of(&findings, Grows::Noise), of(&findings, Grows::Render)), (-0.5, 1.0));
        assert_eq!(findings.exponents[0].scene.as_deref(), Some("one-sphere"));
        let findings = Findings::of(&samples::triangles());
        assert_eq!(findings.exponents.len(), 2);
        assert!((of(&findings, Grows::Build) - 1.0).abs() < 0.1, "{:?}", findings.exponents);
        assert_eq!(findings.setting.scenes[0].id, "bumpy-sphere");
        assert!(findings.cases.iter().all(|c| c.scene == "bumpy-sphere" && c.build.is_some()));
    }
}
