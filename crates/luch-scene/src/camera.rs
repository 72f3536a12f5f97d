//! Cameras: a thin lens that looks somewhere.

use crate::number::{FieldOfView, NonNegative, Positive};
use crate::vector::{Direction, Point};
use glam::Vec3;

/// What a camera looks at.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Aim {
    /// A place.
    At(Point),
    /// A direction.
    Along(Direction),
}

/// A camera: where it stands, where it looks, and its lens.
#[derive(Debug, Clone, PartialEq)]
pub struct Camera {
    /// What people call it; unique among the cameras of a scene.
    pub name: String,
    /// Centre of the lens.
    pub position: Point,
    /// Where it looks.
    pub aim: Aim,
    /// Vertical field of view.
    pub fov: FieldOfView,
    /// Distance along the view direction at which the picture is sharp. `None`: to the point looked at, or 1.
    pub focal_distance: Option<Positive>,
    /// Radius of the lens in scene units: 0 is a pinhole.
    pub lens_radius: NonNegative,
}

impl Camera {
    /// A pinhole camera with the default field of view.
    #[must_use]
    pub fn new(name: impl Into<String>, position: Point, aim: Aim) -> Self {
        Self {
            name: name.into(),
            position,
            aim,
            fov: FieldOfView::DEFAULT,
            focal_distance: None,
            lens_radius: NonNegative::ZERO,
        }
    }

    /// The view direction, of unit length. A camera that looks at its own place looks along -z.
    #[must_use]
    pub fn direction(&self) -> Vec3 {
        match self.aim {
            Aim::At(target) => Direction::new(target.get() - self.position.get()).map_or(Vec3::NEG_Z, Direction::unit),
            Aim::Along(direction) => direction.unit(),
        }
    }

    /// Right, up and forward unit vectors. Up is as near to y as can be; looking straight up or down, it is -z or z.
    #[must_use]
    pub fn frame(&self) -> [Vec3; 3] {
        let forward = self.direction().as_dvec3();
        let right = forward
            .cross(glam::DVec3::Y)
            .try_normalize()
            .filter(|_| forward.y.abs() < 0.999_999_9)
            .unwrap_or(glam::DVec3::X);
        let up = right.cross(forward).normalize_or(glam::DVec3::Y);
        [right.as_vec3(), up.as_vec3(), forward.as_vec3()]
    }

    /// The distance at which the picture is sharp: as set, or to the point looked at, or 1.
    #[must_use]
    pub fn focus(&self) -> f32 {
        match (self.focal_distance, self.aim) {
            (Some(distance), _) => distance.get(),
            (None, Aim::At(target)) => Positive::clamped((target.get() - self.position.get()).length()).get(),
            (None, Aim::Along(_)) => 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn looking(along: Vec3) -> [Vec3; 3] {
        Camera::new("c", Point::ORIGIN, Aim::Along(Direction::new(along).unwrap())).frame()
    }

    #[test]
    fn frames_are_right_handed_and_upright() {
        for along in [Vec3::NEG_Z, Vec3::X, Vec3::new(1.0, -2.0, 0.5), Vec3::Y, Vec3::NEG_Y] {
            let [right, up, forward] = looking(along);
            assert!((right.cross(up) + forward).length() < 1e-6, "{along}: right x up is backward");
            assert!(up.y >= 0.0, "{along}");
            assert!(right.y.abs() < 1e-7, "{along}: the horizon is level");
        }
        assert_eq!(looking(Vec3::NEG_Z), [Vec3::X, Vec3::Y, Vec3::NEG_Z]);
        assert_eq!(looking(Vec3::NEG_Y), [Vec3::X, Vec3::NEG_Z, Vec3::NEG_Y]);
    }

    #[test]
    fn a_camera_that_looks_at_itself_still_looks_somewhere() {
        let camera = Camera::new("c", Point::ORIGIN, Aim::At(Point::ORIGIN));
        assert_eq!(camera.direction(), Vec3::NEG_Z);
        assert!(camera.focus() > 0.0);
    }
}
