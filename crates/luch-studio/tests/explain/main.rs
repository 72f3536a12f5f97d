//! The account of a pixel in the window: what a person clicks, and what the panel and the picture are to show.

#[path = "../support/mod.rs"]
mod support;

mod clicks;
mod copies;
mod many_rays;
mod pages;
