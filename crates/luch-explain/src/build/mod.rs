//! From an account to a document.

mod light;
mod ray;
mod walk;

pub(crate) use ray::{ray, row};

use crate::document::{Block, Document};
use crate::formula::{Expr, Symbol};
use crate::language::Words;
use crate::number::{hex, pair, short, triple};
use crate::{Explanation, Options, Samples};

/// The whole explanation of a pixel.
pub(crate) fn pixel(explanation: &Explanation<'_>, options: &Options) -> Document {
    let words = options.language.words();
    let mut document = Document::default();
    head(explanation, words, &mut document);
    model(words, &mut document);
    setting(explanation, words, &mut document);
    samples(explanation, options, &mut document);
    let account = explanation.account;
    for (number, sample) in (0..).zip(&account.samples) {
        if options.samples != Samples::All && options.samples != Samples::One(number) {
            continue;
        }
        // A path is a chain: the camera ray, and mirror rays behind it.
        let mut next = Some(sample.ray);
        while let Some(at) = next {
            ray(explanation, options, at, &mut document);
            next = account.surface_of(at).and_then(|surface| surface.mirror);
        }
    }
    document
}

/// A name in the language's quotation marks.
pub(crate) fn quoted(words: &Words, name: &str) -> String {
    format!("{}{name}{}", words.quote_open, words.quote_close)
}

fn head(explanation: &Explanation<'_>, words: &Words, document: &mut Document) {
    let account = explanation.account;
    let (x, y) = (account.x, account.y);
    let scene = quoted(words, &explanation.scene.name);
    document.heading(1, format!("{} {x},{y} {} {scene}", words.pixel, words.of_scene));
    let size = format!("{} × {} {}", account.size.width(), account.size.height(), words.pixels);
    document.facts([
        (words.linear_color, triple(account.pixel)),
        (words.screen_color, hex(account.pixel)),
        (words.camera, explanation.camera.to_owned()),
        (words.picture, size),
    ]);
}

/// The formulas of the model and their letters.
fn model(words: &Words, document: &mut Document) {
    use Symbol::*;
    document.heading(2, words.how_it_is_made);
    let product = |a: Symbol, b: Symbol| Expr::Product(vec![a.into(), b.into()]);
    document.blocks.push(Block::Model(vec![
        (AmbientTerm, formula::ambient()),
        (Falloff, formula::falloff()),
        (Strength, formula::strength()),
        (Diffuse, formula::diffuse()),
        (Specular, formula::specular()),
        (Share(0), formula::share()),
        (Local, Expr::Sum(vec![AmbientTerm.into(), Share(1).into(), Share(2).into(), Ellipsis.into()])),
        (Result, formula::mix()),
        (CosTheta, product(Normal, ToLight)),
        (CosAlpha, product(MirroredLight, ToViewer)),
    ]));
    document.paragraph(words.cosines);
    let meanings = [
        (Ambient, words.sym_ia),
        (Attenuation, words.sym_k),
        (Intensity, words.sym_i),
        (LightColor, words.sym_c),
        (Distance, words.sym_d),
        (Falloff, words.sym_a),
        (Strength, words.sym_s),
        (CosTheta, words.sym_theta),
        (CosAlpha, words.sym_alpha),
        (Color, words.sym_kd),
        (Highlight, words.sym_ks),
        (Exponent, words.sym_n),
        (Diffuse, words.sym_diffuse),
        (Specular, words.sym_specular),
        (Share(0), words.sym_share),
        (Local, words.sym_local),
        (Reflection, words.sym_r),
        (Mirrored, words.sym_mirrored),
        (Result, words.sym_result),
    ];
    document.blocks.push(Block::Symbols {
        head: [words.symbol.to_owned(), words.meaning.to_owned()],
        rows: meanings.map(|(symbol, meaning)| (symbol, meaning.to_owned())).to_vec(),
    });
}

fn setting(explanation: &Explanation<'_>, words: &Words, document: &mut Document) {
    let setting = &explanation.account.setting;
    document.heading(2, words.setting);
    document.facts([
        (words.ambient_light, format!("I_a = {}", short(setting.ambient))),
        (words.attenuation, format!("K = {}", short(setting.attenuation))),
        (words.background, triple(setting.background)),
        (words.depth_limit, setting.depth.to_string()),
    ]);
    let rows = setting.lights.iter().map(|light| {
        let name = light_name(explanation, light.light);
        vec![name.to_owned(), triple(light.position.to_array()), short(light.intensity), triple(light.color)]
    });
    document.table(
        &[words.light, words.position, &format!("{} i", words.intensity), &format!("{} c", words.color)],
        rows.collect(),
    );
}

/// The table of the samples and how they differ, if there are several.
fn samples(explanation: &Explanation<'_>, options: &Options, document: &mut Document) {
    let (account, words) = (explanation.account, options.language.words());
    if account.samples.len() < 2 {
        return;
    }
    document.heading(2, words.samples);
    let rows =
        account.samples.iter().enumerate().map(|(number, sample)| {
            vec![number.to_string(), pair(sample.film), pair(sample.lens), triple(sample.color)]
        });
    document.table(&[words.sample, words.film_place, words.lens_place, words.color], rows.collect());
    document.facts([
        (words.mean, triple(account.pixel)),
        (words.smallest, triple(account.spread.min)),
        (words.largest, triple(account.spread.max)),
        (words.std_dev, triple(account.spread.std_dev)),
    ]);
    document.paragraph(format!("{}.", words.mean_of_samples));
    if let Samples::One(number) = options.samples {
        document.paragraph(format!("{} {number}.", words.shown_sample));
    }
}

/// The name of an object.
pub(crate) fn object_name<'a>(explanation: &Explanation<'a>, object: u32) -> &'a str {
    explanation.scene.objects.get(object as usize).map_or("?", |object| object.name.as_str())
}

/// The name of a light.
pub(crate) fn light_name<'a>(explanation: &Explanation<'a>, light: u32) -> &'a str {
    explanation.scene.lights.get(light as usize).map_or("?", |light| light.name.as_str())
}

/// The formulas of the model, in the order of the renderer's arithmetic.
pub(crate) mod formula {
    use crate::formula::Expr;
    use crate::formula::Symbol::{self, *};

    fn product(symbols: &[Symbol]) -> Expr {
        Expr::Product(symbols.iter().map(|&symbol| symbol.into()).collect())
    }

    pub(crate) fn ambient() -> Expr {
        product(&[AmbientColor, Ambient])
    }

    pub(crate) fn falloff() -> Expr {
        Expr::over(Attenuation.into(), Expr::Sum(vec![Distance.into(), Attenuation.into()]))
    }

    pub(crate) fn strength() -> Expr {
        product(&[Falloff, Intensity])
    }

    pub(crate) fn diffuse() -> Expr {
        product(&[Strength, CosTheta])
    }

    pub(crate) fn specular() -> Expr {
        Expr::Product(vec![Strength.into(), Highlight.into(), Expr::power(CosAlpha.into(), Exponent.into())])
    }

    pub(crate) fn share() -> Expr {
        Expr::Product(vec![Expr::Sum(vec![product(&[Color, Diffuse]), Specular.into()]), LightColor.into()])
    }

    pub(crate) fn mix() -> Expr {
        let local = Expr::Product(vec![Expr::minus(Expr::Constant(1.0), Reflection.into()), Local.into()]);
        Expr::Sum(vec![local, product(&[Reflection, Mirrored])])
    }

    pub(crate) fn blend(term: fn(u8) -> Symbol) -> Expr {
        Expr::Sum((1..=3).map(|vertex| product(&[term(vertex), Weight(vertex)])).collect())
    }
}
