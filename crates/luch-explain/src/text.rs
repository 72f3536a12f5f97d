//! Plain text, with what a terminal may colour marked.

use crate::document::{Block, Document};

/// What a piece of text is, for whoever gives it a colour.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// A title.
    Heading,
    /// The name of a number.
    Label,
    /// A formula.
    Formula,
    /// A light that counts.
    Bright,
    /// A light that does not.
    Dark,
}

/// No colours.
#[must_use]
pub fn plain(_role: Role, text: &str) -> String {
    text.to_owned()
}

/// Writes a document as text.
pub(crate) fn write(document: &Document, paint: &dyn Fn(Role, &str) -> String) -> String {
    let mut text = String::new();
    for (number, block) in document.blocks.iter().enumerate() {
        match block {
            Block::Heading { level, text: title } => {
                if number > 0 {
                    text.push('\n');
                }
                let underline = match level {
                    1 => Some('='),
                    2 => Some('-'),
                    _ => None,
                };
                text += &paint(Role::Heading, title);
                text.push('\n');
                if let Some(line) = underline {
                    text.extend(std::iter::repeat_n(line, title.chars().count()));
                    text.push('\n');
                }
            }
            Block::Paragraph(sentence) => {
                text += &format!("  {sentence}\n");
            }
            Block::Facts(facts) => {
                let width = facts.iter().map(|(name, _)| name.chars().count()).max().unwrap_or(0);
                for (name, value) in facts {
                    let name = paint(Role::Label, &format!("{name:<width$}"));
                    text += &format!("  {name}  {value}\n");
                }
            }
            Block::Equations(equations) => {
                for equation in equations {
                    text += &format!("  {}\n", paint(Role::Formula, &equation.text()));
                }
            }
            Block::Verdict { text: verdict, dark } => {
                let role = if *dark { Role::Dark } else { Role::Bright };
                text += &format!("  {}\n", paint(role, verdict));
            }
            Block::Table { head, rows } => table(head, rows, paint, &mut text),
            Block::Symbols { head, rows } => {
                let rows: Vec<_> = rows.iter().map(|(symbol, meaning)| vec![symbol.text(), meaning.clone()]).collect();
                table(head, &rows, paint, &mut text);
            }
            Block::Model(formulas) => {
                for (symbol, formula) in formulas {
                    let line = format!("{} = {}", symbol.text(), formula.text());
                    text += &format!("  {}\n", paint(Role::Formula, &line));
                }
            }
        }
    }
    text
}

/// Columns as wide as what is in them.
fn table(head: &[String], rows: &[Vec<String>], paint: &dyn Fn(Role, &str) -> String, text: &mut String) {
    let width = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column)).chain(head.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..head.len()).map(width).collect();
    let line = |cells: &[String]| {
        let cells = cells.iter().zip(&widths).map(|(cell, &width)| format!("{cell:<width$}"));
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    };
    *text += &format!("  {}\n", paint(Role::Label, &line(head)));
    for row in rows {
        *text += &format!("  {}\n", line(row));
    }
}
