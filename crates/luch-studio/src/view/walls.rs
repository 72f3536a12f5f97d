//! Endless walls, which the mouse does not take the eye through: from behind, nothing of the scene is seen.

use super::eye::Eye;
use glam::DVec3;
use luch_scene::{Scene, Shape};

/// How near to a wall the eye comes, in parts of the way that it had to go.
const MARGIN: f64 = 0.02;
/// Halvings in the search for how far a turn may go.
const HALVINGS: u32 = 24;
/// A point that much nearer to a wall than the eye lies on it.
const ON: f64 = 1e-3;

/// A wall: a point of it, and its normal.
#[derive(Debug, Clone, Copy)]
struct Plane {
    point: DVec3,
    normal: DVec3,
}

impl Plane {
    /// How far a point is from the wall, on which side.
    fn side(&self, of: DVec3) -> f64 {
        (of - self.point).dot(self.normal)
    }
}

/// The endless walls of a scene.
#[derive(Debug, Clone, Default)]
pub(crate) struct Walls(Vec<Plane>);

impl Walls {
    /// Those that are visible. Looks at every object.
    pub(crate) fn of(scene: &Scene) -> Self {
        let walls = scene.objects.iter().filter(|object| !object.hidden).filter_map(|object| match object.shape {
            Shape::Wall { point, normal, size: None } => {
                Some(Plane { point: point.get().as_dvec3(), normal: normal.unit().as_dvec3() })
            }
            _ => None,
        });
        Self(walls.collect())
    }

    /// The part of the straight way from one point to another that ends before any wall.
    pub(super) fn free_part(&self, from: DVec3, to: DVec3) -> f64 {
        let parts = self.0.iter().map(|wall| {
            // How much of the distance to the wall is left: below 0 behind it, NaN or infinite for a start on it.
            let left = wall.side(to) / wall.side(from);
            if left < MARGIN { (1.0 - MARGIN) / (1.0 - left) } else { 1.0 }
        });
        parts.filter(|part| part.is_finite()).fold(1.0, f64::min)
    }

    /// The eye that went straight from one place to another, or came as far as there is no wall.
    pub(crate) fn go(&self, start: &Eye, to: Eye) -> Eye {
        let free = self.free_part(start.position, to.position);
        if free < 1.0 { to.standing_at(start.position + (to.position - start.position) * free) } else { to }
    }

    /// The eye turned about a point. Where a wall would come between, it comes nearer to the point; where that does not
    /// help, because the point is on the wall, it turns no farther.
    pub(crate) fn orbit(&self, start: &Eye, pivot: DVec3, heading: f64, pitch: f64) -> Eye {
        let turned = |heading, pitch| {
            let eye = start.orbit(pivot, heading, pitch);
            let free = self.before(start, pivot).free_part(pivot, eye.position);
            if free < 1.0 { eye.dolly(pivot, free) } else { eye }
        };
        let is_free = |eye: &Eye| {
            // Written so that a wall that the eye is on holds nothing up.
            !self.0.iter().any(|wall| wall.side(eye.position) / wall.side(start.position) < ON)
        };
        let most = |turn: &dyn Fn(f64) -> Eye| {
            if is_free(&turn(1.0)) {
                return 1.0;
            }
            let (mut free, mut step) = (0.0, 0.5);
            for _ in 0..HALVINGS {
                if is_free(&turn(free + step)) {
                    free += step;
                }
                step *= 0.5;
            }
            free
        };
        // One after the other, so that the eye slides along a wall.
        let heading = heading * most(&|part| turned(heading * part, 0.0));
        let pitch = pitch * most(&|part| turned(heading, pitch * part));
        turned(heading, pitch)
    }

    /// The walls that a point and the eye are both before.
    fn before(&self, eye: &Eye, point: DVec3) -> Self {
        Self(self.0.iter().filter(|wall| wall.side(point) / wall.side(eye.position) > ON).copied().collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use luch_scene::{Aim, Camera, Direction, Object, Point};

    fn wall(point: Vec3, normal: Vec3) -> Object {
        let (point, normal) = (Point::new(point).unwrap(), Direction::new(normal).unwrap());
        Object::new("w", Shape::Wall { point, normal, size: None })
    }

    /// A room of 8 x 8 x 8 on the floor.
    fn room() -> Walls {
        let mut scene = Scene::new("s");
        for (point, normal) in [(Vec3::ZERO, Vec3::Y), (Vec3::Y * 8.0, Vec3::NEG_Y)] {
            scene.objects.push(wall(point, normal));
        }
        for axis in [Vec3::X, Vec3::Z] {
            scene.objects.extend([wall(axis * 4.0, axis), wall(axis * -4.0, axis)]);
        }
        Walls::of(&scene)
    }

    fn eye() -> Eye {
        Eye::of(&Camera::new("c", Point::new(Vec3::new(0.0, 2.0, 3.0)).unwrap(), Aim::At(Point::ORIGIN)))
    }

    fn is_inside(p: DVec3) -> bool {
        p.x.abs() < 4.0 && p.z.abs() < 4.0 && p.y > 0.0 && p.y < 8.0
    }

    #[test]
    fn no_orbit_leaves_the_room_and_the_pivot_stays_where_it_is_seen() {
        for pivot in [DVec3::new(1.0, 1.0, 0.0), DVec3::new(-3.0, 0.5, -3.0)] {
            for (heading, pitch) in [(0.5, 0.1), (2.0, -1.5), (-3.0, 1.5), (1.6, 0.0), (40.0, 0.3)] {
                let turned = room().orbit(&eye(), pivot, heading, pitch);
                assert!(is_inside(turned.position), "{pivot} {heading} {pitch}: {}", turned.position);
                let seen = |eye: &Eye| {
                    let [x, y, z] = eye.axes().map(|axis| axis.dot(pivot - eye.position));
                    DVec3::new(x / z, y / z, 0.0)
                };
                assert!((seen(&turned) - seen(&eye())).length() < 1e-9);
            }
        }
    }

    #[test]
    fn an_orbit_about_a_point_of_a_wall_stops_before_it() {
        let pivot = DVec3::new(0.5, 0.0, 0.0);
        let turned = room().orbit(&eye(), pivot, 0.3, 1.5);
        assert!(is_inside(turned.position) && turned.position.y < 0.1, "{}", turned.position);
        // A pivot that rounding put behind the wall does as well.
        let turned = room().orbit(&eye(), pivot - DVec3::Y * 1e-7, 0.3, 1.5);
        assert!(is_inside(turned.position), "{}", turned.position);
    }

    #[test]
    fn where_no_wall_is_in_the_way_nothing_changes() {
        let turned = room().orbit(&eye(), DVec3::Y, 0.3, 0.1);
        assert_eq!(turned, eye().orbit(DVec3::Y, 0.3, 0.1));
        let moved = eye().pan(0.5, 0.5);
        assert_eq!(room().go(&eye(), moved), moved);
        assert_eq!(Walls::default().orbit(&eye(), DVec3::Y, 3.0, 1.0), eye().orbit(DVec3::Y, 3.0, 1.0));
    }

    #[test]
    fn a_straight_way_ends_before_the_wall_from_either_side() {
        assert!(is_inside(room().go(&eye(), eye().pan(100.0, 0.0)).position));
        assert!(is_inside(room().go(&eye(), eye().dolly(DVec3::Y, 1e3)).position));
        let outside = eye().standing_at(DVec3::new(0.0, 2.0, 9.0));
        let stopped = room().go(&outside, eye());
        assert!(stopped.position.z > 4.0, "{}", stopped.position);
    }
}
