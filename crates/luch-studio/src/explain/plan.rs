//! A scene from above: the outline of each object, as lines and circles on the ground.

use egui::{Pos2, Rect, Vec2, pos2, vec2};
use glam::Vec3;
use luch_scene::{Color, Material, MeshInstance, Object, Scene, Shape};

/// The most outlines; of more objects the largest have one.
const MOST: usize = 600;
/// The most vertices that the outline of a mesh is found from.
const VERTICES: usize = 1500;
/// A wall that leans less than this is a floor or a ceiling: from above it is everywhere.
const LEVEL: f32 = 0.1;

/// A scene from above: x to the right, z down.
#[derive(Debug, Default)]
pub(crate) struct Plan {
    pub(crate) parts: Vec<Part>,
    /// The box around all that is bounded.
    pub(crate) bounds: Option<Rect>,
}

/// An object from above.
#[derive(Debug)]
pub(crate) struct Part {
    pub(crate) object: u32,
    pub(crate) figure: Figure,
    pub(crate) color: Color,
}

#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Figure {
    Circle {
        center: Pos2,
        radius: f32,
    },
    Polygon(Vec<Pos2>),
    /// A bounded wall that stands.
    Segment([Pos2; 2]),
    /// An endless wall: a point of it and the way that it runs.
    Line {
        point: Pos2,
        along: Vec2,
    },
}

impl Plan {
    pub(crate) fn of(scene: &Scene) -> Self {
        // Endless walls that lean cut the ground of the picture at the height of its middle.
        let height = scene.bounds().map_or(0.0, |[lo, hi]| (lo.y + hi.y) * 0.5);
        let visible = scene.objects.iter().zip(0_u32..).filter(|(object, _)| !object.hidden);
        let mut parts: Vec<Part> = visible.filter_map(|(object, index)| part(object, index, height)).collect();
        parts.sort_by(|a, b| b.figure.size().total_cmp(&a.figure.size()));
        parts.truncate(MOST);
        let boxes = parts.iter().filter_map(|part| part.figure.bounds());
        let bounds = boxes.reduce(Rect::union);
        Self { parts, bounds }
    }
}

impl Figure {
    pub(crate) fn bounds(&self) -> Option<Rect> {
        let rect = match self {
            Self::Circle { center, radius } => Rect::from_center_size(*center, Vec2::splat(radius * 2.0)),
            Self::Polygon(points) => Rect::from_points(points),
            Self::Segment(ends) => Rect::from_points(ends),
            Self::Line { .. } => return None,
        };
        rect.is_finite().then_some(rect)
    }

    /// The longer side; endless for an endless wall.
    fn size(&self) -> f32 {
        self.bounds().map_or(f32::INFINITY, |bounds| bounds.size().max_elem())
    }
}

/// A place on the ground.
pub(crate) fn from_above(place: Vec3) -> Pos2 {
    pos2(place.x, place.z)
}

fn part(object: &Object, index: u32, height: f32) -> Option<Part> {
    let figure = match &object.shape {
        Shape::Sphere { center, radius } => Figure::Circle { center: from_above(center.get()), radius: radius.get() },
        Shape::Cuboid { center, size, rotation } => {
            let half = size.map(|side| side.get() * 0.5);
            let corner = |bits: u8| {
                let sign = |bit: u8| if bits & bit == 0 { -1.0 } else { 1.0 };
                let corner = Vec3::new(half[0] * sign(1), half[1] * sign(2), half[2] * sign(4));
                from_above(center.get() + rotation.matrix() * corner)
            };
            Figure::Polygon(hull((0..8).map(corner).collect()))
        }
        Shape::Wall { point, normal, size: Some([width, tall]) } => {
            let [u, v] = Shape::wall_axes(*normal);
            let (u, v) = (u * width.get() * 0.5, v * tall.get() * 0.5);
            let corners = [u + v, u - v, -u - v, v - u].map(|corner| from_above(point.get() + corner));
            match hull(corners.to_vec())[..] {
                [a, b] => Figure::Segment([a, b]),
                ref outline => Figure::Polygon(outline.to_vec()),
            }
        }
        Shape::Wall { point, normal, size: None } => {
            let (n, p) = (normal.unit(), point.get());
            let on_ground = vec2(n.x, n.z);
            let length = on_ground.length();
            if length < LEVEL {
                return None;
            }
            // The point of the wall at the height of the scene's middle, straight ahead of the wall's own.
            let shift = on_ground * (n.y * (p.y - height) / (length * length));
            Figure::Line { point: from_above(p) + shift, along: on_ground.rot90() / length }
        }
        Shape::Mesh(instance) => Figure::Polygon(hull(footprint(instance))),
    };
    let color = object.material.color.unwrap_or(Material::DEFAULT_COLOR);
    Some(Part { object: index, figure, color })
}

/// Some of a mesh's vertices, from above.
fn footprint(instance: &MeshInstance) -> Vec<Pos2> {
    let world = instance.rotation.matrix() * instance.scale.get();
    let positions = instance.mesh.positions();
    let step = positions.len().div_ceil(VERTICES).max(1);
    let some = positions.iter().step_by(step);
    some.map(|&p| from_above(world * Vec3::from(p) + instance.position.get())).collect()
}

/// The convex hull: Andrew's monotone chain ("Another efficient algorithm for convex hulls in two dimensions", 1979).
/// Two points where all lie on a line.
fn hull(mut points: Vec<Pos2>) -> Vec<Pos2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let size = Rect::from_points(&points).size().max_elem();
    // What bends less than this is straight: rounding of corners that lie on a line is no corner.
    let flat = size * size * 1e-6;
    let chain = |points: &mut dyn Iterator<Item = &Pos2>| {
        let mut chain: Vec<Pos2> = Vec::new();
        for &point in points {
            while let [.., a, b] = chain[..] {
                let (u, v) = (b - a, point - b);
                if u.x * v.y - u.y * v.x > flat {
                    break;
                }
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop();
        chain
    };
    let mut outline = chain(&mut points.iter());
    outline.extend(chain(&mut points.iter().rev()));
    outline
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::{Direction, Point, Rotation, Size};

    fn scene(shapes: Vec<Shape>) -> Scene {
        let mut scene = Scene::new("s");
        for (number, shape) in shapes.into_iter().enumerate() {
            scene.objects.push(Object::new(format!("{number}"), shape));
        }
        scene
    }

    fn wall(normal: Vec3, size: Option<[Size; 2]>) -> Shape {
        Shape::Wall {
            point: Point::new(Vec3::new(2.0, 0.0, 0.0)).unwrap(),
            normal: Direction::new(normal).unwrap(),
            size,
        }
    }

    #[test]
    fn a_turned_box_has_four_corners_and_a_standing_wall_two() {
        let one = Size::ONE;
        let turned = Shape::Cuboid {
            center: Point::ORIGIN,
            size: [one, one, one],
            rotation: Rotation::new(Vec3::new(0.0, 45.0, 0.0)).unwrap(),
        };
        let plan = Plan::of(&scene(vec![turned, wall(Vec3::X, Some([one, one]))]));
        let Figure::Polygon(corners) = &plan.parts[0].figure else { panic!("{plan:?}") };
        assert_eq!(corners.len(), 4);
        let bounds = plan.parts[0].figure.bounds().unwrap();
        assert!((bounds.width() - 2.0_f32.sqrt()).abs() < 1e-5, "{bounds:?}");
        let Figure::Segment([a, b]) = plan.parts[1].figure else { panic!("{plan:?}") };
        assert!((a.x, b.x) == (2.0, 2.0) && (a.y - b.y).abs() == 1.0, "{a:?} {b:?}");
    }

    #[test]
    fn endless_walls_are_lines_where_they_stand_and_nothing_where_they_lie() {
        let plan =
            Plan::of(&scene(vec![wall(Vec3::X, None), wall(Vec3::Y, None), wall(Vec3::new(1.0, 1.0, 0.0), None)]));
        assert_eq!(plan.parts.len(), 2);
        for part in &plan.parts {
            let Figure::Line { point, along } = part.figure else { panic!("{plan:?}") };
            // The leaning wall through (2, 0) is at height 0 there as well.
            assert!((point.x - 2.0).abs() < 1e-5 && along.x.abs() < 1e-6, "{part:?}");
        }
        assert_eq!(plan.bounds, None);
    }
}
