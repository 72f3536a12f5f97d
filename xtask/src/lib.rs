//! Tools of the Luch repository, as a library so that their results can be tested.

#![forbid(unsafe_code)]

pub mod gallery;
pub mod models;

/// Where `cargo xtask models` writes unless told otherwise, whatever the current folder.
pub const MODELS_DIR: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../assets/models");
