//! How a picture was made, in one line of JSON: the text of [`Metadata::settings`].

use super::Metadata;
use std::fmt::Write;

/// What a picture file says of how it was made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PictureSettings<'a> {
    /// The camera's name.
    pub camera: &'a str,
    /// Width and height of the whole picture.
    pub size: [u32; 2],
    /// The part that was made, if not the whole: left, top, width, height.
    pub crop: Option<[u32; 4]>,
    /// Rays through each pixel.
    pub rays_per_pixel: u32,
    /// Whether they were spread over the pixel.
    pub antialiasing: bool,
    /// Whether they were spread over the lens.
    pub depth_of_field: bool,
    /// Surfaces along a path.
    pub depth: u32,
    /// The word for what the picture shows.
    pub integrator: &'a str,
    /// Whether a bar that says what the colours mean stands to the right of the picture.
    pub color_bar: bool,
}

impl PictureSettings<'_> {
    /// The settings as JSON.
    #[must_use]
    pub fn to_json(&self) -> String {
        let Self { camera, size: [width, height], crop, rays_per_pixel, .. } = self;
        let crop = crop.map(|[x, y, w, h]| format!(r#","crop":[{x},{y},{w},{h}]"#)).unwrap_or_default();
        let bar = if self.color_bar { r#","color_bar":true"# } else { "" };
        let (antialiasing, depth_of_field, depth) = (self.antialiasing, self.depth_of_field, self.depth);
        format!(
            r#"{{"camera":{},"size":[{width},{height}]{crop},"rays_per_pixel":{rays_per_pixel},"antialiasing":{antialiasing},"depth_of_field":{depth_of_field},"depth":{depth},"integrator":{}{bar}}}"#,
            quoted(camera),
            quoted(self.integrator),
        )
    }

    /// The metadata of a picture of the scene `title`, with the hash of its linear values.
    #[must_use]
    pub fn metadata(&self, title: &str, hash: &str) -> Metadata {
        Metadata { title: title.to_owned(), settings: self.to_json(), hash: hash.to_owned() }
    }
}

/// A JSON string (RFC 8259, section 7).
fn quoted(text: &str) -> String {
    let mut quoted = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => quoted.extend(['\\', c]),
            // A String takes whatever is written to it.
            c if u32::from(c) < 0x20 => _ = write!(quoted, "\\u{:04x}", u32::from(c)),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn settings_are_json() {
        let settings = PictureSettings {
            camera: "a \"b\" \\ é",
            size: [96, 72],
            crop: None,
            rays_per_pixel: 4,
            antialiasing: true,
            depth_of_field: false,
            depth: 5,
            integrator: "classic",
            color_bar: false,
        };
        assert_eq!(
            settings.to_json(),
            r#"{"camera":"a \"b\" \\ é","size":[96,72],"rays_per_pixel":4,"antialiasing":true,"depth_of_field":false,"depth":5,"integrator":"classic"}"#
        );
        let part = PictureSettings { crop: Some([1, 2, 3, 4]), ..settings };
        assert!(part.to_json().contains(r#""size":[96,72],"crop":[1,2,3,4],"rays"#));
        let with_bar = PictureSettings { color_bar: true, ..settings };
        assert!(with_bar.to_json().ends_with(r#","color_bar":true}"#));
        assert_eq!(quoted("\n\u{1}"), r#""\u000a\u0001""#);
    }
}
