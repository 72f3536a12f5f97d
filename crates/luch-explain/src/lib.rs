//! The account of a pixel in words: text, Markdown, LaTeX and JSON.
//!
//! ```
//! use luch_explain::{Explanation, Options};
//! use luch_render::explain::explain;
//! use luch_render::{MeshTrees, RenderJob, compile};
//! use luch_scene::{Aim, Camera, Light, Object, Point, Scene, Shape, Size};
//!
//! let mut scene = Scene::new("A ball");
//! let ball = Shape::Sphere { center: Point::ORIGIN, radius: Size::ONE };
//! scene.objects.push(Object::new("Ball", ball));
//! scene.lights.push(Light::new("Lamp", Point::clamped([3.0, 4.0, 5.0].into())));
//! scene.cameras.push(Camera::new("Camera", Point::clamped([0.0, 0.0, 5.0].into()), Aim::At(Point::ORIGIN)));
//!
//! let compiled = compile(&scene, &mut MeshTrees::new(), 1);
//! let job = RenderJob::of_scene(&scene, 0);
//! let account = explain(&compiled, &job, 480, 360).unwrap();
//! let explanation = Explanation { account: &account, scene: &scene, compiled: &compiled, camera: "Camera" };
//! let text = explanation.text(&Options::default(), &luch_explain::plain);
//! assert!(text.contains("cos θ = N · L"));
//! ```

#![forbid(unsafe_code)]

mod build;
mod document;
mod formula;
mod json;
mod language;
mod latex;
mod markdown;
mod number;
mod text;

pub use document::{Block, Document};
pub use formula::{Equation, Expr, Symbol, Value};
pub use language::Language;
pub use number::{hex, short, triple};
pub use text::{Role, plain};

use luch_render::CompiledScene;
use luch_render::explain::PixelAccount;
use luch_scene::Scene;
use std::io;

/// An account and where its names come from.
#[derive(Debug, Clone, Copy)]
pub struct Explanation<'a> {
    /// What is explained.
    pub account: &'a PixelAccount,
    /// The scene that the account is of.
    pub scene: &'a Scene,
    /// The same, compiled: for the ways of rays through its trees.
    pub compiled: &'a CompiledScene,
    /// The camera's name.
    pub camera: &'a str,
}

/// What of it is written, and how.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Options {
    /// The language of text, Markdown and LaTeX.
    pub language: Language,
    /// Whose rays text, Markdown and LaTeX show; JSON has all.
    pub samples: Samples,
    /// Whether to list the boxes and shapes of each ray's way.
    pub boxes: bool,
}

/// Which samples are shown ray by ray.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Samples {
    /// One of them, from 0.
    One(u32),
    /// All.
    All,
}

impl Default for Samples {
    fn default() -> Self {
        Self::One(0)
    }
}

impl Explanation<'_> {
    /// The explanation as parts that a program may show in its own way.
    #[must_use]
    pub fn document(&self, options: &Options) -> Document {
        build::pixel(self, options)
    }

    /// The part about one ray, an index into the account's list.
    #[must_use]
    pub fn ray(&self, ray: u32, options: &Options) -> Document {
        let mut document = Document::default();
        build::ray(self, options, ray, &mut document);
        document
    }

    /// A ray in a line: its kind, what it meets, its share in the pixel.
    #[must_use]
    pub fn row(&self, ray: u32, language: Language) -> String {
        build::row(self, ray, language.words())
    }

    /// Plain text; `paint` may colour it for a terminal, and [`plain`] does not.
    #[must_use]
    pub fn text(&self, options: &Options, paint: &dyn Fn(Role, &str) -> String) -> String {
        text::write(&self.document(options), paint)
    }

    /// Markdown with formulas as `$$...$$`, which GitHub, GitLab, Jupyter and Pandoc show as mathematics.
    #[must_use]
    pub fn markdown(&self, options: &Options) -> String {
        markdown::write(&self.document(options))
    }

    /// A LaTeX document that can be compiled as it is, with the packages `amsmath` and `geometry`.
    #[must_use]
    pub fn latex(&self, options: &Options) -> String {
        latex::write(&self.document(options), options.language)
    }

    /// JSON with everything, by the schema in `docs/explain.schema.json`. Of the options only `boxes` counts.
    ///
    /// # Errors
    /// Those of the writer.
    pub fn json(&self, options: &Options, to: &mut dyn io::Write) -> io::Result<()> {
        json::write(self, options, to)
    }
}
