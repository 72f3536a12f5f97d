//! The files of Luch: scenes, models, pictures. The only crate that opens files.

#![forbid(unsafe_code)]
#![deny(
    clippy::indexing_slicing,
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::arithmetic_side_effects,
    clippy::cast_possible_truncation
)]
#![cfg_attr(
    test,
    allow(
        clippy::indexing_slicing,
        clippy::unwrap_used,
        clippy::expect_used,
        clippy::arithmetic_side_effects,
        clippy::cast_possible_truncation,
        reason = "tests may be plain"
    )
)]

pub mod atomic_save;
pub mod budget;
pub mod built_in_models;
pub mod builtin;
pub mod error;
pub mod folder;
pub mod library;
pub mod load;
pub mod model_scene;
pub mod obj;
pub mod path_text;
pub mod picture;
pub mod recovery;
pub mod report;
pub mod resolve;
pub mod save_scene;
pub mod scene_file;
mod writable;

pub use error::{Error, ErrorKind, Place, Result};
pub use load::{SceneSource, load_scene};
pub use model_scene::{Model, load_model};
pub use path_text::{decode_path, encode_path};
pub use picture::{Metadata, PictureFormat, PictureSettings, Pixels, linear_hash, write_exr, write_png};
pub use report::Report;
pub use save_scene::{Renamed, Saved, save_scene};
pub use scene_file::{LoadMesh, parse_scene, read_scene, write_scene};
pub use writable::check_writable;
