//! Where the handles are in the window, and which of them is at a point. They keep their size on the screen.

use super::math::{Sight, beside};
use super::subject::{Abilities, Subject};
use crate::command::Tool;
use crate::viewport::frame::PictureFrame;
use egui::{Pos2, Vec2};
use glam::DVec3;

/// Lengths in points.
pub(super) const ARROW: f64 = 92.0;
const GAP: f64 = 16.0;
pub(super) const RING: f64 = 84.0;
/// The circle that scales all axes.
const CIRCLE: f64 = 66.0;
/// Near and far side of the squares, and the reach of what is grasped around a line.
const SQUARE: [f64; 2] = [26.0, 46.0];
const REACH: f32 = 8.0;
/// The disk in the middle.
pub(super) const DISK: f32 = 9.0;
/// Shorter arrows point at the eye, and nothing can be told from dragging them.
const SHORTEST: f32 = 14.0;
/// Sides of a square whose normal is that nearly square to the view, as a cosine, are seen from their edge.
const EDGE_ON: f64 = 0.15;
/// Pieces that a ring is drawn in.
const PIECES: u32 = 64;

/// A part of the gizmo that can be grasped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Handle {
    /// Moves or scales along an axis.
    Axis(usize),
    /// Moves in the plane square to an axis.
    Plane(usize),
    /// Moves parallel to the picture.
    Free,
    /// Turns about an axis.
    Ring(usize),
    /// Scales along all axes.
    Whole,
}

/// The gizmo of a thing as it is seen.
#[derive(Debug, Clone)]
pub(super) struct Handles {
    pub(super) frame: PictureFrame,
    pub(super) tool: Tool,
    pub(super) center: DVec3,
    pub(super) axes: [DVec3; 3],
    pub(super) abilities: Abilities,
    /// The length in the scene of one point of the window, where the thing is.
    pub(super) unit: f64,
}

impl Handles {
    /// `None` for a thing behind the eye.
    pub(super) fn of(subject: &Subject, tool: Tool, frame: &PictureFrame) -> Option<Self> {
        let center = subject.position;
        frame.project(center)?;
        Some(Self {
            frame: frame.clone(),
            tool,
            center,
            axes: subject.axes(tool),
            abilities: subject.abilities(tool),
            unit: frame.length_of_point(frame.depth_of(center)),
        })
    }

    /// The handles there are, those in front first.
    pub(super) fn list(&self) -> Vec<Handle> {
        let axes = || (0..3).filter(|axis| self.abilities.axes[*axis]);
        let seen = |axis: &usize| self.arrow(*axis).is_some();
        match self.tool {
            Tool::Move => {
                let planes = (0..3).filter(|axis| self.square(*axis).is_some()).map(Handle::Plane);
                std::iter::once(Handle::Free).chain(planes).chain(axes().filter(seen).map(Handle::Axis)).collect()
            }
            Tool::Rotate => axes().map(Handle::Ring).collect(),
            Tool::Scale => {
                let whole = self.abilities.whole.then_some(Handle::Whole);
                axes().filter(seen).map(Handle::Axis).chain(whole).collect()
            }
            Tool::Select | Tool::Focus | Tool::Explain => Vec::new(),
        }
    }

    /// The handle that is grasped at a point of the window.
    pub(super) fn at(&self, at: Pos2) -> Option<Handle> {
        let list = self.list();
        // What is filled is hit within it; of lines the nearest counts.
        let filled = list.iter().copied().find(|handle| match handle {
            Handle::Free => self.frame.project(self.center).is_some_and(|center| center.distance(at) <= DISK + 2.0),
            Handle::Plane(axis) => self.square(*axis).is_some_and(|square| contains(&square, at)),
            _ => false,
        });
        filled.or_else(|| {
            let away = list.iter().filter_map(|handle| Some((*handle, self.distance(*handle, at)?)));
            let near = away.filter(|(_, away)| *away <= REACH);
            near.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(handle, _)| handle)
        })
    }

    fn distance(&self, handle: Handle, at: Pos2) -> Option<f32> {
        match handle {
            Handle::Axis(axis) => self.arrow(axis).map(|line| distance_to_line(&line, at)),
            // What lies behind is not grasped through what is before it.
            Handle::Ring(axis) => self
                .ring(axis)
                .into_iter()
                .filter(|(_, front)| *front)
                .map(|(line, _)| distance_to_line(&line, at))
                .reduce(f32::min),
            Handle::Whole => {
                let center = self.frame.project(self.center)?;
                Some((center.distance(at) - CIRCLE as f32).abs())
            }
            Handle::Free | Handle::Plane(_) => None,
        }
    }

    /// Both ends of an arrow; `None` if it points at the eye.
    pub(super) fn arrow(&self, axis: usize) -> Option<[Pos2; 2]> {
        let end = |length: f64| self.frame.project(self.center + self.axes[axis] * (length * self.unit));
        let line = [end(GAP)?, end(ARROW)?];
        ((line[1] - line[0]).length() > SHORTEST).then_some(line)
    }

    /// The corners of the square that is square to an axis; `None` if it is seen from its edge.
    pub(super) fn square(&self, axis: usize) -> Option<[Pos2; 4]> {
        if self.facing(axis).abs() < EDGE_ON {
            return None;
        }
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3].map(|other| self.axes[other] * self.unit);
        let [near, far] = SQUARE;
        let corner = |a: f64, b: f64| self.frame.project(self.center + u * a + v * b);
        Some([corner(near, near)?, corner(far, near)?, corner(far, far)?, corner(near, far)?])
    }

    /// A ring in short lines, each with whether it lies on the side of the eye.
    pub(super) fn ring(&self, axis: usize) -> Vec<([Pos2; 2], bool)> {
        let [u, v] = beside(self.axes[axis]);
        let place = |piece: u32| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(piece) / f64::from(PIECES)).sin_cos();
            u * cos + v * sin
        };
        let toward = self.center - self.frame.eye;
        let pieces = (0..PIECES).filter_map(|piece| {
            let ends = [place(piece), place(piece + 1)];
            let [a, b] = ends.map(|end| self.frame.project(self.center + end * (RING * self.unit)));
            Some(([a?, b?], (ends[0] + ends[1]).dot(toward) <= 0.05 * toward.length()))
        });
        pieces.collect()
    }

    /// The circle around everything.
    pub(super) fn circle(&self) -> Option<(Pos2, f32)> {
        Some((self.frame.project(self.center)?, CIRCLE as f32))
    }

    /// How much an axis points at the eye: the cosine of the angle between.
    pub(super) fn facing(&self, axis: usize) -> f64 {
        self.axes[axis].dot((self.frame.eye - self.center).normalize_or_zero())
    }

    /// The ray through a point of the window.
    pub(super) fn sight(&self, at: Pos2) -> Sight {
        Sight { origin: self.frame.eye, direction: self.frame.direction_at(at) }
    }
}

fn distance_to_line([a, b]: &[Pos2; 2], at: Pos2) -> f32 {
    let (way, away) = (*b - *a, at - *a);
    let length = way.length_sq();
    let part = if length > 0.0 { (away.dot(way) / length).clamp(0.0, 1.0) } else { 0.0 };
    (away - way * part).length()
}

/// Whether a convex polygon contains a point.
fn contains(corners: &[Pos2], at: Pos2) -> bool {
    let turn = |a: Vec2, b: Vec2| a.x * b.y - a.y * b.x;
    let next = corners.iter().cycle().skip(1);
    let sides: Vec<f32> = corners.iter().zip(next).map(|(a, b)| turn(*b - *a, at - *a)).collect();
    sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::selection::Part;
    use egui::{Rect, vec2};
    use glam::Vec3;
    use luch_scene::{Aim, Camera, ImageSize, Object, Point, Rotation, Scene, Shape, Size};

    fn handles(tool: Tool, from: Vec3, scale: f32) -> Handles {
        let mut scene = Scene::new("s");
        let size = [Size::new(scale).unwrap(); 3];
        scene.objects.push(Object::new("o", Shape::Cuboid { center: Point::ORIGIN, size, rotation: Rotation::NONE }));
        let camera = Camera::new("c", Point::new(from * scale).unwrap(), Aim::At(Point::ORIGIN));
        let rect = Rect::from_min_size(Pos2::new(10.0, 20.0), vec2(800.0, 600.0));
        let frame = PictureFrame::new(rect, &camera, ImageSize::new(800, 600).unwrap());
        let subject = Subject::of(Part::Object(0), &scene).unwrap();
        Handles::of(&subject, tool, &frame).unwrap()
    }

    const OBLIQUE: Vec3 = Vec3::new(3.0, 2.5, 5.0);

    #[test]
    fn handles_have_the_same_size_on_the_screen_at_any_distance_and_scale() {
        for scale in [1e-3, 1.0, 1e6] {
            for away in [1.0, 10.0] {
                let arrow = handles(Tool::Move, OBLIQUE * away, scale).arrow(0).unwrap();
                let usual = handles(Tool::Move, OBLIQUE, 1.0).arrow(0).unwrap();
                assert!((arrow[1] - usual[1]).length() < 0.5, "{scale} {away}: {arrow:?}");
            }
        }
    }

    #[test]
    fn each_handle_is_grasped_where_it_is_drawn() {
        let moving = handles(Tool::Move, OBLIQUE, 1.0);
        for axis in 0..3 {
            let [_, tip] = moving.arrow(axis).unwrap();
            assert_eq!(moving.at(tip), Some(Handle::Axis(axis)));
            let square = moving.square(axis).unwrap();
            assert_eq!(moving.at(square[0] + (square[2] - square[0]) * 0.5), Some(Handle::Plane(axis)));
        }
        assert_eq!(moving.at(moving.frame.project(DVec3::ZERO).unwrap()), Some(Handle::Free));
        assert_eq!(moving.at(Pos2::new(11.0, 21.0)), None);
        let turning = handles(Tool::Rotate, OBLIQUE, 1.0);
        for axis in 0..3 {
            let front: Vec<_> =
                turning.ring(axis).into_iter().filter(|(_, front)| *front).map(|(line, _)| line).collect();
            let own = front.iter().filter(|line| turning.at(line[0]) == Some(Handle::Ring(axis))).count();
            assert!(own > front.len() / 2, "{axis}: {own} of {}", front.len());
        }
        let scaling = handles(Tool::Scale, OBLIQUE, 1.0);
        let (center, radius) = scaling.circle().unwrap();
        assert_eq!(scaling.at(center + vec2(0.6, 0.8) * radius), Some(Handle::Whole));
    }

    #[test]
    fn what_points_at_the_eye_is_no_handle() {
        let moving = handles(Tool::Move, Vec3::Z * 5.0, 1.0);
        assert!(moving.arrow(2).is_none());
        assert!(moving.square(0).is_none() && moving.square(1).is_none() && moving.square(2).is_some());
        assert!(!moving.list().contains(&Handle::Axis(2)));
    }

    #[test]
    fn the_near_half_of_a_ring_is_in_front() {
        let turning = handles(Tool::Rotate, OBLIQUE, 1.0);
        for axis in 0..3 {
            let front = turning.ring(axis).iter().filter(|(_, front)| *front).count();
            assert!((28..=40).contains(&front), "{axis}: {front}");
        }
    }
}
