//! The part about a ray's way through the trees.

use super::{object_name, quoted};
use crate::Explanation;
use crate::document::Document;
use crate::language::Words;
use crate::number::{short, triple};
use luch_render::explain::Walk;

/// Adds the boxes that a ray enters and the shapes that it is tested against.
pub(super) fn walk(explanation: &Explanation<'_>, ray: u32, words: &Words, document: &mut Document) {
    let walk = explanation.account.walk(explanation.compiled, ray);
    document.heading(3, words.walk);
    document.facts([(words.boxes, walk.boxes.len().to_string()), (words.tests, walk.tests.len().to_string())]);
    let name = |object: u32| quoted(words, object_name(explanation, object));
    let mut rows = Vec::with_capacity(walk.boxes.len() + 1);
    let always = tested_in(&walk, None);
    if !always.is_empty() {
        let names: Vec<String> = always.iter().map(|&test| name(walk.tests[test].object)).collect();
        let what = format!("{}: {}", words.every_ray, names.join(", "));
        rows.push(vec!["—".to_owned(), what, met(&walk, &always, words), String::new()]);
    }
    for (number, visit) in (0..).zip(&walk.boxes) {
        let tests = tested_in(&walk, Some(number));
        let what = match (visit.leaf, visit.object, tests.first()) {
            (true, Some(object), _) => format!("{}, {} {}", name(object), tests.len(), words.triangles_or_shapes),
            (true, None, Some(&test)) => name(walk.tests[test].object),
            (_, Some(object), _) => format!("{}, {}", name(object), words.more_boxes),
            (_, None, _) => words.more_boxes.to_owned(),
        };
        let corners = format!(
            "{} {} {} {}",
            words.corner_low,
            triple(visit.corners[0].to_array()),
            words.corner_high,
            triple(visit.corners[7].to_array())
        );
        rows.push(vec![visit.level.to_string(), what, met(&walk, &tests, words), corners]);
    }
    document.table(&[words.level, words.content, words.met, words.corners], rows);
}

/// The tests in a box, by their places.
fn tested_in(walk: &Walk, in_box: Option<u32>) -> Vec<usize> {
    (0..walk.tests.len()).filter(|&test| walk.tests[test].in_box == in_box).collect()
}

/// What was met there.
fn met(walk: &Walk, tests: &[usize], words: &Words) -> String {
    let found = tests.iter().filter_map(|&test| walk.tests[test].t);
    let found: Vec<String> = found.map(|t| format!("{} {}", words.met_at, short(t))).collect();
    found.join(", ")
}
