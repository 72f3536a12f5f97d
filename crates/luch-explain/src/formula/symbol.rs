//! The letters of the lighting model.

/// A letter of a formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Symbol {
    /// I_a, the ambient light.
    Ambient,
    /// k_a, the colour of the surface for ambient light: the same as k_d.
    AmbientColor,
    /// A, the ambient term.
    AmbientTerm,
    /// K, the attenuation constant.
    Attenuation,
    /// d, the distance to the light.
    Distance,
    /// i, the light's intensity.
    Intensity,
    /// c, the light's colour.
    LightColor,
    /// a, what is left of the light at its distance.
    Falloff,
    /// s, the light's strength at the point.
    Strength,
    /// cos θ.
    CosTheta,
    /// cos α.
    CosAlpha,
    /// n, the sharpness of the highlight.
    Exponent,
    /// k_s, its strength.
    Highlight,
    /// k_d, the colour of the surface.
    Color,
    /// D, the diffuse term.
    Diffuse,
    /// S, the highlight.
    Specular,
    /// D at vertex 1 to 3.
    VertexDiffuse(u8),
    /// S at vertex 1 to 3.
    VertexSpecular(u8),
    /// w, the weight of vertex 1 to 3.
    Weight(u8),
    /// E, what light j adds, from 1; 0 stands for any of them.
    Share(u32),
    /// r, the share of the mirror.
    Reflection,
    /// C_l, the light of the surface itself.
    Local,
    /// C_m, the colour of the mirror ray.
    Mirrored,
    /// C, what a ray brings.
    Result,
    /// P, the pixel.
    Pixel,
    /// N, the normal.
    Normal,
    /// L, the direction to the light.
    ToLight,
    /// R, that mirrored at the normal.
    MirroredLight,
    /// V, the direction to the viewer.
    ToViewer,
    /// And so on.
    Ellipsis,
}

impl Symbol {
    /// In plain text.
    #[must_use]
    pub fn text(self) -> String {
        match self {
            Self::Ambient => "I_a".to_owned(),
            Self::AmbientColor => "k_a".to_owned(),
            Self::AmbientTerm => "A".to_owned(),
            Self::Attenuation => "K".to_owned(),
            Self::Distance => "d".to_owned(),
            Self::Intensity => "i".to_owned(),
            Self::LightColor => "c".to_owned(),
            Self::Falloff => "a".to_owned(),
            Self::Strength => "s".to_owned(),
            Self::CosTheta => "cos θ".to_owned(),
            Self::CosAlpha => "cos α".to_owned(),
            Self::Exponent => "n".to_owned(),
            Self::Highlight => "k_s".to_owned(),
            Self::Color => "k_d".to_owned(),
            Self::Diffuse => "D".to_owned(),
            Self::Specular => "S".to_owned(),
            Self::VertexDiffuse(k) => format!("D_{k}"),
            Self::VertexSpecular(k) => format!("S_{k}"),
            Self::Weight(k) => format!("w_{k}"),
            Self::Share(0) => "E_j".to_owned(),
            Self::Share(j) => format!("E_{j}"),
            Self::Reflection => "r".to_owned(),
            Self::Local => "C_l".to_owned(),
            Self::Mirrored => "C_m".to_owned(),
            Self::Result => "C".to_owned(),
            Self::Pixel => "P".to_owned(),
            Self::Normal => "N".to_owned(),
            Self::ToLight => "L".to_owned(),
            Self::MirroredLight => "R".to_owned(),
            Self::ToViewer => "V".to_owned(),
            Self::Ellipsis => "...".to_owned(),
        }
    }

    /// As LaTeX, for mathematics mode.
    #[must_use]
    pub fn latex(self) -> String {
        match self {
            Self::CosTheta => "\\cos\\theta".to_owned(),
            Self::CosAlpha => "\\cos\\alpha".to_owned(),
            Self::VertexDiffuse(k) => format!("D_{{{k}}}"),
            Self::VertexSpecular(k) => format!("S_{{{k}}}"),
            Self::Weight(k) => format!("w_{{{k}}}"),
            Self::Share(j) if j > 0 => format!("E_{{{j}}}"),
            Self::Ellipsis => "\\dots".to_owned(),
            other => other.text(),
        }
    }

    /// Whether it is a word with a space in it, which needs brackets before a power.
    pub(super) const fn is_function(self) -> bool {
        matches!(self, Self::CosTheta | Self::CosAlpha)
    }
}
