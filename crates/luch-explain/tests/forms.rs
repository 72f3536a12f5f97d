//! Every form of an explanation: what it says, and that it is what it claims to be.

use luch_explain::{Explanation, Language, Options, Samples, plain};
use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::{Report, SceneSource, load_scene};
use luch_render::explain::{PixelAccount, explain};
use luch_render::{CompiledScene, MeshTrees, RenderJob, compile};
use luch_scene::{ImageSize, RayCount, Sampling, Scene, Shading};

/// A built-in scene with what explaining it takes.
struct Subject {
    scene: Scene,
    compiled: CompiledScene,
    job: RenderJob,
}

impl Subject {
    fn of(id: &'static str, shading: Shading, rays: u32) -> Self {
        let source = SceneSource::BuiltIn(id);
        let load = load_scene(&source, &mut MeshLibrary::new(), &mut Budget::default(), &mut Report::default());
        let mut scene = load.unwrap();
        scene.settings.shading = shading;
        scene.objects.iter_mut().for_each(|object| object.shading = None);
        let compiled = compile(&scene, &mut MeshTrees::new(), 2);
        let mut job = RenderJob::of_scene(&scene, 0);
        job.size = ImageSize::new(160, 120).unwrap();
        job.antialiasing = Sampling { on: rays > 1, rays: RayCount::new(rays).unwrap() };
        Self { scene, compiled, job }
    }

    fn with<T>(&self, account: &PixelAccount, use_it: impl FnOnce(&Explanation<'_>) -> T) -> T {
        use_it(&Explanation { account, scene: &self.scene, compiled: &self.compiled, camera: "Camera 1" })
    }

    /// Some pixels of everything that the scene has.
    fn accounts(&self) -> Vec<PixelAccount> {
        let places = (0..160).step_by(23).flat_map(|x| (0..120).step_by(19).map(move |y| (x, y)));
        places.map(|(x, y)| explain(&self.compiled, &self.job, x, y).unwrap()).collect()
    }
}

fn subjects() -> Vec<Subject> {
    vec![
        Subject::of("two-spheres", Shading::Phong, 1),
        Subject::of("knight", Shading::Gouraud, 2),
        Subject::of("knight", Shading::Flat, 1),
        Subject::of("chess", Shading::Phong, 1),
    ]
}

fn options() -> Vec<Options> {
    let all = Options { samples: Samples::All, boxes: true, ..Options::default() };
    vec![Options::default(), all, Options { language: Language::Russian, ..all }]
}

#[test]
fn text_has_the_formulas_with_their_numbers() {
    let subject = Subject::of("two-spheres", Shading::Phong, 1);
    let account = explain(&subject.compiled, &subject.job, 55, 63).unwrap();
    let text = subject.with(&account, |e| e.text(&Options::default(), &plain));
    let [r, g, b] = account.pixel.map(luch_explain::short);
    for part in [
        format!("({r}, {g}, {b})"),
        "hits “Left sphere”".to_owned(),
        "a = K / (d + K) = 60 / (".to_owned(),
        "C = (1 - r) · C_l + r · C_m = (1 - 0.5) · (".to_owned(),
        "Mirror ray".to_owned(),
    ] {
        assert!(text.contains(&part), "{part}:\n{text}");
    }
}

/// Opening and closing marks of LaTeX, as a stack.
fn assert_balanced(latex: &str) {
    let mut open = Vec::new();
    let mut rest = latex;
    while let Some(at) = rest.find(['\\', '{', '}', '%']) {
        let mark = &rest[at..];
        let taken = match mark.as_bytes()[0] {
            b'{' => {
                open.push("{".to_owned());
                1
            }
            b'}' => {
                assert_eq!(open.pop().as_deref(), Some("{"), "before {:?}", &mark[..mark.len().min(80)]);
                1
            }
            b'%' => mark.find('\n').unwrap_or(mark.len()),
            _ if mark.starts_with("\\begin{") => {
                let end = mark.find('}').unwrap();
                open.push(mark[7..end].to_owned());
                end + 1
            }
            _ if mark.starts_with("\\end{") => {
                let end = mark.find('}').unwrap();
                assert_eq!(open.pop().as_deref(), Some(&mark[5..end]));
                end + 1
            }
            _ => 2,
        };
        rest = rest.get(at + taken..).unwrap_or_default();
    }
    assert!(open.is_empty(), "left open: {open:?}");
}

#[test]
fn latex_is_balanced_and_has_no_letter_without_a_font() {
    for subject in subjects() {
        for account in subject.accounts() {
            for options in options() {
                let latex = subject.with(&account, |e| e.latex(&options));
                assert_balanced(&latex);
                assert!(latex.starts_with('%') && latex.ends_with("\\end{document}\n"));
                let known = |c: char| c.is_ascii() || ('\u{400}'..='\u{45f}').contains(&c);
                assert!(latex.chars().all(known), "{:?}", latex.chars().find(|&c| !known(c)));
                assert!(!latex.contains("[U+"), "a sign of ours has no letter");
            }
        }
    }
}

#[test]
fn markdown_has_rows_as_long_as_their_heads_and_closed_formulas() {
    for subject in subjects() {
        for account in subject.accounts() {
            for options in options() {
                let markdown = subject.with(&account, |e| e.markdown(&options));
                assert_eq!(markdown.matches("$$").count() % 2, 0);
                let bars = |line: &str| line.replace("\\|", "").matches('|').count();
                let mut columns = None;
                for line in markdown.lines() {
                    if line.starts_with('|') {
                        assert_eq!(*columns.get_or_insert_with(|| bars(line)), bars(line), "{line}");
                    } else {
                        columns = None;
                    }
                }
            }
        }
    }
}

#[test]
fn a_number_of_the_json_reads_back_to_the_same_bits() {
    for subject in subjects() {
        for account in subject.accounts() {
            let mut json = Vec::new();
            subject.with(&account, |e| e.json(&Options::default(), &mut json)).unwrap();
            let read: serde_json::Value = serde_json::from_slice(&json).unwrap();
            // As most readers do it: first to a 64-bit float.
            #[allow(clippy::cast_possible_truncation, reason = "that is what is tested")]
            let triple = |value: &serde_json::Value| -> [u32; 3] {
                std::array::from_fn(|c| (value[c].as_f64().unwrap() as f32).to_bits())
            };
            assert_eq!(triple(&read["pixel"]), account.pixel.map(f32::to_bits));
            assert_eq!(read["rays"].as_array().unwrap().len(), account.rays.len());
            for (ray, read) in account.rays.iter().zip(read["rays"].as_array().unwrap()) {
                assert_eq!(triple(&read["origin"]), ray.origin.to_array().map(f32::to_bits));
                assert_eq!(triple(&read["direction"]), ray.direction.to_array().map(f32::to_bits));
                assert_eq!(triple(&read["color"]), ray.color.map(f32::to_bits));
            }
        }
    }
}

#[test]
fn every_ray_has_a_row_and_a_part() {
    let subject = Subject::of("knight", Shading::Gouraud, 2);
    let account = explain(&subject.compiled, &subject.job, 70, 70).unwrap();
    subject.with(&account, |explanation| {
        for ray in 0..u32::try_from(account.rays.len()).unwrap() {
            for language in Language::ALL {
                assert!(explanation.row(ray, language).contains('%'));
                let part = explanation.ray(ray, &Options { language, ..Options::default() });
                assert!(part.blocks.len() >= 2);
            }
        }
    });
}
