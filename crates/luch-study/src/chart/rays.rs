//! The plots of time and noise against rays per pixel.

use super::{Axis, Chart, Maker, Panel, Point, Series, heights, places, point};
use crate::findings::{CaseFindings, Grows};

impl Maker<'_> {
    pub(super) fn rays(&self) -> Vec<Chart> {
        let text = self.text;
        let rays = |case: &CaseFindings| f64::from(case.rays_per_pixel);
        let time = self.measured(|case| Some(point(rays(case), &case.render)));
        let noise = self.measured(|case| {
            // No noise at all has no place on a logarithmic axis.
            let y = case.noise_rmse.filter(|noise| *noise > 0.0)?;
            Some(Point { x: rays(case), y, bar: None })
        });
        [
            (Grows::Render, "rays-time", text.plot_rays_time, text.render_time_axis, time),
            (Grows::Noise, "rays-noise", text.plot_rays_noise, text.noise_axis, noise),
        ]
        .into_iter()
        .filter(|(.., series)| !series.is_empty())
        .map(|(grows, stem, title, label, series)| self.power(grows, (stem, title), label, series))
        .collect()
    }

    /// A plot with two logarithmic axes, in which a power law is a straight line; the legend has the exponents.
    fn power(&self, of: Grows, (stem, title): (&'static str, &str), label: &str, mut series: Vec<Series>) -> Chart {
        let (text, numbers) = (self.text, &self.text.numbers);
        for series in &mut series {
            let scene = self.scenes().find(|(number, _)| Some(*number) == series.color).map(|(_, id)| id);
            let exponent = self.findings.exponents.iter().find(|e| e.of == of && e.scene.as_deref() == scene);
            if let Some(exponent) = exponent {
                series.label = (text.power_series)(&series.label, &numbers.fixed(exponent.exponent, 2));
            }
        }
        let x = Axis::of_values(text.rays_per_pixel, &places(&series), numbers);
        let y = Axis::logarithmic(label, &heights(&series), numbers);
        self.chart(stem, title, vec![Panel { title: None, x, y, series, shaded: None }])
    }
}
