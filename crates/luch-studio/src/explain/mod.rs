//! Explain: why a pixel of the picture has its colour, ray by ray and term by term.
//!
//! The account itself is [`luch_render::explain`]'s; it is made on a thread ([`link`]). Here is what the window
//! remembers of it, the panel that shows it, and what is drawn over the picture.

mod command;
mod copy;
mod explained;
mod icons;
mod link;
mod looks;
mod numbers;
mod overlay;
mod panel;
mod plan;
mod rows;

pub(crate) use command::{ExplainCommand, Format, Page};
pub(crate) use copy::Copier;
pub(crate) use explained::Explained;
pub(crate) use link::{Answer, Explainer, Question, Unexplained};
pub(crate) use overlay::draw as draw_over_picture;
pub(crate) use panel::{show as show_panel, tree_has_focus};

use luch_render::explain::Walk;
use luch_render::session::live::{Epoch, Snapshot};
use numbers::Digits;
use rows::Rows;
use std::sync::Arc;
use std::time::Instant;

/// An account of at most so many rays is made anew with every picture that begins; a larger one when the picture is
/// done.
const CHEAP: usize = 20_000;

/// What the window remembers of the pixel that is explained.
#[derive(Debug, Default)]
pub(crate) struct Explain {
    /// The pixel; none while nothing is to be explained.
    pub(crate) pixel: Option<[u32; 2]>,
    /// Its newest account, or that of the pixel before while the new one is made.
    pub(crate) answer: Option<Arc<Explained>>,
    /// Why there is no account of the pixel.
    pub(crate) unexplained: Option<Unexplained>,
    /// Since when an account is awaited, and of which picture.
    pub(crate) asked: Option<(Instant, Epoch)>,
    /// The picture that was asked about last and has had its answer, good or bad.
    answered: Option<Epoch>,
    pub(crate) rows: Rows,
    /// The ray that is looked at, by its place in the account.
    pub(crate) ray: u32,
    /// Its way through the trees.
    pub(crate) walk: Walk,
    pub(crate) page: Page,
    pub(crate) every_digit: bool,
    /// The level of the boxes that are drawn.
    pub(crate) level: u32,
    /// Whether those of the levels above are drawn, too.
    pub(crate) outer_levels: bool,
}

impl Explain {
    /// Whether the panel is open.
    pub(crate) const fn is_open(&self) -> bool {
        self.pixel.is_some()
    }

    pub(crate) const fn digits(&self) -> Digits {
        Digits { every: self.every_digit }
    }

    /// Notes that an account is awaited.
    pub(crate) fn ask(&mut self, pixel: [u32; 2], epoch: Epoch) {
        self.pixel = Some(pixel);
        // Who holds an arrow key down waits since the first of its pixels.
        let since = self.asked.map_or_else(Instant::now, |(since, _)| since);
        self.asked = Some((since, epoch));
    }

    /// The pixel to explain again, since the picture that is shown is another than the account's.
    pub(crate) fn outdated(&self, shown: &Snapshot) -> Option<[u32; 2]> {
        let pixel = self.pixel?;
        let rays = self.answer.as_ref().map_or(0, |answer| answer.account.rays.len());
        let newest = self.asked.map(|(_, epoch)| epoch).or(self.answered);
        (newest != Some(shown.epoch) && (shown.finished || rays <= CHEAP)).then_some(pixel)
    }

    /// Takes an account in. Where the tree was looked at it is looked at again.
    pub(crate) fn take(&mut self, answer: Answer) {
        if self.pixel != Some(answer.pixel) {
            return;
        }
        self.asked = None;
        self.answered = Some(answer.epoch);
        match answer.account {
            Ok(explained) => {
                let account = &explained.account;
                let (rows, ray) = match &self.answer {
                    Some(before) => (
                        std::mem::take(&mut self.rows).anew(&before.account, account),
                        rows::follow(&rows::way_to(self.ray, &before.account), account),
                    ),
                    None => (Rows::of(account), account.samples.first().map_or(0, |sample| sample.ray)),
                };
                self.rows = rows;
                self.unexplained = None;
                self.answer = Some(Arc::new(explained));
                self.look_at(ray);
            }
            Err(why) => {
                self.unexplained = Some(why);
                self.answer = None;
            }
        }
    }

    pub(crate) fn close(&mut self) {
        let Self { page, every_digit, level, outer_levels, .. } = *self;
        *self = Self { page, every_digit, level, outer_levels, ..Self::default() };
    }

    pub(crate) fn look_at(&mut self, ray: u32) {
        let Some(answer) = &self.answer else { return };
        if (ray as usize) < answer.account.rays.len() {
            self.ray = ray;
            self.rows.reveal(ray, &answer.account);
            self.walk = answer.account.walk(&answer.compiled, ray);
        }
    }

    pub(crate) fn fold(&mut self, ray: u32, closed: bool) {
        let Some(answer) = &self.answer else { return };
        self.rows.fold(ray, closed, &answer.account);
        self.look_at_a_row();
    }

    pub(crate) fn fold_all(&mut self, closed: bool) {
        let Some(answer) = &self.answer else { return };
        self.rows.fold_all(closed, &answer.account);
        self.look_at_a_row();
    }

    /// What is looked at has a row.
    fn look_at_a_row(&mut self) {
        if let Some(&row) = self.rows.shown().get(self.rows.place_of(self.ray))
            && row != self.ray
        {
            self.look_at(row);
        }
    }
}
