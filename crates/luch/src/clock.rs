//! Times for people and for `--stats`.

use std::time::{Duration, Instant};

/// Wall and CPU time since a moment.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stopwatch {
    wall: Instant,
    cpu: Option<Duration>,
}

impl Stopwatch {
    pub(crate) fn start() -> Self {
        Self { wall: Instant::now(), cpu: process_cpu() }
    }

    /// Milliseconds that passed.
    pub(crate) fn wall_ms(self) -> f64 {
        milliseconds(self.wall.elapsed())
    }

    /// Milliseconds that the threads of this process worked; `None` where the system does not tell.
    pub(crate) fn cpu_ms(self) -> Option<f64> {
        Some(milliseconds(process_cpu()?.saturating_sub(self.cpu?)))
    }
}

/// With three decimals: clocks are no better.
pub(crate) fn milliseconds(time: Duration) -> f64 {
    (time.as_secs_f64() * 1e6).round() / 1e3
}

/// CPU time of all threads of this process, those that ended included.
#[cfg(unix)]
fn process_cpu() -> Option<Duration> {
    let now = rustix::time::clock_gettime(rustix::time::ClockId::ProcessCPUTime);
    Some(Duration::new(u64::try_from(now.tv_sec).ok()?, u32::try_from(now.tv_nsec).ok()?))
}

#[cfg(not(unix))]
fn process_cpu() -> Option<Duration> {
    None
}
