//! The renderer of Luch: compile a scene, trace rays, fill a film. No files, no window.
#![forbid(unsafe_code)]

pub mod accel;
pub mod math;
pub mod shape;
