//! Times for people and for `--stats`.

pub(crate) use luch_study::clock::{Stopwatch, milliseconds};
