//! Files in the window: open, save, what is asked before something is lost, and what bad files lead to.

#[path = "../support/mod.rs"]
mod support;

mod adding;
mod bad;
mod cameras;
mod desk;
mod drops;
mod export;
mod guard;
mod loading;
mod open;
mod recovery;
mod save;
mod typing;
