//! What is no TOML, in words for people who never heard of TOML.

use super::text::{SceneText, quote};
use crate::error::Error;
use std::ops::Range;

/// The error of the toml crate, at its place in the file, with a hint where the slip is a common one.
///
/// `base` is where the section `source` starts in the file.
pub(super) fn error(text: SceneText<'_>, base: usize, source: &str, error: &toml::de::Error) -> Error {
    let slip = Slip::new(source, error.span().unwrap_or_else(|| deepest_line(source)));
    let (span, words, hint) = slip.describe(error.message());
    let error = text.error(&(span.start.saturating_add(base)..span.end.saturating_add(base)), words);
    match hint {
        Some(hint) => error.hint(hint),
        None => error,
    }
}

/// The line with the most points. An error without a place is about a key of too many parts: `a.a.a.a`.
fn deepest_line(source: &str) -> Range<usize> {
    let lines = source.split_inclusive('\n').scan(0_usize, |end, line| {
        let start = *end;
        *end = start.saturating_add(line.len());
        Some((line.matches('.').count(), start..start.saturating_add(line.trim_end().len())))
    });
    lines.max_by_key(|(points, span)| (*points, std::cmp::Reverse(span.start))).map_or(0..0, |(_, span)| span)
}

/// The surroundings of an error.
struct Slip<'a> {
    source: &'a str,
    /// What the toml crate points at; often nothing, at the end of what it could read.
    span: Range<usize>,
    /// The line around, without the space at its ends.
    line: Range<usize>,
    /// The run of letters, digits and signs around.
    word: Range<usize>,
}

type Description = (Range<usize>, String, Option<&'static str>);

impl<'a> Slip<'a> {
    fn new(source: &'a str, span: Range<usize>) -> Self {
        let around = |ends: fn(char) -> bool| {
            let before = source.get(..span.start).unwrap_or_default();
            let after = source.get(span.start..).unwrap_or_default();
            let start = before.rfind(ends).map_or(0, |at| at.saturating_add(1));
            let end = span.start.saturating_add(after.find(ends).unwrap_or(after.len()));
            start..end
        };
        let line = around(|c| c == '\n');
        let shown = source.get(line.clone()).unwrap_or_default();
        let indent = shown.len().saturating_sub(shown.trim_start().len());
        let start = line.start.saturating_add(indent);
        let line = start..start.saturating_add(shown.trim().len());
        // These are ASCII, so the byte behind one is a character's first.
        let word = around(|c| c.is_ascii() && !(c.is_ascii_alphanumeric() || "+-._".contains(c)));
        Self { source, span, line, word }
    }

    fn get(&self, span: &Range<usize>) -> &'a str {
        self.source.get(span.clone()).unwrap_or_default()
    }

    /// The place, the words and the hint for a message of the toml crate.
    fn describe(&self, message: &str) -> Description {
        let found = quote(self.get(&self.span));
        let word = quote(self.get(&self.word));
        let at = |words: String, hint| (self.span.clone(), words, hint);
        let at_word = |words: String, hint| (self.word.clone(), words, hint);
        // Only the beginnings are compared: what follows lists what TOML would accept.
        let is = |starts: &[&str]| starts.iter().any(|s| message.starts_with(s));
        if is(&["duplicate key"]) {
            at(format!("{found} is given twice"), Some("remove one of the two"))
        } else if is(&["key with no value"]) {
            self.no_value()
        } else if is(&["string values must be quoted"]) {
            self.unquoted()
        } else if is(&["unexpected key or value"]) {
            self.rest_of_line()
        } else if is(&["invalid basic string", "invalid literal string", "invalid multi-line"]) {
            if self.span.is_empty() {
                at("the string is not closed".into(), Some("put a quote behind its last character"))
            } else {
                at("a string must not hold control characters".into(), None)
            }
        } else if is(&["unclosed array table", "unclosed table"]) {
            (self.line.clone(), "the header is not closed".into(), Some("headers look like [[object]] or [render]"))
        } else if is(&["unclosed array"]) {
            at("the bracket `[` is not closed".into(), Some("put a `]` behind the last value"))
        } else if is(&["unclosed inline table"]) {
            at("the brace `{` is not closed".into(), Some("put a `}` behind the last value"))
        } else if is(&["missing comma"]) {
            at(
                "a comma, or the closing bracket before this, is missing".into(),
                Some("a list looks like [1.0, 2.0, 3.0]"),
            )
        } else if is(&["extra comma"]) {
            at("a comma too many".into(), Some("a list looks like [1.0, 2.0, 3.0]"))
        } else if is(&["cannot recurse", "recursion limit"]) {
            at("tables and lists are nested too deeply".into(), Some("the format needs three levels"))
        } else if is(&["invalid mantissa", "invalid fraction", "invalid exponent"]) {
            at_word(format!("{word} is not a number"), Some("a digit stands before and behind the point: 0.5"))
        } else if is(&["redundant numeric sign", "unexpected leading zero", "`_` may only", "invalid integer"]) {
            at_word(format!("{word} is not a number"), Some("numbers look like 5, -0.5 or 1e-3"))
        } else if is(&["invalid float", "invalid date", "invalid time", "invalid datetime"]) {
            at_word(format!("{word} is not a number"), Some("numbers look like 5, -0.5 or 1e-3; text stands in quotes"))
        } else if is(&["invalid boolean"]) {
            at_word(format!("{word} is no value"), Some("write true or false in small letters"))
        } else if is(&["missing escaped value", "invalid value", "invalid unicode"]) {
            let before = self.source.get(..self.span.start).unwrap_or_default();
            let backslash = before.rfind('\\').unwrap_or(self.span.start);
            let hint = "a backslash is written twice: \\\\; paths are written with /";
            (
                backslash..self.span.end.max(self.span.start),
                "the backslash begins nothing that is known".into(),
                Some(hint),
            )
        } else if is(&["carriage return"]) {
            let hint = "save the file with the line ends of Unix (LF) or Windows (CRLF)";
            at("a carriage return that ends no line".into(), Some(hint))
        } else if is(&["unquoted keys cannot be empty"]) {
            at("a key is missing here".into(), Some("lines look like key = value, headers like [[object]]"))
        } else if is(&["invalid key-value pair"]) {
            let hint = if self.get(&self.line).starts_with('{') {
                "a scene is TOML, not JSON: its first line is luch = 1"
            } else {
                "lines look like key = value, headers like [[object]]"
            };
            (self.line.clone(), format!("{} is not key = value", quote(self.get(&self.line))), Some(hint))
        } else {
            at(format!("{message} {found}").trim_end_matches(" ``").to_owned(), None)
        }
    }

    /// A line without `=`.
    fn no_value(&self) -> Description {
        let line = self.get(&self.line);
        let hint = if line.starts_with("//") || line.starts_with("/*") {
            "comments begin with #"
        } else if line.contains('{') && !line.contains('=') || line.split('=').next().is_some_and(|k| k.contains('{')) {
            "a shape is written with `=`: sphere = { center = [0.0, 1.0, 0.0], radius = 1.0 }"
        } else if line.contains(':') {
            "a key and its value are joined by `=`, not by a colon"
        } else {
            "lines look like key = value, headers like [[object]]"
        };
        (self.line.clone(), format!("{} is not key = value", quote(line)), Some(hint))
    }

    /// A value that is neither number nor string nor anything else.
    fn unquoted(&self) -> Description {
        let found = self.get(&self.span);
        if found.is_empty() {
            return (self.span.clone(), "a value is missing behind `=`".into(), Some("lines look like key = value"));
        }
        let hint = if found.contains(';') {
            "lines end without a semicolon"
        } else if found.ends_with('%') {
            "a share is a number: 0.8 for 80 %"
        } else if found.split_whitespace().all(|w| w.parse::<f64>().is_ok()) {
            "the numbers of a list are separated by commas: [1.0, 2.0, 3.0]"
        } else {
            "text stands in quotes: \"phong\", \"#c83232\""
        };
        (self.span.clone(), format!("{} is no value", quote(found)), Some(hint))
    }

    /// Something behind a value.
    fn rest_of_line(&self) -> Description {
        let rest = self.span.start..self.line.end.max(self.span.start);
        let found = self.get(&rest);
        let hint = if found.starts_with(',') {
            "the decimal sign of a number is a point: 0.5"
        } else if found.starts_with(';') {
            "lines end without a semicolon"
        } else if found.starts_with(']') {
            "[[object]] has two brackets on each side, [render] one"
        } else {
            "one key = value to a line; comments begin with #"
        };
        (rest, format!("{} stands behind the value", quote(found)), Some(hint))
    }
}
