//! What is typed in, and the study that it means.

use crate::l10n::Texts;
use crate::preferences::cores;
use luch_io::builtin;
use luch_scene::{Aim, Camera, Direction, ImageSize, Point, Scene};
use luch_study::{Effect, Effort, Kind, Plan, Study, Subject};

/// What stands in the fields.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Form {
    pub(super) kind: Kind,
    pub(super) runs: String,
    pub(super) width: String,
    pub(super) height: String,
    /// The values of what is varied, with commas between them.
    pub(super) values: String,
    /// Threads, where something else is varied.
    pub(super) threads: String,
    /// Ids of the built-in scenes that are measured.
    pub(super) scenes: Vec<&'static str>,
}

impl Form {
    /// The study that the command line makes where nobody says otherwise.
    pub(super) fn of(kind: Kind) -> Self {
        let effort = Effort::of(kind);
        let values: &[u64] = match kind {
            Kind::Threads => &Plan::THREADS,
            Kind::Triangles => &Plan::TRIANGLES,
            Kind::Rays => &Plan::RAYS,
            Kind::Tiles => &Plan::TILES,
        };
        Self {
            kind,
            runs: effort.runs.to_string(),
            width: effort.size.width().to_string(),
            height: effort.size.height().to_string(),
            values: values.iter().map(u64::to_string).collect::<Vec<_>>().join(", "),
            threads: cores().to_string(),
            scenes: Subject::SPHERES.to_vec(),
        }
    }

    /// The scenes that can be chosen, and whether they are.
    pub(super) fn toggle(&mut self, id: &'static str, on: bool) {
        self.scenes.retain(|known| *known != id);
        if on {
            self.scenes.push(id);
        }
        // In the order of the built-in scenes, whatever was clicked first.
        self.scenes.sort_by_key(|id| {
            let spheres = Subject::SPHERES.iter().position(|known| known == id);
            spheres.unwrap_or_else(|| 2 + builtin::ids().position(|known| known == *id).unwrap_or(0))
        });
    }

    /// The study that it means, with empty scenes of the right names: reading those of models takes longer than a frame,
    /// and [`resolve`] does it elsewhere.
    ///
    /// # Errors
    /// What is wrong, in the language of the window.
    pub(super) fn plan(&self, texts: &Texts, language: luch_study::Language) -> Result<Plan, String> {
        let side = |text: &str| number(text, texts).map(|side| u32::try_from(side).unwrap_or(u32::MAX));
        let size = ImageSize::new(side(&self.width)?, side(&self.height)?).map_err(|_| texts.study_size_wrong())?;
        let runs = u32::try_from(number(&self.runs, texts)?).unwrap_or(u32::MAX);
        let effort = Effort { runs, size, ..Effort::of(self.kind) };
        let values = list(&self.values, texts)?;
        let threads = if self.kind == Kind::Threads { 1 } else { number(&self.threads, texts)? };
        let subjects = if self.kind == Kind::Triangles { &[][..] } else { &self.scenes };
        let subjects = subjects.iter().copied().map(stand_in).collect();
        let plan = match self.kind {
            Kind::Threads => Plan::Threads { subjects, threads: values, effort },
            Kind::Triangles => Plan::Triangles { triangles: values, threads, effort },
            Kind::Rays => {
                let (reference, effect) = (Plan::REFERENCE, Effect::Antialiasing);
                Plan::Rays { subjects, rays: values, reference, effect, threads, effort }
            }
            Kind::Tiles => Plan::Tiles { subjects, tiles: values, threads, effort },
        };
        Study::new(plan.clone()).map_err(|error| error.text(language))?;
        Ok(plan)
    }
}

/// What is known of a scene before it is read.
fn stand_in(id: &'static str) -> Subject {
    let mut scene = Scene::new(id);
    scene.cameras.push(Camera::new(id, Point::ORIGIN, Aim::Along(Direction::UP)));
    Subject { id: id.to_owned(), scene }
}

/// The study of a plan, with the scenes that are meant. Reads them: a matter of seconds for models.
///
/// # Errors
/// Why a scene cannot be read.
pub(super) fn resolve(mut plan: Plan) -> Result<Study, String> {
    let subjects = match &mut plan {
        Plan::Threads { subjects, .. } | Plan::Rays { subjects, .. } | Plan::Tiles { subjects, .. } => {
            &mut subjects[..]
        }
        Plan::Triangles { .. } => &mut [],
    };
    for subject in subjects {
        *subject = Subject::built_in(&subject.id).map_err(|error| error.to_string())?;
    }
    Study::new(plan).map_err(|error| error.to_string())
}

fn number(text: &str, texts: &Texts) -> Result<u64, String> {
    let text = text.trim();
    text.parse().map_err(|_| if text.is_empty() { texts.input_empty() } else { texts.input_no_whole_number(text) })
}

fn list(text: &str, texts: &Texts) -> Result<Vec<u64>, String> {
    text.split([',', ';', ' ']).filter(|word| !word.trim().is_empty()).map(|word| number(word, texts)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::l10n::Language;

    #[test]
    fn the_form_means_the_study_of_the_command_line() {
        let texts = Language::En.load();
        for kind in Kind::ALL {
            let plan = Form::of(kind).plan(&texts, luch_study::Language::English).unwrap();
            assert_eq!(plan.kind(), kind);
            assert_eq!(plan.effort(), &Effort::of(kind));
        }
    }

    #[test]
    fn the_form_reads_no_scene_and_the_study_has_them_all() {
        let texts = Language::En.load();
        for kind in [Kind::Threads, Kind::Rays, Kind::Tiles] {
            let mut form = Form::of(kind);
            form.toggle("chess", true);
            let plan = form.plan(&texts, luch_study::Language::English).unwrap();
            let ids = |plan: &Plan| plan.subjects().iter().map(|subject| subject.id.clone()).collect::<Vec<_>>();
            assert_eq!(ids(&plan), ["one-sphere", "two-spheres", "chess"]);
            assert!(
                plan.subjects().iter().all(|subject| subject.scene.objects.is_empty()),
                "{kind:?}: a scene was read"
            );
            form.toggle("chess", false);
            let plan = form.plan(&texts, luch_study::Language::English).unwrap();
            let study = resolve(plan.clone()).unwrap();
            assert_eq!(ids(study.plan()), ids(&plan));
            assert!(study.plan().subjects().iter().all(|subject| !subject.scene.objects.is_empty()));
        }
    }

    #[test]
    fn wrong_input_is_told_in_both_languages() {
        for (&language, words) in Language::iter().zip(luch_study::Language::ALL) {
            let texts = language.load();
            let wrong = |change: fn(&mut Form)| {
                let mut form = Form::of(Kind::Threads);
                change(&mut form);
                form.plan(&texts, words).unwrap_err()
            };
            for error in [
                wrong(|form| form.runs = "0".into()),
                wrong(|form| form.runs = "many".into()),
                wrong(|form| form.values = "0".into()),
                wrong(|form| form.values = "100000".into()),
                wrong(|form| form.values = " , ".into()),
                wrong(|form| form.values = "1, 1".into()),
                wrong(|form| form.width = "0".into()),
                wrong(|form| form.width = String::new()),
                wrong(|form| form.scenes.clear()),
            ] {
                assert!(!error.is_empty());
            }
        }
    }

    #[test]
    fn scenes_keep_their_order() {
        let mut form = Form::of(Kind::Tiles);
        form.toggle("chess", true);
        form.toggle("one-sphere", false);
        form.toggle("one-sphere", true);
        assert_eq!(form.scenes, ["one-sphere", "two-spheres", "chess"]);
    }
}
