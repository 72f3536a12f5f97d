//! A drag of a handle: what the pointer's way comes to. Always worked out from where the drag began, so that it ends
//! where it began when the pointer goes back there.

use super::handles::{Handle, Handles};
use super::math::{angle_about, beside, unwrapped};
use super::subject::{Change, Subject};
use crate::command::Tool;
use egui::{Pos2, Vec2};
use glam::DVec3;

/// The steps that Ctrl snaps to: units, degrees, parts.
const UNITS: f64 = 0.25;
const DEGREES: f64 = 15.0;
const PARTS: f64 = 0.1;
/// The finest turn and scale.
const FINE_DEGREES: f64 = 0.1;
const FINE_PARTS: f64 = 0.001;
/// A ring that is seen from so near its edge (as a cosine) is dragged along itself, as a line.
const EDGE_ON: f64 = 0.2;
/// Scales end here: nothing turns inside out.
const SCALES: [f64; 2] = [0.001, 1000.0];

/// How the pointer is measured.
#[derive(Debug, Clone, Copy)]
enum Measure {
    /// The place on an axis.
    Along { axis: usize, start: f64 },
    /// The point on a plane.
    Across { normal: DVec3, start: DVec3, but: Option<usize> },
    /// The angle about an axis.
    Around { axis: usize, start: f64 },
    /// The way along a direction of the window, for a turn in degrees for each point.
    Tangent { axis: usize, way: Vec2 },
    /// The distance from the middle.
    Outward { center: Pos2, start: f32 },
}

/// A handle that is held.
#[derive(Debug, Clone)]
pub(super) struct Grip {
    pub(super) handle: Handle,
    pub(super) subject: Subject,
    /// The handles as they were: the camera stays what it was, whatever pictures come meanwhile.
    handles: Handles,
    from: Pos2,
    measure: Measure,
    /// What the drag comes to so far.
    pub(super) change: Change,
}

impl Grip {
    /// Grasps a handle at a point of the window. `None` if nothing can be told from dragging there.
    pub(super) fn new(handle: Handle, handles: &Handles, subject: Subject, from: Pos2) -> Option<Self> {
        let sight = handles.sight(from);
        let (center, axes) = (handles.center, handles.axes);
        let across = |normal, but| Some(Measure::Across { normal, start: sight.on_plane(center, normal)?, but });
        let measure = match handle {
            Handle::Axis(axis) => {
                let start = sight.along_axis(center, axes[axis])?;
                // A scale is a share of where it began.
                if handles.tool == Tool::Scale && start < handles.unit {
                    return None;
                }
                Measure::Along { axis, start }
            }
            Handle::Plane(axis) => across(axes[axis], Some(axis))?,
            Handle::Free => across(handles.frame.axes[2], None)?,
            Handle::Ring(axis) if handles.facing(axis).abs() > EDGE_ON => {
                let start = angle_about(center, axes[axis], sight.on_plane(center, axes[axis])?);
                Measure::Around { axis, start }
            }
            Handle::Ring(axis) => Measure::Tangent { axis, way: tangent(handles, axis, from)? },
            Handle::Whole => {
                let (center, _) = handles.circle()?;
                Measure::Outward { center, start: center.distance(from).max(1.0) }
            }
        };
        let change = match handles.tool {
            Tool::Rotate => Change::Turn(0, 0.0),
            Tool::Scale => Change::Scale(DVec3::ONE),
            Tool::Move | Tool::Select | Tool::Focus | Tool::Explain => Change::Move(DVec3::ZERO),
        };
        Some(Self { handle, subject, handles: handles.clone(), from, measure, change })
    }

    /// What the drag comes to with the pointer there. Where nothing can be told, what it came to before.
    pub(super) fn drag_to(&mut self, at: Pos2, snap: bool) -> Change {
        if let Some(change) = self.measured(at, snap) {
            self.change = change;
        }
        self.change
    }

    fn measured(&self, at: Pos2, snap: bool) -> Option<Change> {
        let sight = self.handles.sight(at);
        let (center, axes) = (self.handles.center, self.handles.axes);
        Some(match self.measure {
            Measure::Along { axis, start } => {
                let place = sight.along_axis(center, axes[axis])?;
                if self.handles.tool == Tool::Scale {
                    Change::Scale(with(DVec3::ONE, axis, part(place / start, snap)))
                } else {
                    Change::Move(with(DVec3::ZERO, axis, self.length(place - start, snap)))
                }
            }
            Measure::Across { normal, start, but } => {
                let way = sight.on_plane(center, normal)? - start;
                let along = DVec3::from_array([0, 1, 2].map(|axis: usize| self.length(way.dot(axes[axis]), snap)));
                Change::Move(but.map_or(along, |axis| with(along, axis, 0.0)))
            }
            Measure::Around { axis, start } => {
                let angle = angle_about(center, axes[axis], sight.on_plane(center, axes[axis])?) - start;
                let before = if let Change::Turn(_, degrees) = self.change { degrees.to_radians() } else { 0.0 };
                Change::Turn(axis, rounded(unwrapped(angle, before).to_degrees(), snap, DEGREES, FINE_DEGREES))
            }
            Measure::Tangent { axis, way } => {
                let degrees = f64::from((at - self.from).dot(way));
                Change::Turn(axis, rounded(degrees, snap, DEGREES, FINE_DEGREES))
            }
            Measure::Outward { center, start } => {
                Change::Scale(DVec3::splat(part(f64::from(center.distance(at) / start), snap)))
            }
        })
    }

    /// A length with no more digits than the pointer can tell apart.
    fn length(&self, length: f64, snap: bool) -> f64 {
        let fine = 10_f64.powf(self.handles.unit.log10().floor());
        rounded(length, snap, UNITS, fine)
    }
}

fn with(mut vector: DVec3, axis: usize, value: f64) -> DVec3 {
    vector[axis] = value;
    vector
}

fn part(part: f64, snap: bool) -> f64 {
    let least = if snap { PARTS } else { SCALES[0] };
    rounded(part, snap, PARTS, FINE_PARTS).clamp(least, SCALES[1])
}

/// The nearest multiple of a step, written as a decimal would be.
fn rounded(value: f64, snap: bool, coarse: f64, fine: f64) -> f64 {
    let step = if snap { coarse } else { fine };
    // Through the inverse where that is whole: 0.1 * 3 is not 0.3.
    if step < 1.0 { (value / step).round() / (1.0 / step).round() } else { (value / step).round() * step }
}

/// The way of a ring in the window where it is grasped, for a turn of one degree for each point along it.
fn tangent(handles: &Handles, axis: usize, from: Pos2) -> Option<Vec2> {
    let [u, v] = beside(handles.axes[axis]);
    let pieces = handles.ring(axis);
    let nearest = pieces.iter().enumerate().filter(|(_, (_, front))| *front).min_by(|(_, a), (_, b)| {
        let away = |line: &[Pos2; 2]| line[0].distance_sq(from);
        away(&a.0).total_cmp(&away(&b.0))
    });
    let angle = std::f64::consts::TAU * nearest?.0 as f64 / pieces.len() as f64;
    let forward = v * angle.cos() - u * angle.sin();
    let radius = handles.unit * super::handles::RING;
    let out = handles.center + (u * angle.cos() + v * angle.sin()) * radius;
    let step = handles.frame.project(out + forward * (radius * 0.01))? - handles.frame.project(out)?;
    // The pointer's way along the line, not its speed on it: at the ends of the line that would be nothing.
    let direction = step.normalized();
    (step.length() > 0.0).then(|| direction * (180.0 / std::f64::consts::PI / super::handles::RING) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::selection::Part;
    use crate::viewport::frame::PictureFrame;
    use egui::{Rect, vec2};
    use glam::Vec3;
    use luch_scene::{Aim, Camera, ImageSize, Object, Point, Rotation, Scene, Shape, Size};

    fn grip(tool: Tool, handle: Handle, from: Vec3, at: impl Fn(&Handles) -> Pos2) -> (Grip, Pos2) {
        let mut scene = Scene::new("s");
        let size = [Size::ONE; 3];
        scene.objects.push(Object::new("o", Shape::Cuboid { center: Point::ORIGIN, size, rotation: Rotation::NONE }));
        let camera = Camera::new("c", Point::new(from).unwrap(), Aim::At(Point::ORIGIN));
        let rect = Rect::from_min_size(Pos2::ZERO, vec2(800.0, 600.0));
        let frame = PictureFrame::new(rect, &camera, ImageSize::new(800, 600).unwrap());
        let subject = Subject::of(Part::Object(0), &scene).unwrap();
        let handles = Handles::of(&subject, tool, &frame).unwrap();
        let start = at(&handles);
        (Grip::new(handle, &handles, subject, start).unwrap(), start)
    }

    const OBLIQUE: Vec3 = Vec3::new(3.0, 2.5, 5.0);

    #[test]
    fn a_point_of_an_axis_follows_the_pointer() {
        for axis in 0..3 {
            let (mut grip, _) = grip(Tool::Move, Handle::Axis(axis), OBLIQUE, |h| h.arrow(axis).unwrap()[1]);
            let mut way = DVec3::ZERO;
            way[axis] = 0.4;
            let tip =
                grip.handles.center + grip.handles.axes[axis] * (grip.handles.unit * super::super::handles::ARROW);
            let to = grip.handles.frame.project(tip + way).unwrap();
            let Change::Move(moved) = grip.drag_to(to, false) else { panic!() };
            assert!((moved - way).length() < 0.01, "{axis}: {moved}");
            assert_eq!(moved[(axis + 1) % 3], 0.0);
            let Change::Move(moved) = grip.drag_to(to, true) else { panic!() };
            assert_eq!(moved[axis], 0.5);
        }
    }

    #[test]
    fn back_where_it_began_a_drag_comes_to_nothing() {
        for (tool, handle, none) in [
            (Tool::Move, Handle::Axis(0), Change::Move(DVec3::ZERO)),
            (Tool::Move, Handle::Plane(1), Change::Move(DVec3::ZERO)),
            (Tool::Move, Handle::Free, Change::Move(DVec3::ZERO)),
            (Tool::Rotate, Handle::Ring(2), Change::Turn(2, 0.0)),
            (Tool::Scale, Handle::Axis(1), Change::Scale(DVec3::ONE)),
            (Tool::Scale, Handle::Whole, Change::Scale(DVec3::ONE)),
        ] {
            let at = |h: &Handles| match handle {
                Handle::Axis(axis) => h.arrow(axis).unwrap()[1],
                Handle::Plane(axis) => h.square(axis).unwrap()[0],
                Handle::Ring(axis) => h.ring(axis)[3].0[0],
                Handle::Whole => h.circle().unwrap().0 + vec2(h.circle().unwrap().1, 0.0),
                Handle::Free => h.circle().unwrap().0,
            };
            let (mut grip, start) = grip(tool, handle, OBLIQUE, at);
            assert_ne!(grip.drag_to(start + vec2(31.0, -17.0), false), none, "{tool:?} {handle:?}");
            grip.drag_to(start + vec2(-500.0, 900.0), false);
            assert_eq!(grip.drag_to(start, false), none, "{tool:?} {handle:?}");
        }
    }

    #[test]
    fn planes_leave_their_normal_alone_and_the_free_way_is_parallel_to_the_picture() {
        let (mut plane, start) = grip(Tool::Move, Handle::Plane(1), OBLIQUE, |h| h.square(1).unwrap()[0]);
        let Change::Move(moved) = plane.drag_to(start + vec2(50.0, 20.0), false) else { panic!() };
        assert!(moved.y == 0.0 && moved.x != 0.0 && moved.z != 0.0);
        let (mut free, start) = grip(Tool::Move, Handle::Free, OBLIQUE, |h| h.circle().unwrap().0);
        let Change::Move(moved) = free.drag_to(start + vec2(50.0, 20.0), false) else { panic!() };
        let seen = free.handles.frame.project(moved).unwrap();
        assert!((seen - (start + vec2(50.0, 20.0))).length() < 1.5, "{seen:?}");
    }

    #[test]
    fn a_ring_turns_by_the_angle_of_the_pointer_and_beyond_half_a_turn() {
        // Seen along z, the ring about z is a circle.
        let (mut grip, _) =
            grip(Tool::Rotate, Handle::Ring(2), Vec3::Z * 5.0, |h| h.circle().unwrap().0 + vec2(84.0, 0.0));
        let center = grip.handles.circle().unwrap().0;
        for degrees in [10.0_f32, 80.0, 170.0, 200.0, 300.0, 365.0] {
            let (sin, cos) = (f64::from(degrees).to_radians()).sin_cos();
            // Up in the window is against y.
            let at = center + vec2(cos as f32, -sin as f32) * 84.0;
            let Change::Turn(2, turned) = grip.drag_to(at, false) else { panic!() };
            assert!((turned - f64::from(degrees)).abs() < 0.2, "{degrees}: {turned}");
        }
        let Change::Turn(_, turned) = grip.drag_to(center + vec2(84.0, -9.0), true) else { panic!() };
        assert_eq!(turned, 360.0);
    }

    #[test]
    fn a_ring_seen_from_its_edge_is_dragged_along_itself() {
        let (mut grip, start) = grip(Tool::Rotate, Handle::Ring(1), Vec3::Z * 5.0, |h| h.circle().unwrap().0);
        let Change::Turn(1, right) = grip.drag_to(start + vec2(84.0, 0.0), false) else { panic!() };
        assert!((right - 57.3).abs() < 1.0, "{right}: its near side goes to the right");
        let Change::Turn(1, left) = grip.drag_to(start + vec2(-84.0, 40.0), false) else { panic!() };
        assert!((left + 57.3).abs() < 1.0, "{left}");
    }

    #[test]
    fn scales_are_shares_of_where_they_began() {
        let (mut axis, _) = grip(Tool::Scale, Handle::Axis(0), OBLIQUE, |h| h.arrow(0).unwrap()[1]);
        let handles = axis.handles.clone();
        let tip = |share: f64| handles.frame.project(handles.axes[0] * (handles.unit * share * 92.0)).unwrap();
        assert_eq!(axis.drag_to(tip(0.5), false), Change::Scale(DVec3::new(0.5, 1.0, 1.0)));
        assert_eq!(axis.drag_to(tip(1.27), true), Change::Scale(DVec3::new(1.3, 1.0, 1.0)));
        let Change::Scale(least) = axis.drag_to(tip(-3.0), false) else { panic!() };
        assert!(least.x > 0.0);
        let (mut whole, start) = grip(Tool::Scale, Handle::Whole, OBLIQUE, |h| h.circle().unwrap().0 + vec2(66.0, 0.0));
        assert_eq!(whole.drag_to(start + vec2(33.0, 0.0), false), Change::Scale(DVec3::splat(1.5)));
    }
}
