//! Studies: how long a picture takes, and what that depends on.
//!
//! A [`Plan`] says what to measure; [`Study::new`] checks it; [`run()`] carries it out, tells each [`Measurement`] as it
//! comes and can be watched and cancelled through [`StudyProgress`]; [`Findings::of`] a [`Record`] are all numbers that
//! follow; and from these come reports, tables, plots and files.
//!
//! ```
//! use luch_study::{Effort, Findings, Kind, Language, Plan, Study, StudyProgress, Subject, run, sentences};
//!
//! let subjects = vec![Subject::built_in("one-sphere")?, Subject::built_in("two-spheres")?];
//! let size = luch_scene::ImageSize::new(64, 48)?;
//! let effort = Effort { runs: 3, warm_up: 1, size, ..Effort::of(Kind::Threads) };
//! let study = Study::new(Plan::Threads { subjects, threads: vec![1, 2], effort })?;
//!
//! let mut live = 0;
//! let record = run(&study, &StudyProgress::new(), &mut |_measurement| live += 1)?;
//! assert_eq!((record.partial, live), (false, 12));
//! let findings = Findings::of(&record);
//! assert!(findings.cases[1].speed_up.is_some());
//! for line in sentences(&findings, Language::English) {
//!     assert!(!line.is_empty());
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![forbid(unsafe_code)]

pub mod amdahl;
mod bumpy_sphere;
pub mod case;
pub mod chart;
pub mod clock;
pub mod csv;
pub mod draw;
pub mod files;
pub mod findings;
pub mod json;
pub mod language;
pub mod machine;
pub mod order;
pub mod plan;
pub mod plan_error;
pub mod progress;
pub mod published;
pub mod report;
pub mod run;
#[cfg(test)]
mod samples;
pub mod statistics;
pub mod study;
pub mod subject;

pub use case::Case;
pub use chart::{Chart, charts};
pub use findings::Findings;
pub use json::{from_json, to_json};
pub use language::Language;
pub use machine::Machine;
pub use plan::{Effect, Effort, Kind, Plan};
pub use plan_error::PlanError;
pub use progress::StudyProgress;
pub use report::{markdown, sentences};
pub use run::{Measurement, Record, run};
pub use study::Study;
pub use subject::Subject;
