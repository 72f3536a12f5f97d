//! How much to do at once: resolutions of previews and samples of passes, from what earlier pictures cost.

use super::mailbox::LiveRequest;
use crate::integrator::Integrator;
use std::time::Duration;

/// Seconds within which a request wants its first picture. The rest of a frame of the screen is for the scene to be made
/// ready, the picture to be put together, and the window to draw it.
const FIRST_PICTURE: f64 = 0.012;
/// Seconds that a preview after the first is worth: whatever takes less needs none before it.
const NEXT_PICTURE: f64 = 0.060;
/// How many times the rays of the one before a further preview has.
const STEP: f64 = 6.0;
/// Seconds that passes which refine a picture take at most.
const PASS: f64 = 0.150;
/// Thread-seconds for a ray of a picture that nothing is known of: a heavy scene's.
const UNKNOWN: f64 = 1e-6;
/// Previews have at least this many columns or rows.
const SMALLEST_SIDE: u32 = 32;
/// Kinds of pictures that are remembered.
const KINDS: usize = 16;

/// Pictures whose rays cost about the same.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Kind {
    scene: String,
    integrator: Integrator,
    depth: u32,
}

impl Kind {
    pub(super) fn of(request: &LiveRequest) -> Self {
        let LiveRequest { scene, job } = request;
        Self { scene: scene.name.clone(), integrator: job.integrator, depth: job.depth }
    }
}

/// What is known of a kind.
#[derive(Debug, Clone)]
struct Known {
    kind: Kind,
    /// Thread-seconds for a ray of a preview, which lies far from its neighbours.
    block: Option<f64>,
    /// Thread-seconds for a ray at full resolution.
    pixel: Option<f64>,
    /// The first resolution of the last picture.
    shrink: u32,
}

/// A pass that was made: what to learn from.
#[derive(Debug, Clone, Copy)]
pub(super) struct Measured {
    pub(super) preview: bool,
    pub(super) rays: u64,
    pub(super) threads: usize,
    pub(super) took: Duration,
    /// Whether all of it was made. What was cut short is at least as dear as it looks.
    pub(super) whole: bool,
}

/// Learns what pictures cost.
#[derive(Debug)]
pub(super) struct Pace {
    /// The last used first.
    known: Vec<Known>,
    cores: usize,
}

impl Pace {
    pub(super) fn new(cores: usize) -> Self {
        Self { known: Vec::new(), cores: cores.max(1) }
    }

    /// The resolution to begin with, as the side of the blocks that have a ray: 1 is the full one.
    pub(super) fn first(&mut self, kind: &Kind, [width, height]: [u32; 2], threads: usize) -> u32 {
        let [block, full] = self.seconds(kind, [width, height], threads);
        let known = self.of(kind);
        let coarsest = (width.max(height) / SMALLEST_SIDE).max(1);
        let shrink = if full <= FIRST_PICTURE { 1 } else { steady(known.shrink, block).min(coarsest) };
        known.shrink = shrink;
        shrink
    }

    /// The resolution to go on with after a preview of resolution `shown` that took so long.
    pub(super) fn next(&mut self, kind: &Kind, size: [u32; 2], threads: usize, shown: u32, took: Duration) -> u32 {
        // What this very picture costs is seen by now; what others cost tells how much less neighbours take.
        let block = took.as_secs_f64() * f64::from(shown).powi(2);
        let full = block.min(self.seconds(kind, size, threads)[1]);
        let worth = NEXT_PICTURE.max(took.as_secs_f64() * STEP);
        if full <= worth { 1 } else { (f64::from(shown) / STEP.sqrt()) as u32 }.max(1)
    }

    /// Samples of the next pass, after one of `last.0` samples that took `last.1`: never more than there are.
    pub(super) fn samples(done: u32, wanted: u32, last: (u32, Duration)) -> u32 {
        let each = last.1.as_secs_f64() / f64::from(last.0.max(1));
        let affordable = (PASS / each.max(1e-9)) as u32;
        affordable.min(done).clamp(1, (wanted - done).max(1))
    }

    /// Learns from a pass.
    pub(super) fn learn(&mut self, kind: &Kind, pass: Measured) {
        let parallel = pass.threads.clamp(1, self.cores) as f64;
        let measured = pass.took.as_secs_f64() * parallel / pass.rays.max(1) as f64;
        let known = self.of(kind);
        let cost = if pass.preview { &mut known.block } else { &mut known.pixel };
        *cost = Some(match *cost {
            None => measured,
            Some(old) if !pass.whole => measured.clamp(old * 1.5, old * 8.0),
            // One measurement may be off by whatever else the machine does.
            Some(old) => f64::midpoint(old, measured.clamp(old * 0.25, old * 3.0)),
        });
    }

    /// Seconds that a ray for each pixel will take, if the rays are those of previews, and if they are those of the full
    /// picture.
    fn seconds(&mut self, kind: &Kind, [width, height]: [u32; 2], threads: usize) -> [f64; 2] {
        let rays = f64::from(width) * f64::from(height) / threads.clamp(1, self.cores) as f64;
        let Known { block, pixel, .. } = *self.of(kind);
        [block.or(pixel), pixel.or(block)].map(|cost| cost.unwrap_or(UNKNOWN) * rays)
    }

    fn of(&mut self, kind: &Kind) -> &mut Known {
        let at = self.known.iter().position(|known| known.kind == *kind);
        let known = match at {
            Some(at) => self.known.remove(at),
            None => Known { kind: kind.clone(), block: None, pixel: None, shrink: 1 },
        };
        self.known.truncate(KINDS - 1);
        self.known.insert(0, known);
        &mut self.known[0]
    }
}

/// The side of blocks for a first preview if a ray for each pixel takes `block` seconds. The last one is kept while it
/// nearly fits, so that the picture does not flicker between two resolutions.
fn steady(last: u32, block: f64) -> u32 {
    let time = |shrink: u32| block / f64::from(shrink).powi(2);
    let fitting = ((block / FIRST_PICTURE).sqrt().ceil() as u32).max(2);
    let keeps = if last < fitting { time(last) <= FIRST_PICTURE * 1.25 } else { time(last - 1) > FIRST_PICTURE * 0.8 };
    if last >= 2 && keeps { last } else { fitting }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::session::RenderJob;
    use luch_scene::{Aim, Camera, Point, Scene};
    use std::sync::Arc;

    const SIZE: [u32; 2] = [1280, 720];
    const PIXELS: u64 = 1280 * 720;

    fn kind(name: &str) -> Kind {
        let mut scene = Scene::new(name);
        scene.cameras.push(Camera::new("c", Point::ORIGIN, Aim::At(Point::ORIGIN)));
        let job = RenderJob::of_scene(&scene, 0);
        Kind::of(&LiveRequest { scene: Arc::new(scene), job })
    }

    /// A pace that knows two threads to take so many milliseconds for a ray for each pixel.
    fn knowing(kind: &Kind, full_ms: f64) -> Pace {
        let mut pace = Pace::new(2);
        for preview in [true, false] {
            for _ in 0..30 {
                pace.learn(kind, measured(preview, PIXELS, full_ms));
            }
        }
        pace
    }

    fn measured(preview: bool, rays: u64, ms: f64) -> Measured {
        Measured { preview, rays, threads: 2, took: Duration::from_secs_f64(ms / 1e3), whole: true }
    }

    #[test]
    fn a_picture_that_is_fast_enough_has_no_preview() {
        let kind = kind("a");
        assert_eq!(knowing(&kind, 11.9).first(&kind, SIZE, 2), 1);
        assert_eq!(knowing(&kind, 13.0).first(&kind, SIZE, 2), 2);
        assert_eq!(knowing(&kind, 13.0).first(&kind, [640, 720], 2), 1, "half the pixels");
        assert_eq!(knowing(&kind, 13.0).first(&kind, SIZE, 1), 2, "half the threads");
        assert_eq!(knowing(&kind, 80.0).first(&kind, SIZE, 8), 3, "threads without cores help nobody");
        assert_eq!(knowing(&kind, 1e7).first(&kind, SIZE, 8), 40, "something must be seen");
        assert_eq!(knowing(&kind, 1e7).first(&kind, [1, 1], 8), 1);
    }

    #[test]
    fn the_first_picture_of_an_unknown_kind_is_careful_and_kinds_are_told_apart() {
        let mut pace = knowing(&kind("a"), 1.0);
        assert_eq!(pace.first(&kind("a"), SIZE, 2), 1);
        assert!(pace.first(&kind("b"), SIZE, 2) >= 6);
        for number in 0..100 {
            pace.first(&kind(&number.to_string()), SIZE, 2);
        }
        assert_eq!(pace.known.len(), KINDS, "what is remembered is bounded");
    }

    #[test]
    fn a_resolution_is_kept_while_it_nearly_fits() {
        assert_eq!(steady(1, 0.080), 3);
        assert_eq!(steady(3, 0.120), 3, "13.3 ms are nearly 12");
        assert_eq!(steady(3, 0.140), 4);
        assert_eq!(steady(4, 0.100), 4, "at 3 it would take 11.1 ms");
        assert_eq!(steady(4, 0.060), 3);
        assert_eq!(steady(40, 0.060), 3);
    }

    #[test]
    fn previews_get_finer_until_the_full_picture_is_near() {
        let kind = kind("a");
        let steps = |full_ms: f64| {
            let mut pace = knowing(&kind, full_ms);
            let mut steps = vec![pace.first(&kind, SIZE, 2)];
            while let Some(&last) = steps.last()
                && last > 1
            {
                let took = Duration::from_secs_f64(full_ms / 1e3 / f64::from(last).powi(2));
                steps.push(pace.next(&kind, SIZE, 2, last, took));
            }
            steps
        };
        assert_eq!(steps(5.0), [1]);
        assert_eq!(steps(50.0), [3, 1]);
        assert_eq!(steps(600.0), [8, 3, 1]);
        assert_eq!(steps(6000.0), [23, 9, 3, 1]);
        let mut pace = knowing(&kind, 6000.0);
        assert_eq!(
            pace.next(&kind, SIZE, 2, 23, Duration::from_micros(100)),
            1,
            "it is much easier than the others were"
        );
    }

    #[test]
    fn what_was_cut_short_is_dearer_than_was_thought() {
        let kind = kind("a");
        let mut pace = knowing(&kind, 80.0);
        let first = pace.first(&kind, SIZE, 2);
        let mut cut = measured(true, 0, 33.0);
        cut.whole = false;
        pace.learn(&kind, cut);
        assert!(pace.first(&kind, SIZE, 2) >= first * 2, "nothing was made in time: a coarser one");
        cut.rays = PIXELS;
        cut.took = Duration::ZERO;
        let before = pace.seconds(&kind, SIZE, 2)[0];
        pace.learn(&kind, cut);
        assert!(pace.seconds(&kind, SIZE, 2)[0] > before, "it was not finished, whatever it looks like");
        for _ in 0..10 {
            pace.learn(&kind, measured(true, PIXELS / 9, 80.0 / 9.0));
        }
        assert_eq!(pace.first(&kind, SIZE, 2), first, "and it recovers");
    }

    #[test]
    fn passes_double_and_keep_their_time() {
        let ms = Duration::from_millis;
        let mut done = 1;
        let mut passes = Vec::new();
        while done < 64 {
            let samples = Pace::samples(done, 64, (1, ms(10)));
            passes.push(samples);
            done += samples;
        }
        assert_eq!(passes, [1, 2, 4, 8, 15, 15, 15, 3]);
        assert_eq!(Pace::samples(1, 64, (1, ms(5000))), 1);
        assert_eq!(Pace::samples(16, 4096, (8, Duration::ZERO)), 16);
    }
}
