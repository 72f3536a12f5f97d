//! PNG, in 8 or 16 bits of sRGB.

use super::check_length;
use super::metadata::{Metadata, printable};
use crate::atomic_save::save;
use crate::error::Result;
use png::{BitDepth, ColorType, DeflateCompression, Encoder, EncodingError, Filter, SrgbRenderingIntent};
use std::borrow::Cow;
use std::io::{self, Write};
use std::path::Path;

/// The pixels of a picture, encoded with the sRGB curve: red, green and blue of each, rows from the top.
#[derive(Debug, Clone, Copy)]
pub enum Pixels<'a> {
    /// 8 bits, 0 to 255.
    Rgb8(&'a [u8]),
    /// 16 bits, 0 to 65,535.
    Rgb16(&'a [u16]),
}

/// Measured on pictures of 1920 x 1080, one core: 25 ms for a clean one, 0.1 s for a noisy one and for 16 bits. Level 6 makes
/// files a tenth to a fifth smaller and takes five to ten times as long; level 1 makes them a quarter larger.
const COMPRESSION: DeflateCompression = DeflateCompression::Level(2);
/// For each row the filter that leaves the least entropy: some 4 % smaller than by the usual least sum of differences.
const FILTER: Filter = Filter::MinEntropy;

/// Writes a PNG file, whole or not at all ([`save`]).
///
/// # Errors
/// `Output` if the file cannot be written, or if the values are not three a pixel.
pub fn write_png(path: &Path, width: u32, height: u32, pixels: Pixels<'_>, metadata: &Metadata) -> Result<()> {
    check_length(path, [width, height], pixels.len())?;
    save(path, |out| encode_png(out, width, height, pixels, metadata))
}

/// Writes the bytes of a PNG file.
///
/// # Errors
/// Those of `out`; `InvalidInput` if the values are not three a pixel.
pub fn encode_png(
    out: &mut dyn Write,
    width: u32,
    height: u32,
    pixels: Pixels<'_>,
    metadata: &Metadata,
) -> io::Result<()> {
    let mut encoder = Encoder::new(out, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(pixels.depth());
    encoder.set_deflate_compression(COMPRESSION);
    encoder.set_filter(FILTER);
    encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    for (key, text) in [
        ("Software", Metadata::SOFTWARE),
        ("Title", &metadata.title),
        (Metadata::SETTINGS, &metadata.settings),
        (Metadata::HASH, &metadata.hash),
    ] {
        let text = printable(text);
        match text.as_str() {
            "" => {}
            // The older chunk is the one that every program reads, and ASCII is the same in Latin-1 and UTF-8.
            ascii if ascii.is_ascii() => encoder.add_text_chunk(key.to_owned(), text).map_err(as_io)?,
            _ => encoder.add_itxt_chunk(key.to_owned(), text).map_err(as_io)?,
        }
    }
    let mut writer = encoder.write_header().map_err(as_io)?;
    writer.write_image_data(&pixels.bytes()).map_err(as_io)?;
    writer.finish().map_err(as_io)
}

impl<'a> Pixels<'a> {
    fn len(&self) -> usize {
        match self {
            Self::Rgb8(values) => values.len(),
            Self::Rgb16(values) => values.len(),
        }
    }

    const fn depth(&self) -> BitDepth {
        match self {
            Self::Rgb8(_) => BitDepth::Eight,
            Self::Rgb16(_) => BitDepth::Sixteen,
        }
    }

    /// The values as PNG has them: the higher byte first.
    fn bytes(&self) -> Cow<'a, [u8]> {
        match self {
            Self::Rgb8(values) => Cow::Borrowed(values),
            Self::Rgb16(values) => Cow::Owned(values.iter().flat_map(|v| v.to_be_bytes()).collect()),
        }
    }
}

fn as_io(error: EncodingError) -> io::Error {
    match error {
        EncodingError::IoError(e) => e,
        other => io::Error::new(io::ErrorKind::InvalidInput, other.to_string()),
    }
}
