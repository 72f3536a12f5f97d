//! Rays, boxes and the arithmetic the renderer shares.

pub mod bounds;
pub(crate) mod lanes;
pub(crate) mod pow;
pub mod ray;
