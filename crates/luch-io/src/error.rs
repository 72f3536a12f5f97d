//! One error for all files: which file, which place in it, what is wrong, and what to do next.

use std::fmt;
use std::path::PathBuf;

/// What kind of thing went wrong; decides the exit code of the program.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ErrorKind {
    /// The file's content is not what it should be. Exit code 3.
    Malformed,
    /// The file is missing, unreadable, or outside the folder that may be read. Exit code 4.
    Forbidden,
    /// A stated limit of size or memory would be exceeded. Exit code 5.
    Limit,
    /// A picture or scene cannot be written. Exit code 6.
    Output,
    /// The user asked to stop. Exit code 130.
    Cancelled,
}

/// A place in a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Place {
    /// The file as a whole.
    File,
    /// A place in a text file, with the line to show.
    Text {
        /// Number of the line, from 1.
        line: usize,
        /// Number of the character in the line, from 1.
        column: usize,
        /// The line itself, cut to a showable length.
        source: String,
        /// How many characters to underline, at least 1.
        length: usize,
    },
    /// A byte offset in a binary file.
    Byte(u64),
}

/// An error of a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Error {
    /// What kind it is.
    pub kind: ErrorKind,
    /// The file, as the user would name it.
    pub file: PathBuf,
    /// Where in the file.
    pub place: Place,
    /// What is wrong.
    pub text: String,
    /// What to do next.
    pub hint: Option<String>,
}

/// What the readers and writers of this crate answer with.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// An error about the file as a whole.
    #[must_use]
    pub fn new(kind: ErrorKind, file: impl Into<PathBuf>, text: impl Into<String>) -> Self {
        Self { kind, file: file.into(), place: Place::File, text: text.into(), hint: None }
    }

    /// The same error at a place.
    #[must_use]
    pub fn at(mut self, place: Place) -> Self {
        self.place = place;
        self
    }

    /// The same error with a hint.
    #[must_use]
    pub fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }

    /// The exit code of a program that stops with this error.
    #[must_use]
    pub const fn exit_code(&self) -> u8 {
        match self.kind {
            ErrorKind::Malformed => 3,
            ErrorKind::Forbidden => 4,
            ErrorKind::Limit => 5,
            ErrorKind::Output => 6,
            ErrorKind::Cancelled => 130,
        }
    }
}

impl fmt::Display for Error {
    /// `file:line:column: what is wrong`, then the line with the place underlined, then the hint.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let file = self.file.display();
        match &self.place {
            Place::File => write!(f, "{file}: {}", self.text)?,
            Place::Byte(offset) => write!(f, "{file}: byte {offset}: {}", self.text)?,
            Place::Text { line, column, source, length } => {
                write!(f, "{file}:{line}:{column}: {}", self.text)?;
                if !source.is_empty() {
                    let margin = line.to_string();
                    let pad = " ".repeat(margin.len());
                    let indent = " ".repeat(column.saturating_sub(1));
                    let marks = "^".repeat((*length).max(1));
                    write!(f, "\n {pad} |\n {margin} | {source}\n {pad} | {indent}{marks}")?;
                }
            }
        }
        if let Some(hint) = &self.hint {
            write!(f, "\nhint: {hint}")?;
        }
        Ok(())
    }
}

impl std::error::Error for Error {}
