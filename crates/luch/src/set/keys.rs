//! What each thing of a scene can be asked to change.

use super::value;
use luch_scene::{
    Aim, CameraEdit, LightEdit, MeshInstance, Object, ObjectEdit, Point, Positive, SceneEdit, Shading, Shape, Size,
};

/// Why an assignment means nothing.
#[derive(Debug)]
pub(super) enum Refusal {
    /// The key is not one of this thing's.
    Key { what: &'static str, keys: &'static [&'static str] },
    /// The value is not one of this key's.
    Value(String),
}

impl From<String> for Refusal {
    fn from(text: String) -> Self {
        Self::Value(text)
    }
}

const SPHERE: &[&str] = &["color", "reflection", "gloss", "checker", "position", "center", "radius", "hidden", "name"];
const CUBOID: &[&str] =
    &["color", "reflection", "gloss", "checker", "position", "center", "side", "size", "rotation", "hidden", "name"];
const WALL: &[&str] =
    &["color", "reflection", "gloss", "checker", "position", "point", "normal", "size", "hidden", "name"];
const MESH: &[&str] =
    &["color", "reflection", "gloss", "shading", "checker", "position", "rotation", "scale", "hidden", "name"];
const LIGHT: &[&str] = &["intensity", "color", "position", "hidden", "name"];
const CAMERA: &[&str] = &["position", "look_at", "direction", "fov", "focal_distance", "lens_radius", "name"];
const SCENE: &[&str] = &["background", "ambient", "attenuation", "name"];

pub(super) fn object(object: &Object, key: &str, text: &str) -> Result<ObjectEdit, Refusal> {
    // What every object has.
    match key {
        "color" => return Ok(ObjectEdit::SetColor(value::unless(text, "own", value::color)?)),
        "reflection" => return Ok(ObjectEdit::SetReflection(value::share(text)?)),
        "gloss" => return Ok(ObjectEdit::SetGloss(value::unless(text, "own", value::share)?)),
        "checker" => return Ok(ObjectEdit::SetChecker(value::unless(text, "off", value::checker)?)),
        "position" => return Ok(ObjectEdit::MoveTo(value::point(text)?)),
        "hidden" => return Ok(ObjectEdit::SetHidden(value::yes_or_no(text)?)),
        "name" => return Ok(ObjectEdit::Rename(text.to_owned())),
        _ => {}
    }
    // What belongs to the shape.
    match &object.shape {
        Shape::Sphere { center, radius } => sphere(*center, *radius, key, text).map(ObjectEdit::SetShape),
        Shape::Cuboid { .. } => cuboid(object.shape.clone(), key, text).map(ObjectEdit::SetShape),
        Shape::Wall { .. } => wall(object.shape.clone(), key, text).map(ObjectEdit::SetShape),
        Shape::Mesh(_) if key == "shading" => Ok(ObjectEdit::SetShading(value::unless(text, "scene", shading)?)),
        Shape::Mesh(instance) => mesh(instance.clone(), key, text).map(ObjectEdit::SetShape),
    }
}

fn sphere(center: Point, radius: Size, key: &str, text: &str) -> Result<Shape, Refusal> {
    match key {
        "center" => Ok(Shape::Sphere { center: value::point(text)?, radius }),
        "radius" => Ok(Shape::Sphere { center, radius: value::number(text)? }),
        _ => Err(Refusal::Key { what: "a sphere", keys: SPHERE }),
    }
}

fn cuboid(mut shape: Shape, key: &str, text: &str) -> Result<Shape, Refusal> {
    let what = if shape.kind() == "cube" { "a cube" } else { "a box" };
    if let Shape::Cuboid { center, size, rotation } = &mut shape {
        match key {
            "center" => *center = value::point(text)?,
            "side" => *size = [value::number(text)?; 3],
            "size" => *size = value::numbers(text)?,
            "rotation" => *rotation = value::rotation(text)?,
            _ => return Err(Refusal::Key { what, keys: CUBOID }),
        }
    }
    Ok(shape)
}

fn wall(mut shape: Shape, key: &str, text: &str) -> Result<Shape, Refusal> {
    if let Shape::Wall { point, normal, size } = &mut shape {
        match key {
            "point" => *point = value::point(text)?,
            "normal" => *normal = value::direction(text)?,
            "size" => *size = value::unless(text, "unbounded", value::numbers)?,
            _ => return Err(Refusal::Key { what: "a wall", keys: WALL }),
        }
    }
    Ok(shape)
}

fn mesh(mut instance: MeshInstance, key: &str, text: &str) -> Result<Shape, Refusal> {
    match key {
        "rotation" => instance.rotation = value::rotation(text)?,
        "scale" => instance.scale = value::number(text)?,
        _ => return Err(Refusal::Key { what: "a mesh", keys: MESH }),
    }
    Ok(Shape::Mesh(instance))
}

fn shading(text: &str) -> Result<Shading, String> {
    Shading::from_word(text).ok_or_else(|| format!("\"{text}\" is none of flat, gouraud, phong, scene"))
}

pub(super) fn light(key: &str, text: &str) -> Result<LightEdit, Refusal> {
    match key {
        "intensity" => Ok(LightEdit::SetIntensity(value::share(text)?)),
        "color" => Ok(LightEdit::SetColor(value::color(text)?)),
        "position" => Ok(LightEdit::MoveTo(value::point(text)?)),
        "hidden" => Ok(LightEdit::SetHidden(value::yes_or_no(text)?)),
        "name" => Ok(LightEdit::Rename(text.to_owned())),
        _ => Err(Refusal::Key { what: "a light", keys: LIGHT }),
    }
}

pub(super) fn camera(key: &str, text: &str) -> Result<CameraEdit, Refusal> {
    match key {
        "position" => Ok(CameraEdit::MoveTo(value::point(text)?)),
        "look_at" => Ok(CameraEdit::SetAim(Aim::At(value::point(text)?))),
        "direction" => Ok(CameraEdit::SetAim(Aim::Along(value::direction(text)?))),
        "fov" => Ok(CameraEdit::SetFov(value::number(text)?)),
        "focal_distance" => Ok(CameraEdit::SetFocalDistance(value::unless(text, "auto", value::number::<Positive>)?)),
        "lens_radius" => Ok(CameraEdit::SetLensRadius(value::number(text)?)),
        "name" => Ok(CameraEdit::Rename(text.to_owned())),
        _ => Err(Refusal::Key { what: "a camera", keys: CAMERA }),
    }
}

pub(super) fn scene(key: &str, text: &str) -> Result<SceneEdit, Refusal> {
    match key {
        "background" => Ok(SceneEdit::SetBackground(value::color(text)?)),
        "ambient" => Ok(SceneEdit::SetAmbient(value::share(text)?)),
        "attenuation" => Ok(SceneEdit::SetAttenuation(value::number(text)?)),
        "name" => Ok(SceneEdit::Rename(text.to_owned())),
        _ => Err(Refusal::Key { what: "the scene", keys: SCENE }),
    }
}
