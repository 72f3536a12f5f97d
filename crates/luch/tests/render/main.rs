//! `luch render`.

#[path = "../support/mod.rs"]
mod support;

mod color_bar;
mod edits;
mod flags;
mod outputs;
mod refusals;
#[cfg(unix)]
mod stopping;
