//! How the mouse moves a camera: around a point, sideways, nearer. Pure geometry, in f64, so that a drag back to where it
//! began ends where it began.

use super::Pose;
use glam::DVec3;
use luch_scene::number::{MAX_COORDINATE, MIN_SIZE};
use luch_scene::{Aim, Camera, Direction, Point};

/// The steepest look up or down. Short of straight, so that the horizon stays level and left stays left.
const STEEPEST: f64 = 89.0;
/// The nearest that a camera comes to what it moves towards, in parts of the coordinates there: nearer, their digits end.
const NEAREST: f64 = 1e-5;
/// The shortest way to the point looked at, in parts of the coordinates: a shorter one would have no direction.
const SHORTEST: f64 = 1e-3;

/// A place to look from, with a level horizon.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Eye {
    pub(crate) position: DVec3,
    /// The angle to the right of -z, in radians.
    heading: f64,
    /// The angle above the horizon, in radians.
    pitch: f64,
    /// The distance of the point that is looked at; `None` for a camera that looks along a direction.
    reach: Option<f64>,
}

impl Eye {
    pub(crate) fn of(camera: &Camera) -> Self {
        let [right, _, forward] = camera.frame().map(|axis| axis.as_dvec3());
        let reach = match camera.aim {
            Aim::At(target) => Some((target.get().as_dvec3() - camera.position.get().as_dvec3()).length()),
            Aim::Along(_) => None,
        };
        Self {
            position: camera.position.get().as_dvec3(),
            // From the right and not from the view, which has no heading when it is straight up or down.
            heading: right.z.atan2(right.x),
            pitch: forward.y.clamp(-1.0, 1.0).asin(),
            reach: reach.filter(|reach| *reach > 0.0),
        }
    }

    /// The distance of the point looked at, if there is one.
    pub(crate) const fn reach(&self) -> Option<f64> {
        self.reach
    }

    /// Right, up and forward.
    pub(crate) fn axes(&self) -> [DVec3; 3] {
        let ((sh, ch), (sp, cp)) = (self.heading.sin_cos(), self.pitch.sin_cos());
        [DVec3::new(ch, 0.0, sh), DVec3::new(-sh * sp, cp, ch * sp), DVec3::new(sh * cp, sp, -ch * cp)]
    }

    /// The point seen at a slope (right and up, at distance 1) and a distance along the view.
    pub(crate) fn point_at(&self, slope: [f64; 2], depth: f64) -> DVec3 {
        let [right, up, forward] = self.axes();
        self.position + (forward + right * slope[0] + up * slope[1]) * depth
    }

    /// How far a point lies along the view.
    pub(crate) fn depth_of(&self, point: DVec3) -> f64 {
        (point - self.position).dot(self.axes()[2])
    }

    /// Turned about a point, which stays where it is seen: to the right by `heading` and up by `pitch` radians.
    pub(crate) fn orbit(&self, pivot: DVec3, heading: f64, pitch: f64) -> Self {
        if !(heading.is_finite() && pitch.is_finite()) {
            return *self;
        }
        let [right, up, forward] = self.axes();
        let away = pivot - self.position;
        let seen = [away.dot(right), away.dot(up), away.dot(forward)];
        let steepest = STEEPEST.to_radians();
        let pitch = (self.pitch + pitch).clamp(-steepest, steepest);
        let turned = Self { heading: (self.heading + heading) % std::f64::consts::TAU, pitch, ..*self };
        let [right, up, forward] = turned.axes();
        turned.standing_at(pivot - (right * seen[0] + up * seen[1] + forward * seen[2]))
    }

    /// Moved to the right and up.
    pub(crate) fn pan(&self, right: f64, up: f64) -> Self {
        let axes = self.axes();
        self.standing_at(self.position + axes[0] * right + axes[1] * up)
    }

    /// Moved so that all ways from `towards` are `factor` times as long: it is never reached, nor passed, and stays where
    /// it is seen.
    pub(crate) fn dolly(&self, towards: DVec3, factor: f64) -> Self {
        let way = self.position - towards;
        let nearest = (towards.abs().max_element() * NEAREST).max(f64::from(MIN_SIZE));
        let factor = if factor < 1.0 { factor.max((nearest / way.length()).min(1.0)) } else { factor };
        let moved = self.standing_at(towards + way * factor);
        let reach = self.reach.map(|reach| reach * factor);
        if moved.position == self.position { *self } else { Self { reach, ..moved } }
    }

    /// The same look from another place; from the same place where the other is none.
    pub(crate) fn standing_at(self, position: DVec3) -> Self {
        // Written so that NaN, which fails every comparison, is no place.
        let is_place = position.to_array().into_iter().all(|c| c.abs() <= f64::from(MAX_COORDINATE));
        if is_place { Self { position, ..self } } else { self }
    }

    /// The same look from another place at something that far away.
    pub(crate) fn looking_from(self, position: DVec3, reach: f64) -> Self {
        Self { reach: Some(reach), ..self.standing_at(position) }
    }

    /// As a pose: with the point looked at, if there was one.
    pub(crate) fn pose(&self) -> Pose {
        let position = Point::clamped(self.position.as_vec3());
        let forward = self.axes()[2];
        // Never zero: the components of a unit vector.
        let along = Direction::new(forward.as_vec3()).map_or(Aim::Along(Direction::UP), Aim::Along);
        let aim = self.reach.and_then(|reach| {
            let shortest = self.position.abs().max_element() * SHORTEST;
            let target = Point::new((self.position + forward * reach.max(shortest)).as_vec3()).ok()?;
            let way = Direction::new(target.get() - position.get()).ok()?;
            // Rounding may leave too little between two points to tell a direction by.
            (way.unit().as_dvec3().dot(forward) > 1.0 - 1e-6).then_some(Aim::At(target))
        });
        Pose { position, aim: aim.unwrap_or(along) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;

    fn camera(from: Vec3, at: Vec3) -> Camera {
        Camera::new("c", Point::new(from).unwrap(), Aim::At(Point::new(at).unwrap()))
    }

    fn through(pose: Pose) -> Camera {
        Camera { position: pose.position, aim: pose.aim, ..camera(Vec3::ZERO, Vec3::Z) }
    }

    /// Where a point is seen: right and up at distance 1, and its distance along the view.
    fn seen(camera: &Camera, point: DVec3) -> DVec3 {
        let away = point - camera.position.get().as_dvec3();
        let [x, y, z] = camera.frame().map(|axis| away.dot(axis.as_dvec3()));
        DVec3::new(x / z, y / z, z)
    }

    #[test]
    fn an_eye_looks_as_its_camera_does_even_straight_up_and_down() {
        for along in [Vec3::NEG_Z, Vec3::X, Vec3::new(0.3, -0.7, 0.2), Vec3::Y, Vec3::NEG_Y, Vec3::Z] {
            let camera = camera(Vec3::new(1.0, 2.0, 3.0), Vec3::new(1.0, 2.0, 3.0) + along * 4.0);
            for (own, same) in Eye::of(&camera).axes().into_iter().zip(camera.frame()) {
                assert!((own - same.as_dvec3()).length() < 1e-6, "{along}: {own} {same}");
            }
            let pose = Eye::of(&camera).pose();
            assert_eq!(pose.position, camera.position);
            assert!((through(pose).focus() - camera.focus()).abs() < 1e-5, "{along}");
        }
    }

    #[test]
    fn a_camera_that_looks_along_keeps_doing_so() {
        let mut camera = camera(Vec3::ONE, Vec3::ZERO);
        camera.aim = Aim::Along(Direction::new(Vec3::new(0.0, -1.0, -1.0)).unwrap());
        let pose = Eye::of(&camera).orbit(DVec3::ZERO, 0.3, 0.1).dolly(DVec3::ZERO, 0.5).pose();
        assert!(matches!(pose.aim, Aim::Along(_)), "{pose:?}");
    }

    #[test]
    fn an_orbit_keeps_the_pivot_where_it_is_seen_and_the_horizon_level() {
        let start = camera(Vec3::new(0.0, 2.0, 7.0), Vec3::new(0.0, 1.0, 0.0));
        for pivot in [DVec3::new(0.0, 1.0, 0.0), DVec3::new(2.0, 0.0, -3.0), DVec3::new(-4.0, 5.0, 1.0)] {
            for (heading, pitch) in [(0.1, 0.0), (3.0, 0.4), (-2.0, -0.9), (100.0, 0.2)] {
                let after = through(Eye::of(&start).orbit(pivot, heading, pitch).pose());
                assert!((seen(&after, pivot) - seen(&start, pivot)).length() < 1e-4, "{pivot} {heading} {pitch}");
                assert!(after.frame()[0].y.abs() < 1e-6);
            }
        }
    }

    #[test]
    fn an_orbit_to_the_right_shows_more_of_the_left_and_one_up_looks_from_below() {
        let start = camera(Vec3::new(0.0, 0.0, 5.0), Vec3::ZERO);
        let turned = Eye::of(&start).orbit(DVec3::ZERO, 0.5, 0.0).position;
        assert!(turned.x < -1.0 && turned.z > 0.0, "{turned}");
        let turned = Eye::of(&start).orbit(DVec3::ZERO, 0.0, 0.5).position;
        assert!(turned.y < -1.0, "{turned}");
    }

    #[test]
    fn no_orbit_flips_over_the_poles() {
        for from in [Vec3::new(0.0, 2.0, 7.0), Vec3::new(0.0, 9.0, 0.0), Vec3::new(0.0, -9.0, 0.0)] {
            let start = camera(from, Vec3::ZERO);
            for step in -50..50 {
                let turned = Eye::of(&start).orbit(DVec3::ZERO, 0.0, f64::from(step) * 0.3);
                let camera = through(turned.pose());
                assert!(f64::from(camera.direction().y.abs()) <= 89.01_f64.to_radians().sin(), "{from} {step}");
                // Left stays left.
                assert!((camera.frame()[0] - start.frame()[0]).length() < 1e-4, "{from} {step}");
            }
        }
    }

    #[test]
    fn a_drag_back_to_where_it_began_ends_there() {
        let start = camera(Vec3::new(3.0, 2.0, 7.0), Vec3::new(0.5, 1.0, 0.0));
        let eye = Eye::of(&start);
        assert_eq!(eye.orbit(DVec3::ONE, 0.0, 0.0).pose(), eye.pose());
        assert_eq!(eye.pan(0.0, 0.0), eye);
    }

    #[test]
    fn a_dolly_comes_near_but_never_reaches_at_any_scale() {
        for scale in [1e-3, 1.0, 1e6] {
            let towards = DVec3::new(1.0, 1.0, -2.0) * scale;
            let start = camera(Vec3::new(0.0, 2.0, 7.0) * scale as f32, Vec3::new(0.0, 1.0, 0.0) * scale as f32);
            let mut eye = Eye::of(&start);
            let [right, up, before] = seen(&through(eye.pose()), towards).to_array();
            let once = eye.dolly(towards, 0.9);
            let after = seen(&through(once.pose()), towards);
            assert!(
                (after.x - right).abs() < 1e-4 && (after.y - up).abs() < 1e-4,
                "{scale}: it stays where it is seen"
            );
            assert!((after.z / before - 0.9).abs() < 1e-4, "{scale}");
            for _ in 0..1000 {
                eye = eye.dolly(towards, 0.8);
                assert!(eye.depth_of(towards) > 0.0, "{scale}");
            }
            assert!(eye.depth_of(towards) < before * 1e-3, "{scale}: {}", eye.depth_of(towards));
            let camera = through(eye.pose());
            assert!((camera.frame()[2] - start.frame()[2]).length() < 1e-3, "{scale}: it looks the same way");
            assert!(camera.frame().iter().all(|axis| axis.is_finite()));
            for _ in 0..1000 {
                eye = eye.dolly(towards, 1.25);
            }
            assert!(Point::new(eye.position.as_vec3()).is_ok(), "{scale}: it stays in the world");
        }
    }

    #[test]
    fn nonsense_moves_nothing() {
        let eye = Eye::of(&camera(Vec3::new(3.0, 2.0, 7.0), Vec3::ZERO));
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e300] {
            assert_eq!(eye.pan(bad, 0.0), eye);
            assert_eq!(eye.dolly(DVec3::ZERO, bad.abs()), eye);
            assert_eq!(eye.dolly(DVec3::new(bad, 0.0, 0.0), 0.9), eye);
        }
        assert_eq!(eye.orbit(DVec3::ZERO, f64::NAN, 0.0), eye);
        assert_eq!(eye.orbit(DVec3::ZERO, 0.0, f64::INFINITY), eye);
        assert_eq!(eye.dolly(eye.position, 0.5), eye);
    }
}
