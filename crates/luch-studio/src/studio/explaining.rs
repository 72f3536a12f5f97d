//! What the studio does with the pixels that are to be explained.

use super::Studio;
use crate::command::Tool;
use crate::explain::{ExplainCommand, Format, Question};
use crate::notices::Severity;
use egui::Context;
use std::sync::Arc;
use std::time::Duration;

/// How soon a person is told that an account takes its time.
pub(crate) const PATIENCE: Duration = Duration::from_millis(500);

impl Studio {
    pub(super) fn apply_explain(&mut self, command: ExplainCommand, ctx: &Context) {
        let explain = &mut self.state.explain;
        match command {
            ExplainCommand::Pixel(pixel) => self.explain(pixel, ctx),
            ExplainCommand::Step([dx, dy]) => {
                let Some([x, y]) = explain.pixel else { return };
                let Some((snapshot, _)) = self.render.picture() else { return };
                let step = |place: u32, by: i32, side: u32| place.saturating_add_signed(by).min(side - 1);
                let size = snapshot.job.size;
                self.explain([step(x, dx, size.width()), step(y, dy, size.height())], ctx);
            }
            ExplainCommand::Close => {
                explain.close();
                self.explainer.stop();
                self.state.tool = Tool::Select;
            }
            ExplainCommand::SelectRay(ray) => explain.look_at(ray),
            ExplainCommand::Fold(ray, closed) => explain.fold(ray, closed),
            ExplainCommand::FoldAll(closed) => explain.fold_all(closed),
            ExplainCommand::Show(page) => explain.page = page,
            ExplainCommand::SetEveryDigit(every) => explain.every_digit = every,
            ExplainCommand::SetLevel(level) => explain.level = level,
            ExplainCommand::SetOuterLevels(outer) => explain.outer_levels = outer,
            ExplainCommand::Copy(format) => self.copy_account(format, ctx),
        }
    }

    /// Asks why a pixel of the picture that is shown has its colour.
    fn explain(&mut self, pixel: [u32; 2], ctx: &Context) {
        let Some((snapshot, _)) = self.render.picture() else { return };
        let question = Question::about(snapshot, pixel, self.state.explain.answer.as_deref());
        self.state.explain.unexplained = None;
        self.state.explain.ask(pixel, question.epoch);
        let wake = ctx.clone();
        if let Err(error) = self.explainer.ask(question, move || wake.request_repaint()) {
            self.state.notices.error(self.texts.notice_internal(), error.to_string());
        }
        ctx.request_repaint_after(PATIENCE);
    }

    fn copy_account(&mut self, format: Format, ctx: &Context) {
        let explain = &self.state.explain;
        let Some(answer) = &explain.answer else { return };
        let sample = answer.account.rays.get(explain.ray as usize).map_or(0, |ray| ray.sample);
        let wake = ctx.clone();
        let language = self.state.preferences.language;
        if let Err(error) = self.copier.start(answer, sample, format, language, move || wake.request_repaint()) {
            self.state.notices.error(self.texts.notice_internal(), error.to_string());
        }
    }

    /// Takes in an account that was made, and asks for another where the picture has changed since.
    pub(super) fn follow_explained(&mut self, ctx: &Context) {
        let wake = ctx.clone();
        match self.explainer.poll(move || wake.request_repaint()) {
            Ok(Some(answer)) => self.state.explain.take(answer),
            Ok(None) => {}
            Err(error) => self.state.notices.error(self.texts.notice_internal(), error.to_string()),
        }
        if let Some(text) = self.copier.poll() {
            ctx.copy_text(text);
            self.state.notices.add(Severity::Done, self.texts.explain_copied(), String::new());
        }
        let shown = self.render.picture().map(|(snapshot, _)| Arc::clone(snapshot));
        if let Some(pixel) = shown.and_then(|shown| self.state.explain.outdated(&shown)) {
            self.explain(pixel, ctx);
        }
    }
}
