//! An explanation before it is text, Markdown or LaTeX.

use crate::formula::Equation;

/// An explanation, part by part.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Document {
    /// Its parts, in order.
    pub blocks: Vec<Block>,
}

/// A part of an explanation.
#[derive(Debug, Clone, PartialEq)]
pub enum Block {
    /// A title; 1 is that of the whole.
    Heading {
        /// How deep it lies, from 1.
        level: u8,
        /// What it says.
        text: String,
    },
    /// A sentence.
    Paragraph(String),
    /// Names and what they stand for.
    Facts(Vec<(String, String)>),
    /// Formulas with their numbers.
    Equations(Vec<Equation>),
    /// What was found, and whether it takes light away.
    Verdict {
        /// What it says.
        text: String,
        /// Whether the light does not count.
        dark: bool,
    },
    /// Rows under a head.
    Table {
        /// The names of the columns.
        head: Vec<String>,
        /// The rows, each as long as the head.
        rows: Vec<Vec<String>>,
    },
    /// Letters and what they mean, as columns of a table: formulas stand in the first.
    Symbols {
        /// The names of the two columns.
        head: [String; 2],
        /// The letter, and what it means.
        rows: Vec<(crate::formula::Symbol, String)>,
    },
    /// The formulas of the model, with letters only.
    Model(Vec<(crate::formula::Symbol, crate::formula::Expr)>),
}

impl Document {
    pub(crate) fn heading(&mut self, level: u8, text: impl Into<String>) {
        self.blocks.push(Block::Heading { level, text: text.into() });
    }

    pub(crate) fn paragraph(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Paragraph(text.into()));
    }

    pub(crate) fn facts<'a>(&mut self, facts: impl IntoIterator<Item = (&'a str, String)>) {
        let facts = facts.into_iter().map(|(name, value)| (name.to_owned(), value));
        self.blocks.push(Block::Facts(facts.collect()));
    }

    pub(crate) fn equations(&mut self, equations: Vec<Equation>) {
        if !equations.is_empty() {
            self.blocks.push(Block::Equations(equations));
        }
    }

    pub(crate) fn verdict(&mut self, text: impl Into<String>, dark: bool) {
        self.blocks.push(Block::Verdict { text: text.into(), dark });
    }

    pub(crate) fn table(&mut self, head: &[&str], rows: Vec<Vec<String>>) {
        let head = head.iter().map(|&name| name.to_owned()).collect();
        self.blocks.push(Block::Table { head, rows });
    }
}
