//! How much room a thing takes, and from where all of it is seen.

use super::eye::Eye;
use crate::selection::Part;
use glam::{DMat3, DVec3};
use luch_scene::number::MIN_SIZE;
use luch_scene::{Scene, Shape};

/// The part of the picture's width and height that a thing in view takes.
const FILLED: f64 = 0.85;
/// The room given to a lamp, which has none of its own, in parts of the scene's.
const LAMP: f64 = 0.1;

/// The room that a thing takes: a ball or a turned box.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Extent {
    pub(crate) center: DVec3,
    radius: f64,
    /// From the centre to three faces of the box.
    half: DMat3,
}

impl Extent {
    fn ball(center: DVec3, radius: f64) -> Self {
        Self { center, radius, half: DMat3::ZERO }
    }

    /// The room of a part; `None` for an endless wall and for what the scene does not have.
    pub(crate) fn of(part: Part, scene: &Scene) -> Option<Self> {
        match part {
            Part::Object(index) => Self::of_shape(&scene.objects.get(index)?.shape),
            Part::Light(index) => {
                let room = Self::of_scene(scene).map_or(1.0, |all| all.reach() * LAMP);
                Some(Self::ball(scene.lights.get(index)?.position.get().as_dvec3(), room))
            }
        }
    }

    /// The room of all visible objects that are bounded. Looks at each of them.
    pub(crate) fn of_scene(scene: &Scene) -> Option<Self> {
        let [lo, hi] = scene.bounds()?.map(|corner| corner.as_dvec3());
        Some(Self { center: (lo + hi) * 0.5, radius: 0.0, half: DMat3::from_diagonal((hi - lo) * 0.5) })
    }

    fn of_shape(shape: &Shape) -> Option<Self> {
        let center = shape.position().get().as_dvec3();
        let boxed = |axes: DMat3, half: DVec3| axes * DMat3::from_diagonal(half);
        Some(match shape {
            Shape::Sphere { radius, .. } => Self::ball(center, f64::from(radius.get())),
            Shape::Cuboid { size, rotation, .. } => {
                let half = DVec3::from_array(size.map(|side| f64::from(side.get()) * 0.5));
                Self { center, radius: 0.0, half: boxed(rotation.matrix().as_dmat3(), half) }
            }
            Shape::Wall { size: None, .. } => return None,
            Shape::Wall { normal, size: Some([width, height]), .. } => {
                let [u, v] = Shape::wall_axes(*normal).map(|axis| axis.as_dvec3());
                let half = DVec3::new(f64::from(width.get()) * 0.5, f64::from(height.get()) * 0.5, 0.0);
                Self { center, radius: 0.0, half: boxed(DMat3::from_cols(u, v, DVec3::ZERO), half) }
            }
            Shape::Mesh(instance) => {
                let turn = instance.rotation.matrix().as_dmat3() * f64::from(instance.scale.get());
                let [lo, hi] = instance.mesh.bounds().map(|corner| corner.as_dvec3());
                let center = center + turn * ((lo + hi) * 0.5);
                Self { center, radius: 0.0, half: boxed(turn, (hi - lo) * 0.5) }
            }
        })
    }

    /// How far it reaches from its centre, at most.
    pub(crate) fn reach(&self) -> f64 {
        let [x, y, z] = [self.half.x_axis, self.half.y_axis, self.half.z_axis];
        self.radius + (x.length_squared() + y.length_squared() + z.length_squared()).sqrt()
    }

    /// The radius of a ball; `None` for a box.
    pub(crate) fn radius(&self) -> Option<f64> {
        (self.radius > 0.0).then_some(self.radius)
    }

    /// The corners of a box. Each bit of a corner's number stands for a side.
    pub(crate) fn corners(&self) -> [DVec3; 8] {
        let sign = |corner: usize, bit: usize| if corner & bit == 0 { -1.0 } else { 1.0 };
        std::array::from_fn(|corner| {
            self.center + self.half * DVec3::new(sign(corner, 1), sign(corner, 2), sign(corner, 4))
        })
    }

    /// How far it reaches along `way`: the greatest product with it.
    fn support(&self, way: DVec3) -> f64 {
        let across = (self.half.transpose() * way).abs().element_sum();
        self.center.dot(way) + self.radius * way.length() + across
    }

    /// The same look from where all of it is in the picture, in the middle. `slopes`: half the picture's width and height
    /// at distance 1.
    pub(crate) fn framed(&self, eye: &Eye, slopes: [f64; 2]) -> Eye {
        let [right, up, forward] = eye.axes();
        // The eye must lie behind the two planes through an edge of the picture that touch the thing; where they meet, it
        // fits exactly and is in the middle.
        let fit = |across: DVec3, slope: f64| {
            let slope = slope * FILLED;
            let sides = [across, -across].map(|side| self.support(side - forward * slope));
            ((sides[0] - sides[1]) * 0.5, -(sides[0] + sides[1]) / (2.0 * slope))
        };
        let ((x, from_width), (y, from_height)) = (fit(right, slopes[0]), fit(up, slopes[1]));
        let middle = self.center.dot(forward);
        let nearest = (self.center.abs().max_element() * 1e-4).max(f64::from(MIN_SIZE));
        let z = from_width.min(from_height).min(middle - nearest);
        eye.looking_from(right * x + up * y + forward * z, middle - z)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use luch_scene::{Aim, Camera, Direction, Light, Object, Point, Rotation, Size};

    fn eye() -> Eye {
        Eye::of(&Camera::new("c", Point::new(Vec3::new(3.0, 4.0, 9.0)).unwrap(), Aim::At(Point::ORIGIN)))
    }

    fn scene_of(shape: Shape) -> Scene {
        let mut scene = Scene::new("s");
        scene.objects.push(Object::new("o", shape));
        scene
    }

    fn point(x: f32, y: f32, z: f32) -> Point {
        Point::new(Vec3::new(x, y, z)).unwrap()
    }

    /// The greatest parts of half the width and height at which corners of a box are seen.
    fn filled(eye: &Eye, extent: &Extent, slopes: [f64; 2]) -> [f64; 2] {
        let [right, up, forward] = eye.axes();
        let mut most = [0.0_f64; 2];
        for corner in extent.corners() {
            let away = corner - eye.position;
            let depth = away.dot(forward);
            assert!(depth > 0.0);
            most[0] = most[0].max((away.dot(right) / depth).abs() / slopes[0]);
            most[1] = most[1].max((away.dot(up) / depth).abs() / slopes[1]);
        }
        most
    }

    #[test]
    fn a_framed_box_fills_the_picture_to_its_margin_at_any_scale() {
        for scale in [1e-3, 1.0, 1e6] {
            let size = [2.0, 0.5, 1.0].map(|side| Size::new(side * scale).unwrap());
            let rotation = Rotation::new(Vec3::new(10.0, 30.0, 5.0)).unwrap();
            let scene = scene_of(Shape::Cuboid { center: point(scale, -scale, 5.0 * scale), size, rotation });
            let extent = Extent::of(Part::Object(0), &scene).unwrap();
            for slopes in [[0.55, 0.41], [0.2, 0.41], [3.0, 2.0]] {
                let framed = extent.framed(&eye(), slopes);
                let [wide, tall] = filled(&framed, &extent, slopes);
                assert!((wide.max(tall) - FILLED).abs() < 1e-6, "{scale} {slopes:?}: {wide} {tall}");
                assert_eq!(framed.axes(), eye().axes(), "it looks the same way");
            }
        }
    }

    #[test]
    fn a_framed_ball_touches_its_margin() {
        let scene = scene_of(Shape::Sphere { center: point(1.0, 2.0, 3.0), radius: Size::new(0.5).unwrap() });
        let extent = Extent::of(Part::Object(0), &scene).unwrap();
        let framed = extent.framed(&eye(), [0.8, 0.4]);
        let away = extent.center - framed.position;
        // A tangent to the ball from that far away has the slope of the margin.
        let tangent = (0.5 / away.length()).asin().tan();
        assert!((tangent - 0.4 * FILLED).abs() < 1e-9);
        assert!(away.dot(framed.axes()[0]).abs() < 1e-9 && away.dot(framed.axes()[1]).abs() < 1e-9);
    }

    #[test]
    fn endless_walls_have_no_room_and_lamps_are_given_some() {
        let mut scene = scene_of(Shape::Wall { point: Point::ORIGIN, normal: Direction::UP, size: None });
        scene.lights.push(Light::new("l", point(0.0, 5.0, 0.0)));
        assert_eq!(Extent::of(Part::Object(0), &scene), None);
        assert_eq!(Extent::of_scene(&scene), None);
        assert_eq!(Extent::of(Part::Object(7), &scene), None);
        let lamp = Extent::of(Part::Light(0), &scene).unwrap();
        assert!(lamp.reach() > 0.0);
        assert!(lamp.framed(&eye(), [0.5, 0.4]).depth_of(lamp.center) > 0.0);
    }

    #[test]
    fn a_point_is_framed_from_in_front_of_it() {
        let least = Size::new(MIN_SIZE).unwrap();
        let scene = scene_of(Shape::Sphere { center: point(100.0, 2.0, 3.0), radius: least });
        let extent = Extent::of(Part::Object(0), &scene).unwrap();
        let framed = extent.framed(&eye(), [0.5, 0.4]);
        assert!(framed.depth_of(extent.center) > 1e-3);
    }
}
