//! The plot of time against triangles.

use super::{Axis, Chart, Maker, Panel, Series, Style, heights, places, point, sorted};
use crate::findings::Grows;

impl Maker<'_> {
    pub(super) fn triangles(&self) -> Vec<Chart> {
        let (text, numbers, cases) = (self.text, &self.text.numbers, &self.findings.cases);
        let series = |of: Grows, what: &str, color, points| {
            let exponent = self.findings.exponents.iter().find(|e| e.of == of);
            let label = exponent.map(|e| (text.power_series)(what, &numbers.fixed(e.exponent, 2)));
            Series {
                label: label.unwrap_or_else(|| what.to_owned()),
                color: Some(color),
                style: Style::Measured,
                points: sorted(points),
            }
        };
        let build = cases.iter().filter_map(|c| Some(point(c.triangles as f64, c.build.as_ref()?))).collect();
        let render = cases.iter().map(|c| point(c.triangles as f64, &c.render)).collect();
        let series = vec![series(Grows::Build, text.build, 0, build), series(Grows::Render, text.render, 1, render)];
        let x = Axis::logarithmic(text.triangles, &places(&series), numbers);
        let y = Axis::logarithmic(text.time_axis, &heights(&series), numbers);
        vec![self.chart("triangles", text.plot_triangles, vec![Panel { title: None, x, y, series, shaded: None }])]
    }
}
