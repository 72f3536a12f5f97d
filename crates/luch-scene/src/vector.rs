//! Places, directions and turns of a scene.

use crate::number::{Finite, NumberError};
use glam::{Mat3, Vec3};

/// A place: three finite coordinates in scene units, right-handed, y up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point(Vec3);

impl Point {
    /// The origin.
    pub const ORIGIN: Self = Self(Vec3::ZERO);

    /// Takes three coordinates.
    ///
    /// # Errors
    /// [`NumberError`] for the first coordinate that is not a [`Finite`].
    pub fn new(p: Vec3) -> Result<Self, NumberError> {
        for c in p.to_array() {
            Finite::new(c)?;
        }
        Ok(Self(p))
    }

    /// The nearest place of the range; NaN coordinates become 0.
    #[must_use]
    pub fn clamped(p: Vec3) -> Self {
        Self(Vec3::from_array(p.to_array().map(|c| Finite::clamped(c).get())))
    }

    /// The coordinates.
    #[must_use]
    pub const fn get(self) -> Vec3 {
        self.0
    }
}

/// A direction as somebody wrote it: finite, not zero, of any length.
///
/// The length is kept so that a scene file is written back as it was read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Direction(Vec3);

impl Direction {
    /// Straight up.
    pub const UP: Self = Self(Vec3::Y);

    /// Takes three components, not all zero.
    ///
    /// # Errors
    /// [`NumberError`] for a component that is not a [`Finite`], or for a vector too short to have a direction (below 1e-9).
    pub fn new(v: Vec3) -> Result<Self, NumberError> {
        for c in v.to_array() {
            Finite::new(c)?;
        }
        let length = v.as_dvec3().length();
        if length < 1e-9 {
            return Err(NumberError { value: length, expected: "the length of a direction (at least 1e-9)" });
        }
        Ok(Self(v))
    }

    /// The vector as written.
    #[must_use]
    pub const fn get(self) -> Vec3 {
        self.0
    }

    /// The unit vector of this direction, rounded from f64.
    #[must_use]
    pub fn unit(self) -> Vec3 {
        let v = self.0.as_dvec3();
        (v / v.length()).as_vec3()
    }
}

/// Turns about the x, y and z axes in degrees, applied in that order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rotation(Vec3);

impl Rotation {
    /// No turn.
    pub const NONE: Self = Self(Vec3::ZERO);

    /// Takes three angles in degrees.
    ///
    /// # Errors
    /// [`NumberError`] for the first angle that is not a [`Finite`].
    pub fn new(degrees: Vec3) -> Result<Self, NumberError> {
        Point::new(degrees).map(|p| Self(p.get()))
    }

    /// The angles in degrees.
    #[must_use]
    pub const fn degrees(self) -> Vec3 {
        self.0
    }

    /// Whether nothing is turned.
    #[must_use]
    pub fn is_none(self) -> bool {
        self.0 == Vec3::ZERO
    }

    /// The rotation as a matrix, `Rz * Ry * Rx`, each entry rounded from f64.
    ///
    /// Quarter turns are exact, so that a box turned by 90 degrees keeps its faces on the axes.
    #[must_use]
    pub fn matrix(self) -> Mat3 {
        let [(sx, cx), (sy, cy), (sz, cz)] = self.0.to_array().map(sin_cos_degrees);
        let entry = |v: f64| {
            #[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
            let rounded = v as f32;
            rounded
        };
        Mat3::from_cols(
            Vec3::new(entry(cz * cy), entry(sz * cy), entry(-sy)),
            Vec3::new(entry(cz * sy * sx - sz * cx), entry(sz * sy * sx + cz * cx), entry(cy * sx)),
            Vec3::new(entry(cz * sy * cx + sz * sx), entry(sz * sy * cx - cz * sx), entry(cy * cx)),
        )
    }
}

/// Sine and cosine of an angle in degrees, exact at quarter turns, the same bits on every machine.
fn sin_cos_degrees(degrees: f32) -> (f64, f64) {
    let turn = f64::from(degrees).rem_euclid(360.0);
    match turn {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        _ => libm::sincos(turn.to_radians()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rotations_apply_about_x_then_y_then_z() {
        let r = Rotation::new(Vec3::new(90.0, 90.0, 0.0)).unwrap().matrix();
        // About x first: y goes to z; then about y: z goes to x.
        assert_eq!(r * Vec3::Y, Vec3::X);
        let r = Rotation::new(Vec3::new(0.0, 0.0, 90.0)).unwrap().matrix();
        assert_eq!(r * Vec3::X, Vec3::Y);
    }

    #[test]
    fn a_rotation_keeps_lengths_and_handedness() {
        let r = Rotation::new(Vec3::new(20.0, -130.0, 77.0)).unwrap().matrix();
        assert!((r.determinant() - 1.0).abs() < 1e-6);
        assert!(((r * Vec3::new(1.0, 2.0, 3.0)).length() - 14.0_f32.sqrt()).abs() < 1e-5);
    }

    #[test]
    fn zero_and_nan_are_no_directions() {
        assert!(Direction::new(Vec3::ZERO).is_err());
        assert!(Direction::new(Vec3::new(0.0, f32::NAN, 1.0)).is_err());
        assert_eq!(Direction::new(Vec3::new(0.0, -1e8, 0.0)).unwrap().unit(), Vec3::NEG_Y);
    }
}
