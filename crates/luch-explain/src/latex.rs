//! A LaTeX document that can be compiled as it is.

use crate::document::{Block, Document};
use crate::language::Language;

/// Writes a document as LaTeX.
pub(crate) fn write(document: &Document, language: Language) -> String {
    let mut body = String::new();
    for block in &document.blocks {
        self::block(block, &mut body);
    }
    // Latin and Cyrillic letters need fonts of their own; only who has Cyrillic ones in the text must have them.
    let cyrillic = body.chars().any(is_cyrillic);
    let encoding = if cyrillic { "T2A" } else { "T1" };
    let babel = match language {
        Language::English => "english",
        Language::Russian => "russian",
    };
    format!(
        "% Made by Luch (luch explain --latex); compile with pdflatex.\n\
         \\documentclass[a4paper,10pt]{{article}}\n\
         \\usepackage[utf8]{{inputenc}}\n\
         \\usepackage[{encoding}]{{fontenc}}\n\
         \\usepackage[{babel}]{{babel}}\n\
         \\usepackage{{amsmath}}\n\
         \\usepackage[margin=20mm]{{geometry}}\n\
         \\setlength{{\\parindent}}{{0pt}}\n\
         \\allowdisplaybreaks\n\
         \\begin{{document}}\n{body}\\end{{document}}\n"
    )
}

fn block(block: &Block, body: &mut String) {
    match block {
        Block::Heading { level, text } => {
            let command = match level {
                1 => "section*",
                2 => "subsection*",
                _ => "paragraph*",
            };
            *body += &format!("\\{command}{{{}}}\n", escaped(text));
            if *level > 2 {
                // A paragraph's title stands in its first line; a display needs a line before it.
                *body += "\\mbox{}\n\n";
            }
        }
        Block::Paragraph(text) => *body += &format!("{}\n\n", escaped(text)),
        Block::Facts(facts) => {
            *body += "\\begin{itemize}\n";
            for (name, value) in facts {
                *body += &format!("\\item \\textbf{{{}}}: {}\n", escaped(name), escaped(value));
            }
            *body += "\\end{itemize}\n";
        }
        Block::Equations(equations) => {
            display(&equations.iter().map(|equation| equation.latex()).collect::<Vec<_>>(), body);
        }
        Block::Verdict { text, dark } => {
            let command = if *dark { "emph" } else { "textbf" };
            *body += &format!("\\{command}{{{}}}\n\n", escaped(text));
        }
        Block::Table { head, rows } => {
            let rows = rows.iter().map(|row| row.iter().map(|cell| escaped(cell)).collect());
            table(&head.iter().map(|cell| escaped(cell)).collect::<Vec<_>>(), rows, body);
        }
        Block::Symbols { head, rows } => {
            let rows = rows.iter().map(|(symbol, meaning)| vec![format!("${}$", symbol.latex()), escaped(meaning)]);
            table(&head.clone().map(|cell| escaped(&cell)), rows, body);
        }
        Block::Model(formulas) => {
            let line =
                |(symbol, formula): &(crate::Symbol, crate::Expr)| format!("{} &= {}", symbol.latex(), formula.latex());
            display(&formulas.iter().map(line).collect::<Vec<_>>(), body);
        }
    }
}

/// Formulas under each other, in small letters: colours are long.
fn display(lines: &[String], body: &mut String) {
    *body += &format!("{{\\small\n\\begin{{align*}}\n{}\n\\end{{align*}}}}\n\n", lines.join("\\\\\n"));
}

/// A row is a line of its own that may break between pages, which a tabular of hundreds of rows could not: tables are cut.
const ROWS_OF_A_TABLE: usize = 40;

/// Letters of a table that fit side by side on a line.
const LETTERS_OF_A_LINE: usize = 100;

fn table(head: &[String], rows: impl Iterator<Item = Vec<String>>, body: &mut String) {
    let rows: Vec<Vec<String>> = rows.collect();
    let columns = columns_of(head, &rows);
    for part in rows.chunks(ROWS_OF_A_TABLE) {
        *body += &format!("\\begin{{center}}\\small\n\\begin{{tabular}}{{{columns}}}\n");
        *body += &format!("{} \\\\\n\\hline\n", head.join(" & "));
        for row in part {
            *body += &format!("{} \\\\\n", row.join(" & "));
        }
        *body += "\\end{tabular}\n\\end{center}\n";
    }
}

/// As wide as what is in them; where that is wider than the page, shares of it in which lines are broken.
fn columns_of(head: &[String], rows: &[Vec<String>]) -> String {
    let width = |column: usize| {
        let cells = rows.iter().filter_map(|row| row.get(column)).chain(head.get(column));
        cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let widths: Vec<usize> = (0..head.len()).map(width).collect();
    if widths.iter().sum::<usize>() <= LETTERS_OF_A_LINE {
        return "l".repeat(head.len());
    }
    // No column takes all of the line, or none.
    let widths: Vec<usize> = widths.into_iter().map(|width| width.clamp(5, 60)).collect();
    let all: usize = widths.iter().sum();
    let share = |width: &usize| format!("p{{0.{:03}\\linewidth}}", width * 900 / all);
    widths.iter().map(share).collect()
}

const fn is_cyrillic(c: char) -> bool {
    matches!(c, '\u{400}'..='\u{45f}' | '\u{490}' | '\u{491}')
}

/// Text without the characters that LaTeX would take for its own, and with a stand-in for those it has no letter for.
fn escaped(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '\\' => safe.push_str("\\textbackslash{}"),
            '~' => safe.push_str("\\textasciitilde{}"),
            '^' => safe.push_str("\\textasciicircum{}"),
            '<' => safe.push_str("\\textless{}"),
            '>' => safe.push_str("\\textgreater{}"),
            '|' => safe.push_str("\\textbar{}"),
            '"' => safe.push_str("\\textquotedbl{}"),
            '&' | '%' | '$' | '#' | '_' | '{' | '}' => {
                safe.push('\\');
                safe.push(c);
            }
            '“' => safe.push_str("``"),
            '”' => safe.push_str("''"),
            '«' => safe.push_str("\\guillemotleft{}"),
            '»' => safe.push_str("\\guillemotright{}"),
            '—' => safe.push_str("---"),
            '×' => safe.push_str("$\\times$"),
            '·' => safe.push_str("$\\cdot$"),
            '→' => safe.push_str("$\\to$"),
            '∞' => safe.push_str("$\\infty$"),
            'θ' => safe.push_str("$\\theta$"),
            'α' => safe.push_str("$\\alpha$"),
            c if c.is_control() => safe.push(' '),
            // Latin letters with accents are made of what every font has.
            c if c.is_ascii() || is_cyrillic(c) || ('\u{c0}'..='\u{17f}').contains(&c) => safe.push(c),
            c => safe.push_str(&format!("[U+{:04X}]", u32::from(c))),
        }
    }
    // Letters of formulas in the middle of a text.
    for letter in ["k_d", "k_a", "k_s", "I_a", "I_l", "C_l", "C_m"] {
        safe = safe.replace(&letter.replace('_', "\\_"), &format!("${letter}$"));
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_cannot_break_out_of_its_place() {
        assert_eq!(escaped("50% & \\input{x}_1^2"), "50\\% \\& \\textbackslash{}input\\{x\\}\\_1\\textasciicircum{}2");
        assert_eq!(escaped("шар é 😀"), "шар é [U+1F600]");
    }

    #[test]
    fn cyrillic_fonts_are_asked_for_only_where_there_is_cyrillic() {
        let document = |text: &str| Document { blocks: vec![Block::Paragraph(text.to_owned())] };
        assert!(write(&document("ball"), Language::English).contains("[T1]{fontenc}"));
        assert!(write(&document("шар"), Language::English).contains("[T2A]{fontenc}"));
        assert!(write(&document("шар"), Language::Russian).contains("[russian]{babel}"));
    }
}
