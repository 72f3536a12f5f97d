//! Objects of a scene file: exactly one shape, and the look.

use super::fields::{Field, Fields, Schema};
use super::raw::shading;
use crate::error::Result;
use luch_scene::{Checker, Direction, Material, Point, Rotation, Shading, Shape, Size};
use std::ops::Range;

/// An object as the file says it.
#[derive(Debug)]
pub(super) struct RawObject {
    /// Empty where the file gives none.
    pub(super) name: String,
    pub(super) shape: RawShape,
    pub(super) material: Material,
    pub(super) shading: Option<Shading>,
    pub(super) hidden: bool,
    /// Where it stands in the file, for what is found out later.
    pub(super) place: Range<usize>,
}

/// A shape, or a mesh that is not loaded yet.
#[derive(Debug)]
pub(super) enum RawShape {
    Ready(Shape),
    Mesh { path: String, span: Range<usize>, position: Point, rotation: Rotation, scale: Size },
}

/// The keys that give an object its shape.
const SHAPES: [&str; 5] = ["sphere", "cube", "box", "wall", "mesh"];

pub(super) const OBJECT: Schema = Schema {
    what: "an object",
    keys: &[
        "name",
        "sphere",
        "cube",
        "box",
        "wall",
        "mesh",
        "position",
        "rotation",
        "scale",
        "color",
        "reflection",
        "gloss",
        "shading",
        "pattern",
        "hidden",
    ],
    elsewhere: &[
        ("radius", "it belongs to the sphere: sphere = { center = [x, y, z], radius = r }"),
        ("center", "it belongs to the shape: sphere = { center = [x, y, z], radius = r }"),
        ("side", "it belongs to the cube: cube = { center = [x, y, z], side = s }"),
        ("size", "it belongs to the shape: box = { center = [x, y, z], size = [x, y, z] }"),
        ("point", "it belongs to the wall: wall = { point = [x, y, z], normal = [x, y, z] }"),
        ("normal", "it belongs to the wall: wall = { point = [x, y, z], normal = [x, y, z] }"),
        ("checker", "it belongs to the pattern: pattern = { checker = { size = 1.0, color = \"#404040\" } }"),
    ],
};
const SPHERE: Schema = Schema { what: "a sphere", keys: &["center", "radius"], elsewhere: &[] };
const CUBE: Schema = Schema {
    what: "a cube",
    keys: &["center", "side"],
    elsewhere: &[
        ("size", "a cube has one `side`; three sizes make a box: box = { center = [x, y, z], size = [x, y, z] }"),
        ("rotation", "rotation stands in the object, beside the cube"),
    ],
};
const BOX: Schema = Schema {
    what: "a box",
    keys: &["center", "size"],
    elsewhere: &[("rotation", "rotation stands in the object, beside the box")],
};
const WALL: Schema = Schema { what: "a wall", keys: &["point", "normal", "size"], elsewhere: &[] };
const PATTERN: Schema = Schema {
    what: "a pattern",
    keys: &["checker"],
    elsewhere: &[("size", "write pattern = { checker = { size = 1.0, color = \"#404040\" } }")],
};
const CHECKER: Schema = Schema { what: "a checker pattern", keys: &["size", "color"], elsewhere: &[] };

impl RawObject {
    /// Reads an object.
    pub(super) fn read(fields: &Fields<'_, '_>, name: String) -> Result<Self> {
        let material = Material {
            color: fields.get("color").map(|f| f.color()).transpose()?,
            reflection: fields.get("reflection").map(|f| f.number()).transpose()?.unwrap_or(luch_scene::Unit::ZERO),
            gloss: fields.get("gloss").map(|f| f.number()).transpose()?,
            checker: fields.get("pattern").map(|f| pattern(&f)).transpose()?,
        };
        Ok(Self {
            name,
            shape: shape(fields)?,
            material,
            shading: fields.get("shading").map(|f| shading(&f)).transpose()?,
            hidden: fields.get("hidden").map_or(Ok(false), |f| f.truth())?,
            place: fields.place.clone(),
        })
    }
}

fn shape(fields: &Fields<'_, '_>) -> Result<RawShape> {
    let mut given: Vec<Field<'_, '_>> = SHAPES.iter().filter_map(|key| fields.get(key)).collect();
    given.sort_by_key(|f| f.key_span().start);
    let shape = match given.as_slice() {
        [] => {
            let what = "a shape: sphere, cube, box, wall or mesh";
            return Err(fields.missing(what, "sphere = { center = [0.0, 1.0, 0.0], radius = 1.0 }"));
        }
        [shape] => *shape,
        [first, second, ..] => {
            let text = format!("an object has one shape, and this one has `{}` already", first.key);
            return Err(second.key_error(text).hint("begin another [[object]] for it"));
        }
    };
    // What does not apply to a shape is refused, not ignored: somebody expects it to do something.
    let centre = "a place of its own, inside its braces";
    match shape.key {
        "mesh" => {}
        "cube" | "box" => refuse(fields, shape.key, &[("position", centre), ("scale", "a size of its own")])?,
        _ => {
            let turned = if shape.key == "wall" { "a normal instead" } else { "nothing to turn" };
            refuse(fields, shape.key, &[("position", centre), ("rotation", turned), ("scale", "a size of its own")])?;
        }
    }
    let rotation = fields.get("rotation").map_or(Ok(Rotation::NONE), |f| f.vector(Rotation::new))?;
    Ok(match shape.key {
        "sphere" => {
            let inner = shape.table(SPHERE, "{ center = [0.0, 1.0, 0.0], radius = 1.0 }")?;
            RawShape::Ready(Shape::Sphere {
                center: point(&inner, "center")?,
                radius: inner.need("radius", "radius = 1.0")?.number()?,
            })
        }
        "cube" => {
            let inner = shape.table(CUBE, "{ center = [0.0, 0.5, 0.0], side = 1.0 }")?;
            let side = inner.need("side", "side = 1.0")?.number()?;
            RawShape::Ready(Shape::Cuboid { center: point(&inner, "center")?, size: [side; 3], rotation })
        }
        "box" => {
            let inner = shape.table(BOX, "{ center = [0.0, 0.5, 0.0], size = [1.0, 1.0, 2.0] }")?;
            let size = inner.need("size", "size = [1.0, 1.0, 2.0]")?.triple()?;
            RawShape::Ready(Shape::Cuboid { center: point(&inner, "center")?, size, rotation })
        }
        "wall" => {
            let inner = shape.table(WALL, "{ point = [0.0, 0.0, 0.0], normal = [0.0, 1.0, 0.0] }")?;
            RawShape::Ready(Shape::Wall {
                point: point(&inner, "point")?,
                normal: inner.need("normal", "normal = [0.0, 1.0, 0.0]")?.vector(Direction::new)?,
                size: inner.get("size").map(|f| f.pair_of_sizes()).transpose()?,
            })
        }
        _ => RawShape::Mesh {
            path: shape.string("the path of a model file in quotes")?.to_owned(),
            span: shape.span(),
            position: fields.get("position").map_or(Ok(Point::ORIGIN), |f| f.vector(Point::new))?,
            rotation,
            scale: fields.get("scale").map_or(Ok(Size::ONE), |f| f.number())?,
        },
    })
}

fn point(fields: &Fields<'_, '_>, key: &'static str) -> Result<Point> {
    fields.need(key, &format!("{key} = [0.0, 1.0, 0.0]"))?.vector(Point::new)
}

/// Refuses keys that mean nothing for a shape, saying what it has instead.
fn refuse(fields: &Fields<'_, '_>, shape: &str, keys: &[(&'static str, &str)]) -> Result<()> {
    match keys.iter().find_map(|(key, instead)| fields.get(key).map(|f| (f, instead))) {
        Some((field, instead)) => {
            Err(field.key_error(format!("`{}` is not for a {shape}, which has {instead}", field.key)))
        }
        None => Ok(()),
    }
}

fn pattern(field: &Field<'_, '_>) -> Result<Checker> {
    const EXAMPLE: &str = "{ size = 1.0, color = \"#404040\" }";
    let pattern = field.table(PATTERN, &format!("{{ checker = {EXAMPLE} }}"))?;
    let checker = pattern.need("checker", &format!("pattern = {{ checker = {EXAMPLE} }}"))?.table(CHECKER, EXAMPLE)?;
    Ok(Checker {
        size: checker.need("size", "size = 1.0")?.number()?,
        color: checker.need("color", "color = \"#404040\"")?.color()?,
    })
}
