//! Where a ray meets a single shape: the scalar truth.
//!
//! These functions are the definition of a hit. The kernels of [`crate::accel`] do the same arithmetic in lanes, in the
//! same order and without fused multiply-add, and must give the same bits.
//! Every one answers `None` or a finite `t` with `t_min < t < t_max`, whatever numbers come in.

pub mod cuboid;
pub mod plane;
pub mod sphere;
pub mod triangle;
