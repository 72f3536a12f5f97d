//! Amdahl's law: what part of the work does not get faster with more threads.

use crate::statistics::Line;
use serde::{Deserialize, Serialize};

/// T(n) = T(1) (s + (1 - s) / n), with the serial share s (G. M. Amdahl, Validity of the Single Processor Approach to
/// Achieving Large Scale Computing Capabilities, 1967).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Amdahl {
    /// The scene, by its id.
    pub scene: String,
    /// The numbers of threads that it was fitted to: those that the machine has cores for.
    pub fitted_threads: Vec<u32>,
    /// T(1) of the law, in milliseconds.
    pub one_thread_ms: f64,
    /// s, from 0 to 1.
    pub serial_share: f64,
}

impl Amdahl {
    /// The law that fits the times best: the least squares of a + b / n, of which a is the serial part. A share below 0,
    /// which noise and larger caches can make, is told as 0.
    ///
    /// `points` are threads and milliseconds; those beyond `cores` are left out, for the law knows no waiting in line.
    /// `None` unless two different numbers remain.
    #[must_use]
    pub fn fit(scene: &str, points: &[(u32, f64)], cores: u32) -> Option<Self> {
        let fitted: Vec<&(u32, f64)> = points.iter().filter(|(threads, _)| (1..=cores).contains(threads)).collect();
        let inverse: Vec<(f64, f64)> = fitted.iter().map(|&&(n, ms)| (1.0 / f64::from(n), ms)).collect();
        let Line { intercept: serial, slope: parallel } = Line::fit(&inverse)?;
        let one_thread_ms = serial + parallel;
        let share = serial / one_thread_ms;
        share.is_finite().then(|| Self {
            scene: scene.to_owned(),
            fitted_threads: fitted.iter().map(|(threads, _)| *threads).collect(),
            one_thread_ms,
            serial_share: share.clamp(0.0, 1.0),
        })
    }

    /// How many times as fast `threads` threads are as one.
    #[must_use]
    pub fn speed_up(&self, threads: f64) -> f64 {
        1.0 / (self.serial_share + (1.0 - self.serial_share) / threads)
    }

    /// The speed-up that no number of threads reaches; `None` if there is no such limit.
    #[must_use]
    pub fn limit(&self) -> Option<f64> {
        (self.serial_share > 0.0).then(|| 1.0 / self.serial_share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn times(share: f64, counts: &[u32]) -> Vec<(u32, f64)> {
        counts.iter().map(|&n| (n, 200.0 * (share + (1.0 - share) / f64::from(n)))).collect()
    }

    #[test]
    fn a_known_serial_share_is_found_again() {
        for share in [0.0, 0.01, 0.25, 1.0] {
            let law = Amdahl::fit("x", &times(share, &[1, 2, 4, 8, 12]), 12).unwrap();
            assert!((law.serial_share - share).abs() < 1e-12, "{share}: {law:?}");
            assert!((law.one_thread_ms - 200.0).abs() < 1e-9);
        }
        let law = Amdahl::fit("x", &times(0.25, &[1, 2]), 2).unwrap();
        assert!((law.speed_up(2.0) - 1.6).abs() < 1e-12, "1 / (0.25 + 0.75 / 2)");
        assert!((law.limit().unwrap() - 4.0).abs() < 1e-12);
    }

    #[test]
    fn noise_is_averaged_over_all_counts() {
        let mut points = times(0.1, &[1, 2, 4, 8]);
        for (place, (_, ms)) in points.iter_mut().enumerate() {
            *ms *= if place % 2 == 0 { 1.01 } else { 0.99 };
        }
        let law = Amdahl::fit("x", &points, 8).unwrap();
        assert!((law.serial_share - 0.1).abs() < 0.02, "{law:?}");
    }

    #[test]
    fn threads_without_a_core_do_not_count() {
        let mut points = times(0.1, &[1, 2]);
        points.extend([(4, 500.0), (64, 9000.0)]);
        let law = Amdahl::fit("x", &points, 2).unwrap();
        assert!((law.serial_share - 0.1).abs() < 1e-12);
        assert_eq!(law.fitted_threads, [1, 2]);
    }

    #[test]
    fn better_than_perfect_is_told_as_no_serial_share() {
        let law = Amdahl::fit("x", &[(1, 100.0), (2, 45.0)], 2).unwrap();
        assert_eq!((law.serial_share, law.limit()), (0.0, None));
    }

    #[test]
    fn one_count_has_no_law() {
        assert_eq!(Amdahl::fit("x", &[(1, 100.0), (4, 30.0)], 2), None);
        assert_eq!(Amdahl::fit("x", &[], 2), None);
    }
}
