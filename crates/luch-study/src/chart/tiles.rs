//! The plot of time against the size of the tiles.

use super::{Axis, Chart, Maker, Panel, heights, places, point};

impl Maker<'_> {
    pub(super) fn tiles(&self) -> Vec<Chart> {
        let (text, numbers) = (self.text, &self.text.numbers);
        let series = self.measured(|case| Some(point(f64::from(case.tile_size), &case.render)));
        let x = Axis::of_values(text.tile_side_axis, &places(&series), numbers);
        let y = Axis::from_zero(text.render_time_axis, &heights(&series), numbers);
        vec![self.chart("tiles", text.plot_tiles, vec![Panel { title: None, x, y, series, shaded: None }])]
    }
}
