//! `luch study`.

#[path = "../support/mod.rs"]
mod support;

mod outputs;
mod refusals;
#[cfg(unix)]
mod stopping;
