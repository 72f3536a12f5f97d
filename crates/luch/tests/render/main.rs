//! `luch render`.

#[path = "../support/mod.rs"]
mod support;

mod edits;
mod flags;
mod outputs;
mod refusals;
#[cfg(unix)]
mod stopping;
