//! Markdown (CommonMark with tables and mathematics).

use crate::document::{Block, Document};

/// Writes a document as Markdown.
pub(crate) fn write(document: &Document) -> String {
    let mut text = String::new();
    for block in &document.blocks {
        if !text.is_empty() {
            text.push('\n');
        }
        match block {
            Block::Heading { level, text: title } => {
                let marks = "#".repeat(usize::from(*level));
                text += &format!("{marks} {}\n", escaped(title));
            }
            Block::Paragraph(sentence) => text += &format!("{}\n", escaped(sentence)),
            Block::Facts(facts) => {
                for (name, value) in facts {
                    text += &format!("- **{}**: {}\n", escaped(name), escaped(value));
                }
            }
            Block::Equations(equations) => {
                let lines: Vec<String> = equations.iter().map(|equation| equation.latex()).collect();
                text += &display(&lines);
            }
            Block::Verdict { text: verdict, dark } => {
                let mark = if *dark { "*" } else { "**" };
                text += &format!("{mark}{}{mark}\n", escaped(verdict));
            }
            Block::Table { head, rows } => {
                let rows = rows.iter().map(|row| row.iter().map(|cell| escaped(cell)).collect());
                table(&head.iter().map(|cell| escaped(cell)).collect::<Vec<_>>(), rows, &mut text);
            }
            Block::Symbols { head, rows } => {
                let rows = rows.iter().map(|(symbol, meaning)| vec![format!("${}$", symbol.latex()), escaped(meaning)]);
                table(&head.clone().map(|cell| escaped(&cell)), rows, &mut text);
            }
            Block::Model(formulas) => {
                let line = |(symbol, formula): &(crate::Symbol, crate::Expr)| {
                    format!("{} &= {}", symbol.latex(), formula.latex())
                };
                text += &display(&formulas.iter().map(line).collect::<Vec<_>>());
            }
        }
    }
    text
}

/// Formulas under each other.
fn display(lines: &[String]) -> String {
    format!("$$\n\\begin{{aligned}}\n{}\n\\end{{aligned}}\n$$\n", lines.join("\\\\\n"))
}

fn table(head: &[String], rows: impl Iterator<Item = Vec<String>>, text: &mut String) {
    *text += &format!("| {} |\n|{}\n", head.join(" | "), "---|".repeat(head.len()));
    for row in rows {
        *text += &format!("| {} |\n", row.join(" | "));
    }
}

/// Text without the characters that Markdown or HTML would take for its own.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' | '`' | '*' | '_' | '[' | ']' | '<' | '>' | '#' | '|' | '$' | '~' | '&' => {
                safe.push('\\');
                safe.push(c);
            }
            c if c.is_control() => safe.push(' '),
            c => safe.push(c),
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_cannot_break_out_of_its_place() {
        assert_eq!(escaped("a|b *c* <img> $x$\n"), "a\\|b \\*c\\* \\<img\\> \\$x\\$ ");
        let mut document = Document::default();
        document.table(&["name"], vec![vec!["left | right".to_owned()]]);
        assert_eq!(write(&document), "| name |\n|---|\n| left \\| right |\n");
    }
}
