//! Plots as plain data: what stands where, in the words of a language. Files are drawn from it ([`crate::draw`]), and a
//! window may draw it by its own means.

mod axis;
mod rays;
mod threads;
mod tiles;
mod triangles;

pub use axis::{Axis, Scale, Tick};

use crate::findings::{CaseFindings, Findings, Times};
use crate::language::{Language, Text};
use crate::plan::Kind;
use crate::report::scene_name;

/// A plot: one panel, or several below each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// The name of its files, without extension.
    pub stem: &'static str,
    /// The title.
    pub title: String,
    /// From top to bottom.
    pub panels: Vec<Panel>,
    /// What stands small below: machine, setting, what bars mean.
    pub foot: String,
}

/// A pair of axes and what is between them.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// A title of its own, where there are several.
    pub title: Option<String>,
    /// To the right.
    pub x: Axis,
    /// Upwards.
    pub y: Axis,
    /// The curves, later ones over earlier ones.
    pub series: Vec<Series>,
    /// A part that is shaded, and why.
    pub shaded: Option<Shaded>,
}

/// The part of a panel to the right of a place.
#[derive(Debug, Clone, PartialEq)]
pub struct Shaded {
    /// Where it begins.
    pub from_x: f64,
    /// What it means.
    pub label: String,
}

/// A curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// What it shows, for the legend.
    pub label: String,
    /// Series of one scene have one colour: its number, from 0; `None` is grey.
    pub color: Option<usize>,
    /// What kind of curve it is.
    pub style: Style,
    /// From left to right.
    pub points: Vec<Point>,
}

/// How a curve is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// What was measured: points with bars, joined.
    Measured,
    /// What others published: hollow points, joined by dashes.
    Published,
    /// A law: a thin dotted line.
    Law,
}

/// A place on a curve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// To the right.
    pub x: f64,
    /// Upwards: the median.
    pub y: f64,
    /// The lower and the upper quartile, if there are any.
    pub bar: Option<[f64; 2]>,
}

/// The colours of series 0, 1, ...: those of M. Okabe and K. Ito (2002) that the colour-blind tell apart, on white.
pub const COLORS: [[u8; 3]; 4] = [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167]];

/// The names of the plots that a study of a kind may have.
#[must_use]
pub const fn stems(kind: Kind) -> &'static [&'static str] {
    match kind {
        Kind::Threads => &["threads-all", "threads-from-2", "threads-speed-up"],
        Kind::Triangles => &["triangles"],
        Kind::Rays => &["rays-time", "rays-noise"],
        Kind::Tiles => &["tiles"],
    }
}

/// The plots of a study; none of what was not measured.
#[must_use]
pub fn charts(findings: &Findings, language: Language) -> Vec<Chart> {
    let maker = Maker { findings, text: language.text() };
    if findings.cases.is_empty() {
        return Vec::new();
    }
    match findings.study {
        Kind::Threads => maker.threads(),
        Kind::Triangles => maker.triangles(),
        Kind::Rays => maker.rays(),
        Kind::Tiles => maker.tiles(),
    }
}

/// What is needed to make charts.
struct Maker<'a> {
    findings: &'a Findings,
    text: &'static Text,
}

impl Maker<'_> {
    fn scene(&self, id: &str) -> String {
        scene_name(self.findings, id, self.text)
    }

    /// The number and id of each scene.
    fn scenes(&self) -> impl Iterator<Item = (usize, &str)> {
        self.findings.setting.scenes.iter().map(|scene| scene.id.as_str()).enumerate()
    }

    /// A measured series for each scene.
    fn measured(&self, point: impl Fn(&CaseFindings) -> Option<Point>) -> Vec<Series> {
        let series = |(number, id): (usize, &str)| Series {
            label: self.scene(id),
            color: Some(number),
            style: Style::Measured,
            points: sorted(self.findings.cases_of(id).filter_map(&point).collect()),
        };
        self.scenes().map(series).filter(|series| !series.points.is_empty()).collect()
    }

    fn chart(&self, stem: &'static str, title: &str, panels: Vec<Panel>) -> Chart {
        let bars = panels.iter().flat_map(|panel| &panel.series).flat_map(|s| &s.points).any(|p| p.bar.is_some());
        Chart { stem, title: title.to_owned(), panels, foot: self.foot(bars) }
    }

    fn foot(&self, bars: bool) -> String {
        let (text, Findings { machine, setting, partial, .. }) = (self.text, self.findings);
        let cpu = machine.cpu.clone().unwrap_or_else(|| machine.arch.clone());
        let [width, height] = setting.size;
        let partial = if *partial { format!("{} ", text.partial_short) } else { String::new() };
        let cores = (text.cores_short)(machine.cores_for_threads());
        let bars = if bars { format!(" {}", text.bars) } else { String::new() };
        format!("{partial}{cpu}, {cores}, {}. {width}\u{d7}{height}.{bars}", machine.simd)
    }
}

/// Times as a point of a curve.
fn point(x: f64, times: &Times) -> Point {
    let summary = times.summary_ms;
    Point { x, y: summary.median, bar: Some([summary.lower_quartile, summary.upper_quartile]) }
}

/// The points from left to right, in whatever order they were asked for.
fn sorted(mut points: Vec<Point>) -> Vec<Point> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x));
    points
}

/// All places upwards that an axis must hold.
fn heights(series: &[Series]) -> Vec<f64> {
    series
        .iter()
        .flat_map(|s| &s.points)
        .flat_map(|p| [p.y, p.bar.map_or(p.y, |b| b[0]), p.bar.map_or(p.y, |b| b[1])])
        .collect()
}

/// All places to the right that an axis must hold, each once.
fn places(series: &[Series]) -> Vec<f64> {
    let mut places: Vec<f64> = series.iter().flat_map(|s| &s.points).map(|p| p.x).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    places
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples;

    #[test]
    fn each_study_has_its_plots_in_both_languages() {
        for language in Language::ALL {
            for record in [samples::threads(), samples::triangles(), samples::rays(), samples::tiles()] {
                let charts = charts(&Findings::of(&record), language);
                assert_eq!(charts.iter().map(|c| c.stem).collect::<Vec<_>>(), stems(record.study.plan().kind()));
                for panel in charts.iter().flat_map(|c| &c.panels) {
                    assert!(!panel.series.is_empty());
                    assert!(panel.x.ticks.len() >= 2 && panel.y.ticks.len() >= 2, "{panel:?}");
                    let inside = |axis: &Axis, v: f64| (axis.low..=axis.high).contains(&v);
                    for series in &panel.series {
                        for point in &series.points {
                            assert!(inside(&panel.x, point.x) && inside(&panel.y, point.y), "{series:?} {point:?}");
                        }
                    }
                }
            }
        }
    }

    #[test]
    fn the_published_curve_stands_beside_ours_as_its_own() {
        let charts = charts(&Findings::of(&samples::threads()), Language::English);
        let all = &charts[0].panels[0];
        let published: Vec<&Series> = all.series.iter().filter(|s| s.style == Style::Published).collect();
        assert_eq!(published.len(), 2);
        assert_eq!(published[0].label, "One sphere, published");
        let first = published[0].points[0];
        assert_eq!((first.x, first.y, first.bar), (1.0, 626.01, None));
        // From two threads on it has a panel of its own, for its times are another machine's.
        let [above, below] = &charts[1].panels[..] else { panic!("{:?}", charts[1]) };
        assert!(above.series.iter().all(|s| s.style == Style::Published && s.points[0].x >= 2.0));
        assert!(below.series.iter().all(|s| s.style == Style::Measured && s.points[0].x >= 2.0));
    }

    #[test]
    fn partial_findings_have_the_plots_they_are_enough_for() {
        for mut record in [samples::threads(), samples::triangles(), samples::rays(), samples::tiles()] {
            for left in [2, 1, 0] {
                record.measurements.truncate(left);
                for chart in charts(&Findings::of(&record), Language::English) {
                    assert!(chart.panels.iter().all(|p| !p.series.is_empty()), "{chart:?}");
                }
            }
        }
    }
}
