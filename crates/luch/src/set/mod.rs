//! `--set 'OBJECT.key=value'`: one change of the scene, written in one word.
//!
//! Names may hold dots, spaces and equals signs, so an assignment is read with the scene at hand: the longest name of
//! the scene that the text begins with is meant. Every assignment becomes a [`luch_scene::Edit`].

mod colors;
mod keys;
mod value;

use crate::exit::Failure;
use keys::Refusal;
use luch_io::scene_file::nearest;
use luch_scene::{Edit, Scene};

/// How many names an error lists before it counts the rest.
const SHOWN_NAMES: usize = 40;

/// What an assignment may change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Target {
    Object(usize),
    Light(usize),
    Camera(usize),
    /// The scene as a whole, by the name `scene`.
    Scene,
}

/// Reads the assignment and applies it to the scene.
///
/// # Errors
/// A usage failure that says what there is to be named.
pub(crate) fn apply(assignment: &str, scene: &mut Scene) -> Result<(), Failure> {
    let edit = parse(assignment, scene)?;
    edit.apply(scene).map_err(|e| refused(assignment, &e.to_string()))?;
    Ok(())
}

fn parse(assignment: &str, scene: &Scene) -> Result<Edit, Failure> {
    let Some((target, rest)) = longest_name(assignment, scene) else {
        return Err(unknown_name(assignment, scene));
    };
    let Some((key, value)) = rest.split_once('=') else {
        return Err(refused(assignment, "there is no = with a value behind it").hint(FORM));
    };
    let (key, value) = (key.trim(), value.trim());
    edit_of(target, key, value, scene).map_err(|refusal| match refusal {
        Refusal::Value(text) => refused(assignment, &format!("{key}: {text}")),
        Refusal::Key { what, keys } => {
            let meant =
                nearest(key, keys.iter().copied()).map(|k| format!("; did you mean `{k}`?")).unwrap_or_default();
            refused(assignment, &format!("{what} has no `{key}`{meant}"))
                .hint(format!("its keys are {}", keys.join(", ")))
        }
    })
}

/// The form of an assignment, for errors that have nothing better to say.
const FORM: &str = "write --set 'OBJECT.key=value', as in --set 'Cube.reflection=95%'";

fn edit_of(target: Target, key: &str, value: &str, scene: &Scene) -> Result<Edit, Refusal> {
    match target {
        Target::Object(i) => keys::object(&scene.objects[i], key, value).map(|e| Edit::Object(i, e)),
        Target::Light(i) => keys::light(key, value).map(|e| Edit::Light(i, e)),
        Target::Camera(i) => keys::camera(key, value).map(|e| Edit::Camera(i, e)),
        Target::Scene => keys::scene(key, value).map(Edit::Scene),
    }
}

/// The thing with the longest name that the text begins with, and what stands behind the dot.
///
/// Of equal names an object comes before a light, a camera and the word `scene`.
fn longest_name<'t>(text: &'t str, scene: &Scene) -> Option<(Target, &'t str)> {
    let behind = |name: &str| text.strip_prefix(name).and_then(|rest| rest.trim_start().strip_prefix('.'));
    let mut best: Option<(usize, Target, &str)> = None;
    for (name, target) in names(scene) {
        if let Some(rest) = behind(name)
            && best.is_none_or(|(length, ..)| name.len() > length)
        {
            best = Some((name.len(), target, rest));
        }
    }
    best.map(|(_, target, rest)| (target, rest))
}

fn names(scene: &Scene) -> impl Iterator<Item = (&str, Target)> {
    let objects = scene.objects.iter().enumerate().map(|(i, o)| (o.name.as_str(), Target::Object(i)));
    let lights = scene.lights.iter().enumerate().map(|(i, l)| (l.name.as_str(), Target::Light(i)));
    let cameras = scene.cameras.iter().enumerate().map(|(i, c)| (c.name.as_str(), Target::Camera(i)));
    objects.chain(lights).chain(cameras).chain([("scene", Target::Scene)])
}

fn refused(assignment: &str, why: &str) -> Failure {
    Failure::usage(format!("--set '{assignment}': {why}"))
}

fn unknown_name(assignment: &str, scene: &Scene) -> Failure {
    let left = assignment.split_once('=').map_or(assignment, |(left, _)| left);
    let Some((name, _)) = left.rsplit_once('.') else {
        let why = if assignment.contains('=') { "no object is named" } else { "this is no assignment" };
        return refused(assignment, why).hint(format!("{FORM}\nhint: {}", listing(scene)));
    };
    let name = name.trim();
    let meant =
        nearest(name, names(scene).map(|(n, _)| n)).map(|n| format!("; did you mean \"{n}\"?")).unwrap_or_default();
    refused(assignment, &format!("the scene has nothing named \"{name}\"{meant}")).hint(listing(scene))
}

/// What can be named, in one line for each kind.
fn listing(scene: &Scene) -> String {
    let objects = quoted(scene.objects.iter().map(|o| o.name.as_str()));
    let lights = quoted(scene.lights.iter().map(|l| l.name.as_str()));
    let cameras = quoted(scene.cameras.iter().map(|c| c.name.as_str()));
    format!("objects: {objects}\n      lights: {lights}\n      cameras: {cameras}\n      scene")
}

/// The names in quotes; none is `none`.
pub(crate) fn quoted<'a>(names: impl ExactSizeIterator<Item = &'a str>) -> String {
    let count = names.len();
    if count == 0 {
        return "none".to_owned();
    }
    let shown: Vec<String> = names.take(SHOWN_NAMES).map(|n| format!("\"{n}\"")).collect();
    let more = count.saturating_sub(SHOWN_NAMES);
    if more > 0 { format!("{} and {more} more", shown.join(", ")) } else { shown.join(", ") }
}

#[cfg(test)]
mod tests;
