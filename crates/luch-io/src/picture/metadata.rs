//! What a picture file says about how it was made.

/// Written into every picture file, so that a picture found years later can be made again.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Metadata {
    /// The scene's name. PNG: `Title`. EXR: `comments`.
    pub title: String,
    /// The settings in one line, as JSON. PNG and EXR: `luch:settings`.
    pub settings: String,
    /// [`super::linear_hash`] of the linear picture; empty for none. PNG and EXR: `luch:hash`.
    pub hash: String,
}

impl Metadata {
    /// The key of [`Metadata::settings`].
    pub const SETTINGS: &'static str = "luch:settings";
    /// The key of [`Metadata::hash`].
    pub const HASH: &'static str = "luch:hash";
    /// What the files say of the program. PNG: `Software`. EXR: `software`.
    pub const SOFTWARE: &'static str = concat!("Luch ", env!("CARGO_PKG_VERSION"));
}

/// The text without what neither format can hold: NUL ends a string in both.
pub(super) fn printable(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
