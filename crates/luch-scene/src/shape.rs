//! The shapes that a scene is made of.

use crate::mesh::Mesh;
use crate::number::Size;
use crate::vector::{Direction, Point, Rotation};
use glam::Vec3;
use std::sync::Arc;

/// A placed mesh. The mesh itself is shared: pieces of one kind have one.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshInstance {
    /// The triangles.
    pub mesh: Arc<Mesh>,
    /// Where they came from, as the scene file names it: a path relative to the scene's folder.
    pub path: String,
    /// Where the model's origin stands: for a chess piece the centre of its bottom face.
    pub position: Point,
    /// How it is turned about its origin.
    pub rotation: Rotation,
    /// How much larger than in its file.
    pub scale: Size,
}

/// The geometry of an object.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// An exact sphere.
    Sphere {
        /// Its centre.
        center: Point,
        /// Its radius.
        radius: Size,
    },
    /// A box; a cube where the three sizes are equal.
    Cuboid {
        /// Its centre.
        center: Point,
        /// Full side lengths along its own x, y and z.
        size: [Size; 3],
        /// How it is turned about its centre.
        rotation: Rotation,
    },
    /// A plane, or a rectangle of one.
    Wall {
        /// A point of the plane; the centre of the rectangle.
        point: Point,
        /// The direction that the wall faces.
        normal: Direction,
        /// Width and height of the rectangle along [`Shape::wall_axes`]; `None`: unbounded.
        size: Option<[Size; 2]>,
    },
    /// A triangle mesh.
    Mesh(MeshInstance),
}

impl Shape {
    /// The word for it in scene files: `sphere`, `cube`, `box`, `wall` or `mesh`.
    #[must_use]
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Sphere { .. } => "sphere",
            Self::Cuboid { size: [x, y, z], rotation, .. } if x == y && y == z && rotation.is_none() => "cube",
            Self::Cuboid { .. } => "box",
            Self::Wall { .. } => "wall",
            Self::Mesh(_) => "mesh",
        }
    }

    /// The point that "position" means: a centre, a wall's point, a model's origin.
    #[must_use]
    pub const fn position(&self) -> Point {
        match self {
            Self::Sphere { center, .. } | Self::Cuboid { center, .. } => *center,
            Self::Wall { point, .. } => *point,
            Self::Mesh(instance) => instance.position,
        }
    }

    /// Moves the shape so that [`Shape::position`] is `to`.
    pub fn set_position(&mut self, to: Point) {
        match self {
            Self::Sphere { center, .. } | Self::Cuboid { center, .. } => *center = to,
            Self::Wall { point, .. } => *point = to,
            Self::Mesh(instance) => instance.position = to,
        }
    }

    /// The axes of a wall in its own plane: width runs along the first, height along the second.
    ///
    /// A standing wall's height is as near to y as can be; a floor's runs along -z, away from the usual viewer. `u x v = n`.
    #[must_use]
    pub fn wall_axes(normal: Direction) -> [Vec3; 2] {
        let n = normal.unit().as_dvec3();
        // A floor or ceiling has no "up" of its own: -z, the way a viewer looks, serves for it.
        let up = if n.y.abs() > 0.999 { glam::DVec3::NEG_Z } else { glam::DVec3::Y };
        let u = up.cross(n).normalize_or(glam::DVec3::X);
        let v = n.cross(u);
        [u.as_vec3(), v.as_vec3()]
    }

    /// Lower and upper corner of the box around the shape; `None` for an unbounded wall.
    #[must_use]
    pub fn bounds(&self) -> Option<[Vec3; 2]> {
        match self {
            Self::Sphere { center, radius } => {
                let r = Vec3::splat(radius.get());
                Some([center.get() - r, center.get() + r])
            }
            Self::Cuboid { center, size, rotation } => {
                let half = Vec3::from_array(size.map(|s| s.get() * 0.5));
                let m = rotation.matrix();
                let reach = m.x_axis.abs() * half.x + m.y_axis.abs() * half.y + m.z_axis.abs() * half.z;
                Some([center.get() - reach, center.get() + reach])
            }
            Self::Wall { size: None, .. } => None,
            Self::Wall { point, normal, size: Some([width, height]) } => {
                let [u, v] = Self::wall_axes(*normal);
                let reach = u.abs() * (width.get() * 0.5) + v.abs() * (height.get() * 0.5);
                Some([point.get() - reach, point.get() + reach])
            }
            Self::Mesh(instance) => {
                let m = instance.rotation.matrix() * instance.scale.get();
                let [lo, hi] = instance.mesh.bounds();
                let (center, half) = ((lo + hi) * 0.5, (hi - lo) * 0.5);
                let middle = m * center + instance.position.get();
                let reach = m.x_axis.abs() * half.x + m.y_axis.abs() * half.y + m.z_axis.abs() * half.z;
                Some([middle - reach, middle + reach])
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wall_axes_are_right_handed_and_stand_upright() {
        for n in [Vec3::Y, Vec3::NEG_Y, Vec3::X, Vec3::NEG_Z, Vec3::new(1.0, 2.0, 3.0), Vec3::new(0.001, -5.0, 0.0)] {
            let normal = Direction::new(n).unwrap();
            let [u, v] = Shape::wall_axes(normal);
            assert!((u.cross(v) - normal.unit()).length() < 1e-6, "{n}");
            assert!(v.y >= -1e-6, "{n}");
        }
        let [u, v] = Shape::wall_axes(Direction::UP);
        assert_eq!((u, v), (Vec3::X, Vec3::NEG_Z));
    }

    #[test]
    fn a_turned_cube_is_a_box_with_wider_bounds() {
        let one = Size::ONE;
        let cube = |degrees: f32| Shape::Cuboid {
            center: Point::ORIGIN,
            size: [one, one, one],
            rotation: Rotation::new(Vec3::new(0.0, degrees, 0.0)).unwrap(),
        };
        assert_eq!((cube(0.0).kind(), cube(45.0).kind()), ("cube", "box"));
        let [_, hi] = cube(45.0).bounds().unwrap();
        assert!((hi.x - 0.5_f32.sqrt()).abs() < 1e-6 && hi.y == 0.5);
    }
}
