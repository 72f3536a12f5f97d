//! Studies in the window: a plan that is typed in, runs in the background, plots that grow with every run.

mod form;
mod plot;
mod runner;
mod window;

pub(crate) use window::show;

use crate::l10n::Language;
use luch_study::{Findings, Plan};
use runner::Running;
use std::io;
use std::path::PathBuf;
use std::sync::Arc;

/// What the study window can be told.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum StudyCommand {
    /// Show the window, or put it away; a study goes on without it.
    Open(bool),
    /// Begin to measure.
    Start(Box<Plan>),
    /// Stop measuring; what was measured stays.
    Cancel,
    /// Write report, tables and plots into a folder.
    Save(PathBuf),
}

/// What came of writing a study.
#[derive(Debug)]
pub(crate) enum Outcome {
    /// It is in this folder.
    Saved(PathBuf),
    /// Why it is not.
    NotSaved(String),
    /// The renderer's own mistake.
    Failed(String),
}

/// The study at hand.
#[derive(Debug, Default)]
pub(crate) struct StudyDesk {
    pub(crate) open: bool,
    running: Option<Running>,
    /// What was measured so far, or last.
    findings: Option<Arc<Findings>>,
    saving: Option<runner::Saving>,
}

impl StudyDesk {
    /// Begins to measure on a thread of its own; `wake` is called with every result.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn start(&mut self, plan: Plan, wake: impl Fn() + Send + 'static) -> io::Result<()> {
        self.cancel();
        self.findings = None;
        self.running = Some(Running::start(plan, wake)?);
        Ok(())
    }

    pub(crate) fn cancel(&self) {
        if let Some(running) = &self.running {
            running.cancel();
        }
    }

    /// Writes what was measured on a thread of its own; `wake` is called at the end.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn save(
        &mut self,
        folder: PathBuf,
        language: Language,
        wake: impl FnOnce() + Send + 'static,
    ) -> io::Result<()> {
        let Some(findings) = self.findings.clone() else { return Ok(()) };
        self.saving = Some(runner::Saving::start(findings, folder, words(language), wake)?);
        Ok(())
    }

    /// Takes in what was measured and written since the last frame.
    pub(crate) fn poll(&mut self) -> Option<Outcome> {
        if let Some(running) = &mut self.running {
            if let Some(findings) = running.news() {
                self.findings = Some(Arc::new(findings));
            }
            if let Some(end) = running.end() {
                self.findings = running.last().map(Arc::new);
                self.running = None;
                if let Err(message) = end {
                    return Some(Outcome::Failed(message));
                }
            }
        }
        let saved = self.saving.as_ref()?.poll()?;
        self.saving = None;
        Some(saved)
    }

    pub(crate) const fn is_running(&self) -> bool {
        self.running.is_some()
    }

    /// Whether something is measured or written.
    pub(crate) const fn is_busy(&self) -> bool {
        self.running.is_some() || self.saving.is_some()
    }
}

impl Drop for StudyDesk {
    fn drop(&mut self) {
        self.cancel();
    }
}

/// The language of reports and plots.
const fn words(language: Language) -> luch_study::Language {
    match language {
        Language::En => luch_study::Language::English,
        Language::Ru => luch_study::Language::Russian,
    }
}
