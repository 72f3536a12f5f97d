//! The two streams: results to stdout, everything else to stderr. No other module writes to either.

use crate::exit::{Code, Failure};
use std::fmt::Write as _;
use std::io::{self, IsTerminal, Write as _};

/// Writes a result to stdout and sees it off.
///
/// # Errors
/// [`Code::Output`] if the reader has gone away or the disk is full.
pub(crate) fn result(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())
        .and_then(|()| out.flush())
        .map_err(|e| Failure::new(Code::Output, format!("standard output cannot be written: {e}")))
}

/// Lets `write` write a result to stdout piece by piece, and tells it whether colours are welcome.
///
/// # Errors
/// As [`result`].
pub(crate) fn streamed(write: impl FnOnce(&mut dyn io::Write, bool) -> io::Result<()>) -> Result<(), Failure> {
    let out = io::stdout().lock();
    let colored = is_colored(&out);
    let mut out = io::BufWriter::new(out);
    write(&mut out, colored)
        .and_then(|()| out.flush())
        .map_err(|e| Failure::new(Code::Output, format!("standard output cannot be written: {e}")))
}

/// Writes a value to stdout as JSON that people can read too.
///
/// # Errors
/// As [`result`].
pub(crate) fn json(value: &impl serde::Serialize) -> Result<(), Failure> {
    result(&to_json(value)?)
}

/// The value as indented JSON with a line break at the end.
///
/// # Errors
/// [`Code::Internal`]: plain data has no reason to fail.
pub(crate) fn to_json(value: &impl serde::Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(value)
        .map(|text| text + "\n")
        .map_err(|e| Failure::new(Code::Internal, format!("the result cannot be written as JSON: {e}")))
}

/// Tells the user why the program gives up.
pub(crate) fn error(text: &str) {
    message("error", "1;31", text);
}

/// Tells the user of something that is odd but does no harm.
pub(crate) fn warning(text: &str) {
    message("warning", "1;33", text);
}

/// Tells the user a fact on stderr.
pub(crate) fn note(text: &str) {
    let _ = writeln!(io::stderr().lock(), "{}", printable(text));
}

fn message(label: &str, color: &str, text: &str) {
    let mut err = io::stderr().lock();
    let label = if is_colored(&err) { format!("\x1b[{color}m{label}:\x1b[0m") } else { format!("{label}:") };
    // Nobody is left to tell if stderr is gone too.
    let _ = writeln!(err, "{label} {}", printable(text));
}

/// Colour is for people at a terminal who did not ask for none (no-color.org).
fn is_colored(stream: &impl IsTerminal) -> bool {
    stream.is_terminal() && std::env::var_os("NO_COLOR").is_none_or(|v| v.is_empty())
}

/// The text without control characters: a file's name or content must not steer the terminal.
fn printable(text: &str) -> String {
    let mut safe = String::with_capacity(text.len());
    for c in text.chars() {
        if c.is_control() && c != '\n' && c != '\t' {
            // Writing to a string cannot fail.
            let _ = write!(safe, "{}", c.escape_default());
        } else {
            safe.push(c);
        }
    }
    safe
}

#[cfg(test)]
mod tests {
    use super::printable;

    #[test]
    fn escape_sequences_of_a_file_name_do_not_reach_the_terminal() {
        assert_eq!(printable("a\x1b[2Jb\nc\tя\u{9b}"), "a\\u{1b}[2Jb\nc\tя\\u{9b}");
    }
}
