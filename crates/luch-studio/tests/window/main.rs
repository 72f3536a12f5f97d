//! The window as a whole: what is typed wrong, what is taken back, what waits, and in which language it speaks.

#[path = "../support/mod.rs"]
mod support;

mod input;
mod keyboard;
mod language;
mod layout;
mod live;
mod picker;
mod picking;
mod snapshots;
mod starting;
mod tips;
mod typing;
mod undo;
