//! OpenEXR: the linear picture itself, every bit of it.

use super::check_length;
use super::metadata::{Metadata, printable};
use crate::atomic_save::{Sink, save};
use crate::error::Result;
use exr::image::{Encoding, Image, Layer, SpecificChannels};
use exr::math::Vec2;
use exr::meta::attribute::{AttributeValue, Chromaticities, Text};
use exr::meta::header::LayerAttributes;
use exr::prelude::{Compression, WritableImage};
use std::io;
use std::path::Path;

/// The primaries and the white point of sRGB (ITU-R BT.709, D65), which our linear values are meant in.
const CHROMATICITIES: Chromaticities = Chromaticities {
    red: Vec2(0.64, 0.33),
    green: Vec2(0.30, 0.60),
    blue: Vec2(0.15, 0.06),
    white: Vec2(0.3127, 0.3290),
};

/// Writes linear values as 32-bit floats, losslessly compressed (ZIP, 16 rows a block), whole or not at all ([`save`]).
///
/// `rgb` has red, green and blue of each pixel, rows from the top.
///
/// # Errors
/// `Output` if the file cannot be written, or if the values are not three a pixel.
pub fn write_exr(path: &Path, width: u32, height: u32, rgb: &[f32], metadata: &Metadata) -> Result<()> {
    check_length(path, [width, height], rgb.len())?;
    save(path, |out| encode(out, [width, height], rgb, metadata))
}

fn encode(out: &mut dyn Sink, [width, height]: [u32; 2], rgb: &[f32], metadata: &Metadata) -> io::Result<()> {
    let too_large = |_| io::Error::new(io::ErrorKind::InvalidInput, "the picture is too large");
    let size: Vec2<usize> = Vec2(width.try_into().map_err(too_large)?, height.try_into().map_err(too_large)?);
    let (pixels, _) = rgb.as_chunks::<3>();
    let channels = SpecificChannels::rgb(|Vec2(x, y): Vec2<usize>| {
        // The length was checked, so every place is there; a black pixel would be better than a panic.
        let [r, g, b] =
            y.checked_mul(size.0).and_then(|row| pixels.get(row.checked_add(x)?)).copied().unwrap_or_default();
        (r, g, b)
    });
    let encoding = Encoding { compression: Compression::ZIP16, ..Encoding::FAST_LOSSLESS };

    // One attribute in each of the two lists of free ones: the writer goes through them in random order, and the same
    // picture shall be the same file.
    let mut attributes = LayerAttributes { software_name: text(Metadata::SOFTWARE), ..LayerAttributes::default() };
    attributes.comments = text(&metadata.title);
    attributes.other.extend(entry(Metadata::SETTINGS, &metadata.settings));
    let mut image = Image::from_layer(Layer::new(size, attributes, encoding, channels));
    image.attributes.chromaticities = Some(CHROMATICITIES);
    image.attributes.other.extend(entry(Metadata::HASH, &metadata.hash));
    image.write().to_buffered(out).map_err(|e| match e {
        exr::error::Error::Io(e) => e,
        other => io::Error::other(other.to_string()),
    })
}

/// A text attribute, if there is something to say.
fn text(text: &str) -> Option<Text> {
    if text.is_empty() {
        return None;
    }
    // Readers show the bytes as they are, and most take them for UTF-8.
    Some(Text::from_bytes_unchecked(printable(text).bytes().collect()))
}

fn entry(key: &str, value: &str) -> Option<(Text, AttributeValue)> {
    Some((text(key)?, AttributeValue::Text(text(value)?)))
}
