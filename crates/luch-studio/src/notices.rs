//! Notices: what went wrong or well, shown over the picture until it is read.

use std::time::{Duration, Instant};

/// How bad it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Severity {
    /// Something was done; goes away by itself.
    Done,
    /// Something is odd but harmless.
    Warning,
    /// Something could not be done.
    Error,
}

/// One notice.
#[derive(Debug, Clone)]
pub(crate) struct Notice {
    pub(crate) id: u64,
    pub(crate) severity: Severity,
    /// What happened, in one line.
    pub(crate) title: String,
    /// Where and why, and what to do next.
    pub(crate) details: String,
    ends: Option<Instant>,
}

/// The notices that are shown, the oldest first.
#[derive(Debug, Default)]
pub(crate) struct Notices {
    list: Vec<Notice>,
    next: u64,
}

impl Notices {
    /// More would cover the picture: the oldest go.
    const MOST: usize = 4;
    /// How long it takes to read that something was done.
    const DONE: Duration = Duration::from_secs(5);

    /// Shows a notice. One with the same words is shown once.
    pub(crate) fn add(&mut self, severity: Severity, title: impl Into<String>, details: impl Into<String>) {
        let (title, details) = (title.into(), drawable(&details.into()));
        self.list.retain(|known| (&known.title, &known.details) != (&title, &details));
        let ends = (severity == Severity::Done).then(|| Instant::now() + Self::DONE);
        self.list.push(Notice { id: self.next, severity, title, details, ends });
        self.next += 1;
        let extra = self.list.len().saturating_sub(Self::MOST);
        self.list.drain(..extra);
    }

    pub(crate) fn error(&mut self, title: impl Into<String>, details: impl Into<String>) {
        self.add(Severity::Error, title, details);
    }

    pub(crate) fn dismiss(&mut self, id: u64) {
        self.list.retain(|notice| notice.id != id);
    }

    /// Drops what has been shown long enough; answers when to look again.
    pub(crate) fn expire(&mut self, now: Instant) -> Option<Duration> {
        self.list.retain(|notice| notice.ends.is_none_or(|ends| ends > now));
        self.list.iter().filter_map(|notice| notice.ends).min().map(|ends| ends - now)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &Notice> {
        self.list.iter()
    }
}

/// The text without the sign for what is no text, which the fonts do not have.
pub(crate) fn drawable(text: &str) -> String {
    text.replace(char::REPLACEMENT_CHARACTER, "?")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notices_are_few_and_those_of_success_go_by_themselves() {
        let mut notices = Notices::default();
        notices.add(Severity::Done, "saved", "a.toml");
        for i in 0..3 {
            notices.error("cannot read", format!("{i}"));
        }
        notices.error("cannot read", "1");
        assert_eq!(notices.iter().count(), 4, "the same words are shown once");
        assert!(notices.expire(Instant::now()).is_some());
        assert!(notices.expire(Instant::now() + Duration::from_secs(60)).is_none());
        assert_eq!(notices.iter().count(), 3);
        let id = notices.iter().next().unwrap().id;
        notices.dismiss(id);
        assert_eq!(notices.iter().count(), 2);
    }
}
