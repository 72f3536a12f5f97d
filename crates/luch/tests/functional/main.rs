//! The fourteen functional tests of the studio as command lines of the real program: what each picture must show.
//!
//! Nothing is compared with a stored picture. The `objects` view says what is seen at each pixel, the scene says where
//! things stand, and the linear picture obeys the lighting model; docs/functional-tests.md shows the pictures.

#[path = "../support/mod.rs"]
mod support;

mod commands;
mod geometry;
mod lab;
mod picture;

mod chess;
mod documentation;
mod effects;
mod knight;
mod light;
mod spheres;
