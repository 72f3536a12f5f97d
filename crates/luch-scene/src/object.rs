//! Objects: a shape with a name and a look.

use crate::color::Color;
use crate::number::{Size, Unit};
use crate::shape::Shape;

/// How the light on a mesh is worked out between its vertices.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Shading {
    /// The face's own normal: facets show.
    Flat,
    /// Intensities at the three vertices, blended over the face (Gouraud, 1971).
    Gouraud,
    /// Normals blended over the face, lighting at the hit point (Phong, 1975).
    #[default]
    Phong,
}

impl Shading {
    /// Every model, from coarse to smooth.
    pub const ALL: [Self; 3] = [Self::Flat, Self::Gouraud, Self::Phong];

    /// The word for it in scene files and on the command line.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::Flat => "flat",
            Self::Gouraud => "gouraud",
            Self::Phong => "phong",
        }
    }

    /// The model of that word.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|s| s.word() == word)
    }
}

/// A second colour in squares (on walls) or cubes (elsewhere) that alternate with the first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Checker {
    /// Side of a square, in scene units.
    pub size: Size,
    /// The other colour.
    pub color: Color,
}

/// The look of an object.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Material {
    /// Diffuse colour. `None`: what the model's own file says, or [`Material::DEFAULT_COLOR`].
    pub color: Option<Color>,
    /// Share of the mirror in the picture of the surface: 0 none, 1 a perfect mirror.
    pub reflection: Unit,
    /// Strength and sharpness of the highlight: 0 is matt, 1 a tight bright highlight. `None`: what the model's own file says, or 0.
    pub gloss: Option<Unit>,
    /// A second colour in squares.
    pub checker: Option<Checker>,
}

impl Material {
    /// The colour of what nobody gave one: a light grey, sRGB #cccccc.
    pub const DEFAULT_COLOR: Color = DEFAULT_GREY;

    /// A matt surface of one colour.
    #[must_use]
    pub const fn matt(color: Color) -> Self {
        Self { color: Some(color), reflection: Unit::ZERO, gloss: None, checker: None }
    }
}

/// sRGB 204 of 255 in linear light, written out because the curve is no constant function; a test compares.
const DEFAULT_GREY: Color = Color::grey_const(0.603_827_4);

impl Default for Material {
    fn default() -> Self {
        Self { color: None, reflection: Unit::ZERO, gloss: None, checker: None }
    }
}

/// One thing of the scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Object {
    /// What people call it; unique among the objects and lights of a scene.
    pub name: String,
    /// Its geometry.
    pub shape: Shape,
    /// Its look.
    pub material: Material,
    /// For meshes: the shading model, if not the scene's.
    pub shading: Option<Shading>,
    /// Whether it is left out of the picture.
    pub hidden: bool,
}

impl Object {
    /// A visible object with the default look.
    #[must_use]
    pub fn new(name: impl Into<String>, shape: Shape) -> Self {
        Self { name: name.into(), shape, material: Material::default(), shading: None, hidden: false }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_default_grey_is_srgb_204() {
        assert_eq!(Material::DEFAULT_COLOR, Color::srgb8([204; 3]));
    }

    #[test]
    fn shading_words_are_read_back() {
        for shading in Shading::ALL {
            assert_eq!(Shading::from_word(shading.word()), Some(shading));
        }
        assert_eq!(Shading::from_word("Phong"), None);
    }
}
