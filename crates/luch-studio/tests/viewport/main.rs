//! What one does with the mouse and the keys in the picture, and what the picture shows then.

#[path = "../support/mod.rs"]
mod support;

mod focus;
mod gizmo;
mod large;
mod mouse;
mod navigation;
