//! Rendering as work: what is to be made, in which order, by which threads, and how to stop it.

mod job;
mod progress;
mod render;
mod scheduler;

pub use job::{Crop, RenderJob};
pub use progress::Progress;
pub use render::{RenderError, render};
pub use scheduler::{RenderWork, Scheduler};
