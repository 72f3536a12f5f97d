//! Warnings: what a reader left out or changed, counted and capped for each kind.

use std::collections::BTreeMap;

/// Collects the warnings of one load. The caller shows them; the library prints nothing.
#[derive(Debug, Default, Clone)]
pub struct Report {
    kinds: BTreeMap<&'static str, Kind>,
}

#[derive(Debug, Default, Clone)]
struct Kind {
    count: u64,
    shown: Vec<String>,
}

impl Report {
    /// How many warnings of a kind are kept with their text.
    pub const SHOWN: usize = 20;

    /// Notes a warning. `kind` names the class (`lines and points are skipped`), `text` the case with its place; the
    /// text is made only while few of the kind are known.
    pub fn warn(&mut self, kind: &'static str, text: impl FnOnce() -> String) {
        let entry = self.kinds.entry(kind).or_default();
        entry.count = entry.count.saturating_add(1);
        if entry.shown.len() < Self::SHOWN {
            entry.shown.push(text());
        }
    }

    /// Whether there is nothing to say.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.kinds.is_empty()
    }

    /// How many warnings of a kind there were.
    #[must_use]
    pub fn count(&self, kind: &str) -> u64 {
        self.kinds.get(kind).map_or(0, |k| k.count)
    }

    /// The warnings as lines to show: those with text, and `... and 4,113 more` where a kind was capped.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        let mut lines = Vec::new();
        for (kind, Kind { count, shown }) in &self.kinds {
            lines.extend(shown.iter().map(|text| format!("{kind}: {text}")));
            let more = count.saturating_sub(u64::try_from(shown.len()).unwrap_or(u64::MAX));
            if more > 0 {
                lines.push(format!("{kind}: ... and {more} more"));
            }
        }
        lines
    }
}
