//! Axes: their range, and round numbers along them.

use crate::language::Numbers;

/// How places on an axis follow from numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// In proportion.
    Linear,
    /// In proportion to the logarithm.
    Logarithmic,
}

/// A number written beside an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Tick {
    /// The number.
    pub at: f64,
    /// As it is written.
    pub label: String,
}

/// An axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    /// What is along it, with its unit.
    pub label: String,
    /// How places follow from numbers.
    pub scale: Scale,
    /// Where it begins.
    pub low: f64,
    /// Where it ends.
    pub high: f64,
    /// From low to high.
    pub ticks: Vec<Tick>,
}

/// Room at both ends of an axis, as a share of its length.
const MARGIN: f64 = 0.05;
/// The least distance of two ticks of [`Axis::of_values`], as a share of the axis: nearer labels would touch.
const APART: f64 = 0.04;

impl Axis {
    /// Where a number lies: 0 at the beginning, 1 at the end.
    #[must_use]
    pub fn place(&self, value: f64) -> f64 {
        let along = |v: f64| self.scale.along(v);
        (along(value) - along(self.low)) / (along(self.high) - along(self.low))
    }

    /// A logarithmic axis whose ticks are the values themselves, as far as there is room.
    pub(super) fn of_values(label: &str, values: &[f64], numbers: &Numbers) -> Self {
        let mut axis = Self::empty(label, Scale::Logarithmic, values);
        for &at in values {
            let after = axis.ticks.last().is_none_or(|last| axis.place(at) - axis.place(last.at) >= APART);
            if after {
                axis.ticks.push(Tick { at, label: numbers.short(at) });
            }
        }
        axis
    }

    /// A logarithmic axis with round numbers.
    pub(super) fn logarithmic(label: &str, values: &[f64], numbers: &Numbers) -> Self {
        let mut axis = Self::empty(label, Scale::Logarithmic, values);
        let decades = axis.high.log10() - axis.low.log10();
        let steps: &[f64] = match decades {
            d if d > 4.0 => &[1.0],
            d if d > 2.0 => &[1.0, 3.0],
            d if d > 1.0 => &[1.0, 2.0, 5.0],
            _ => &[1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0],
        };
        #[allow(clippy::cast_possible_truncation, reason = "the exponents of what people measure")]
        let exponents = axis.low.log10().floor() as i32..=axis.high.log10().ceil() as i32;
        let round = exponents.flat_map(|e| steps.iter().map(move |step| step * 10_f64.powi(e)));
        let inside = round.filter(|at| (axis.low..=axis.high).contains(at));
        axis.ticks = inside.map(|at| Tick { at, label: numbers.short(at) }).collect();
        if axis.ticks.len() < 2 {
            // So short an axis is nearly straight.
            axis.ticks = ticks(axis.low, axis.high, numbers);
        }
        axis
    }

    /// A straight axis from 0.
    pub(super) fn from_zero(label: &str, values: &[f64], numbers: &Numbers) -> Self {
        let high = values.iter().copied().fold(0.0, f64::max) * (1.0 + 2.0 * MARGIN);
        let (low, high) = if high > 0.0 { (0.0, high) } else { (0.0, 1.0) };
        Self { label: label.to_owned(), scale: Scale::Linear, low, high, ticks: ticks(low, high, numbers) }
    }

    /// A straight axis around the values. It spans a tenth of them at least, so that noise does not look like a mountain.
    pub(super) fn around(label: &str, values: &[f64], numbers: &Numbers) -> Self {
        let [least, most] = extremes(values);
        let span = (most - least).max(0.1 * most);
        let middle = (least + most) / 2.0;
        let (low, high) = (middle - span * (0.5 + MARGIN), middle + span * (0.5 + MARGIN));
        Self { label: label.to_owned(), scale: Scale::Linear, low, high, ticks: ticks(low, high, numbers) }
    }

    /// An axis that holds the values and has no ticks yet.
    fn empty(label: &str, scale: Scale, values: &[f64]) -> Self {
        let [least, most] = extremes(values);
        let (from, to) = (scale.along(least), scale.along(most));
        // One value alone is given room.
        let margin = if to > from { (to - from) * MARGIN } else { 0.5 };
        let (low, high) = (scale.back(from - margin), scale.back(to + margin));
        Self { label: label.to_owned(), scale, low, high, ticks: Vec::new() }
    }
}

impl Scale {
    fn along(self, value: f64) -> f64 {
        match self {
            Self::Linear => value,
            Self::Logarithmic => value.max(f64::MIN_POSITIVE).ln(),
        }
    }

    fn back(self, along: f64) -> f64 {
        match self {
            Self::Linear => along,
            Self::Logarithmic => along.exp(),
        }
    }
}

/// The least and the largest value; 1 and 1 if there are none.
fn extremes(values: &[f64]) -> [f64; 2] {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if least <= most { [least, most] } else { [1.0, 1.0] }
}

/// Four to ten round numbers between two, at the same distance.
fn ticks(low: f64, high: f64, numbers: &Numbers) -> Vec<Tick> {
    const ABOUT: f64 = 6.0;
    let rough = (high - low) / ABOUT;
    let unit = 10_f64.powf(rough.log10().floor());
    let step = [1.0, 2.0, 2.5, 5.0, 10.0].map(|s| s * unit).into_iter().find(|s| *s >= rough).unwrap_or(unit * 10.0);
    #[allow(clippy::cast_possible_truncation, reason = "a handful of steps")]
    let steps = (low / step).ceil() as i64..=(high / step).floor() as i64;
    steps.map(|i| i as f64 * step).map(|at| Tick { at, label: numbers.short(at) }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::language::Language;

    fn labels(axis: &Axis) -> Vec<&str> {
        axis.ticks.iter().map(|tick| tick.label.as_str()).collect()
    }

    #[test]
    fn every_thread_count_of_the_published_study_has_its_tick() {
        let counts = [1.0, 2.0, 4.0, 8.0, 12.0, 16.0, 20.0, 32.0, 64.0];
        let axis = Axis::of_values("n", &counts, &Language::English.text().numbers);
        assert_eq!(labels(&axis), ["1", "2", "4", "8", "12", "16", "20", "32", "64"]);
        assert!((axis.place(8.0) - 0.5).abs() < 1e-12, "halves and doubles lie equally far");
        let close = Axis::of_values("n", &[1.0, 63.0, 64.0], &Language::English.text().numbers);
        assert_eq!(labels(&close), ["1", "63"]);
    }

    #[test]
    fn ticks_are_round_and_inside() {
        let en = &Language::English.text().numbers;
        let values = [12.0, 700.0];
        assert_eq!(labels(&Axis::logarithmic("ms", &values, en)), ["10", "20", "50", "100", "200", "500"]);
        assert_eq!(labels(&Axis::from_zero("ms", &values, en)), ["0", "200", "400", "600"]);
        assert_eq!(labels(&Axis::around("ms", &[205.0, 226.0], en)), ["205", "210", "215", "220", "225"]);
        let ru = &Language::Russian.text().numbers;
        assert_eq!(labels(&Axis::from_zero("мс", &[1.2], ru)), ["0", "0,25", "0,5", "0,75", "1", "1,25"]);
    }

    #[test]
    fn axes_of_one_value_or_none_have_two_ends_and_ticks() {
        let en = &Language::English.text().numbers;
        for values in [&[][..], &[3.0]] {
            for axis in
                [Axis::logarithmic("", values, en), Axis::from_zero("", values, en), Axis::around("", values, en)]
            {
                assert!(axis.low < axis.high && axis.ticks.len() >= 2, "{axis:?}");
            }
        }
    }
}
