//! Names of files inside files: what they may look like, before any file is looked at.

/// Why a name is refused.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum NameFault {
    /// Nothing is named.
    Empty,
    /// Longer than 4,096 bytes.
    TooLong,
    /// `http:`, `file:`, `data:`, or a drive letter.
    Scheme,
    /// Begins with a slash.
    Absolute,
    /// Has a backslash: a separator on one system and a letter on others.
    Backslash,
    /// Percent signs that decode to what is no UTF-8.
    NotUtf8,
    /// Has a NUL character, or a character that the system gives a meaning of its own.
    Character,
    /// Leads out of the folder.
    Outside,
}

impl NameFault {
    pub(super) fn text(self, name: &str) -> String {
        let shown: String = name.chars().take(120).collect();
        let why = match self {
            Self::Empty => return "an empty file name".to_owned(),
            Self::TooLong => "is longer than 4096 bytes",
            Self::Scheme => "has a scheme or a drive, only files of the scene's folder are opened",
            Self::Absolute => "is an absolute path",
            Self::Backslash => "has a backslash",
            Self::NotUtf8 => "does not decode to UTF-8",
            Self::Character => "has a character that no file name may have",
            Self::Outside => "leads out of the scene's folder",
        };
        format!("the path {shown:?} {why}")
    }

    pub(super) const fn hint(self) -> &'static str {
        match self {
            Self::Backslash => "write / between folders",
            Self::NotUtf8 | Self::Character => "a percent sign in a file's name is written %25",
            Self::Empty | Self::TooLong => "name a file by a path relative to the file that names it",
            Self::Scheme | Self::Absolute | Self::Outside => {
                "copy the file into the scene's folder and name it by a relative path"
            }
        }
    }
}

/// The folders and the file that `name` means, seen from the fence, when it is written in a file of `folder`.
///
/// `.` and `..` are resolved in words, so the result has neither. It is empty for the fence itself.
///
/// # Errors
/// [`NameFault`] says why the name is refused.
pub fn components_of(folder: &[String], name: &str) -> Result<Vec<String>, NameFault> {
    if name.trim().is_empty() {
        return Err(NameFault::Empty);
    }
    if name.len() > 4096 {
        return Err(NameFault::TooLong);
    }
    // Both before and after decoding: `%66ile:` is a scheme too.
    check_form(name)?;
    let decoded = percent_decoded(name)?;
    check_form(&decoded)?;
    let mut inside = folder.to_vec();
    for part in decoded.split('/') {
        match part {
            "" | "." => {}
            ".." => {
                inside.pop().ok_or(NameFault::Outside)?;
            }
            part => inside.push(part.to_owned()),
        }
    }
    Ok(inside)
}

fn check_form(name: &str) -> Result<(), NameFault> {
    if has_scheme(name) {
        return Err(NameFault::Scheme);
    }
    if name.starts_with('/') {
        return Err(NameFault::Absolute);
    }
    if name.contains('\\') {
        return Err(NameFault::Backslash);
    }
    // On Windows a colon opens a second stream of a file.
    if name.contains('\0') || (cfg!(windows) && name.contains(':')) {
        return Err(NameFault::Character);
    }
    Ok(())
}

/// `letter *( letter / digit / "+" / "-" / "." ) ":"` (RFC 3986), which a drive letter is too.
fn has_scheme(name: &str) -> bool {
    let Some((scheme, _)) = name.split_once(':') else { return false };
    scheme.starts_with(|c: char| c.is_ascii_alphabetic())
        && scheme.chars().all(|c| c.is_ascii_alphanumeric() || matches!(c, '+' | '-' | '.'))
}

/// Decodes `%41` once; a percent sign that two hexadecimal digits do not follow stays what it is.
fn percent_decoded(name: &str) -> Result<String, NameFault> {
    let mut bytes = Vec::with_capacity(name.len());
    let mut rest = name.as_bytes();
    while let [first, tail @ ..] = rest {
        rest = tail;
        let code = match (first, tail) {
            (b'%', [high, low, after @ ..]) => hex(*high).zip(hex(*low)).map(|(high, low)| {
                rest = after;
                (high << 4) | low
            }),
            _ => None,
        };
        bytes.push(code.unwrap_or(*first));
    }
    String::from_utf8(bytes).map_err(|_| NameFault::NotUtf8)
}

fn hex(digit: u8) -> Option<u8> {
    char::from(digit).to_digit(16).and_then(|d| u8::try_from(d).ok())
}

/// The name by which a scene in the same folder names a file called `file_name`: percent signs are encoded, and what
/// would look like a scheme gets `./` before it.
///
/// ```
/// use luch_io::resolve::encode_name;
/// assert_eq!(encode_name("100%.obj"), "100%25.obj");
/// ```
#[must_use]
pub fn encode_name(file_name: &str) -> String {
    let encoded = file_name.replace('%', "%25");
    if has_scheme(&encoded) { format!("./{encoded}") } else { encoded }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn parts(name: &str) -> Result<String, NameFault> {
        components_of(&["models".to_owned()], name).map(|p| p.join("/"))
    }

    #[test]
    fn names_are_relative_to_the_file_that_writes_them() {
        assert_eq!(parts("a.mtl").unwrap(), "models/a.mtl");
        assert_eq!(parts("./b//c.mtl").unwrap(), "models/b/c.mtl");
        assert_eq!(parts("../a b.mtl").unwrap(), "a b.mtl");
        assert_eq!(parts("a%20b%25.mtl").unwrap(), "models/a b%.mtl");
        assert_eq!(parts("100%.obj").unwrap(), "models/100%.obj");
        assert_eq!(parts("%").unwrap(), "models/%");
        assert_eq!(parts("é 你 🦀.obj").unwrap(), "models/é 你 🦀.obj");
    }

    #[test]
    fn what_leads_out_is_refused_in_every_spelling() {
        for name in ["../../a", "..%2f..%2Fa", "%2e%2e/%2E%2E/a", "b/../../../a", ".././../a"] {
            assert_eq!(parts(name), Err(NameFault::Outside), "{name}");
        }
        for name in ["/etc/passwd", "//server/share", "%2fetc/passwd"] {
            assert_eq!(parts(name), Err(NameFault::Absolute), "{name}");
        }
        for name in ["http://a/b", "file:a", "data:,x", "C:a", "c:/a", "C:\\a", "%66ile:///a", "a+b.c-d:e"] {
            assert_eq!(parts(name), Err(NameFault::Scheme), "{name}");
        }
        for name in ["\\\\server\\share", "..\\..\\a", "a%5cb", "\\a"] {
            assert_eq!(parts(name), Err(NameFault::Backslash), "{name}");
        }
    }

    #[test]
    fn names_that_are_no_names() {
        assert_eq!(parts(""), Err(NameFault::Empty));
        assert_eq!(parts("   "), Err(NameFault::Empty));
        assert_eq!(parts("a%00b"), Err(NameFault::Character));
        assert_eq!(parts("a\0b"), Err(NameFault::Character));
        assert_eq!(parts("a%ff"), Err(NameFault::NotUtf8));
        assert_eq!(parts(&"a/".repeat(3000)), Err(NameFault::TooLong));
    }

    #[test]
    fn decoding_happens_once() {
        assert_eq!(parts("%252e%252e/%252e%252e/a").unwrap(), "models/%2e%2e/%2e%2e/a");
        for name in ["100%.obj", "a%20b.obj", "%%", "plain", "a:b.obj"] {
            assert_eq!(components_of(&[], &encode_name(name)).unwrap(), [name]);
        }
    }
}
