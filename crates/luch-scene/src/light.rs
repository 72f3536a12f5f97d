//! Lights.

use crate::color::Color;
use crate::number::NonNegative;
use crate::vector::Point;

/// A light without size that shines the same in all directions.
#[derive(Debug, Clone, PartialEq)]
pub struct Light {
    /// What people call it; unique among the objects and lights of a scene.
    pub name: String,
    /// Where it is.
    pub position: Point,
    /// 1 is the 100 % of the studio: at distance d it lights by K / (d + K), K being the scene's attenuation.
    pub intensity: NonNegative,
    /// Its colour.
    pub color: Color,
    /// Whether it is switched off.
    pub hidden: bool,
}

impl Light {
    /// A white light of full intensity.
    #[must_use]
    pub fn new(name: impl Into<String>, position: Point) -> Self {
        Self { name: name.into(), position, intensity: NonNegative::ONE, color: Color::WHITE, hidden: false }
    }
}
