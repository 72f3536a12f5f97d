//! Is it text at all? Tells other encodings and other formats apart before a line is read.

use super::place::line_of;
use crate::error::{Error, ErrorKind, Place, Result};
use std::path::Path;

/// The text behind a byte order mark.
///
/// # Errors
/// [`ErrorKind::Malformed`] for an empty file, UTF-16, and bytes that no text has.
pub(super) fn checked<'a>(bytes: &'a [u8], file: &Path) -> Result<&'a [u8]> {
    let refuse = |text: &str| Error::new(ErrorKind::Malformed, file, text);
    match bytes {
        [] => return Err(refuse("the file is empty")),
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => {
            return Err(refuse("the file is UTF-16 text").hint("save it as UTF-8 or ASCII"));
        }
        _ => {}
    }
    if let Some((what, hint)) = other_format(bytes) {
        return Err(refuse(what).hint(hint));
    }
    if let Some(offset) = bytes.iter().position(|b| *b == 0) {
        let line = line_of(bytes, offset);
        let hint = "the file is binary, or UTF-16: save it as plain text";
        return Err(refuse(&format!("line {line} has a NUL byte: this is no plain text"))
            .at(Place::Byte(u64::try_from(offset).unwrap_or(u64::MAX)))
            .hint(hint));
    }
    Ok(bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes))
}

/// What the first bytes say, if they say that it is something else.
fn other_format(bytes: &[u8]) -> Option<(&'static str, &'static str)> {
    const READ: &str = "the model formats read so far: OBJ";
    let starts = |magic: &[u8]| bytes.starts_with(magic);
    let line_is = |word: &[u8]| bytes.split(|b| matches!(b, b'\n' | b'\r')).next() == Some(word);
    if starts(b"glTF") {
        Some(("the file is a glTF binary (GLB), not an OBJ model", READ))
    } else if line_is(b"ply") {
        Some(("the file is a PLY model, not an OBJ model", READ))
    } else if starts(b"solid ") {
        Some(("the file is an STL model, not an OBJ model", READ))
    } else if starts(b"PK\x03\x04") {
        Some(("the file is a ZIP archive, not an OBJ model", "unpack it first"))
    } else if starts(b"\x1f\x8b") {
        Some(("the file is packed with gzip", "unpack it first"))
    } else if starts(b"\x89PNG") || starts(b"\xff\xd8\xff") {
        Some(("the file is a picture, not an OBJ model", READ))
    } else if starts(b"<") {
        Some(("the file is a web page or XML, not an OBJ model", "download the model itself, not the page around it"))
    } else if starts(b"version https://git-lfs") {
        Some(("the file is a Git LFS pointer, not the model itself", "fetch it with `git lfs pull`"))
    } else {
        None
    }
}
