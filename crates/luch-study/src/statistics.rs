//! Numbers about numbers: quartiles, straight lines.

use serde::{Deserialize, Serialize};

/// What a list of times is like.
///
/// Quartiles are those of Hyndman and Fan's definition 7 (Sample Quantiles in Statistical Packages, 1996), which NumPy, R
/// and spreadsheets use: the value at the place (n - 1) p of the sorted list, from 0, between two values in proportion.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Summary {
    /// Half of the values are not larger.
    pub median: f64,
    /// A quarter of the values are not larger.
    pub lower_quartile: f64,
    /// Three quarters of the values are not larger.
    pub upper_quartile: f64,
    /// The smallest.
    pub minimum: f64,
    /// The largest.
    pub maximum: f64,
}

impl Summary {
    /// Of a list; `None` if it is empty or holds what is no number.
    #[must_use]
    pub fn of(values: &[f64]) -> Option<Self> {
        if values.iter().any(|v| !v.is_finite()) {
            return None;
        }
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        Some(Self {
            median: quantile(&sorted, 0.5)?,
            lower_quartile: quantile(&sorted, 0.25)?,
            upper_quartile: quantile(&sorted, 0.75)?,
            minimum: *sorted.first()?,
            maximum: *sorted.last()?,
        })
    }
}

/// The quantile `p` (0 to 1) of a sorted list; `None` if it is empty.
fn quantile(sorted: &[f64], p: f64) -> Option<f64> {
    let place = sorted.len().checked_sub(1)? as f64 * p;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a place in the list")]
    let below = place.floor() as usize;
    let low = *sorted.get(below)?;
    let high = *sorted.get(below + 1).unwrap_or(&low);
    Some(low + (high - low) * (place - below as f64))
}

/// A straight line, y = intercept + slope x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// y at x = 0.
    pub intercept: f64,
    /// How y grows with x.
    pub slope: f64,
}

impl Line {
    /// The line with the least sum of squared distances in y; `None` unless there are two different x.
    #[must_use]
    pub fn fit(points: &[(f64, f64)]) -> Option<Self> {
        let count = points.len() as f64;
        let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / count;
        let (x0, y0) = (mean(|p| p.0), mean(|p| p.1));
        let sum = |of: &dyn Fn(f64, f64) -> f64| points.iter().map(|&(x, y)| of(x - x0, y - y0)).sum::<f64>();
        let (xx, xy) = (sum(&|x, _| x * x), sum(&|x, y| x * y));
        let slope = xy / xx;
        // Also where there are no points, and every mean is NaN.
        slope.is_finite().then_some(Self { intercept: y0 - slope * x0, slope })
    }

    /// The exponent of the power law y = c x^e that fits best where both axes are logarithmic; `None` unless there are two
    /// different positive x with positive y.
    #[must_use]
    pub fn power_law(points: &[(f64, f64)]) -> Option<f64> {
        let positive = points.iter().filter(|(x, y)| *x > 0.0 && *y > 0.0);
        let logs: Vec<(f64, f64)> = positive.map(|(x, y)| (x.ln(), y.ln())).collect();
        Self::fit(&logs).map(|line| line.slope)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quartiles_of_lists_worked_out_by_hand() {
        let of = |values: &[f64]| {
            let s = Summary::of(values).unwrap();
            [s.minimum, s.lower_quartile, s.median, s.upper_quartile, s.maximum]
        };
        // Places 0, 0.75, 1.5, 2.25 and 3 of 1, 2, 3, 10.
        assert_eq!(of(&[10.0, 3.0, 1.0, 2.0]), [1.0, 1.75, 2.5, 4.75, 10.0]);
        // Places 0, 1, 2, 3 and 4.
        assert_eq!(of(&[5.0, 4.0, 3.0, 2.0, 1.0]), [1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!(of(&[7.0]), [7.0; 5]);
        assert_eq!(of(&[1.0, 2.0]), [1.0, 1.25, 1.5, 1.75, 2.0]);
    }

    #[test]
    fn lists_that_have_no_summary() {
        assert_eq!(Summary::of(&[]), None);
        assert_eq!(Summary::of(&[1.0, f64::NAN]), None);
        assert_eq!(Summary::of(&[f64::INFINITY]), None);
    }

    #[test]
    fn a_line_is_found_and_the_noise_averaged() {
        let line = Line::fit(&[(0.0, 1.0), (1.0, 3.0), (2.0, 5.0)]).unwrap();
        assert_eq!((line.intercept, line.slope), (1.0, 2.0));
        // By hand: means 1 and 2, sums of products 2 and 2.
        let line = Line::fit(&[(0.0, 1.0), (1.0, 2.0), (2.0, 3.0), (1.0, 2.0)]).unwrap();
        assert_eq!((line.intercept, line.slope), (1.0, 1.0));
        assert_eq!(Line::fit(&[(1.0, 1.0), (1.0, 2.0)]), None);
        assert_eq!(Line::fit(&[]), None);
    }

    #[test]
    fn a_power_law_has_its_exponent() {
        let points: Vec<(f64, f64)> = [1.0, 4.0, 16.0, 64.0].map(|x: f64| (x, 3.0 * x.powf(-0.5))).to_vec();
        assert!((Line::power_law(&points).unwrap() + 0.5).abs() < 1e-12);
        assert_eq!(Line::power_law(&[(1.0, 0.0), (2.0, 1.0)]), None);
    }
}
