//! From a byte offset to a line and column: worked out only when there is something to say.

use crate::error::Place;

/// How many characters of a line are shown.
const SHOWN: usize = 160;

/// The place of byte `offset` of a text, with `length` bytes underlined.
///
/// Lines end with LF, CR LF or CR. Cost: one pass over the text before it.
pub(super) fn place_at(text: &[u8], offset: usize, length: usize) -> Place {
    let offset = offset.min(text.len());
    let (before, after) = text.split_at_checked(offset).unwrap_or((text, &[]));
    let start = before.iter().rposition(|b| is_break(*b)).map_or(0, |i| i.saturating_add(1));
    let head = before.get(start..).unwrap_or(&[]);
    let end = after.iter().position(|b| is_break(*b)).unwrap_or(after.len());
    // Only a little more than is shown: a line may have megabytes.
    let tail = after.get(..end.min(SHOWN.saturating_mul(4))).unwrap_or(&[]);
    let column = String::from_utf8_lossy(head).chars().count().saturating_add(1);
    let marked = tail.get(..length).unwrap_or(tail);
    let length = String::from_utf8_lossy(marked).chars().count().max(1);
    let source = if column > SHOWN {
        // The underline would be far to the right of any terminal.
        String::new()
    } else {
        let line = [head, tail].concat();
        String::from_utf8_lossy(&line).chars().take(SHOWN).map(|c| if c.is_control() { ' ' } else { c }).collect()
    };
    let room = SHOWN.saturating_sub(column).saturating_add(1).max(1);
    Place::Text { line: line_of(text, offset), column, source, length: length.min(room) }
}

/// Number of the line that byte `offset` lies in, from 1.
pub(super) fn line_of(text: &[u8], offset: usize) -> usize {
    let before = text.get(..offset).unwrap_or(text);
    let feeds = before.iter().filter(|b| **b == b'\n').count();
    let lone_returns = before.windows(2).filter(|pair| matches!(pair, [b'\r', b] if *b != b'\n')).count();
    // A return at the very end of `before` is one line more unless its line feed follows.
    let last = before.last() == Some(&b'\r') && text.get(offset) != Some(&b'\n');
    feeds.saturating_add(lone_returns).saturating_add(usize::from(last)).saturating_add(1)
}

/// Some bytes of the file as they may be shown in a message: cut, without control characters.
pub(super) fn shown(bytes: &[u8]) -> String {
    const LONGEST: usize = 60;
    let cut = bytes.get(..LONGEST.saturating_mul(4)).unwrap_or(bytes);
    let text = String::from_utf8_lossy(cut);
    let mut shown: String =
        text.chars().take(LONGEST).map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c }).collect();
    if cut.len() < bytes.len() || text.chars().count() > LONGEST {
        shown.push_str("...");
    }
    shown
}

const fn is_break(byte: u8) -> bool {
    matches!(byte, b'\n' | b'\r')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_in_three_ways() {
        let text = b"a\nb\r\nc\rdd\n\ne";
        let lines: Vec<usize> = (0..=text.len()).map(|at| line_of(text, at)).collect();
        assert_eq!(lines, [1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5, 6, 6]);
    }

    #[test]
    fn columns_count_characters() {
        let text = "v 1\nusemtl é x\tz".as_bytes();
        let Place::Text { line, column, source, length } = place_at(text, text.len() - 3, 2) else { panic!() };
        assert_eq!((line, column, source.as_str(), length), (2, 10, "usemtl é x z", 2));
    }

    #[test]
    fn a_place_far_to_the_right_shows_no_line() {
        let text = vec![b'x'; 1000];
        let Place::Text { column, source, .. } = place_at(&text, 500, 1) else { panic!() };
        assert_eq!((column, source.as_str()), (501, ""));
        let Place::Text { source, length, .. } = place_at(&text, 150, 900) else { panic!() };
        assert_eq!((source.len(), length), (160, 10));
        assert_eq!(shown(&text).len(), 63);
    }
}
