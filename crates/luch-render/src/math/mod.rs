//! Rays, boxes and the arithmetic the renderer shares.

pub mod bounds;
pub mod ray;
