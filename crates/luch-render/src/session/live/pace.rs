//! How much to do at once: resolutions of previews and samples of passes, from what earlier pictures cost.

use super::mailbox::LiveRequest;
use crate::integrator::Integrator;
use std::time::Duration;

/// A whole picture that is expected within this time needs no preview; one that needs it gets one of about this time.
const FIRST_PICTURE: Duration = Duration::from_millis(10);
/// Passes that refine a picture take about as long.
const PASS: Duration = Duration::from_millis(150);
/// Thread-seconds for a ray of a picture that nothing is known of: a heavy scene's.
const UNKNOWN: f64 = 1e-6;
/// Sides of the blocks of one preview and the next: six times the rays.
const LADDER: f64 = 2.5;
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
    /// Thread-seconds for a ray of a preview, which is far from its neighbours.
    block: Option<f64>,
    /// Thread-seconds for a ray at full resolution.
    pixel: Option<f64>,
    /// The last resolution chosen.
    shrink: u32,
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

    /// The resolutions to show before the full one, coarsest first, each as the side of its blocks.
    pub(super) fn previews(&mut self, kind: &Kind, [width, height]: [u32; 2], threads: usize) -> Vec<u32> {
        let parallel = threads.clamp(1, self.cores) as f64;
        let known = self.of(kind);
        let pixels = f64::from(width) * f64::from(height) / parallel;
        let block = known.block.or(known.pixel).unwrap_or(UNKNOWN) * pixels;
        let full = known.pixel.or(known.block).unwrap_or(UNKNOWN) * pixels;
        let budget = FIRST_PICTURE.as_secs_f64();
        let first = if full <= budget { 1 } else { steady(known.shrink, block, budget) };
        let first = first.min((width.max(height) / SMALLEST_SIDE).max(1));
        known.shrink = first;
        ladder(first)
    }

    /// Samples of the next pass, after one of `last.0` samples that took `last.1`.
    pub(super) fn samples(done: u32, wanted: u32, last: (u32, Duration)) -> u32 {
        let each = last.1.as_secs_f64() / f64::from(last.0.max(1));
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast of a float saturates")]
        let affordable = (PASS.as_secs_f64() / each.max(1e-9)) as u32;
        affordable.min(done).clamp(1, (wanted - done).max(1))
    }

    /// Learns from a pass: `rays` rays through pixels or blocks were done in that time. What was cut short is at least
    /// as dear as it looks.
    pub(super) fn learn(&mut self, kind: &Kind, preview: bool, rays: u64, threads: usize, took: Duration, whole: bool) {
        let parallel = threads.clamp(1, self.cores) as f64;
        let measured = took.as_secs_f64() * parallel / (rays.max(1) as f64);
        let known = self.of(kind);
        let cost = if preview { &mut known.block } else { &mut known.pixel };
        *cost = Some(match *cost {
            None => measured,
            Some(old) if !whole => measured.clamp(old, old * 8.0),
            // One measurement may be off by whatever else the machine does.
            Some(old) => old * 0.6 + measured.clamp(old * 0.5, old * 3.0) * 0.4,
        });
    }

    fn of(&mut self, kind: &Kind) -> &mut Known {
        let at = self.known.iter().position(|known| known.kind == *kind);
        let known = match at {
            Some(at) => self.known.remove(at),
            None => Known { kind: kind.clone(), block: None, pixel: None, shrink: 0 },
        };
        self.known.truncate(KINDS - 1);
        self.known.insert(0, known);
        &mut self.known[0]
    }
}

/// The side of blocks at which a preview keeps within the budget, if the full resolution of it takes `block` seconds. The
/// last one is kept while it nearly fits, so that the picture does not flicker between two resolutions.
fn steady(last: u32, block: f64, budget: f64) -> u32 {
    let time = |shrink: u32| block / f64::from(shrink).powi(2);
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a cast of a float saturates")]
    let fitting = ((block / budget).sqrt().ceil() as u32).max(2);
    let nearly = last >= 2 && time(last) <= budget * 1.25 && (last <= fitting || time(last - 1) > budget * 0.8);
    if nearly { last } else { fitting }
}

/// From a coarse resolution to the full one.
fn ladder(first: u32) -> Vec<u32> {
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "smaller than a u32")]
    let finer = |shrink: &u32| Some((f64::from(*shrink) / LADDER) as u32);
    std::iter::successors(Some(first), finer).take_while(|&shrink| shrink > 1).collect()
}
