//! What the reader says when something is wrong, and where.

use super::super::corner::CornerFault;
use super::super::cursor::Cursor;
use super::super::number::float;
use super::super::place::{line_of, place_at, shown};
use super::Reader;
use crate::error::{Error, ErrorKind};

impl Reader<'_, '_> {
    #[cold]
    pub(super) fn corner_fault(&self, fault: CornerFault) -> Error {
        let token = self.cursor.peek_token();
        let word = shown(token);
        let (text, hint) = match fault {
            CornerFault::Form => {
                (format!("\"{word}\" is no corner of a face"), "a corner is 1, 1/2, 1//3 or 1/2/3, of whole numbers")
            }
            CornerFault::Zero => (format!("\"{word}\" has the index 0"), "indices count from 1, or back from -1"),
            CornerFault::Before { what, index, count } => (
                format!("{what} {index} does not exist: {count} come before this line"),
                "an index below zero counts back from the line it stands in",
            ),
            CornerFault::Huge => {
                (format!("\"{word}\" has an index that no model reaches"), "indices are below 4294967295")
            }
        };
        self.fault(ErrorKind::Malformed, self.cursor.offset(), token.len(), text).hint(hint)
    }

    /// The error of a word that should be a number, or of a line that ends too early.
    #[cold]
    pub(super) fn number_fault(&self, missing: &str, hint: &str) -> Error {
        if self.cursor.at_line_end() {
            let text = format!("the line ends too early: {missing}");
            return self.fault(ErrorKind::Malformed, self.cursor.offset(), 1, text);
        }
        let token = self.cursor.peek_token();
        let word = shown(token);
        let (text, hint) = match float(self.cursor.rest()) {
            Some((_, [b',', ..])) => (format!("\"{word}\" is not a number"), "the decimal separator is a point"),
            Some((_, rest)) if Cursor::new(rest).at_delimiter() => (format!("{word} is too large"), hint),
            _ => (format!("\"{word}\" is not a number"), hint),
        };
        self.fault(ErrorKind::Malformed, self.cursor.offset(), token.len(), text).hint(hint)
    }

    pub(super) fn fault(&self, kind: ErrorKind, offset: usize, length: usize, text: String) -> Error {
        Error::new(kind, self.file, text).at(place_at(self.cursor.text(), offset, length))
    }

    /// Warns about the statement being read: `what (file:line)`, or only the place.
    pub(super) fn warn(&mut self, kind: &'static str, what: String) {
        let (file, text, statement) = (self.file, self.cursor.text(), self.statement);
        self.report.warn(kind, move || {
            let line = line_of(text, statement);
            let place = format!("{}:{line}", file.display());
            if what.is_empty() { place } else { format!("{what} ({place})") }
        });
    }
}
