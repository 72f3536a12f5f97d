//! A plan that was checked: what is measured, case by case.

use crate::bumpy_sphere;
use crate::case::Case;
use crate::plan::{Effort, Kind, MAX_PIXELS, MAX_VALUES, Plan, RAYS, RUNS, THREADS, TILES, TRIANGLES, WARM_UP};
use crate::plan_error::{PlanError, Quantity};
use crate::subject::Subject;
use luch_render::RenderJob;
use std::ops::RangeInclusive;

/// A plan that can be carried out.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    plan: Plan,
    cases: Vec<Case>,
}

impl Study {
    /// Checks a plan.
    ///
    /// # Errors
    /// [`PlanError`] says the first thing that is wrong.
    pub fn new(plan: Plan) -> Result<Self, PlanError> {
        check_effort(plan.effort())?;
        if plan.kind() != Kind::Triangles {
            check_subjects(plan.subjects())?;
        }
        let cases = match &plan {
            Plan::Threads { subjects, threads, .. } => {
                check_list(Quantity::Threads, threads, &THREADS)?;
                cases(subjects, threads, |case, &threads| case.threads = whole(threads))
            }
            Plan::Triangles { triangles, threads, .. } => {
                check(Quantity::Threads, *threads, &THREADS)?;
                check_list(Quantity::Triangles, triangles, &TRIANGLES)?;
                cases_of_meshes(triangles, whole(*threads))?
            }
            Plan::Rays { subjects, rays, reference, threads, .. } => {
                check(Quantity::Threads, *threads, &THREADS)?;
                check_list(Quantity::Rays, rays, &RAYS)?;
                check(Quantity::Rays, *reference, &RAYS)?;
                let most = rays.iter().copied().max().unwrap_or(0);
                if *reference <= most {
                    return Err(PlanError::Reference { reference: *reference, most });
                }
                cases(subjects, rays, |case, &rays| {
                    (case.threads, case.rays_per_pixel) = (whole(*threads), whole(rays));
                })
            }
            Plan::Tiles { subjects, tiles, threads, .. } => {
                check(Quantity::Threads, *threads, &THREADS)?;
                check_list(Quantity::Tiles, tiles, &TILES)?;
                cases(subjects, tiles, |case, &side| (case.threads, case.tile_size) = (whole(*threads), whole(side)))
            }
        };
        Ok(Self { plan, cases })
    }

    /// What was asked for.
    #[must_use]
    pub const fn plan(&self) -> &Plan {
        &self.plan
    }

    /// What is measured, in the order of reports: the scenes one after another, the values of each in the order given.
    #[must_use]
    pub fn cases(&self) -> &[Case] {
        &self.cases
    }
}

/// A case for each value and scene.
fn cases<T>(subjects: &[Subject], values: &[T], vary: impl Fn(&mut Case, &T)) -> Vec<Case> {
    let mut cases = Vec::with_capacity(subjects.len() * values.len());
    for (subject, Subject { scene, .. }) in subjects.iter().enumerate() {
        for value in values {
            let mut case = Case {
                subject,
                threads: 1,
                triangles: scene.triangle_count(),
                rays_per_pixel: scene.settings.rays_per_pixel(),
                tile_size: RenderJob::TILE_SIZE,
            };
            vary(&mut case, value);
            cases.push(case);
        }
    }
    cases
}

/// A case for each mesh; its subject is the mesh of the same place in the list.
fn cases_of_meshes(wanted: &[u64], threads: u32) -> Result<Vec<Case>, PlanError> {
    let mut cases: Vec<Case> = Vec::with_capacity(wanted.len());
    for (subject, &about) in wanted.iter().enumerate() {
        let triangles = bumpy_sphere::triangles(about);
        if let Some(same) = cases.iter().position(|case| case.triangles == triangles) {
            return Err(PlanError::SameMesh { wanted: [wanted[same], about], triangles });
        }
        cases.push(Case { subject, threads, triangles, rays_per_pixel: 1, tile_size: RenderJob::TILE_SIZE });
    }
    Ok(cases)
}

/// A number that was checked to lie in one of the ranges above.
fn whole(value: u64) -> u32 {
    u32::try_from(value).unwrap_or(u32::MAX)
}

fn check(quantity: Quantity, value: u64, range: &RangeInclusive<u64>) -> Result<(), PlanError> {
    if range.contains(&value) {
        return Ok(());
    }
    Err(PlanError::OutOfRange { quantity, value, least: *range.start(), most: *range.end() })
}

fn check_list(quantity: Quantity, values: &[u64], range: &RangeInclusive<u64>) -> Result<(), PlanError> {
    if values.is_empty() {
        return Err(PlanError::NoValues(quantity));
    }
    if values.len() > MAX_VALUES {
        return Err(PlanError::TooManyValues { quantity, count: values.len() });
    }
    for (place, &value) in values.iter().enumerate() {
        check(quantity, value, range)?;
        if values[..place].contains(&value) {
            return Err(PlanError::Twice { quantity, value });
        }
    }
    Ok(())
}

fn check_effort(effort: &Effort) -> Result<(), PlanError> {
    check(Quantity::Runs, u64::from(effort.runs), &RUNS)?;
    check(Quantity::WarmUp, u64::from(effort.warm_up), &WARM_UP)?;
    if effort.size.pixels() > MAX_PIXELS {
        return Err(PlanError::TooLarge { width: effort.size.width(), height: effort.size.height() });
    }
    Ok(())
}

fn check_subjects(subjects: &[Subject]) -> Result<(), PlanError> {
    if subjects.is_empty() {
        return Err(PlanError::NoScene);
    }
    if subjects.len() > MAX_VALUES {
        return Err(PlanError::TooManyScenes { count: subjects.len() });
    }
    for (place, subject) in subjects.iter().enumerate() {
        if subjects[..place].iter().any(|earlier| earlier.id == subject.id) {
            return Err(PlanError::SceneTwice(subject.id.clone()));
        }
        if subject.scene.cameras.is_empty() {
            return Err(PlanError::NoCamera(subject.id.clone()));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan::Effect;
    use luch_scene::ImageSize;

    fn subjects(ids: &[&'static str]) -> Vec<Subject> {
        ids.iter().map(|id| Subject::built_in(id).unwrap()).collect()
    }

    fn threads(values: &[u64]) -> Plan {
        let subjects = subjects(&["one-sphere", "two-spheres"]);
        Plan::Threads { subjects, threads: values.to_vec(), effort: Effort::of(Kind::Threads) }
    }

    #[test]
    fn the_default_study_has_a_case_for_each_scene_and_count() {
        let study = Study::new(threads(&Plan::THREADS)).unwrap();
        assert_eq!(study.cases().len(), 18);
        let case = study.cases()[10];
        assert_eq!((case.subject, case.threads, case.rays_per_pixel, case.tile_size), (1, 2, 1, RenderJob::TILE_SIZE));
    }

    #[test]
    fn plans_that_make_no_sense_are_refused_with_the_reason() {
        let told = |plan: Plan| Study::new(plan).unwrap_err().to_string();
        assert_eq!(told(threads(&[])), "there is no number of threads to measure");
        assert_eq!(told(threads(&[1, 0])), "0 is not a number of threads from 1 to 1024");
        assert_eq!(told(threads(&[100_000])), "100000 is not a number of threads from 1 to 1024");
        assert_eq!(told(threads(&[1, 2, 1])), "the number of threads 1 is given twice");
        let many: Vec<u64> = (1..=65).collect();
        assert_eq!(told(threads(&many)), "65 numbers of threads are more than the 64 that a study may have");

        let with = |change: &dyn Fn(&mut Effort)| {
            let mut effort = Effort::of(Kind::Tiles);
            change(&mut effort);
            told(Plan::Tiles { subjects: subjects(&["one-sphere"]), tiles: vec![32], threads: 2, effort })
        };
        assert_eq!(with(&|e| e.runs = 0), "0 is not a number of runs from 1 to 10000");
        assert_eq!(with(&|e| e.warm_up = 1001), "1001 is not a number of warm-up runs from 0 to 1000");
        let large = ImageSize::new(65_535, 65_535).unwrap();
        assert!(with(&|e| e.size = large).starts_with("pictures of 65535x65535 pixels are too large for a study"));

        let rays = |reference| {
            let effort = Effort::of(Kind::Rays);
            let (subjects, rays) = (subjects(&["one-sphere"]), vec![1, 64]);
            told(Plan::Rays { subjects, rays, reference, effect: Effect::Both, threads: 1, effort })
        };
        assert!(rays(64).starts_with("the reference needs more rays per pixel than the 64"));
        assert_eq!(rays(5000), "5000 is not a number of rays per pixel from 1 to 4096");

        let effort = Effort::of(Kind::Threads);
        let scenes = |ids: &[&'static str]| told(Plan::Threads { subjects: subjects(ids), threads: vec![1], effort });
        assert_eq!(scenes(&[]), "there is no scene to measure");
        assert_eq!(scenes(&["one-sphere", "one-sphere"]), "the scene one-sphere is given twice");
        let mut blind = Subject::built_in("one-sphere").unwrap();
        blind.scene.cameras.clear();
        assert_eq!(
            told(Plan::Threads { subjects: vec![blind], threads: vec![1], effort }),
            "the scene one-sphere has no camera"
        );
    }

    #[test]
    fn meshes_that_would_be_the_same_are_refused() {
        let plan =
            |triangles| Study::new(Plan::Triangles { triangles, threads: 1, effort: Effort::of(Kind::Triangles) });
        assert!(plan(Plan::TRIANGLES.to_vec()).is_ok());
        let error = plan(vec![100_000, 100_001]).unwrap_err().to_string();
        assert!(error.starts_with("100000 and 100001 triangles would be the same mesh"), "{error}");
    }
}
