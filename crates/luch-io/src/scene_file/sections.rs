//! Cuts the text into sections: the keys before the first header, then one section for each `[[object]]` and the like.
//!
//! Each section is read and forgotten before the next. A tree of the whole file, as the toml crate makes it, takes
//! over 2 KiB for an object, so that a million objects would not fit in 1 GiB; a section at a time they do. The cuts
//! are made by TOML's own lexer, so a bracket in a string or comment is no header.

use std::ops::Range;
use toml_parser::lexer::{Lexer, Token, TokenKind};
use toml_parser::{Source, Span};

/// A piece of the file that is a TOML document of its own.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Section {
    /// Where it lies in the text.
    pub(super) span: Range<usize>,
    /// Its first header; empty before the first header of the file.
    pub(super) header: Range<usize>,
}

/// Answers with one section after the other.
pub(super) struct Sections<'a> {
    source: Source<'a>,
    tokens: Lexer<'a>,
    /// Start of the section that is being read, with its header and the header's first word.
    open: Option<(usize, Header)>,
}

/// A header: where it is, its first word, and whether more words follow (`[object.pattern]`).
#[derive(Debug, Clone, Default, PartialEq, Eq)]
struct Header {
    span: Range<usize>,
    word: String,
    dotted: bool,
}

impl<'a> Sections<'a> {
    pub(super) fn new(text: &'a str) -> Self {
        let source = Source::new(text);
        Self { source, tokens: source.lex(), open: Some((0, Header::default())) }
    }

    /// Reads on to the next header that opens a section; `None` at the end of the text.
    fn next_header(&mut self, current: &str) -> Option<Header> {
        let mut depth = 0_usize;
        let mut line_start = true;
        while let Some(token) = self.tokens.next() {
            match token.kind() {
                TokenKind::Newline => line_start = true,
                TokenKind::Whitespace => {}
                TokenKind::LeftSquareBracket if line_start && depth == 0 => {
                    let header = self.header(token);
                    // `[object.pattern]` goes on with the object above it.
                    if !(header.dotted && header.word == current) {
                        return Some(header);
                    }
                    line_start = true;
                }
                kind => {
                    line_start = false;
                    match kind {
                        TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket => depth = depth.saturating_add(1),
                        TokenKind::RightSquareBracket | TokenKind::RightCurlyBracket => depth = depth.saturating_sub(1),
                        _ => {}
                    }
                }
            }
        }
        None
    }

    /// Reads the rest of a header's line.
    fn header(&mut self, bracket: Token) -> Header {
        let mut header = Header { span: span_of(bracket.span()), ..Header::default() };
        let mut words = 0_usize;
        for token in self.tokens.by_ref() {
            match token.kind() {
                TokenKind::Newline | TokenKind::Eof => break,
                TokenKind::LeftSquareBracket | TokenKind::Whitespace | TokenKind::Comment => continue,
                TokenKind::Dot if words == 1 => header.dotted = true,
                TokenKind::RightSquareBracket => {}
                _ => {
                    if words == 0
                        && let Some(raw) = self.source.get(token)
                    {
                        // A word that does not decode is found again, and told, when the section is read.
                        raw.decode_key(&mut header.word, &mut ());
                    }
                    words = words.saturating_add(1);
                }
            }
            header.span.end = token.span().end();
        }
        header
    }
}

fn span_of(span: Span) -> Range<usize> {
    span.start()..span.end()
}

impl Iterator for Sections<'_> {
    type Item = Section;

    fn next(&mut self) -> Option<Section> {
        let (start, header) = self.open.take()?;
        let next = self.next_header(&header.word);
        let end = next.as_ref().map_or(self.source.input().len(), |h| h.span.start);
        self.open = next.map(|h| (h.span.start, h));
        Some(Section { span: start..end, header: header.span })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cut(text: &str) -> Vec<(&str, &str)> {
        Sections::new(text).map(|s| (&text[s.header], &text[s.span])).collect()
    }

    #[test]
    fn every_header_opens_a_section_and_nothing_is_lost() {
        let text = "a = 1\n[[object]] # one\nb = [\n [1],\n]\n  [ \"render\" ]\nc = 2\n[[object]]";
        let sections = cut(text);
        assert_eq!(
            sections.iter().map(|s| s.0).collect::<Vec<_>>(),
            ["", "[[object]]", "[ \"render\" ]", "[[object]]"]
        );
        assert_eq!(sections.iter().map(|s| s.1).collect::<String>(), text);
        assert_eq!(sections[1].1, "[[object]] # one\nb = [\n [1],\n]\n  ");
    }

    #[test]
    fn brackets_in_strings_and_comments_are_no_headers() {
        assert_eq!(cut("a = \"\"\"\n[[object]]\n\"\"\"\n# [[object]]\nb = '''\n[x]\n'''\n").len(), 1);
        assert_eq!(cut("a = \"[x]\"\nb = { c = [\n[1] ] }\n").len(), 1);
    }

    #[test]
    fn tables_of_an_object_stay_with_it() {
        let sections =
            cut("[[object]]\n[object.pattern]\n[object.pattern.checker]\n[[object]]\n[render.x]\n[render.y]");
        assert_eq!(sections.iter().map(|s| s.0).collect::<Vec<_>>(), ["", "[[object]]", "[[object]]", "[render.x]"]);
    }
}
