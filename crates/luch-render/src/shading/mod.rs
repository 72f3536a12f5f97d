//! From a hit to light: where the surface is, how it is lit, what it mirrors.

pub(crate) mod gather;
pub(crate) mod gouraud;
pub(crate) mod spawn;
pub(crate) mod surface;
pub(crate) mod terms;
