//! How long a field says what was wrong with its input after it was left.

use egui::{Id, Ui};

/// Where a person went from a field: nowhere yet, or to what had the focus then.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Left(Option<Option<Id>>);

impl Left {
    /// Whether a person has gone on since. Where the field is left to, its complaint can still be read; whoever turns to
    /// something else after that has read it.
    pub(crate) fn has_gone_on(&mut self, ui: &Ui, field: Id) -> bool {
        let focused = ui.memory(|m| m.focused());
        if focused == Some(field) {
            self.0 = None;
            return false;
        }
        let first = *self.0.get_or_insert(focused);
        focused.is_some() && focused != first
    }
}
