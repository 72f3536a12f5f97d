//! The mane: locks in relief on the back of the neck, and the forelock between the ears.

use glam::DVec3;

use super::loft::Nearest;
use super::sdf::smooth_step;

/// Number of locks per unit of the neck's spine parameter (about 7 mm).
const LOCKS: f64 = 1.05;
/// Thickness of the mane, millimetres.
const THICKNESS: f64 = 1.5;
/// How much further each lock reaches than the mean: the hand of the carver.
const HAND: [f64; 7] = [0.0, 0.09, -0.05, 0.05, -0.08, 0.1, -0.02];

/// Lays the mane over the neck's distance `d`.
///
/// Hair falls from the crest: a lock is a band between two lines t + fall(way down from the crest) = const. Each lock overlaps
/// the next like a shingle and ends in a point on the side of the neck.
#[must_use]
pub fn over(d: f64, near: &Nearest, [depth, width, _]: [f64; 3], aside: f64) -> f64 {
    if d > 4.0 {
        return d - 1.0;
    }
    // 0 on the crest, 1 at the middle of the side, 2 at the throat.
    let down = libm::atan2(aside / width, near.across / depth) * 2.0 / std::f64::consts::PI;
    let lock = (near.t + 0.55 * down + 0.95 * down * down) * LOCKS;
    let number = libm::floor(lock);
    let w = lock - number;
    let reach = HAND[(number as usize) % HAND.len()];
    // Where the lock ends: its point reaches furthest.
    let side = (2.0 * w - 1.0).abs();
    let end = 1.0 + reach * (1.0 - side) - 0.42 * side * libm::sqrt(side);
    let cover =
        smooth_step(end + 0.08, end - 0.18, down) * smooth_step(0.8, 1.5, near.t) * smooth_step(6.98, 6.6, near.t);
    // A shingle: thick in its upper part, thin where the next one lies over it; three strands.
    let shingle = 0.3 + 0.7 * smooth_step(0.0, 0.3, w) * smooth_step(1.0, 0.2, w);
    let strands = -0.09 * libm::cos(w * 4.0 * std::f64::consts::TAU);
    // The groove that runs down the side of the throat.
    let groove = 0.4
        * libm::exp(-(down - 1.4) * (down - 1.4) / 0.02)
        * smooth_step(1.2, 3.0, near.t)
        * smooth_step(6.0, 4.5, near.t);
    d + groove - cover * THICKNESS * (shingle + strands)
}

/// Lays the forelock over the head's distance `d`: pointed locks that fall from between the ears over the brow. `h` is in the
/// head's frame.
#[must_use]
pub fn forelock(h: DVec3, d: f64) -> f64 {
    if h.x > 12.0 || h.y < 2.0 || d > 4.0 {
        return d;
    }
    let lock = h.z / (0.75 + 0.13 * h.x.max(0.0)) * 0.62 + 0.5;
    // Beyond the middle of each side's lock the hair thins out.
    let w = if lock < 1.5 { lock - libm::floor(lock) } else { 0.5 };
    let side = (2.0 * w - 1.0).abs();
    let thin = smooth_step(2.9, 1.5, lock);
    let strands = -0.09 * libm::cos(w * 2.0 * std::f64::consts::TAU);
    let end = 9.8 - 1.2 * lock - 3.8 * side * libm::sqrt(side);
    let cover = smooth_step(end + 0.3, end - 1.2, h.x) * smooth_step(3.4, 5.0, h.y) * smooth_step(4.4, 2.0, h.z);
    let swell = smooth_step(-3.0, 1.5, h.x);
    d - cover * swell * thin * (0.5 + 0.45 * (1.0 - side * side) + strands)
}
