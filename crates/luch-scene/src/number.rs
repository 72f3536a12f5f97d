//! Numbers that cannot be wrong: each type admits one range, and only its constructor makes it.

/// Why a number was refused: what it was and the range that it must lie in.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error("{value} is not {expected}")]
pub struct NumberError {
    /// The refused number.
    pub value: f64,
    /// The range in words, to stand behind "is not": `a number from 0 to 1`.
    pub expected: &'static str,
}

macro_rules! ranged {
    ($(#[$doc:meta])* $name:ident, $expected:literal, |$v:ident| $accept:expr) => {
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
        pub struct $name(f32);

        impl $name {
            /// The range in words, as [`NumberError`] tells it.
            pub const EXPECTED: &'static str = $expected;

            /// Takes a number of the range.
            ///
            /// # Errors
            /// [`NumberError`] for any other number, NaN and infinities among them.
            pub fn new($v: f32) -> Result<Self, NumberError> {
                // Written so that NaN, which fails every comparison, is refused.
                if $accept { Ok(Self($v)) } else { Err(NumberError { value: f64::from($v), expected: $expected }) }
            }

            /// The number itself.
            #[must_use]
            pub const fn get(self) -> f32 {
                self.0
            }
        }

        impl TryFrom<f64> for $name {
            type Error = NumberError;

            /// The nearest f32, if it is in range.
            fn try_from(value: f64) -> Result<Self, NumberError> {
                #[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
                Self::new(value as f32).map_err(|e| NumberError { value, ..e })
            }
        }
    };
}

/// The largest coordinate and length of a scene, in scene units. Squares and products of three such numbers stay finite in f32.
pub const MAX_COORDINATE: f32 = 1e9;
/// The smallest length of a scene, in scene units: its square is still a normal f32.
pub const MIN_SIZE: f32 = 1e-9;

ranged!(
    /// Any coordinate of a scene: finite, at most [`MAX_COORDINATE`] from zero.
    Finite, "a number from -1e9 to 1e9", |v| v.abs() <= MAX_COORDINATE
);
ranged!(
    /// A share: reflection, gloss, a colour's component.
    Unit, "a number from 0 to 1", |v| (0.0..=1.0).contains(&v)
);
ranged!(
    /// A light's intensity or the ambient light: finite, not below zero.
    NonNegative, "a finite number of at least 0", |v| v >= 0.0 && v.is_finite()
);
ranged!(
    /// The attenuation constant K and the focal distance.
    Positive, "a number above 0, up to 1e9", |v| (MIN_SIZE..=MAX_COORDINATE).contains(&v)
);
ranged!(
    /// A radius, a side, a scale: from [`MIN_SIZE`] to [`MAX_COORDINATE`].
    Size, "a length from 1e-9 to 1e9", |v| (MIN_SIZE..=MAX_COORDINATE).contains(&v)
);
ranged!(
    /// A vertical field of view in degrees.
    FieldOfView, "an angle from 0.01 to 179 degrees", |v| (0.01..=179.0).contains(&v)
);

impl Unit {
    /// None of it.
    pub const ZERO: Self = Self(0.0);
    /// All of it.
    pub const ONE: Self = Self(1.0);

    /// The nearest share: numbers outside are moved to the nearer end, NaN to 0.
    #[must_use]
    pub fn clamped(value: f32) -> Self {
        if value.is_nan() { Self(0.0) } else { Self(value.clamp(0.0, 1.0)) }
    }
}

impl NonNegative {
    /// Nothing.
    pub const ZERO: Self = Self(0.0);
    /// One.
    pub const ONE: Self = Self(1.0);

    /// The nearest number of the range; NaN gives 0.
    #[must_use]
    pub fn clamped(value: f32) -> Self {
        if value.is_nan() { Self(0.0) } else { Self(value.clamp(0.0, f32::MAX)) }
    }
}

impl Positive {
    /// The nearest positive number of the range; NaN gives the smallest.
    #[must_use]
    pub fn clamped(value: f32) -> Self {
        if value.is_nan() { Self(MIN_SIZE) } else { Self(value.clamp(MIN_SIZE, MAX_COORDINATE)) }
    }
}

impl Size {
    /// One unit of the scene.
    pub const ONE: Self = Self(1.0);

    /// The nearest length of the range; NaN gives the smallest.
    #[must_use]
    pub fn clamped(value: f32) -> Self {
        if value.is_nan() { Self(MIN_SIZE) } else { Self(value.clamp(MIN_SIZE, MAX_COORDINATE)) }
    }
}

impl Finite {
    /// The nearest coordinate of the range; NaN gives 0.
    #[must_use]
    pub fn clamped(value: f32) -> Self {
        if value.is_nan() { Self(0.0) } else { Self(value.clamp(-MAX_COORDINATE, MAX_COORDINATE)) }
    }
}

impl FieldOfView {
    /// 45 degrees, the default of a camera.
    pub const DEFAULT: Self = Self(45.0);

    /// The angle in radians.
    #[must_use]
    pub fn radians(self) -> f32 {
        self.0.to_radians()
    }

    /// The nearest angle of the range; NaN gives the default.
    #[must_use]
    pub fn clamped(value: f32) -> Self {
        if value.is_nan() { Self::DEFAULT } else { Self(value.clamp(0.01, 179.0)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_range_refuses_what_lies_outside() {
        for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, -1.0, -f32::MIN_POSITIVE] {
            assert!(Unit::new(bad).is_err(), "{bad}");
            assert!(NonNegative::new(bad).is_err(), "{bad}");
            assert!(Positive::new(bad).is_err(), "{bad}");
            assert!(Size::new(bad).is_err(), "{bad}");
            assert!(FieldOfView::new(bad).is_err(), "{bad}");
        }
        assert!(Unit::new(1.000_001).is_err());
        assert!(Finite::new(1.1e9).is_err());
        assert!(Size::new(0.0).is_err());
        assert!(FieldOfView::new(180.0).is_err());
        assert!(NonNegative::new(f32::MAX).is_ok());
    }

    #[test]
    fn a_refusal_says_what_and_why() {
        let error = Unit::try_from(1.5_f64).unwrap_err();
        assert_eq!(error.to_string(), "1.5 is not a number from 0 to 1");
        assert_eq!(Finite::try_from(1e300).unwrap_err().value, 1e300);
    }
}
