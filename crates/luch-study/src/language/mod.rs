//! The languages of reports and plots: every text stands in `Text`, once for each language.

mod english;
mod numbers;
mod russian;

pub(crate) use numbers::Numbers;

use crate::findings::Grows;
use crate::plan::{Effect, Kind};
use crate::plan_error::PlanError;

/// A language that people read reports in.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// Russian.
    Russian,
}

impl Language {
    /// Every language.
    pub const ALL: [Self; 2] = [Self::English, Self::Russian];

    /// Its code, as `en`.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Self::English => "en",
            Self::Russian => "ru",
        }
    }

    /// The language of that code.
    #[must_use]
    pub fn from_word(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.word() == word)
    }

    /// The system's language: that of the first of `LC_ALL`, `LC_MESSAGES` and `LANG` that is set and not empty, as POSIX
    /// has it. English where that is a language which is not here.
    #[must_use]
    pub fn of_system(variable: impl Fn(&str) -> Option<String>) -> Self {
        let set = ["LC_ALL", "LC_MESSAGES", "LANG"].into_iter().filter_map(variable).find(|value| !value.is_empty());
        // ru_RU.UTF-8, ru-RU, ru: the language ends at what is no letter.
        let locale = set.unwrap_or_default();
        let word = locale.split(|c: char| !c.is_ascii_alphabetic()).next().unwrap_or_default().to_ascii_lowercase();
        Self::from_word(&word).unwrap_or_default()
    }

    pub(crate) const fn text(self) -> &'static Text {
        match self {
            Self::English => &english::TEXT,
            Self::Russian => &russian::TEXT,
        }
    }
}

/// Every text of a language. A language that lacks one does not compile.
///
/// Texts with numbers in them get these written already, as the language writes them.
pub(crate) struct Text {
    pub(crate) numbers: Numbers,

    /// The name of a built-in scene.
    pub(crate) scene: fn(id: &str) -> Option<&'static str>,
    pub(crate) title: fn(Kind) -> &'static str,
    pub(crate) effect: fn(Effect) -> &'static str,

    /// What is wrong with a plan.
    pub(crate) plan_error: fn(&PlanError) -> String,

    // Headings.
    pub(crate) found: &'static str,
    pub(crate) results: &'static str,
    pub(crate) growth: &'static str,
    pub(crate) published: &'static str,
    pub(crate) method: &'static str,
    pub(crate) machine: &'static str,

    // What is measured: columns and axes.
    pub(crate) threads: &'static str,
    pub(crate) threads_started: &'static str,
    pub(crate) triangles: &'static str,
    pub(crate) rays_per_pixel: &'static str,
    pub(crate) tile_side: &'static str,
    pub(crate) tile_side_axis: &'static str,
    pub(crate) median_ms: &'static str,
    pub(crate) quartiles_ms: &'static str,
    pub(crate) minimum_ms: &'static str,
    pub(crate) cpu_ms: &'static str,
    pub(crate) build_ms: &'static str,
    pub(crate) speed_up: &'static str,
    pub(crate) efficiency: &'static str,
    pub(crate) over_cores: &'static str,
    pub(crate) over_best: &'static str,
    pub(crate) mray_per_s: &'static str,
    pub(crate) noise: &'static str,
    pub(crate) growth_percent: &'static str,
    pub(crate) time_axis: &'static str,
    pub(crate) render_time_axis: &'static str,
    pub(crate) noise_axis: &'static str,
    pub(crate) speed_up_axis: &'static str,
    pub(crate) mean: &'static str,
    pub(crate) ms: &'static str,

    // Titles of plots and what is in them.
    pub(crate) plot_threads_all: &'static str,
    pub(crate) plot_threads_from_2: &'static str,
    pub(crate) plot_speed_up: &'static str,
    pub(crate) plot_triangles: &'static str,
    pub(crate) plot_rays_time: &'static str,
    pub(crate) plot_rays_noise: &'static str,
    pub(crate) plot_tiles: &'static str,
    pub(crate) ours: &'static str,
    pub(crate) build: &'static str,
    pub(crate) render: &'static str,
    pub(crate) perfect: &'static str,
    pub(crate) published_series: fn(scene: &str) -> String,
    pub(crate) published_panel: fn(cpu: &str) -> String,
    pub(crate) law_series: fn(scene: &str) -> String,
    pub(crate) power_series: fn(what: &str, exponent: &str) -> String,
    pub(crate) more_than_cores: fn(cores: &str) -> String,
    pub(crate) bars: &'static str,
    pub(crate) partial_short: &'static str,

    // The machine.
    pub(crate) processor: &'static str,
    pub(crate) cores: &'static str,
    pub(crate) hardware_threads: &'static str,
    pub(crate) usable_threads: &'static str,
    pub(crate) memory: &'static str,
    pub(crate) gibibytes: fn(&str) -> String,
    pub(crate) simd: &'static str,
    pub(crate) system: &'static str,
    pub(crate) program: &'static str,
    pub(crate) release: &'static str,
    pub(crate) debug: &'static str,
    pub(crate) load: &'static str,
    pub(crate) began: &'static str,
    pub(crate) unknown: &'static str,
    /// A machine in few words, for the foot of a plot.
    pub(crate) cores_short: fn(count: u32) -> String,

    // Sentences.
    pub(crate) partial: &'static str,
    pub(crate) debug_build: &'static str,
    pub(crate) busy: fn(load: &str) -> String,
    pub(crate) found_speed_up: fn(&SpeedUp<'_>) -> String,
    pub(crate) found_law: fn(scene: &str, percent: &str, limit: Option<&str>) -> String,
    pub(crate) found_growth: fn(from: &str, to: &str, percent: &str) -> String,
    pub(crate) found_over_cores: fn(cores: u32, percent: &str) -> String,
    pub(crate) found_exponent: fn(Grows, scene: Option<&str>, exponent: &str) -> String,
    pub(crate) found_best_tile: fn(scene: &str, side: u32, ms: &str) -> String,
    pub(crate) published_best: fn(scene: &str, speed_up: &str) -> String,
    pub(crate) published_caveat: fn(cpu: &str, cores: u32, threads: u32) -> String,
    pub(crate) method_time: &'static str,
    pub(crate) method_build: &'static str,
    pub(crate) method_picture: fn(size: [u32; 2], simd: &str) -> String,
    pub(crate) method_threads: fn(threads: u32) -> String,
    pub(crate) method_runs: fn(warm_up: u32, runs: u32) -> String,
    pub(crate) method_quartiles: &'static str,
    pub(crate) method_started: &'static str,
    pub(crate) method_law: fn(threads: &str) -> String,
    pub(crate) method_law_exact: &'static str,
    pub(crate) method_efficiency: &'static str,
    pub(crate) method_over_cores: fn(threads: u32, cores: u32) -> String,
    pub(crate) method_noise: fn(effect: &str, reference: u32) -> String,
    pub(crate) method_exponent: &'static str,
    pub(crate) method_meshes: &'static str,
    pub(crate) more: &'static str,
}

/// What more threads brought.
pub(crate) struct SpeedUp<'a> {
    pub(crate) scene: &'a str,
    pub(crate) one_ms: &'a str,
    pub(crate) threads: u32,
    pub(crate) ms: &'a str,
    pub(crate) speed_up: &'a str,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_language_of_the_system_is_that_of_the_first_variable_that_is_set() {
        let of = |variables: &[(&str, &str)]| {
            Language::of_system(|name| variables.iter().find(|(n, _)| *n == name).map(|(_, v)| (*v).to_owned()))
        };
        assert_eq!(of(&[]), Language::English);
        assert_eq!(of(&[("LANG", "ru_RU.UTF-8")]), Language::Russian);
        assert_eq!(of(&[("LC_MESSAGES", "ru"), ("LANG", "en_GB")]), Language::Russian);
        assert_eq!(of(&[("LC_ALL", "C"), ("LANG", "ru_RU.UTF-8")]), Language::English);
        assert_eq!(of(&[("LC_ALL", ""), ("LANG", "ru-RU")]), Language::Russian, "empty is not set");
        assert_eq!(of(&[("LANG", "run_XX")]), Language::English);
        assert_eq!(of(&[("LANG", "de_DE.UTF-8")]), Language::English);
    }

    #[test]
    fn words_are_read_back() {
        for language in Language::ALL {
            assert_eq!(Language::from_word(language.word()), Some(language));
        }
        assert_eq!(Language::from_word("EN"), None);
    }
}
