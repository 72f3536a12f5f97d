//! What went wrong, in the language of the window.

use crate::l10n::{Language, Texts};
use luch_io::budget::human_bytes;
use luch_io::{Error, ErrorKind};
use luch_scene::{EditError, NameError};

/// An error of a file. The readers speak English; in another language a line before their details says what they are
/// about. Hints about flags are for the command line.
pub(crate) fn file_error(mut error: Error, language: Language, texts: &Texts) -> String {
    error.hint = error.hint.filter(|hint| !hint.contains("--"));
    let details = error.to_string();
    if language == Language::En {
        return details;
    }
    let kind = match error.kind {
        ErrorKind::Malformed => texts.error_malformed(),
        ErrorKind::Forbidden => texts.error_forbidden(),
        ErrorKind::Limit => texts.error_limit(),
        ErrorKind::Output => texts.error_output(),
        ErrorKind::Cancelled => texts.error_cancelled(),
    };
    format!("{kind}\n{details}")
}

/// A number of bytes, with a unit.
pub(crate) fn bytes(bytes: u64, language: Language) -> String {
    let text = human_bytes(bytes);
    match language {
        Language::En => text,
        Language::Ru => [("KiB", "КиБ"), ("MiB", "МиБ"), ("GiB", "ГиБ"), ("bytes", "байт"), (".", ",")]
            .iter()
            .fold(text, |text, (english, russian)| text.replace(english, russian)),
    }
}

/// Why the scene refuses a change.
pub(crate) fn edit_error(error: &EditError, texts: &Texts) -> String {
    match error {
        EditError::NoSuch { .. } => texts.edit_no_such(),
        EditError::Name(NameError::Taken(name)) => texts.name_taken(name),
        EditError::Name(_) => texts.name_form(),
        EditError::LastCamera => texts.edit_last_camera(),
        EditError::OutOfBounds => texts.edit_out_of_bounds(),
        EditError::Number(error) => error.to_string(),
    }
}
