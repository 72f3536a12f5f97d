//! What is being moved, turned or scaled, as it was when the drag began, and what becomes of it.

use super::euler::degrees_of;
use crate::command::Tool;
use crate::selection::Part;
use glam::{DMat3, DVec3};
use luch_scene::{Direction, Edit, ObjectEdit, Point, Rotation, Scene, Shape, Size};

/// A change by the gizmo.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Change {
    /// Moved by so much along the axes of the scene.
    Move(DVec3),
    /// Turned about an axis of the scene, by degrees.
    Turn(usize, f64),
    /// Its own axes made so many times as long.
    Scale(DVec3),
}

impl Change {
    /// Whether it leaves everything as it is.
    pub(super) fn is_nothing(self) -> bool {
        match self {
            Self::Move(by) => by == DVec3::ZERO,
            Self::Turn(_, degrees) => degrees == 0.0,
            Self::Scale(by) => by == DVec3::ONE,
        }
    }
}

/// The selected thing.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Subject {
    pub(super) part: Part,
    name: String,
    pub(super) position: DVec3,
    /// `None` for a lamp.
    shape: Option<Shape>,
}

/// Which handles a tool has for a thing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Abilities {
    /// For each axis whether there is a handle.
    pub(super) axes: [bool; 3],
    /// Whether there is one for all axes together.
    pub(super) whole: bool,
}

impl Abilities {
    const NONE: Self = Self { axes: [false; 3], whole: false };
    const ALL: Self = Self { axes: [true; 3], whole: true };

    pub(super) fn is_none(self) -> bool {
        self == Self::NONE
    }
}

impl Subject {
    pub(super) fn of(part: Part, scene: &Scene) -> Option<Self> {
        let name = part.name(scene)?.to_owned();
        let position = part.position(scene)?.get().as_dvec3();
        let shape = match part {
            Part::Object(index) => Some(scene.objects.get(index)?.shape.clone()),
            Part::Light(_) => None,
        };
        Some(Self { part, name, position, shape })
    }

    /// Whether it is still the same thing that has this place in the scene, whatever was done to it.
    pub(super) fn is_still_in(&self, scene: &Scene) -> bool {
        self.part.name(scene) == Some(self.name.as_str())
    }

    /// What a tool can do with it.
    pub(super) fn abilities(&self, tool: Tool) -> Abilities {
        let whole = Abilities { axes: [false; 3], whole: true };
        match (tool, &self.shape) {
            (Tool::Move, _) => Abilities::ALL,
            (Tool::Rotate, Some(Shape::Cuboid { .. } | Shape::Mesh(_))) => Abilities { whole: false, ..Abilities::ALL },
            // About its own normal a wall cannot turn.
            (Tool::Rotate, Some(Shape::Wall { normal, .. })) => {
                Abilities { axes: normal.unit().to_array().map(|part| part.abs() < 0.999), whole: false }
            }
            (Tool::Scale, Some(Shape::Sphere { .. } | Shape::Mesh(_))) => whole,
            (Tool::Scale, Some(Shape::Cuboid { .. })) => Abilities::ALL,
            (Tool::Scale, Some(Shape::Wall { size: Some(_), .. })) => {
                Abilities { axes: [true, true, false], whole: true }
            }
            _ => Abilities::NONE,
        }
    }

    /// The directions of its handles: the scene's axes, or its own where it is scaled along them.
    pub(super) fn axes(&self, tool: Tool) -> [DVec3; 3] {
        let own = match (tool, &self.shape) {
            (Tool::Scale, Some(Shape::Cuboid { rotation, .. })) => Some(rotation.matrix().as_dmat3()),
            (Tool::Scale, Some(Shape::Wall { normal, .. })) => {
                let [u, v] = Shape::wall_axes(*normal).map(|axis| axis.as_dvec3());
                Some(DMat3::from_cols(u, v, u.cross(v)))
            }
            _ => None,
        };
        let axes = own.unwrap_or(DMat3::IDENTITY);
        // Of unit length up to the rounding of a matrix: handles rely on it.
        [axes.x_axis, axes.y_axis, axes.z_axis].map(DVec3::normalize_or_zero)
    }

    /// The edit that makes of the thing as it was what a change makes of it. `None` if it cannot be changed so.
    pub(super) fn edit(&self, change: Change) -> Option<Edit> {
        if let Change::Move(by) = change {
            let to = (self.position + by).as_vec3();
            return Some(self.part.move_to(Point::new(to).ok()?));
        }
        let Part::Object(index) = self.part else { return None };
        let mut shape = self.shape.clone()?;
        match change {
            Change::Move(_) => {}
            Change::Turn(axis, degrees) => turn(&mut shape, axis, degrees)?,
            Change::Scale(by) => scale(&mut shape, by),
        }
        Some(Edit::Object(index, ObjectEdit::SetShape(shape)))
    }
}

fn turn(shape: &mut Shape, axis: usize, degrees: f64) -> Option<()> {
    let mut about = DVec3::ZERO;
    about[axis] = 1.0;
    let turn = DMat3::from_axis_angle(about, degrees.to_radians());
    let turned = |old: Rotation| {
        let angles = degrees_of(turn * old.matrix().as_dmat3(), old.degrees().as_dvec3());
        Rotation::new(angles.as_vec3()).ok()
    };
    match shape {
        Shape::Cuboid { rotation, .. } => *rotation = turned(*rotation)?,
        Shape::Mesh(instance) => instance.rotation = turned(instance.rotation)?,
        Shape::Wall { normal, .. } => {
            let length = normal.get().as_dvec3().length();
            let turned = turn * normal.get().as_dvec3();
            // A quarter turn of an axis is an axis.
            let clean = (turned / length * 1e6).round() / 1e6 * length;
            *normal = Direction::new(clean.as_vec3()).ok()?;
        }
        Shape::Sphere { .. } => return None,
    }
    Some(())
}

fn scale(shape: &mut Shape, by: DVec3) {
    let scaled = |size: Size, by: f64| Size::clamped((f64::from(size.get()) * by) as f32);
    match shape {
        Shape::Sphere { radius, .. } => *radius = scaled(*radius, by.x),
        Shape::Mesh(instance) => instance.scale = scaled(instance.scale, by.x),
        Shape::Cuboid { size: [x, y, z], .. } => {
            (*x, *y, *z) = (scaled(*x, by.x), scaled(*y, by.y), scaled(*z, by.z));
        }
        Shape::Wall { size, .. } => {
            if let Some([width, height]) = size {
                (*width, *height) = (scaled(*width, by.x), scaled(*height, by.y));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use luch_scene::{Light, Object};

    fn scene(shape: Shape) -> Scene {
        let mut scene = Scene::new("s");
        scene.objects.push(Object::new("o", shape));
        scene.lights.push(Light::new("l", Point::ORIGIN));
        scene
    }

    fn point(x: f32, y: f32, z: f32) -> Point {
        Point::new(Vec3::new(x, y, z)).unwrap()
    }

    fn cuboid() -> Shape {
        let rotation = Rotation::new(Vec3::new(0.0, 30.0, 0.0)).unwrap();
        Shape::Cuboid { center: point(1.0, 2.0, 3.0), size: [1.0, 2.0, 4.0].map(|s| Size::new(s).unwrap()), rotation }
    }

    fn wall(size: Option<[Size; 2]>) -> Shape {
        Shape::Wall { point: Point::ORIGIN, normal: Direction::new(Vec3::new(0.0, 2.0, 0.0)).unwrap(), size }
    }

    /// The object after a change.
    fn after(shape: Shape, change: Change) -> Shape {
        let mut scene = scene(shape);
        let subject = Subject::of(Part::Object(0), &scene).unwrap();
        subject.edit(change).unwrap().apply(&mut scene).unwrap();
        scene.objects[0].shape.clone()
    }

    #[test]
    fn a_move_along_an_axis_leaves_the_other_coordinates_bit_for_bit() {
        let Shape::Cuboid { center, .. } = after(cuboid(), Change::Move(DVec3::X * 0.123)) else { panic!() };
        assert_eq!((center.get().y, center.get().z), (2.0, 3.0));
        assert!((center.get().x - 1.123).abs() < 1e-6);
    }

    #[test]
    fn turns_are_about_the_axes_of_the_scene() {
        let Shape::Cuboid { rotation, .. } = after(cuboid(), Change::Turn(1, 15.0)) else { panic!() };
        assert_eq!(rotation.degrees(), Vec3::new(0.0, 45.0, 0.0));
        let Shape::Cuboid { rotation, .. } = after(cuboid(), Change::Turn(0, 90.0)) else { panic!() };
        let expected = DMat3::from_rotation_x(90_f64.to_radians()) * DMat3::from_rotation_y(30_f64.to_radians());
        let apart = rotation.matrix().as_dmat3() - expected;
        assert!(apart.x_axis.length() + apart.y_axis.length() + apart.z_axis.length() < 1e-5);
        let Shape::Wall { normal, .. } = after(wall(None), Change::Turn(2, 90.0)) else { panic!() };
        assert_eq!(normal.get(), Vec3::new(-2.0, 0.0, 0.0), "a wall keeps the length of its normal");
    }

    #[test]
    fn scaling_is_along_its_own_axes() {
        let Shape::Cuboid { size, center, .. } = after(cuboid(), Change::Scale(DVec3::new(2.0, 1.0, 0.5))) else {
            panic!()
        };
        assert_eq!(size.map(Size::get), [2.0, 2.0, 2.0]);
        assert_eq!(center, point(1.0, 2.0, 3.0));
        let subject = Subject::of(Part::Object(0), &scene(cuboid())).unwrap();
        let [x, ..] = subject.axes(Tool::Scale);
        assert!((x - DVec3::new(0.75_f64.sqrt(), 0.0, -0.5)).length() < 1e-6, "{x}");
        assert_eq!(subject.axes(Tool::Move)[0], DVec3::X);
        // It never vanishes.
        let Shape::Cuboid { size, .. } = after(cuboid(), Change::Scale(DVec3::ZERO)) else { panic!() };
        assert!(size.iter().all(|side| side.get() > 0.0));
    }

    #[test]
    fn handles_are_only_for_what_can_be_done() {
        let of = |shape: Shape, tool| Subject::of(Part::Object(0), &scene(shape)).unwrap().abilities(tool);
        let ball = || Shape::Sphere { center: Point::ORIGIN, radius: Size::ONE };
        assert!(of(ball(), Tool::Rotate).is_none());
        assert_eq!(of(ball(), Tool::Scale), Abilities { axes: [false; 3], whole: true });
        assert_eq!(of(cuboid(), Tool::Scale), Abilities::ALL);
        assert_eq!(of(wall(None), Tool::Rotate).axes, [true, false, true]);
        assert!(of(wall(None), Tool::Scale).is_none());
        assert_eq!(of(wall(Some([Size::ONE; 2])), Tool::Scale).axes, [true, true, false]);
        let lamp = Subject::of(Part::Light(0), &scene(ball())).unwrap();
        assert_eq!(lamp.abilities(Tool::Move), Abilities::ALL);
        assert!(lamp.abilities(Tool::Rotate).is_none() && lamp.abilities(Tool::Scale).is_none());
        assert!(lamp.edit(Change::Scale(DVec3::ONE)).is_none());
    }
}
