//! The threads of a render: as many as the machine runs at once begin together, those beyond when there is time for them.
//!
//! A thread that has no core of its own brings nothing, but to start and end it costs as much as some tiles: with 64
//! threads on two cores a frame of 26 ms took 30. So it is started only once the picture has taken so long that the cost
//! is a hundredth of it.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{self, Scope};
use std::time::{Duration, Instant};

/// CPU time that a thread costs without bringing any: start, end, memory of its own. From 50 µs on were measured.
const COST: Duration = Duration::from_micros(100);
/// One part in so many of the machine's time may go to such threads.
const SHARE: u32 = 100;

/// Which threads there are, and when the next one is due.
struct Crew {
    /// Threads that begin at once.
    together: usize,
    /// Threads in all.
    threads: usize,
    /// From one late beginning to the next.
    pause: Duration,
    began: Instant,
    /// Numbers given out.
    numbers: AtomicUsize,
    /// Threads that the system gave.
    started: AtomicUsize,
}

/// Runs the same work on up to `threads` named threads, waits for them and answers with their number. The work calls what
/// it is given between its pieces. If the system gives fewer threads, those do it, and if it gives none, the caller does.
pub(super) fn run(threads: usize, work: &(impl Fn(&dyn Fn()) + Sync)) -> usize {
    let crew = Crew::new(threads, usable_threads());
    thread::scope(|scope| {
        (0..crew.together).for_each(|number| start(scope, &crew, number, work));
        if crew.started.load(Ordering::Relaxed) == 0 {
            work(&|| {});
        }
    });
    crew.started.into_inner().max(1)
}

/// Starts thread `number`, if the system gives one.
fn start<'scope>(
    scope: &'scope Scope<'scope, '_>,
    crew: &'scope Crew,
    number: usize,
    work: &'scope (impl Fn(&dyn Fn()) + Sync),
) {
    let between = move || {
        if let Some(next) = crew.due(crew.began.elapsed()) {
            start(scope, crew, next, work);
        }
    };
    let run = move || work(&between);
    if thread::Builder::new().name(format!("luch-render-{number}")).spawn_scoped(scope, run).is_ok() {
        crew.started.fetch_add(1, Ordering::Relaxed);
    }
}

impl Crew {
    fn new(threads: usize, cores: usize) -> Self {
        let threads = threads.max(1);
        let together = threads.min(cores);
        let pause = COST * SHARE / u32::try_from(cores).unwrap_or(u32::MAX).max(1);
        let (numbers, started) = (AtomicUsize::new(together), AtomicUsize::new(0));
        Self { together, threads, pause, began: Instant::now(), numbers, started }
    }

    /// The number of a thread that is to begin now, `elapsed` after the first; each number is given once.
    fn due(&self, elapsed: Duration) -> Option<usize> {
        let number = self.numbers.load(Ordering::Relaxed);
        if number >= self.threads {
            return None;
        }
        let late = u32::try_from(number + 1 - self.together).unwrap_or(u32::MAX);
        if elapsed < self.pause.saturating_mul(late) {
            return None;
        }
        let order = Ordering::Relaxed;
        self.numbers.compare_exchange(number, number + 1, order, order).is_ok().then_some(number)
    }
}

/// Threads that the machine runs at once for this process. The system is asked once: it reads files to answer.
fn usable_threads() -> usize {
    static KNOWN: OnceLock<usize> = OnceLock::new();
    *KNOWN.get_or_init(|| thread::available_parallelism().map_or(1, std::num::NonZero::get))
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Barrier;

    const MS: Duration = Duration::from_millis(1);

    #[test]
    fn threads_beyond_the_cores_begin_one_by_one() {
        let crew = Crew::new(5, 2);
        assert_eq!((crew.together, crew.pause), (2, MS * 5), "100 µs are a hundredth of 10 ms, of 5 ms of two cores");
        assert_eq!(crew.due(MS * 4), None);
        assert_eq!(crew.due(MS * 5), Some(2));
        assert_eq!(crew.due(MS * 5), None, "the next is due after another 5 ms");
        assert_eq!(crew.due(MS * 17), Some(3));
        assert_eq!(crew.due(MS * 17), Some(4));
        assert_eq!(crew.due(MS * 1000), None, "no more were asked for");
    }

    #[test]
    fn as_many_as_the_cores_begin_together() {
        for (threads, cores, together) in [(1, 8, 1), (8, 8, 8), (3, 8, 3), (0, 2, 1)] {
            let crew = Crew::new(threads, cores);
            assert_eq!((crew.together, crew.due(MS * 1000)), (together, None), "{threads} on {cores}");
        }
    }

    #[test]
    fn all_threads_that_were_asked_for_come_if_the_work_lasts() {
        // Each waits until all are there, whether or not they have a core.
        let threads = usable_threads() + 3;
        let (all, there) = (Barrier::new(threads), AtomicUsize::new(0));
        let started = run(threads, &|between| {
            there.fetch_add(1, Ordering::Relaxed);
            while there.load(Ordering::Relaxed) < threads {
                between();
                thread::yield_now();
            }
            all.wait();
        });
        assert_eq!((started, there.into_inner()), (threads, threads));
    }
}
