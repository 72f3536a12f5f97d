//! The controls of the panels: what egui has, with checked input, accessible names and a line of one look.

pub(crate) mod check;
pub(crate) mod color;
pub(crate) mod icon;
pub(crate) mod left;
pub(crate) mod number;
pub(crate) mod picker;
pub(crate) mod row;
pub(crate) mod size;
pub(crate) mod text;
