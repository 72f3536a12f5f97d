//! Paths as text that says exactly them, whatever bytes they have.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// The path as ASCII in one line: bytes that are no plain characters are written as `%` and two hexadecimal digits.
#[must_use]
pub fn encode_path(path: &Path) -> String {
    let mut text = String::new();
    for &byte in path.as_os_str().as_encoded_bytes() {
        if byte.is_ascii_graphic() && byte != b'%' {
            text.push(char::from(byte));
        } else {
            text.push_str(&format!("%{byte:02x}"));
        }
    }
    text
}

/// The path of such a text; `None` for a text that [`encode_path`] does not write.
#[must_use]
pub fn decode_path(text: &str) -> Option<PathBuf> {
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, tail @ ..] = rest {
        match (first, tail) {
            (b'%', [high, low, after @ ..]) => {
                let digit = |byte: &u8| char::from(*byte).to_digit(16).and_then(|digit| u8::try_from(digit).ok());
                bytes.push((digit(high)? << 4) | digit(low)?);
                rest = after;
            }
            (b'%', _) => return None,
            (byte, _) => {
                bytes.push(*byte);
                rest = tail;
            }
        }
    }
    os_string(bytes).map(PathBuf::from)
}

#[cfg(unix)]
#[allow(clippy::unnecessary_wraps, reason = "elsewhere not every list of bytes is a path")]
fn os_string(bytes: Vec<u8>) -> Option<OsString> {
    use std::os::unix::ffi::OsStringExt;
    Some(OsString::from_vec(bytes))
}

#[cfg(not(unix))]
fn os_string(bytes: Vec<u8>) -> Option<OsString> {
    String::from_utf8(bytes).ok().map(OsString::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn paths_come_back_as_they_were() {
        for path in ["", "/a/b.toml", "100% of it/ель №1", "a\nb", "%41"] {
            let text = encode_path(Path::new(path));
            assert!(text.is_ascii() && !text.contains(['\n', ' ']), "{text}");
            assert_eq!(decode_path(&text).as_deref(), Some(Path::new(path)));
        }
        for text in ["%", "%4", "%zz"] {
            assert_eq!(decode_path(text), None, "{text}");
        }
    }

    #[cfg(unix)]
    #[test]
    fn bytes_that_are_no_utf_8_come_back() {
        use std::os::unix::ffi::OsStrExt;
        let odd = Path::new(std::ffi::OsStr::from_bytes(b"/caf\xe9/\xff.obj"));
        assert_eq!(decode_path(&encode_path(odd)).as_deref(), Some(odd));
    }
}
