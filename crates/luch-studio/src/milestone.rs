//! When the window and its first pictures were there, for those who measure how fast it starts.

use crate::render_link::RenderLink;
use egui::Context;

/// A point on the way from the start to a finished picture, told once each.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Milestone {
    /// The window has drawn its first frame.
    Window,
    /// A frame with a picture in it has been drawn, be it a preview.
    FirstPicture,
    /// The finished first picture has been drawn.
    WholePicture,
}

impl Milestone {
    /// All, in the order in which they come.
    pub const ALL: [Self; 3] = [Self::Window, Self::FirstPicture, Self::WholePicture];
}

/// Tells the milestones.
#[derive(Debug, Default)]
pub(crate) struct Milestones {
    tell: Option<fn(Milestone)>,
    /// What the frame showed that was drawn last.
    drawn: Option<Milestone>,
    told: usize,
}

impl Milestones {
    pub(crate) const fn new(tell: Option<fn(Milestone)>) -> Self {
        Self { tell, drawn: None, told: 0 }
    }

    /// At the start of a frame: the one before it is on the screen.
    pub(crate) fn tell(&mut self) {
        let (Some(tell), Some(drawn)) = (self.tell, self.drawn) else { return };
        for milestone in Milestone::ALL.into_iter().skip(self.told).filter(|milestone| *milestone <= drawn) {
            tell(milestone);
            self.told += 1;
        }
    }

    /// At the end of a frame: notes what it shows. Another frame follows at once, so that it can be told.
    pub(crate) fn note(&mut self, render: &RenderLink, ctx: &Context) {
        if self.tell.is_none() || self.told == Milestone::ALL.len() {
            return;
        }
        let shows = match render.picture() {
            Some((snapshot, _)) if snapshot.finished => Milestone::WholePicture,
            Some(_) => Milestone::FirstPicture,
            None => Milestone::Window,
        };
        if self.drawn != Some(shows) {
            self.drawn = Some(shows);
            ctx.request_repaint();
        }
    }
}
