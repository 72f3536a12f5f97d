//! Pictures are read back by other people's readers: every value, and what the file says of itself.

use luch_io::{ErrorKind, Metadata, PictureFormat, Pixels, linear_hash, write_exr, write_png};
use std::fs;
use std::io::BufReader;
use std::path::{Path, PathBuf};

/// A file of its own for a test, removed at its end.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("luch-picture-{}-{name}", std::process::id()));
        let _ = fs::remove_file(&path);
        Self(path)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_file(&self.0);
    }
}

const WIDTH: u32 = 37;
const HEIGHT: u32 = 21;

/// Numbers without a pattern that a filter would like, from a fixed start (xorshift, Marsaglia 2003).
fn noise() -> impl Iterator<Item = u32> {
    let mut state = 0x9e37_79b9_u32;
    std::iter::repeat_with(move || {
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
        state
    })
    .take((WIDTH * HEIGHT * 3) as usize)
}

fn metadata(hash: &str) -> Metadata {
    Metadata {
        title: "Сцена «5»".into(),
        settings: r#"{"camera":"Camera 1","size":[37,21]}"#.into(),
        hash: hash.into(),
    }
}

fn decode_png(path: &Path) -> (png::Info<'static>, Vec<u8>) {
    let mut reader = png::Decoder::new(BufReader::new(fs::File::open(path).unwrap())).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut bytes).unwrap();
    reader.finish().unwrap();
    (reader.info().clone(), bytes)
}

#[test]
fn a_png_of_8_bits_holds_every_pixel_and_says_what_made_it() {
    let file = Scratch::new("8.png");
    let values: Vec<u8> = noise().map(|v| (v >> 24) as u8).collect();
    write_png(&file.0, WIDTH, HEIGHT, Pixels::Rgb8(&values), &metadata("ab12")).unwrap();
    let (info, bytes) = decode_png(&file.0);
    assert_eq!((info.width, info.height, info.bit_depth), (WIDTH, HEIGHT, png::BitDepth::Eight));
    assert!(bytes == values);
    assert_eq!(info.srgb, Some(png::SrgbRenderingIntent::Perceptual));
    let texts: Vec<_> = info.uncompressed_latin1_text.iter().map(|t| (t.keyword.as_str(), t.text.as_str())).collect();
    assert!(texts[0].1.starts_with("Luch "));
    assert_eq!(texts[1..], [(Metadata::SETTINGS, metadata("").settings.as_str()), (Metadata::HASH, "ab12")]);
    let title = &info.utf8_text[0];
    assert_eq!((title.keyword.as_str(), title.get_text().unwrap()), ("Title", "Сцена «5»".to_owned()));
}

#[test]
fn a_png_of_16_bits_holds_every_pixel() {
    let file = Scratch::new("16.png");
    let values: Vec<u16> = noise().map(|v| (v >> 16) as u16).collect();
    write_png(&file.0, WIDTH, HEIGHT, Pixels::Rgb16(&values), &metadata("")).unwrap();
    let (info, bytes) = decode_png(&file.0);
    assert_eq!(info.bit_depth, png::BitDepth::Sixteen);
    let read: Vec<u16> = bytes.chunks(2).map(|b| u16::from_be_bytes([b[0], b[1]])).collect();
    assert!(read == values);
    assert!(info.uncompressed_latin1_text.iter().all(|t| t.keyword != Metadata::HASH), "no hash, no chunk");
}

#[test]
fn an_exr_holds_every_bit_and_says_what_made_it() {
    use exr::prelude::*;
    let file = Scratch::new("a.exr");
    // All bit patterns but those of infinities and NaN, denormals and negative zero among them.
    let values: Vec<f32> = noise().map(f32::from_bits).map(|v| if v.is_finite() { v } else { -0.0 }).collect();
    let hash = linear_hash(&values);
    write_exr(&file.0, WIDTH, HEIGHT, &values, &metadata(&hash)).unwrap();

    let image = read_first_flat_layer_from_file(&file.0).unwrap();
    let size = (WIDTH as usize, HEIGHT as usize);
    assert_eq!((image.layer_data.size.0, image.layer_data.size.1), size);
    let channels = &image.layer_data.channel_data.list;
    assert_eq!(channels.iter().map(|c| c.name.to_string()).collect::<Vec<_>>(), ["B", "G", "R"]);
    let read = |channel: usize, i: usize| {
        let FlatSamples::F32(samples) = &channels[channel].sample_data else { panic!("32-bit floats") };
        samples[i]
    };
    let again: Vec<f32> = (0..size.0 * size.1).flat_map(|i| [read(2, i), read(1, i), read(0, i)]).collect();
    assert_eq!(linear_hash(&again), hash, "every bit in its place");

    let attributes = &image.layer_data.attributes;
    assert!(attributes.software_name.as_ref().unwrap().to_string().starts_with("Luch "));
    // The exr crate shows text as Latin-1; the programs that people use take it for UTF-8, and so do we.
    let title: Vec<u8> = attributes.comments.as_ref().unwrap().bytes().to_vec();
    assert_eq!(String::from_utf8(title).unwrap(), "Сцена «5»");
    let text = |value: &AttributeValue| match value {
        AttributeValue::Text(text) => text.to_string(),
        other => panic!("{other:?}"),
    };
    assert_eq!(text(&attributes.other[&Text::from(Metadata::SETTINGS)]), metadata("").settings);
    assert_eq!(text(&attributes.other[&Text::from(Metadata::HASH)]), hash);
    assert_eq!(image.attributes.chromaticities.unwrap().red, Vec2(0.64, 0.33));
    assert_eq!(image.layer_data.encoding.compression, Compression::ZIP16);
}

#[test]
fn the_same_picture_is_the_same_file() {
    let values: Vec<f32> = noise().map(|v| v as f32).collect();
    let (one, two) = (Scratch::new("1.exr"), Scratch::new("2.exr"));
    for file in [&one, &two] {
        write_exr(&file.0, WIDTH, HEIGHT, &values, &metadata("00")).unwrap();
    }
    assert!(fs::read(&one.0).unwrap() == fs::read(&two.0).unwrap());
}

#[test]
fn infinities_and_nan_are_written_and_nothing_panics() {
    let file = Scratch::new("nan.exr");
    write_exr(&file.0, 1, 1, &[f32::NAN, f32::INFINITY, f32::NEG_INFINITY], &Metadata::default()).unwrap();
}

#[test]
fn a_wrong_number_of_values_is_refused_and_no_file_made() {
    let file = Scratch::new("wrong.png");
    for (width, height, values) in [(2, 2, 11), (2, 2, 13), (0, 2, 0), (u32::MAX, u32::MAX, 12)] {
        let error = write_png(&file.0, width, height, Pixels::Rgb8(&vec![0; values]), &metadata("")).unwrap_err();
        assert_eq!(error.kind, ErrorKind::Output);
        let error = write_exr(&file.0, width, height, &vec![0.0; values], &metadata("")).unwrap_err();
        assert_eq!(error.kind, ErrorKind::Output);
    }
    assert!(!file.0.exists());
}

#[test]
fn control_characters_in_a_name_make_no_broken_file() {
    let (png, exr) = (Scratch::new("c.png"), Scratch::new("c.exr"));
    let metadata = Metadata { title: "a\0b\nc".into(), settings: String::new(), hash: String::new() };
    write_png(&png.0, 1, 1, Pixels::Rgb8(&[1, 2, 3]), &metadata).unwrap();
    write_exr(&exr.0, 1, 1, &[1.0, 2.0, 3.0], &metadata).unwrap();
    let (info, _) = decode_png(&png.0);
    assert!(info.uncompressed_latin1_text.iter().any(|t| t.text == "a b c"));
}

#[test]
fn the_extension_tells_the_format() {
    for (path, format) in
        [("a.png", PictureFormat::Png), ("d/b.PNG", PictureFormat::Png), ("a.b.Exr", PictureFormat::Exr)]
    {
        assert_eq!(PictureFormat::of(Path::new(path)).unwrap(), format, "{path}");
    }
    assert_eq!(PictureFormat::of(Path::new("-")).unwrap(), PictureFormat::Png);
    let words = |path: &str| PictureFormat::of(Path::new(path)).unwrap_err().to_string();
    assert_eq!(words("a.jpg"), "a.jpg: pictures are not written as .jpg\nhint: use .png or .exr: a.png");
    assert_eq!(
        words("picture"),
        "picture: has no extension that tells the format\nhint: use .png or .exr: picture.png"
    );
    for path in ["", ".", "..", ".png", "a.", "a.png/", "a.exr.txt"] {
        let known = PictureFormat::of(Path::new(path));
        assert_eq!(known.is_ok(), path == "a.png/", "{path}: {known:?}");
    }
}
