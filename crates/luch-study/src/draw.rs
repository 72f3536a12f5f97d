//! Draws charts with kuva's shapes, as SVG and PNG. Where everything stands is decided here, so that axes, legend and both
//! kinds of file agree in every language.

use crate::chart::{Axis, COLORS, Chart, Panel, Point, Series, Shaded, Style};
use kuva::backend::raster::RasterBackend;
use kuva::backend::svg::SvgBackend;
use kuva::render::color::Color;
use kuva::render::render::{Primitive, Scene, TextAnchor};

const WIDTH: f64 = 960.0;
/// Pixels of a PNG for each unit of a drawing.
const PNG_SCALE: f32 = 2.0;
/// The font that kuva draws PNG with; others stand in where a viewer of SVG has it not.
const FONT: &str = "DejaVu Sans, Verdana, Arial, sans-serif";

const LEFT: f64 = 100.0;
const RIGHT: f64 = 36.0;
const TITLE_BASELINE: f64 = 42.0;
const LEGEND_TOP: f64 = 72.0;
const LEGEND_ROW: f64 = 26.0;
const LEGEND_COLUMNS: usize = 2;
/// Width of what stands before an entry.
const SWATCH: f64 = 36.0;
/// Above each panel: what is along its axis, and its title.
const HEAD: f64 = 50.0;
/// Height of the axes of one panel, and of each of several.
const ONE_PANEL: f64 = 400.0;
const EACH_PANEL: f64 = 250.0;
/// Below a panel: numbers of the axis; below the last: its label too.
const TICK_ROOM: f64 = 34.0;
const LABEL_ROOM: f64 = 32.0;
const FOOT_ROOM: f64 = 36.0;

const TITLE_SIZE: u32 = 22;
const LABEL_SIZE: u32 = 16;
const TEXT_SIZE: u32 = 14;
const FOOT_SIZE: u32 = 12;

const BLACK: [u8; 3] = [30, 30, 30];
const GREY: [u8; 3] = [110, 110, 110];
const GRID: [u8; 3] = [225, 225, 225];
const SHADE: [u8; 3] = [241, 241, 241];

/// The chart as an SVG file. Its text is text: a viewer sets it in its font or the nearest that it has.
#[must_use]
pub fn svg(chart: &Chart) -> String {
    let scene = Drawing::of(chart).scene;
    let (width, height, text) = (scene.width, scene.height, SvgBackend::new().render_scene(&scene));
    // Without it a viewer that shows the picture smaller cuts it off.
    text.replacen("<svg ", &format!("<svg viewBox=\"0 0 {width} {height}\" "), 1)
}

/// The chart as a PNG file, 1920 pixels wide.
///
/// # Errors
/// What kuva says of a drawing that it cannot make; none is known of.
pub fn png(chart: &Chart) -> Result<Vec<u8>, String> {
    RasterBackend::new().with_scale(PNG_SCALE).render_scene(&Drawing::of(chart).scene)
}

struct Drawing {
    scene: Scene,
}

/// The rectangle between the axes of a panel.
#[derive(Clone, Copy)]
struct Frame {
    top: f64,
    bottom: f64,
}

impl Frame {
    const WIDTH: f64 = WIDTH - LEFT - RIGHT;

    fn x(axis: &Axis, value: f64) -> f64 {
        LEFT + axis.place(value) * Self::WIDTH
    }

    fn y(self, axis: &Axis, value: f64) -> f64 {
        self.bottom - axis.place(value) * (self.bottom - self.top)
    }
}

impl Drawing {
    fn of(chart: &Chart) -> Self {
        let legend = legend(chart);
        let panel_height = if chart.panels.len() > 1 { EACH_PANEL } else { ONE_PANEL };
        let legend_height = legend.len().div_ceil(LEGEND_COLUMNS) as f64 * LEGEND_ROW;
        let panels = chart.panels.len() as f64;
        let height = LEGEND_TOP + legend_height + panels * (HEAD + panel_height + TICK_ROOM) + LABEL_ROOM + FOOT_ROOM;
        let mut scene = Scene::new(WIDTH, height);
        scene.font_family = Some(FONT.to_owned());
        let mut drawing = Self { scene };

        drawing.text(WIDTH / 2.0, TITLE_BASELINE, &chart.title, TITLE_SIZE, TextAnchor::Middle, BLACK);
        drawing.legend(&legend);
        let mut top = LEGEND_TOP + legend_height;
        for panel in &chart.panels {
            top += HEAD;
            // Beside each other above the axis: letters on their side are hard to read.
            let head = top - 16.0;
            drawing.text(LEFT - 72.0, head, &panel.y.label, LABEL_SIZE, TextAnchor::Start, BLACK);
            if let Some(title) = &panel.title {
                drawing.text(LEFT + Frame::WIDTH, head, title, TEXT_SIZE, TextAnchor::End, GREY);
            }
            let frame = Frame { top, bottom: top + panel_height };
            drawing.panel(panel, frame);
            top = frame.bottom + TICK_ROOM;
        }
        if let Some(panel) = chart.panels.last() {
            let middle = LEFT + Frame::WIDTH / 2.0;
            drawing.text(middle, top + 16.0, &panel.x.label, LABEL_SIZE, TextAnchor::Middle, BLACK);
        }
        drawing.text(LEFT, height - 14.0, &chart.foot, FOOT_SIZE, TextAnchor::Start, GREY);
        drawing
    }

    fn panel(&mut self, panel: &Panel, frame: Frame) {
        if let Some(Shaded { from_x, .. }) = &panel.shaded {
            let from = Frame::x(&panel.x, *from_x);
            self.shade([from, frame.top], [LEFT + Frame::WIDTH - from, frame.bottom - frame.top]);
        }
        self.axes(panel, frame);
        for series in &panel.series {
            self.series(series, panel, frame);
        }
    }

    fn axes(&mut self, panel: &Panel, frame: Frame) {
        for tick in &panel.x.ticks {
            let x = Frame::x(&panel.x, tick.at);
            self.line([x, frame.top], [x, frame.bottom], GRID, 1.0, None);
            self.text(x, frame.bottom + 22.0, &tick.label, TEXT_SIZE, TextAnchor::Middle, BLACK);
        }
        for tick in &panel.y.ticks {
            let y = frame.y(&panel.y, tick.at);
            self.line([LEFT, y], [LEFT + Frame::WIDTH, y], GRID, 1.0, None);
            self.text(LEFT - 10.0, y + 5.0, &tick.label, TEXT_SIZE, TextAnchor::End, BLACK);
        }
        self.line([LEFT, frame.bottom], [LEFT + Frame::WIDTH, frame.bottom], BLACK, 1.2, None);
        self.line([LEFT, frame.top], [LEFT, frame.bottom], BLACK, 1.2, None);
    }

    fn series(&mut self, series: &Series, panel: &Panel, frame: Frame) {
        let at = |x: f64, y: f64| (Frame::x(&panel.x, x), frame.y(&panel.y, y));
        let paint = paint(series.color);
        let line = Line::of(series.style);
        self.scene.add(Primitive::PolyLine {
            points: series.points.iter().map(|p| at(p.x, p.y)).collect(),
            stroke: color(paint),
            stroke_width: line.width,
            stroke_dasharray: line.dashes.map(str::to_owned),
        });
        for &Point { x, y, bar } in &series.points {
            if let Some([low, high]) = bar {
                let ((x, low), (_, high)) = (at(x, low), at(x, high));
                self.line([x, low], [x, high], paint, 1.5, None);
                for end in [low, high] {
                    self.line([x - 5.0, end], [x + 5.0, end], paint, 1.5, None);
                }
            }
            self.marker(at(x, y), paint, series.style);
        }
    }

    fn marker(&mut self, (cx, cy): (f64, f64), paint: [u8; 3], style: Style) {
        let fill = match style {
            Style::Measured => color(paint),
            Style::Published => color([255, 255, 255]),
            Style::Law => return,
        };
        self.scene.add(Primitive::Circle {
            cx,
            cy,
            r: 4.5,
            fill,
            fill_opacity: None,
            stroke: Some(color(paint)),
            stroke_width: Some(1.8),
        });
    }

    /// Entries in columns above the panels, where no curve can run.
    fn legend(&mut self, entries: &[Entry<'_>]) {
        let column = Frame::WIDTH / LEGEND_COLUMNS as f64;
        for (place, entry) in entries.iter().enumerate() {
            let x = LEFT + (place % LEGEND_COLUMNS) as f64 * column;
            let y = LEGEND_TOP + (place / LEGEND_COLUMNS) as f64 * LEGEND_ROW;
            let label = match entry {
                Entry::Series(series) => {
                    let line = Line::of(series.style);
                    let paint = paint(series.color);
                    self.line([x, y], [x + SWATCH, y], paint, line.width, line.dashes);
                    self.marker((x + SWATCH / 2.0, y), paint, series.style);
                    &series.label
                }
                Entry::Shaded(shaded) => {
                    self.shade([x, y - 8.0], [SWATCH, 16.0]);
                    &shaded.label
                }
            };
            self.text(x + SWATCH + 10.0, y + 5.0, label, TEXT_SIZE, TextAnchor::Start, BLACK);
        }
    }

    fn shade(&mut self, [x, y]: [f64; 2], [width, height]: [f64; 2]) {
        let (fill, stroke, stroke_width, opacity) = (color(SHADE), None, None, None);
        self.scene.add(Primitive::Rect { x, y, width, height, fill, stroke, stroke_width, opacity });
    }

    fn line(&mut self, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2], paint: [u8; 3], width: f64, dashes: Option<&str>) {
        self.scene.add(Primitive::Line {
            x1,
            y1,
            x2,
            y2,
            stroke: color(paint),
            stroke_width: width,
            stroke_dasharray: dashes.map(str::to_owned),
        });
    }

    fn text(&mut self, x: f64, y: f64, content: &str, size: u32, anchor: TextAnchor, paint: [u8; 3]) {
        let content = literal(content);
        let color = Some(color(paint));
        self.scene.add(Primitive::Text { x, y, content, size, anchor, rotate: None, bold: false, color });
    }
}

/// How a line of a style looks.
struct Line {
    width: f64,
    dashes: Option<&'static str>,
}

impl Line {
    const fn of(style: Style) -> Self {
        match style {
            Style::Measured => Self { width: 2.5, dashes: None },
            Style::Published => Self { width: 1.8, dashes: Some("8 5") },
            Style::Law => Self { width: 1.8, dashes: Some("2 4") },
        }
    }
}

/// What a legend explains.
enum Entry<'a> {
    Series(&'a Series),
    Shaded(&'a Shaded),
}

/// Everything that a legend must explain, once, however many panels it is in: what was measured first.
fn legend(chart: &Chart) -> Vec<Entry<'_>> {
    let mut series: Vec<&Series> = Vec::new();
    for own in chart.panels.iter().flat_map(|panel| &panel.series) {
        if !series.iter().any(|known| known.label == own.label && known.style == own.style) {
            series.push(own);
        }
    }
    let rank = |series: &Series| match (series.color, series.style) {
        (None, _) => 3,
        (_, Style::Measured) => 0,
        (_, Style::Law) => 1,
        (_, Style::Published) => 2,
    };
    series.sort_by_key(|series| rank(series));
    let shaded = chart.panels.iter().find_map(|panel| panel.shaded.as_ref());
    series.into_iter().map(Entry::Series).chain(shaded.map(Entry::Shaded)).collect()
}

fn paint(number: Option<usize>) -> [u8; 3] {
    number.map_or(GREY, |number| COLORS[number % COLORS.len()])
}

const fn color([r, g, b]: [u8; 3]) -> Color {
    Color::Rgb(r, g, b)
}

/// The text as it is: kuva takes what stands between two dollars for a formula. Control characters have no place in XML.
fn literal(text: &str) -> String {
    text.replace('$', "\\$").chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chart::charts;
    use crate::findings::Findings;
    use crate::language::Language;
    use crate::samples;

    #[test]
    fn every_chart_is_drawn_in_both_languages_and_kinds_of_file() {
        for record in [samples::threads(), samples::triangles(), samples::rays(), samples::tiles()] {
            for language in Language::ALL {
                for chart in charts(&Findings::of(&record), language) {
                    let text = svg(&chart);
                    assert!(text.starts_with("<svg ") && text.trim_end().ends_with("</svg>"));
                    for word in [&chart.title, &chart.panels[0].y.label, &chart.panels[0].series[0].label] {
                        assert!(text.contains(word.as_str()), "{word} is not in {text}");
                    }
                    assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
                    let bytes = png(&chart).unwrap();
                    let info = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().unwrap().info().clone();
                    assert_eq!(info.width, 1920);
                }
            }
        }
    }

    #[test]
    fn a_scene_may_be_called_anything() {
        let mut record = samples::tiles();
        let crate::Plan::Tiles { mut subjects, tiles, threads, effort } = record.study.plan().clone() else { panic!() };
        subjects[0].id = "a.toml".to_owned();
        subjects[0].scene.name = "<b> & $x^2$ \u{1b}[2J".to_owned();
        record.study = crate::Study::new(crate::Plan::Tiles { subjects, tiles, threads, effort }).unwrap();
        let text = svg(&charts(&Findings::of(&record), Language::English)[0]);
        assert!(text.contains("&lt;b&gt; &amp; $x^2$  [2J"), "{text}");
    }
}
