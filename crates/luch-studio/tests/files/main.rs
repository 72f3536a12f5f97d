//! Files in the window: open, save, what is asked before something is lost, and what bad files lead to.

#[path = "../support/mod.rs"]
mod support;

mod bad;
mod desk;
mod guard;
mod open;
mod save;
