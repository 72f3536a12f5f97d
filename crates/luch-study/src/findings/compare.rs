//! Works out what the measurements say: cases beside each other, laws, exponents.

use super::{CaseFindings, Exponent, Grows, Growth, SceneName, Setting, Times};
use crate::amdahl::Amdahl;
use crate::plan::Kind;
use crate::run::{Measurement, Record};
use crate::statistics::{Line, Summary};

/// The times of each case that was run at least once.
pub(super) fn measured(record: &Record, setting: &Setting) -> Vec<CaseFindings> {
    let mut cases = Vec::new();
    for (number, case) in record.study.cases().iter().enumerate() {
        let runs: Vec<&Measurement> = record.measurements.iter().filter(|m| m.case == number).collect();
        let Some(render) = Times::of(runs.iter().map(|m| m.render_ms).collect()) else { continue };
        let cpu: Vec<f64> = runs.iter().filter_map(|m| m.cpu_ms).collect();
        let rays = runs.first().map_or(0, |m| m.rays);
        let most_started = runs.iter().map(|m| m.threads_started).max().unwrap_or(0);
        // All meshes of the study of triangles are one scene.
        let scene = setting.scenes.get(case.subject).or(setting.scenes.first());
        cases.push(CaseFindings {
            scene: scene.map(|s| s.id.clone()).unwrap_or_default(),
            threads: case.threads,
            triangles: case.triangles,
            rays_per_pixel: case.rays_per_pixel,
            tile_size: case.tile_size,
            rays_per_s: (rays as f64 / (render.summary_ms.median / 1e3).max(1e-9)).round(),
            render,
            cpu_ms: Summary::of(&cpu).map(|s| decimals(s.median)),
            build: Times::of(runs.iter().filter_map(|m| m.build_ms).collect()),
            rays,
            threads_started: u32::try_from(most_started).unwrap_or(u32::MAX),
            noise_rmse: runs.iter().find_map(|m| m.noise_rmse),
            speed_up: None,
            efficiency: None,
            over_cores_percent: None,
            growth_percent: None,
            over_best_percent: None,
        });
    }
    cases
}

pub(super) fn cases_of<'a>(cases: &'a [CaseFindings], scene: &'a str) -> impl Iterator<Item = &'a CaseFindings> {
    cases.iter().filter(move |case| case.scene == scene)
}

/// Sets the cases of a scene beside those with one thread and with as many as cores, and beside the first scene.
pub(super) fn with_cores_and_first(cases: &mut [CaseFindings], setting: &Setting, cores: u32) {
    let known = cases.to_vec();
    let first = setting.scenes.first().map(|s| s.id.as_str()).unwrap_or_default();
    for case in cases {
        let of_scene = |threads| cases_of(&known, &case.scene).find(move |c| c.threads == threads);
        if let Some(one) = of_scene(1) {
            let speed_up = one.median_ms() / case.median_ms();
            case.speed_up = Some(decimals(speed_up));
            case.efficiency = Some(decimals(speed_up / f64::from(case.threads)));
        }
        if case.threads > cores {
            let full = cases_of(&known, &case.scene).filter(|c| c.threads <= cores).max_by_key(|c| c.threads);
            case.over_cores_percent = full.map(|full| percent_over(case.median_ms(), full.median_ms()));
        }
        if case.scene != first {
            let other = cases_of(&known, first).find(|c| c.threads == case.threads);
            case.growth_percent = other.map(|other| percent_over(case.median_ms(), other.median_ms()));
        }
    }
}

/// Sets the cases of a scene beside its best.
pub(super) fn with_best(cases: &mut [CaseFindings]) {
    let known = cases.to_vec();
    for case in cases {
        let best = cases_of(&known, &case.scene).map(CaseFindings::median_ms).min_by(f64::total_cmp);
        case.over_best_percent = best.map(|best| percent_over(case.median_ms(), best));
    }
}

pub(super) fn laws(cases: &[CaseFindings], setting: &Setting, cores: u32) -> Vec<Amdahl> {
    let law = |scene: &SceneName| {
        let points: Vec<(u32, f64)> = cases_of(cases, &scene.id).map(|c| (c.threads, c.median_ms())).collect();
        let law = Amdahl::fit(&scene.id, &points, cores)?;
        let (one_thread_ms, serial_share) = (decimals(law.one_thread_ms), decimals(law.serial_share));
        Some(Amdahl { one_thread_ms, serial_share, ..law })
    };
    setting.scenes.iter().filter_map(law).collect()
}

pub(super) fn growths(cases: &[CaseFindings], setting: &Setting) -> Vec<Growth> {
    let Some((first, others)) = setting.scenes.split_first() else { return Vec::new() };
    let growth = |other: &SceneName| {
        let percents: Vec<f64> = cases_of(cases, &other.id).filter_map(|c| c.growth_percent).collect();
        let mean = percents.iter().sum::<f64>() / percents.len() as f64;
        // No number if there are no percents.
        mean.is_finite().then(|| Growth { from: first.id.clone(), to: other.id.clone(), mean_percent: decimals(mean) })
    };
    others.iter().filter_map(growth).collect()
}

pub(super) fn exponents(kind: Kind, cases: &[CaseFindings], setting: &Setting) -> Vec<Exponent> {
    let fit = |scene: Option<&SceneName>, of: Grows, point: &dyn Fn(&CaseFindings) -> Option<(f64, f64)>| {
        let points: Vec<(f64, f64)> =
            cases.iter().filter(|c| scene.is_none_or(|s| s.id == c.scene)).filter_map(point).collect();
        let exponent = decimals(Line::power_law(&points)?);
        Some(Exponent { scene: scene.map(|s| s.id.clone()), of, exponent })
    };
    match kind {
        Kind::Threads | Kind::Tiles => Vec::new(),
        Kind::Triangles => [
            fit(None, Grows::Build, &|c| Some((c.triangles as f64, c.build.as_ref()?.summary_ms.median))),
            fit(None, Grows::Render, &|c| Some((c.triangles as f64, c.median_ms()))),
        ]
        .into_iter()
        .flatten()
        .collect(),
        Kind::Rays => {
            let of_scene = |scene| {
                let rays = |c: &CaseFindings| f64::from(c.rays_per_pixel);
                [
                    fit(Some(scene), Grows::Render, &|c| Some((rays(c), c.median_ms()))),
                    fit(Some(scene), Grows::Noise, &|c| Some((rays(c), c.noise_rmse?))),
                ]
            };
            setting.scenes.iter().flat_map(of_scene).flatten().collect()
        }
    }
}

fn percent_over(value: f64, base: f64) -> f64 {
    decimals((value / base - 1.0) * 100.0)
}

/// With four decimals: more would say nothing. What has no number, as after a division by zero, is 0.
pub(super) fn decimals(value: f64) -> f64 {
    let rounded = (value * 1e4).round() / 1e4;
    if rounded.is_finite() { rounded } else { 0.0 }
}
