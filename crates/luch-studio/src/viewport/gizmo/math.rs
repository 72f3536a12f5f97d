//! The geometry of dragging: a ray through the pointer against lines and planes.

use glam::DVec3;

/// A ray from the eye through a point of the window.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sight {
    pub(super) origin: DVec3,
    /// Of unit length.
    pub(super) direction: DVec3,
}

/// How nearly a line may point at the eye, as the sine of the angle between, before no place on it can be told by the
/// pointer.
const PARALLEL: f64 = 0.02;

impl Sight {
    /// Where on the line through a point along an axis (of unit length) the ray comes nearest to it, from that point.
    ///
    /// `None` where the ray runs along the axis, or comes nearest behind the eye.
    pub(super) fn along_axis(&self, point: DVec3, axis: DVec3) -> Option<f64> {
        let between = point - self.origin;
        let cosine = axis.dot(self.direction);
        let sine_squared = 1.0 - cosine * cosine;
        // Written so that NaN, which fails every comparison, gives nothing.
        if sine_squared.is_nan() || sine_squared < PARALLEL * PARALLEL {
            return None;
        }
        let (on_axis, on_ray) = (axis.dot(between), self.direction.dot(between));
        let t = (cosine * on_ray - on_axis) / sine_squared;
        let ahead = on_ray + t * cosine;
        (ahead > 0.0).then_some(t)
    }

    /// Where the ray meets the plane through a point with that normal; `None` if it runs along it or meets it behind the
    /// eye.
    pub(super) fn on_plane(&self, point: DVec3, normal: DVec3) -> Option<DVec3> {
        let toward = self.direction.dot(normal);
        if toward.is_nan() || toward.abs() < PARALLEL * normal.length() {
            return None;
        }
        let t = (point - self.origin).dot(normal) / toward;
        (t > 0.0 && t.is_finite()).then(|| self.origin + self.direction * t)
    }
}

/// Two unit vectors that make a right-handed frame with an axis of unit length.
pub(super) fn beside(axis: DVec3) -> [DVec3; 2] {
    let u = axis.any_orthonormal_vector();
    [u, axis.cross(u)]
}

/// The angle of a point about an axis of unit length through `center`, right-handed, in radians from any one direction.
pub(super) fn angle_about(center: DVec3, axis: DVec3, point: DVec3) -> f64 {
    let [u, v] = beside(axis);
    let away = point - center;
    away.dot(v).atan2(away.dot(u))
}

/// The angle that is `angle` up to whole turns and nearest to `near`, in radians.
pub(super) fn unwrapped(angle: f64, near: f64) -> f64 {
    near + (angle - near + std::f64::consts::PI).rem_euclid(std::f64::consts::TAU) - std::f64::consts::PI
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sight(origin: DVec3, through: DVec3) -> Sight {
        Sight { origin, direction: (through - origin).normalize_or_zero() }
    }

    #[test]
    fn a_ray_through_a_point_of_an_axis_finds_it() {
        let eye = DVec3::new(1.0, 2.0, 9.0);
        for axis in [DVec3::X, DVec3::Y, DVec3::Z, DVec3::new(1.0, 2.0, 2.0) / 3.0] {
            for t in [-3.0, -0.5, 0.0, 1.0, 2.5] {
                let point = DVec3::new(0.3, -0.2, 0.1);
                let found = sight(eye, point + axis * t).along_axis(point, axis).unwrap();
                assert!((found - t).abs() < 1e-9, "{axis} {t}: {found}");
            }
        }
    }

    #[test]
    fn beside_an_axis_the_nearest_place_counts() {
        // From straight above the x axis, a way in z does not matter.
        let found = sight(DVec3::new(0.0, 5.0, 0.0), DVec3::new(2.0, 0.0, 0.7)).along_axis(DVec3::ZERO, DVec3::X);
        let t = found.unwrap();
        // The two lines are nearest where the way between them is square to both.
        let ray = sight(DVec3::new(0.0, 5.0, 0.0), DVec3::new(2.0, 0.0, 0.7));
        let on_axis = DVec3::X * t;
        let on_ray = ray.origin + ray.direction * (on_axis - ray.origin).dot(ray.direction);
        assert!((on_axis - on_ray).dot(DVec3::X).abs() < 1e-9 && (on_axis - on_ray).dot(ray.direction).abs() < 1e-9);
    }

    #[test]
    fn an_axis_that_points_at_the_eye_gives_nothing() {
        let ray = sight(DVec3::new(0.0, 0.0, 5.0), DVec3::ZERO);
        assert_eq!(ray.along_axis(DVec3::ZERO, DVec3::Z), None);
        assert_eq!(ray.on_plane(DVec3::ZERO, DVec3::X), None);
        // Above the horizon a floor is not met.
        assert_eq!(sight(DVec3::Y, DVec3::new(0.0, 1.5, -1.0)).on_plane(DVec3::ZERO, DVec3::Y), None);
        let nowhere = Sight { origin: DVec3::ZERO, direction: DVec3::NAN };
        assert_eq!((nowhere.along_axis(DVec3::ONE, DVec3::X), nowhere.on_plane(DVec3::ONE, DVec3::X)), (None, None));
    }

    #[test]
    fn a_ray_meets_a_plane() {
        let met = sight(DVec3::new(1.0, 4.0, 2.0), DVec3::new(3.0, 0.0, -1.0)).on_plane(DVec3::ZERO, DVec3::Y).unwrap();
        assert!((met - DVec3::new(3.0, 0.0, -1.0)).length() < 1e-9, "{met}");
    }

    #[test]
    fn angles_are_right_handed_and_go_on_after_a_turn() {
        for axis in [DVec3::X, DVec3::Y, DVec3::Z, DVec3::NEG_Y, DVec3::new(0.6, 0.0, 0.8)] {
            let [u, v] = beside(axis);
            assert!((u.cross(v) - axis).length() < 1e-9);
            let center = DVec3::new(1.0, 2.0, 3.0);
            let angle = angle_about(center, axis, center + (u + v) * 2.0 + axis * 7.0);
            assert!((angle - std::f64::consts::FRAC_PI_4).abs() < 1e-9);
        }
        assert!((unwrapped(-3.0, 3.2) - (std::f64::consts::TAU - 3.0)).abs() < 1e-9);
        assert!((unwrapped(0.1, 6.0) - (std::f64::consts::TAU + 0.1)).abs() < 1e-9);
        assert_eq!(unwrapped(1.0, 1.2), 1.0);
    }
}
