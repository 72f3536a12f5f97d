//! The part about one light at one surface.

use super::{formula, light_name, object_name, quoted};
use crate::Explanation;
use crate::document::Document;
use crate::formula::{Equation, Expr, Symbol, Value};
use crate::language::Words;
use crate::number::{short, triple};
use luch_render::explain::{LightAccount, LightFactors, LightSource, SurfaceAccount, Visibility};

/// Adds the part about light `number` (from 1) at a surface.
pub(crate) fn light(
    explanation: &Explanation<'_>,
    surface: &SurfaceAccount,
    light: &LightAccount,
    number: u32,
    words: &Words,
    document: &mut Document,
) {
    let account = explanation.account;
    let Some(source) = account.setting.lights.get(number as usize - 1) else { return };
    let name = quoted(words, light_name(explanation, light.light));
    document.heading(3, format!("{} {number}: {name}", words.light));
    let look = [surface.highlight, surface.exponent];
    match account.vertices_of(light) {
        None => at_point(source, account.setting.attenuation, &light.factors, look, words, document),
        Some(vertices) => at_vertices(explanation, surface, light, vertices, words, document),
    }
    if light.visibility == Visibility::NotAsked {
        verdict(explanation, light, words, document);
        return;
    }
    let blocked = light.visibility != Visibility::Visible;
    if blocked {
        verdict(explanation, light, words, document);
        document.paragraph(format!("{}:", words.would_add));
    }
    document.equations(vec![Equation {
        result: Symbol::Share(number),
        formula: formula::share(),
        numbers: vec![
            (Symbol::Color, Value::Triple(surface.base)),
            (Symbol::Diffuse, Value::Number(light.diffuse)),
            (Symbol::Specular, Value::Number(light.specular)),
            (Symbol::LightColor, Value::Triple(source.color)),
        ],
        value: Value::Triple(light.share),
    }]);
    if !blocked {
        verdict(explanation, light, words, document);
    }
}

/// Whether the light reaches the surface.
pub(super) fn verdict(explanation: &Explanation<'_>, light: &LightAccount, words: &Words, document: &mut Document) {
    match light.visibility {
        Visibility::Visible => document.verdict(format!("{}.", words.visible), false),
        Visibility::NotAsked => {
            let why = if light.factors.cos_theta <= 0.0 { words.behind } else { words.no_strength };
            document.verdict(format!("{why}."), true);
        }
        Visibility::Blocked(blocker) => {
            let point = light.shadow.map(|ray| explanation.account.segment(ray).end.to_array());
            let place = point.map(|point| format!(", {}", triple(point))).unwrap_or_default();
            let name = quoted(words, object_name(explanation, blocker.object));
            let at = format!("{} {}{place}", words.at_distance, short(blocker.t));
            document.verdict(format!("{} {name} {at}: {}.", words.blocked_by, words.adds_nothing), true);
        }
    }
}

/// The factors at the hit point.
fn at_point(
    source: &LightSource,
    attenuation: f32,
    factors: &LightFactors,
    [highlight, exponent]: [f32; 2],
    words: &Words,
    document: &mut Document,
) {
    document.facts([
        (words.direction_to_light, triple(factors.to_light.to_array())),
        (words.mirrored_direction, triple(factors.mirrored.to_array())),
        (words.to_viewer, triple(factors.to_viewer.to_array())),
    ]);
    let lit = factors.cos_theta > 0.0;
    let mut equations = strength(source, attenuation, factors);
    equations.push(dot(Symbol::CosTheta, [Symbol::Normal, Symbol::ToLight], factors));
    if lit {
        equations.push(Equation {
            result: Symbol::Diffuse,
            formula: formula::diffuse(),
            numbers: numbers_of(factors),
            value: Value::Number(factors.diffuse),
        });
    }
    let glossy = lit && highlight > 0.0 && factors.cos_alpha > 0.0;
    if glossy {
        equations.push(dot(Symbol::CosAlpha, [Symbol::MirroredLight, Symbol::ToViewer], factors));
        let mut numbers = numbers_of(factors);
        numbers.extend([(Symbol::Highlight, Value::Number(highlight)), (Symbol::Exponent, Value::Number(exponent))]);
        let formula = formula::specular();
        let value = Value::Number(factors.specular);
        equations.push(Equation { result: Symbol::Specular, formula, numbers, value });
    }
    document.equations(equations);
    if lit && !glossy {
        let why = if highlight > 0.0 { words.mirrored_away } else { words.matt };
        document.paragraph(format!("S = 0: {why}."));
    }
}

/// Attenuation and strength.
fn strength(source: &LightSource, attenuation: f32, factors: &LightFactors) -> Vec<Equation> {
    let number = Value::Number;
    vec![
        Equation {
            result: Symbol::Falloff,
            formula: formula::falloff(),
            numbers: vec![(Symbol::Attenuation, number(attenuation)), (Symbol::Distance, number(factors.distance))],
            value: number(factors.falloff),
        },
        Equation {
            result: Symbol::Strength,
            formula: formula::strength(),
            numbers: vec![(Symbol::Falloff, number(factors.falloff)), (Symbol::Intensity, number(source.intensity))],
            value: number(factors.strength),
        },
    ]
}

/// A cosine as the product of two unit vectors.
fn dot(result: Symbol, pair: [Symbol; 2], factors: &LightFactors) -> Equation {
    let vectors = [
        (Symbol::Normal, factors.normal),
        (Symbol::ToLight, factors.to_light),
        (Symbol::MirroredLight, factors.mirrored),
        (Symbol::ToViewer, factors.to_viewer),
    ];
    Equation {
        result,
        formula: Expr::Product(pair.map(Expr::from).to_vec()),
        numbers: vectors.map(|(symbol, vector)| (symbol, Value::Triple(vector.to_array()))).to_vec(),
        value: Value::Number(if result == Symbol::CosTheta { factors.cos_theta } else { factors.cos_alpha }),
    }
}

fn numbers_of(factors: &LightFactors) -> Vec<(Symbol, Value)> {
    vec![
        (Symbol::Strength, Value::Number(factors.strength)),
        (Symbol::CosTheta, Value::Number(factors.cos_theta)),
        (Symbol::CosAlpha, Value::Number(factors.cos_alpha)),
    ]
}

/// Gouraud: the factors at the three vertices side by side, and the blend of their terms.
fn at_vertices(
    explanation: &Explanation<'_>,
    surface: &SurfaceAccount,
    light: &LightAccount,
    vertices: &[LightFactors],
    words: &Words,
    document: &mut Document,
) {
    let weights = explanation.account.face_of(surface).map_or([0.0; 3], |face| face.weights);
    document.paragraph(format!("{}.", words.gouraud_note));
    let rows = (1..).zip(vertices).zip(weights).map(|((number, f), weight)| {
        let numbers = [f.distance, f.falloff, f.strength, f.cos_theta, f.cos_alpha, f.diffuse, f.specular, weight];
        let mut row = vec![format!("{number}")];
        row.extend(numbers.map(short));
        row
    });
    document.table(&[words.vertex, "d", "a", "s", "cos θ", "cos α", "D", "S", "w"], rows.collect());
    if light.visibility == Visibility::NotAsked {
        return;
    }
    let mut numbers = Vec::new();
    for ((vertex, factors), weight) in (1..).zip(vertices).zip(weights) {
        numbers.push((Symbol::VertexDiffuse(vertex), Value::Number(factors.diffuse)));
        numbers.push((Symbol::VertexSpecular(vertex), Value::Number(factors.specular)));
        numbers.push((Symbol::Weight(vertex), Value::Number(weight)));
    }
    document.equations(vec![
        Equation {
            result: Symbol::Diffuse,
            formula: formula::blend(Symbol::VertexDiffuse),
            numbers: numbers.clone(),
            value: Value::Number(light.diffuse),
        },
        Equation {
            result: Symbol::Specular,
            formula: formula::blend(Symbol::VertexSpecular),
            numbers,
            value: Value::Number(light.specular),
        },
    ]);
}
