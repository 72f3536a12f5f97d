//! The part about one ray: where it goes, what it hits, the light there, and what it brings.

use super::{formula, light, light_name, object_name, quoted, walk};
use crate::document::Document;
use crate::formula::{Equation, Expr, Symbol, Value};
use crate::language::Words;
use crate::number::{short, triple};
use crate::{Explanation, Options};
use luch_render::explain::{PixelAccount, RayAccount, RayEnd, RayKind, Side, Square, SurfaceAccount, Visibility};
use luch_scene::Shape;

/// Adds the part about a ray.
pub(crate) fn ray(explanation: &Explanation<'_>, options: &Options, index: u32, document: &mut Document) {
    let words = options.language.words();
    let account = &explanation.account.rays[index as usize];
    document.heading(2, title(explanation, account, index, words));
    document.facts([
        (words.origin, triple(account.origin.to_array())),
        (words.direction, triple(account.direction.to_array())),
        (words.weight, short(account.weight)),
        (words.depth, account.depth.to_string()),
    ]);
    match account.end {
        RayEnd::Surface(place) => surface(explanation, options, place, document),
        RayEnd::Nothing => document.paragraph(format!("{}: {}.", words.meets_nothing, triple(account.color))),
        RayEnd::DepthUsedUp => document.paragraph(format!("{}: {}.", words.depth_used_up, triple(account.color))),
        RayEnd::Light(place) => shadow(explanation, place, words, document),
        RayEnd::Blocked { light, .. } => shadow(explanation, light, words, document),
    }
    if options.boxes {
        walk::walk(explanation, index, words, document);
    }
}

fn title(explanation: &Explanation<'_>, account: &RayAccount, index: u32, words: &Words) -> String {
    let kind = match account.kind {
        RayKind::Camera => words.camera_ray,
        RayKind::Mirror => words.mirror_ray,
        RayKind::Shadow => words.shadow_ray,
    };
    match account.end {
        RayEnd::Surface(place) => {
            let object = explanation.account.surfaces[place as usize].object;
            format!("{kind} {index}: {} {}", words.hits, quoted(words, object_name(explanation, object)))
        }
        _ => format!("{kind} {index}"),
    }
}

/// A ray in a line.
pub(crate) fn row(explanation: &Explanation<'_>, index: u32, words: &Words) -> String {
    let account = &explanation.account.rays[index as usize];
    let name = |object: u32| quoted(words, object_name(explanation, object));
    let kind = match account.kind {
        RayKind::Camera => words.camera_ray,
        RayKind::Mirror => words.mirror_ray,
        RayKind::Shadow => words.shadow_ray,
    };
    let source = |place: u32| {
        let light = explanation.account.lights[place as usize].light;
        quoted(words, light_name(explanation, light))
    };
    let end = match account.end {
        RayEnd::Surface(place) => {
            let surface = &explanation.account.surfaces[place as usize];
            format!("{} {} {}", name(surface.object), words.at_distance, short(surface.t))
        }
        RayEnd::Nothing => words.background.to_owned(),
        RayEnd::DepthUsedUp => words.depth_used_up.to_owned(),
        RayEnd::Light(place) => source(place),
        RayEnd::Blocked { light, blocker } => {
            format!("{}: {} {}", source(light), words.blocked_by, name(blocker.object))
        }
    };
    format!("{kind} → {end} · {} %", short(account.weight * 100.0))
}

fn shadow(explanation: &Explanation<'_>, place: u32, words: &Words, document: &mut Document) {
    let light = &explanation.account.lights[place as usize];
    light::verdict(explanation, light, words, document);
}

/// The surface that a ray hit, its light, and the mix with what it mirrors.
fn surface(explanation: &Explanation<'_>, options: &Options, place: u32, document: &mut Document) {
    let (account, words) = (explanation.account, options.language.words());
    let surface = &account.surfaces[place as usize];
    document.facts(facts_of(explanation, surface, words));

    document.heading(3, words.ambient_term);
    document.equations(vec![Equation {
        result: Symbol::AmbientTerm,
        formula: formula::ambient(),
        numbers: vec![
            (Symbol::AmbientColor, Value::Triple(surface.base)),
            (Symbol::Ambient, Value::Number(account.setting.ambient)),
        ],
        value: Value::Triple(surface.ambient),
    }]);
    for (number, entry) in (1..).zip(account.lights_of(place)) {
        light::light(explanation, surface, entry, number, words, document);
    }
    document.heading(3, words.local_sum);
    document.equations(vec![local_sum(account, place, surface)]);
    result(account, surface, words, document);
}

fn facts_of<'w>(explanation: &Explanation<'_>, surface: &SurfaceAccount, words: &'w Words) -> Vec<(&'w str, String)> {
    let shape = explanation.scene.objects.get(surface.object as usize).map(|object| &object.shape);
    let part = match shape {
        Some(Shape::Mesh(_)) => format!(", {} {}", words.triangle, surface.primitive),
        Some(Shape::Cuboid { .. }) => format!(", {} {}", words.face, surface.primitive),
        _ => String::new(),
    };
    let side = if surface.side == Side::Front { words.front } else { words.back };
    let object = quoted(words, object_name(explanation, surface.object));
    let mut facts = vec![
        (words.object, format!("{object}{part}, {side}, {} {}", words.at_distance, short(surface.t))),
        (words.point, triple(surface.position.to_array())),
        (words.geometric_normal, triple(surface.geometric_normal.to_array())),
        (words.normal, triple(surface.normal.to_array())),
    ];
    if let (Some(shading), Some(face)) = (surface.shading, explanation.account.face_of(surface)) {
        let list = |vectors: [glam::Vec3; 3]| vectors.map(|v| triple(v.to_array())).join(" ");
        facts.push((words.shading, shading.word().to_owned()));
        facts.push((words.vertices, list(face.vertices)));
        facts.push((words.vertex_normals, list(face.normals)));
        facts.push((words.weights, triple(face.weights)));
    }
    let square = match surface.square {
        Some(Square::First) => format!(" ({})", words.first_square),
        Some(Square::Second) => format!(" ({})", words.second_square),
        None => String::new(),
    };
    let look = [surface.highlight, surface.exponent, surface.reflection, surface.gloss].map(short);
    let [highlight, exponent, reflection, gloss] = look;
    let material =
        format!("k_d = k_a = {}{square}, k_s = {highlight}, n = {exponent}, r = {reflection}", triple(surface.base));
    facts.push((words.material, format!("{material}, {} {gloss}", words.gloss)));
    facts
}

/// The ambient term and what each light adds: nothing, where it does not reach.
fn local_sum(account: &PixelAccount, place: u32, surface: &SurfaceAccount) -> Equation {
    let mut parts: Vec<Expr> = vec![Symbol::AmbientTerm.into()];
    let mut numbers = vec![(Symbol::AmbientTerm, Value::Triple(surface.ambient))];
    for (number, light) in (1..).zip(account.lights_of(place)) {
        if light.visibility == Visibility::Visible {
            parts.push(Symbol::Share(number).into());
            numbers.push((Symbol::Share(number), Value::Triple(light.share)));
        }
    }
    let formula = Expr::Sum(parts);
    Equation { result: Symbol::Local, formula, numbers, value: Value::Triple(surface.local) }
}

fn result(account: &PixelAccount, surface: &SurfaceAccount, words: &Words, document: &mut Document) {
    let color = account.rays[surface.ray as usize].color;
    let Some(mirror) = surface.mirror else {
        document.paragraph(format!("{} C = C_l = {}.", words.brings, triple(color)));
        return;
    };
    document.heading(3, words.mirror_mix);
    document.equations(vec![Equation {
        result: Symbol::Result,
        formula: formula::mix(),
        numbers: vec![
            (Symbol::Reflection, Value::Number(surface.reflection)),
            (Symbol::Local, Value::Triple(surface.local)),
            (Symbol::Mirrored, Value::Triple(account.rays[mirror as usize].color)),
        ],
        value: Value::Triple(color),
    }]);
    document.paragraph(format!("{} C = {}; {} {mirror}.", words.brings, triple(color), words.mirrored_comes_from));
}
