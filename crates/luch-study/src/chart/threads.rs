//! The plots of time against threads.

use super::{Axis, Chart, Maker, Panel, Point, Series, Shaded, Style, heights, places, point, sorted};
use crate::amdahl::Amdahl;

/// Points of the curve of a law.
const CURVE: u32 = 64;

impl Maker<'_> {
    pub(super) fn threads(&self) -> Vec<Chart> {
        let (text, numbers) = (self.text, &self.text.numbers);
        let ours = self.measured(|case| Some(point(f64::from(case.threads), &case.render)));
        let published = self.published();
        let all: Vec<Series> = published.iter().chain(&ours).cloned().collect();
        let time = Axis::logarithmic(text.render_time_axis, &heights(&all), numbers);
        let panel = self.panel(None, time, &places(&all), all);
        let mut charts = vec![self.chart("threads-all", text.plot_threads_all, vec![panel])];
        charts.extend(self.two_and_more(&published, &ours));
        charts.extend(self.speed_up());
        charts
    }

    /// From two threads on, straight axes show what logarithms hide. Ours and the published times differ too much for one.
    fn two_and_more(&self, published: &[Series], ours: &[Series]) -> Option<Chart> {
        let (text, numbers) = (self.text, &self.text.numbers);
        let [published, ours] = [published, ours].map(from_2);
        if ours.is_empty() {
            return None;
        }
        let x = places(&published.iter().chain(&ours).cloned().collect::<Vec<_>>());
        let panel = |title: Option<String>, series: Vec<Series>| {
            let time = Axis::around(text.render_time_axis, &heights(&series), numbers);
            self.panel(title, time, &x, series)
        };
        let panels = match &self.findings.published {
            Some(study) if !published.is_empty() => vec![
                Panel { shaded: None, ..panel(Some((text.published_panel)(&study.cpu)), published) },
                panel(Some(text.ours.to_owned()), ours),
            ],
            _ => vec![panel(None, ours)],
        };
        Some(self.chart("threads-from-2", text.plot_threads_from_2, panels))
    }

    fn speed_up(&self) -> Option<Chart> {
        let (text, numbers) = (self.text, &self.text.numbers);
        let ours = self.measured(|case| {
            let summary = case.render.summary_ms;
            let y = case.speed_up?;
            // The quartiles of the time, seen from the median of one thread: a long time is a small speed-up.
            let one_ms = y * summary.median;
            let bar = Some([one_ms / summary.upper_quartile, one_ms / summary.lower_quartile]);
            Some(Point { x: f64::from(case.threads), y, bar })
        });
        let x = places(&ours);
        let most = x.last().copied()?;
        let published: Vec<Series> = self.published().iter().filter_map(relative).collect();
        let cores = self.findings.machine.cores_for_threads();
        let mut series = Vec::new();
        let perfect = curve(f64::from(cores), |threads| threads);
        series.push(Series { label: text.perfect.to_owned(), color: None, style: Style::Law, points: perfect });
        for (number, id) in self.scenes() {
            let Some(law) = self.findings.amdahl.iter().find(|law| law.scene == id) else { continue };
            // Beyond the cores the law says nothing.
            let points = curve(most.min(f64::from(cores)), |threads| Amdahl::speed_up(law, threads));
            let label = (text.law_series)(&self.scene(id));
            series.push(Series { label, color: Some(number), style: Style::Law, points });
        }
        series.extend(published);
        series.extend(ours);
        let axis = Axis::from_zero(text.speed_up_axis, &heights(&series), numbers);
        let x = places(&series.iter().filter(|s| s.style != Style::Law).cloned().collect::<Vec<_>>());
        let panel = self.panel(None, axis, &x, series);
        Some(self.chart("threads-speed-up", text.plot_speed_up, vec![panel]))
    }

    /// A panel over the numbers of threads, shaded where they outnumber the cores.
    fn panel(&self, title: Option<String>, y: Axis, threads: &[f64], series: Vec<Series>) -> Panel {
        let x = Axis::of_values(self.text.threads, threads, &self.text.numbers);
        let cores = self.findings.machine.cores_for_threads();
        let from_x = f64::from(cores);
        let label = (self.text.more_than_cores)(&cores.to_string());
        let shaded = (x.low < from_x && from_x < x.high).then_some(Shaded { from_x, label });
        Panel { title, x, y, series, shaded }
    }

    /// The published times of the scenes that are also ours.
    fn published(&self) -> Vec<Series> {
        let series = |(number, id): (usize, &str)| {
            let times = self.findings.published.as_ref()?.times_of(id)?;
            let points = times.iter().map(|&(threads, ms)| Point { x: f64::from(threads), y: ms, bar: None }).collect();
            let label = (self.text.published_series)(&self.scene(id));
            Some(Series { label, color: Some(number), style: Style::Published, points: sorted(points) })
        };
        self.scenes().filter_map(series).collect()
    }
}

/// The parts of curves from two threads on.
fn from_2(series: &[Series]) -> Vec<Series> {
    let part = |s: &Series| Series { points: s.points.iter().filter(|p| p.x >= 2.0).copied().collect(), ..s.clone() };
    series.iter().map(part).filter(|s| !s.points.is_empty()).collect()
}

/// Times as speed-ups against one thread.
fn relative(times: &Series) -> Option<Series> {
    let one = times.points.iter().find(|p| p.x == 1.0)?.y;
    let points = times.points.iter().map(|p| Point { y: one / p.y, ..*p }).collect();
    Some(Series { points, ..times.clone() })
}

/// A curve from one thread on, its points close where the axis is logarithmic.
fn curve(to: f64, speed_up: impl Fn(f64) -> f64) -> Vec<Point> {
    let at = |i: u32| to.powf(f64::from(i) / f64::from(CURVE));
    (0..=CURVE).map(at).map(|x| Point { x, y: speed_up(x), bar: None }).collect()
}
