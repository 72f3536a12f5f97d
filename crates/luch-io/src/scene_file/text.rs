//! The text of a scene file, and places in it.

use crate::error::{Error, ErrorKind, Place, Result};
use std::ops::Range;
use std::path::Path;

/// The longest line that an error shows, in characters: a longer one would only flood the terminal.
const SHOWN_LINE: usize = 160;
/// The longest piece of the file that a message quotes, in characters.
const QUOTED: usize = 40;

/// A scene file's text with the name of the file that it came from.
#[derive(Debug, Clone, Copy)]
pub(crate) struct SceneText<'a> {
    /// The file, as the user named it.
    pub(crate) file: &'a Path,
    /// What is in it, without the byte order mark.
    pub(crate) text: &'a str,
}

/// The text of the bytes, without a byte order mark.
///
/// # Errors
/// `Malformed` at the first byte that is no UTF-8.
pub(crate) fn decode<'a>(file: &Path, bytes: &'a [u8]) -> Result<&'a str> {
    let bytes = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
    if bytes.starts_with(b"\xFF\xFE") || bytes.starts_with(b"\xFE\xFF") {
        return Err(Error::new(ErrorKind::Malformed, file, "the text is UTF-16").hint("save it as UTF-8"));
    }
    std::str::from_utf8(bytes).map_err(|e| {
        let good = bytes.get(..e.valid_up_to()).and_then(|b| std::str::from_utf8(b).ok()).unwrap_or_default();
        let wrong = bytes.get(e.valid_up_to()).copied().unwrap_or_default();
        let place = match (SceneText { file, text: good }).place(&(good.len()..good.len())) {
            // The line is cut at the byte in question, for what follows is not text.
            Place::Text { line, column, .. } => Place::Text { line, column, source: String::new(), length: 1 },
            other => other,
        };
        Error::new(ErrorKind::Malformed, file, format!("the byte 0x{wrong:02x} is not UTF-8 text"))
            .at(place)
            .hint("a scene is a UTF-8 text file in TOML: save it as UTF-8")
    })
}

impl SceneText<'_> {
    /// The place of a span of bytes, its line with it. Only the first line of the span is marked.
    pub(crate) fn place(&self, span: &Range<usize>) -> Place {
        let before = self.text.get(..span.start).unwrap_or(self.text);
        let line_start = before.rfind('\n').map_or(0, |at| at.saturating_add(1));
        let line = before.matches('\n').count().saturating_add(1);
        let column = before.get(line_start..).unwrap_or_default().chars().count().saturating_add(1);
        let whole = self.text.get(line_start..).unwrap_or_default();
        let whole = whole.split('\n').next().unwrap_or_default().trim_end_matches('\r');
        // A control character or tab would shift the marks away from what they mark.
        let shown = |c: char| if c.is_control() { ' ' } else { c };
        let source =
            if column > SHOWN_LINE { String::new() } else { whole.chars().take(SHOWN_LINE).map(shown).collect() };
        let marked = self.text.get(span.clone()).unwrap_or_default();
        let left = source.chars().count().saturating_sub(column.saturating_sub(1));
        let length = marked.split('\n').next().unwrap_or_default().trim_end().chars().count().min(left).max(1);
        Place::Text { line, column, source, length }
    }

    /// Number of the line that holds a byte, from 1.
    pub(crate) fn line(&self, at: usize) -> usize {
        self.text.get(..at).unwrap_or(self.text).matches('\n').count().saturating_add(1)
    }

    /// A malformed file, at a span of bytes.
    pub(crate) fn error(&self, span: &Range<usize>, text: impl Into<String>) -> Error {
        Error::new(ErrorKind::Malformed, self.file, text).at(self.place(span))
    }
}

/// A piece of text as a message quotes it: one line, cut to a readable length, in backticks.
pub(crate) fn quote(text: &str) -> String {
    let line = text.split('\n').next().unwrap_or_default().trim_end();
    let mut shown: String = line.chars().take(QUOTED).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if shown.len() < text.trim_end().len() {
        shown.push_str("...");
    }
    format!("`{shown}`")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(text: &str) -> SceneText<'_> {
        SceneText { file: Path::new("s.toml"), text }
    }

    #[test]
    fn places_count_lines_and_characters_from_one() {
        let t = text("a = 1\r\nname = \"яя\" # x\r\n");
        let Place::Text { line, column, source, length } = t.place(&(14..20)) else { panic!() };
        assert_eq!((line, column, source.as_str(), length), (2, 8, "name = \"яя\" # x", 4));
        let Place::Text { line, column, length, .. } = t.place(&(t.text.len()..t.text.len())) else { panic!() };
        assert_eq!((line, column, length), (3, 1, 1));
    }

    #[test]
    fn a_very_long_line_is_not_shown_and_a_long_word_is_cut() {
        let long = "x".repeat(100_000);
        let t = text(&long);
        let Place::Text { column, source, .. } = t.place(&(5_000..6_000)) else { panic!() };
        assert_eq!((column, source.len()), (5_001, 0));
        let Place::Text { source, length, .. } = t.place(&(0..6_000)) else { panic!() };
        assert_eq!((source.len(), length), (160, 160));
        assert_eq!(quote(&long).len(), 45);
    }

    #[test]
    fn bytes_that_are_no_text_are_told_with_their_place() {
        let e = decode(Path::new("s"), b"luch = 1\nname = \"\xff\"").unwrap_err();
        assert!(e.to_string().starts_with("s:2:9: the byte 0xff is not UTF-8 text"), "{e}");
        assert!(decode(Path::new("s"), b"\xff\xfel\0").unwrap_err().text.contains("UTF-16"));
        assert_eq!(decode(Path::new("s"), b"\xEF\xBB\xBFluch").unwrap(), "luch");
    }
}
