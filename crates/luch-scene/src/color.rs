//! Colours: linear light inside, sRGB where people write and see them.

use crate::number::{NumberError, Unit};
use glam::Vec3;

/// A colour of linear light, each component from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Color(Vec3);

impl Color {
    /// No light.
    pub const BLACK: Self = Self(Vec3::ZERO);
    /// All of it.
    pub const WHITE: Self = Self(Vec3::ONE);

    /// A grey of linear light from a constant in 0..=1.
    pub(crate) const fn grey_const(linear: f32) -> Self {
        Self(Vec3::splat(linear))
    }

    /// Takes linear components.
    ///
    /// # Errors
    /// [`NumberError`] for the first component that is not a [`Unit`].
    pub fn linear(rgb: Vec3) -> Result<Self, NumberError> {
        for c in rgb.to_array() {
            Unit::new(c)?;
        }
        Ok(Self(rgb))
    }

    /// The colour of three sRGB bytes.
    #[must_use]
    pub fn srgb8(rgb: [u8; 3]) -> Self {
        Self(Vec3::from_array(rgb.map(|c| linear_from_srgb(f32::from(c) / 255.0))))
    }

    /// The colour of `#rrggbb` or `#rgb`, in sRGB; `None` if `text` is neither.
    #[must_use]
    pub fn from_hex(text: &str) -> Option<Self> {
        let digits = text.strip_prefix('#')?;
        if !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
            return None;
        }
        let byte = |text: &str| u8::from_str_radix(text, 16).ok();
        match digits.len() {
            6 => Some(Self::srgb8([byte(&digits[0..2])?, byte(&digits[2..4])?, byte(&digits[4..6])?])),
            3 => {
                let nibble = |i: usize| byte(&digits[i..=i]).map(|n| n * 17);
                Some(Self::srgb8([nibble(0)?, nibble(1)?, nibble(2)?]))
            }
            _ => None,
        }
    }

    /// `#rrggbb`, if that says exactly this colour.
    #[must_use]
    pub fn to_hex(self) -> Option<String> {
        let rgb = self.to_srgb8();
        (Self::srgb8(rgb) == self).then(|| format!("#{:02x}{:02x}{:02x}", rgb[0], rgb[1], rgb[2]))
    }

    /// The nearest three sRGB bytes.
    #[must_use]
    pub fn to_srgb8(self) -> [u8; 3] {
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 0..=255 by construction")]
        self.0.to_array().map(|c| (srgb_from_linear(c) * 255.0 + 0.5) as u8)
    }

    /// The linear components.
    #[must_use]
    pub const fn get(self) -> Vec3 {
        self.0
    }
}

/// Linear light of an sRGB value in 0..=1 (IEC 61966-2-1), the same bits on every machine.
#[must_use]
pub fn linear_from_srgb(c: f32) -> f32 {
    if c <= 0.040_45 { c / 12.92 } else { libm::powf((c + 0.055) / 1.055, 2.4) }
}

/// sRGB value in 0..=1 of linear light (IEC 61966-2-1); values outside 0..=1 are moved to the nearer end.
#[must_use]
pub fn srgb_from_linear(c: f32) -> f32 {
    let c = if c > 0.0 { c.min(1.0) } else { 0.0 };
    if c <= 0.003_130_8 { c * 12.92 } else { 1.055 * libm::powf(c, 1.0 / 2.4) - 0.055 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_srgb_byte_survives_the_way_to_linear_and_back() {
        for b in 0..=255_u8 {
            let color = Color::srgb8([b, 255 - b, b]);
            assert_eq!(color.to_srgb8(), [b, 255 - b, b]);
            assert_eq!(Color::from_hex(&color.to_hex().unwrap()), Some(color));
        }
    }

    #[test]
    fn known_values_of_the_srgb_curve() {
        assert_eq!(linear_from_srgb(0.0), 0.0);
        assert_eq!(linear_from_srgb(1.0), 1.0);
        assert!((linear_from_srgb(0.5) - 0.214_041_14).abs() < 1e-6);
        assert!((srgb_from_linear(0.18) - 0.461_356_2).abs() < 1e-5);
        assert_eq!(srgb_from_linear(f32::NAN), 0.0);
        assert_eq!(srgb_from_linear(7.0), srgb_from_linear(1.0));
    }

    #[test]
    fn words_that_are_no_colours() {
        for text in ["", "#", "ff0000", "#ff00", "#gg0000", "#ff00000", "#яяя", "# ff00"] {
            assert_eq!(Color::from_hex(text), None, "{text}");
        }
        assert_eq!(Color::from_hex("#F0a"), Color::from_hex("#ff00aa"));
    }
}
