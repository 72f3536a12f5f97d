//! The fourteen functional tests of the window: what a person does, and what the picture is to show.

#[path = "../support/mod.rs"]
mod support;

mod scenes;
