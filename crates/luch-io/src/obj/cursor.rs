//! A place in the text that moves forward: over blanks, tokens, and the rest of lines.

/// What is not yet read of a text.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cursor<'a> {
    text: &'a [u8],
    rest: &'a [u8],
}

impl<'a> Cursor<'a> {
    pub(super) const fn new(text: &'a [u8]) -> Self {
        Self { text, rest: text }
    }

    pub(super) const fn text(&self) -> &'a [u8] {
        self.text
    }

    pub(super) const fn rest(&self) -> &'a [u8] {
        self.rest
    }

    /// Bytes already read.
    pub(super) const fn offset(&self) -> usize {
        self.text.len().wrapping_sub(self.rest.len())
    }

    /// Continues at a later place, given as what is left of the text.
    pub(super) const fn jump(&mut self, rest: &'a [u8]) {
        self.rest = rest;
    }

    /// Skips blanks, and line breaks behind a backslash.
    #[inline]
    pub(super) fn skip_blanks(&mut self) {
        loop {
            match self.rest {
                [b' ' | b'\t' | 0x0b | 0x0c, tail @ ..] => self.rest = tail,
                [b'\\', tail @ ..] => match after_continuation(tail) {
                    Some(next_line) => self.rest = next_line,
                    None => return,
                },
                _ => return,
            }
        }
    }

    /// Skips blanks and line breaks: to the first thing of the next line that has one.
    pub(super) fn skip_to_statement(&mut self) {
        loop {
            self.skip_blanks();
            match self.rest {
                [b'\n' | b'\r', tail @ ..] => self.rest = tail,
                _ => return,
            }
        }
    }

    /// Whether nothing more but a comment is in the line.
    #[inline]
    pub(super) const fn at_line_end(&self) -> bool {
        matches!(self.rest, [] | [b'\n' | b'\r' | b'#', ..])
    }

    /// Whether a number may end here: before a blank, a line's end, a comment or a continuation. `1.#INF` and `1.#QNAN`,
    /// as old C libraries write them, are no numbers with a comment behind.
    #[inline]
    pub(super) const fn at_delimiter(&self) -> bool {
        if matches!(self.rest, [b'#', b'I' | b'Q' | b'S', b'N', ..]) {
            return false;
        }
        self.at_line_end() || matches!(self.rest, [b' ' | b'\t' | 0x0b | 0x0c | b'\\', ..])
    }

    /// The word that begins here, up to a blank or the line's end.
    pub(super) fn peek_token(&self) -> &'a [u8] {
        let end = self.rest.iter().position(|b| matches!(b, b' ' | b'\t' | 0x0b | 0x0c | b'\n' | b'\r'));
        end.and_then(|end| self.rest.get(..end)).unwrap_or(self.rest)
    }

    /// Takes the word that begins here.
    pub(super) fn token(&mut self) -> &'a [u8] {
        let token = self.peek_token();
        self.rest = self.rest.get(token.len()..).unwrap_or(&[]);
        token
    }

    /// Skips the rest of the statement: to the line break, which stays; a comment ends with its line, anything else
    /// goes on where a backslash stands before the break.
    pub(super) fn skip_line(&mut self) {
        let comment = matches!(self.rest, [b'#', ..]);
        loop {
            let end = self.rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(self.rest.len());
            let (line, tail) = self.rest.split_at_checked(end).unwrap_or((self.rest, &[]));
            self.rest = tail;
            let goes_on = !comment && matches!(line.trim_ascii_end(), [.., b'\\']);
            match (goes_on, tail) {
                (true, [b'\r', b'\n', next @ ..] | [_, next @ ..]) => self.rest = next,
                _ => return,
            }
        }
    }

    /// Takes the rest of the line as a name: trimmed, not beyond the line. It may hold blanks and `#`.
    pub(super) fn name(&mut self) -> &'a [u8] {
        self.skip_blanks();
        let end = self.rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(self.rest.len());
        let (line, tail) = self.rest.split_at_checked(end).unwrap_or((self.rest, &[]));
        self.rest = tail;
        line.trim_ascii_end()
    }
}

/// What follows a backslash that ends its line; blanks behind it do not matter.
fn after_continuation(mut text: &[u8]) -> Option<&[u8]> {
    loop {
        match text {
            [b' ' | b'\t', tail @ ..] => text = tail,
            [b'\r', b'\n', tail @ ..] | [b'\n' | b'\r', tail @ ..] => return Some(tail),
            _ => return None,
        }
    }
}

/// The part of a name before a comment, if ` #` begins one.
pub(super) fn before_comment(name: &[u8]) -> &[u8] {
    let comment = name.windows(2).position(|pair| matches!(pair, [b' ' | b'\t', b'#']));
    comment.and_then(|at| name.get(..at)).unwrap_or(name).trim_ascii_end()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_backslash_joins_lines() {
        let mut cursor = Cursor::new(b"f 1 \\\r\n 2 \\ \n3 # c \\\nnext");
        let mut words = Vec::new();
        while !cursor.at_line_end() {
            words.push(cursor.token());
            cursor.skip_blanks();
        }
        assert_eq!(words, [&b"f"[..], b"1", b"2", b"3"]);
        cursor.skip_line();
        cursor.skip_to_statement();
        assert_eq!(cursor.rest(), b"next", "a comment ends with its line");
    }

    #[test]
    fn a_skipped_line_ends_where_its_last_part_ends() {
        let mut cursor = Cursor::new(b"curv 1 \\\n2 \\\r\n3\nv");
        cursor.skip_line();
        assert_eq!(cursor.rest(), b"\nv");
        let mut cursor = Cursor::new(b"x \\");
        cursor.skip_line();
        assert_eq!(cursor.rest(), b"");
    }

    #[test]
    fn names_run_to_the_end_of_the_line() {
        let mut cursor = Cursor::new(b"usemtl  Material #25  \r\n");
        cursor.token();
        assert_eq!(cursor.name(), b"Material #25");
        assert_eq!(before_comment(b"Material #25"), b"Material");
        assert_eq!(before_comment(b"a#b"), b"a#b");
    }
}
