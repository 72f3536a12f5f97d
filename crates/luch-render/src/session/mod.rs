//! Rendering as work: what is to be made, in which order, by which threads, and how to stop it.

mod crew;
mod job;
pub mod live;
mod progress;
mod queue;
mod render;
mod scheduler;
mod worker;

pub use job::{Crop, RenderJob};
pub use progress::Progress;
pub use render::{RenderError, render};
pub use scheduler::{RenderWork, Scheduler};
