//! The published study that ours is set beside: the same two scenes in another program.

use serde::{Deserialize, Serialize};

/// Times as they were published.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Published {
    /// The processor.
    pub cpu: String,
    /// Its cores.
    pub cores: u32,
    /// Threads that it runs at the same time.
    pub hardware_threads: u32,
    /// Width and height of the pictures: not stated.
    pub size: Option<[u32; 2]>,
    /// What was measured.
    pub times: Vec<PublishedTime>,
    /// How much longer the second sphere took, over all numbers of threads, as it was published.
    pub growth_percent: f64,
}

/// Times for one number of threads.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct PublishedTime {
    /// Threads.
    pub threads: u32,
    /// Milliseconds for the scene with one sphere.
    pub one_sphere_ms: f64,
    /// Milliseconds for the scene with two spheres.
    pub two_spheres_ms: f64,
}

impl Published {
    /// The study as published.
    #[must_use]
    pub fn study() -> Self {
        let time = |threads, one_sphere_ms, two_spheres_ms| PublishedTime { threads, one_sphere_ms, two_spheres_ms };
        Self {
            cpu: "Intel Core i7-12700KF".to_owned(),
            cores: 12,
            hardware_threads: 20,
            size: None,
            times: vec![
                time(1, 626.01, 694.57),
                time(2, 206.82, 225.64),
                time(20, 205.92, 223.79),
                time(64, 207.43, 225.96),
            ],
            growth_percent: 8.4,
        }
    }

    /// Threads and milliseconds of one of the scenes; `None` for a scene that was not published.
    #[must_use]
    pub fn times_of(&self, scene: &str) -> Option<Vec<(u32, f64)>> {
        let of: fn(&PublishedTime) -> f64 = match scene {
            "one-sphere" => |time| time.one_sphere_ms,
            "two-spheres" => |time| time.two_spheres_ms,
            _ => return None,
        };
        Some(self.times.iter().map(|time| (time.threads, of(time))).collect())
    }

    /// The best speed-up against one thread that was published for a scene.
    #[must_use]
    pub fn best_speed_up(&self, scene: &str) -> Option<f64> {
        let times = self.times_of(scene)?;
        let one = times.iter().find(|(threads, _)| *threads == 1)?.1;
        times.iter().map(|(_, ms)| one / ms).max_by(f64::total_cmp)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_published_speed_up_stops_at_three() {
        let published = Published::study();
        for scene in crate::Subject::SPHERES {
            let best = published.best_speed_up(scene).unwrap();
            assert!((3.0..3.2).contains(&best), "{scene}: {best}");
        }
        assert_eq!(published.times_of("chess"), None);
    }
}
