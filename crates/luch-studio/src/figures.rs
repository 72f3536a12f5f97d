//! Figures that no two runs have alike: how long a picture took, how fast it came, what the machine is. A window that is
//! compared with a stored picture of it shows fixed ones instead.

use luch_render::SimdLevel;
use std::time::Duration;

/// Where the window takes such figures from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Figures {
    /// From the run and the machine.
    Measured,
    /// The same every time.
    Still,
}

impl Figures {
    /// Threads of a still window, whatever the machine has.
    pub(crate) const STILL_CORES: usize = 4;

    /// Threads that the machine runs at once.
    pub(crate) fn cores(self) -> usize {
        match self {
            Self::Measured => crate::preferences::cores(),
            Self::Still => Self::STILL_CORES,
        }
    }

    /// How long something took.
    pub(crate) const fn elapsed(self, measured: Duration) -> Duration {
        match self {
            Self::Measured => measured,
            Self::Still => Duration::from_millis(120),
        }
    }

    /// Millions of rays in a second; `None` where no time has passed.
    pub(crate) fn mrays_per_s(self, rays: u64, elapsed: Duration) -> Option<f64> {
        match self {
            Self::Measured => (!elapsed.is_zero()).then(|| rays as f64 / elapsed.as_secs_f64() / 1e6),
            Self::Still => Some(24.5),
        }
    }

    /// The instruction set in use.
    pub(crate) fn simd(self) -> &'static str {
        match self {
            Self::Measured => SimdLevel::Auto.resolved().word(),
            Self::Still => SimdLevel::Avx2.word(),
        }
    }
}
