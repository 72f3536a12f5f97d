//! Progress for people at a terminal: what is going on, how far it is, how fast, how long it will take.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use luch_render::Progress;
use luch_study::StudyProgress;
use std::io::{self, IsTerminal, Write as _};
use std::sync::{Condvar, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// What takes less is not worth a flicker.
const DELAY: Duration = Duration::from_millis(500);
/// Time between two looks at the work.
const PERIOD: Duration = Duration::from_millis(100);

/// What tells how far the work is.
#[derive(Debug, Clone, Copy)]
pub(crate) enum Meter<'a> {
    /// One picture.
    Render(&'a Progress),
    /// Many pictures.
    Study(&'a StudyProgress),
}

impl Meter<'_> {
    fn done(self) -> u64 {
        match self {
            Self::Render(progress) => progress.done(),
            Self::Study(progress) => progress.done(),
        }
    }

    fn total(self) -> u64 {
        match self {
            Self::Render(progress) => progress.total(),
            Self::Study(progress) => progress.total(),
        }
    }

    fn rays(self) -> u64 {
        match self {
            Self::Render(progress) => progress.rays(),
            Self::Study(progress) => progress.rays(),
        }
    }
}

/// Shows the stages of a run, or does not.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Stages {
    shown: bool,
}

impl Stages {
    /// Shows on a terminal, unless the user wants quiet.
    pub(crate) fn new(quiet: bool) -> Self {
        Self { shown: !quiet && io::stderr().is_terminal() }
    }

    /// Does the work and meanwhile, once it takes long, shows `label` and how far the work is.
    pub(crate) fn during<T>(self, label: &str, meter: Option<Meter<'_>>, work: impl FnOnce() -> T) -> T {
        if !self.shown {
            return work();
        }
        let end = End::default();
        thread::scope(|scope| {
            let paint = || paint(label, meter, &end);
            // Without a thread there is no progress to see, and no harm.
            let _painter = thread::Builder::new().name("luch-progress".to_owned()).spawn_scoped(scope, paint);
            // Dropped before the scope waits for the painter, also when the work panics.
            let _ends = Ends(&end);
            work()
        })
    }
}

/// Whether the work is over.
#[derive(Debug, Default)]
struct End {
    over: Mutex<bool>,
    changed: Condvar,
}

struct Ends<'a>(&'a End);

impl Drop for Ends<'_> {
    fn drop(&mut self) {
        *self.0.over.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.0.changed.notify_all();
    }
}

impl End {
    /// Waits for the end, for so long at most; answers whether it came.
    fn came_within(&self, time: Duration) -> bool {
        let over = self.over.lock().unwrap_or_else(PoisonError::into_inner);
        let waited = self.changed.wait_timeout_while(over, time, |over| !*over);
        *waited.unwrap_or_else(PoisonError::into_inner).0
    }
}

fn paint(label: &str, meter: Option<Meter<'_>>, end: &End) {
    let begin = Instant::now();
    if end.came_within(DELAY) {
        return;
    }
    let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
    bar.set_prefix(label.to_owned());
    bar.set_style(style("{prefix} {spinner} {elapsed}"));
    loop {
        if let Some(meter) = meter.filter(|m| m.total() > 0) {
            if bar.length().is_none() {
                bar.set_style(style("{prefix} [{bar:30}] {percent:>3} %  {msg}, {eta} left"));
                bar.set_length(meter.total());
            }
            bar.set_message(rate(meter.rays(), begin.elapsed()));
            bar.set_position(meter.done());
        }
        bar.tick();
        if end.came_within(PERIOD) {
            break;
        }
    }
    bar.finish_and_clear();
}

fn style(template: &str) -> ProgressStyle {
    // The templates are constants that a test tries.
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar()).progress_chars("=> ")
}

/// `12.3 Mray/s`.
pub(crate) fn rate(rays: u64, time: Duration) -> String {
    let per_second = rays as f64 / time.as_secs_f64().max(1e-9);
    let (scale, unit) = if per_second < 1e6 { (1e3, "kray/s") } else { (1e6, "Mray/s") };
    format!("{:.1} {unit}", per_second / scale)
}

/// Takes a half-painted bar off the terminal before the program's last words.
pub(crate) fn clear_line() {
    let mut err = io::stderr().lock();
    if err.is_terminal() {
        let _ = err.write_all(b"\r\x1b[2K");
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rates() {
        assert_eq!(rate(5_000, Duration::from_secs(10)), "0.5 kray/s");
        assert_eq!(rate(123_000_000, Duration::from_secs(10)), "12.3 Mray/s");
        assert_eq!(rate(0, Duration::ZERO), "0.0 kray/s");
    }

    #[test]
    fn templates_are_right() {
        for template in ["{prefix} {spinner} {elapsed}", "{prefix} [{bar:30}] {percent:>3} %  {msg}, {eta} left"] {
            assert!(ProgressStyle::with_template(template).is_ok(), "{template}");
        }
    }

    #[test]
    fn the_end_is_noticed_at_once() {
        let end = End::default();
        assert!(!end.came_within(Duration::from_millis(1)));
        drop(Ends(&end));
        assert!(end.came_within(Duration::from_secs(3600)));
    }

    #[test]
    fn a_panic_of_the_work_is_not_waited_for() {
        let stages = Stages { shown: true };
        let outcome = std::panic::catch_unwind(|| stages.during("x", None, || panic!("as planned")));
        assert!(outcome.is_err());
    }
}
