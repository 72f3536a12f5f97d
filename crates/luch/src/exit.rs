//! How the program ends: one failure type, its exit code, and what a panic becomes.

use luch_io::ErrorKind;
use std::fmt;
use std::panic::{self, AssertUnwindSafe};

/// Why the program ends with something else than success; the number is the exit code, a fixed contract.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub(crate) enum Code {
    /// The renderer gave up.
    Render = 1,
    /// The command line is wrong.
    Usage = 2,
    /// A file's content is not what it should be.
    Malformed = 3,
    /// A file is missing, or may not be read.
    Forbidden = 4,
    /// A stated limit would be exceeded.
    Limit = 5,
    /// The result cannot be written.
    Output = 6,
    /// A mistake in the program.
    Internal = 70,
    /// Stopped by SIGINT.
    Interrupted = 130,
    /// Stopped by SIGTERM.
    Terminated = 143,
}

/// What the user reads when the program gives up.
#[derive(Debug)]
pub(crate) struct Failure {
    pub(crate) code: Code,
    /// What is wrong, without "error:".
    pub(crate) text: String,
    /// What to do next.
    pub(crate) hint: Option<String>,
}

impl Failure {
    pub(crate) fn new(code: Code, text: impl Into<String>) -> Self {
        Self { code, text: text.into(), hint: None }
    }

    /// A mistake in the command line.
    pub(crate) fn usage(text: impl Into<String>) -> Self {
        Self::new(Code::Usage, text)
    }

    /// The same failure with advice.
    pub(crate) fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hint = Some(hint.into());
        self
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)?;
        if let Some(hint) = &self.hint {
            write!(f, "\nhint: {hint}")?;
        }
        Ok(())
    }
}

impl From<luch_io::Error> for Failure {
    fn from(error: luch_io::Error) -> Self {
        let code = match error.kind {
            ErrorKind::Malformed => Code::Malformed,
            ErrorKind::Forbidden => Code::Forbidden,
            ErrorKind::Limit => Code::Limit,
            ErrorKind::Output => Code::Output,
            ErrorKind::Cancelled => Code::Interrupted,
        };
        // The error's own text shows the place in the file and ends with its hint.
        Self::new(code, error.to_string())
    }
}

/// Runs the program and turns a panic into [`Code::Internal`]. The hook has told the user by then.
pub(crate) fn guarded(run: impl FnOnce() -> u8) -> u8 {
    panic::set_hook(Box::new(report_panic));
    panic::catch_unwind(AssertUnwindSafe(run)).unwrap_or(Code::Internal as u8)
}

/// What anybody sees of a panic, on any thread: what to do, and what we need to mend it.
fn report_panic(info: &panic::PanicHookInfo<'_>) {
    let message = info.payload_as_str().unwrap_or("no message");
    let place = info.location().map_or_else(String::new, |at| format!(" at {}:{}", at.file(), at.line()));
    let text = format!(
        "internal error: {message}{place}\n\
         This is a mistake in Luch, not in your file; no picture was written.\n\
         Please report it at {}/issues with the command line, the scene and this text.\n\
         luch {} on {} {}",
        env!("CARGO_PKG_REPOSITORY"),
        env!("CARGO_PKG_VERSION"),
        std::env::consts::OS,
        std::env::consts::ARCH,
    );
    crate::output::error(&text);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_an_internal_error_and_not_the_end_of_the_process() {
        assert_eq!(guarded(|| 3), 3);
        let hook = panic::take_hook();
        assert_eq!(guarded(|| panic!("as planned")), 70);
        panic::set_hook(hook);
    }

    #[test]
    fn a_failure_shows_its_hint() {
        assert_eq!(Failure::usage("no").hint("yes").to_string(), "no\nhint: yes");
        let error = luch_io::Error::new(ErrorKind::Limit, "a.obj", "too large").hint("--memory");
        let failure = Failure::from(error);
        assert_eq!((failure.code as u8, failure.to_string().as_str()), (5, "a.obj: too large\nhint: --memory"));
    }
}
