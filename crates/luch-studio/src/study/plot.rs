//! Draws the charts of a study. Their axes may be logarithmic, which the plot does not know: it gets places along them.

use egui::{Color32, Id, Sense, Stroke, Ui, vec2};
use egui_plot::{AxisHints, GridMark, Line, LineStyle, MarkerShape, Plot, PlotPoints, Points, Span};
use luch_study::chart::{Axis, COLORS, Panel, Scale, Series, Style};

/// Height of a panel, in points.
const HEIGHT: f32 = 230.0;

/// Shows one panel of a chart.
pub(super) fn show(ui: &mut Ui, id: &str, panel: &Panel) {
    let (x, y) = (&panel.x, &panel.y);
    legend(ui, panel);
    let plot = Plot::new(Id::unique(("study plot", id)))
        .height(HEIGHT)
        .allow_scroll(false)
        .default_x_bounds(along(x, x.low), along(x, x.high))
        .default_y_bounds(along(y, y.low), along(y, y.high))
        .x_grid_spacer(move |_| marks(x))
        .y_grid_spacer(move |_| marks(y))
        .custom_x_axes(vec![AxisHints::new_x().label(x.label.clone()).formatter(move |mark, _| label(x, mark))])
        .custom_y_axes(vec![AxisHints::new_y().label(y.label.clone()).formatter(move |mark, _| label(y, mark))]);
    plot.show(ui, |ui| {
        if let Some(shaded) = &panel.shaded {
            let grey = Color32::from_gray(128).gamma_multiply(0.18);
            ui.span(Span::new(shaded.label.clone(), along(x, shaded.from_x)..=along(x, x.high)).fill(grey));
        }
        for series in &panel.series {
            draw(ui, panel, series);
        }
    });
}

/// What each curve is, above the plot: within it would cover some.
fn legend(ui: &mut Ui, panel: &Panel) {
    ui.horizontal_wrapped(|ui| {
        for series in &panel.series {
            let (rect, _) = ui.allocate_exact_size(vec2(14.0, 14.0), Sense::hover());
            let (center, color) = (rect.center(), color(series));
            match series.style {
                Style::Measured => _ = ui.painter().circle_filled(center, 4.0, color),
                Style::Published => _ = ui.painter().circle_stroke(center, 3.5, Stroke::new(1.5, color)),
                Style::Law => _ = ui.painter().hline(rect.x_range(), center.y, Stroke::new(1.5, color)),
            }
            ui.label(&series.label);
            ui.add_space(6.0);
        }
    });
}

fn color(series: &Series) -> Color32 {
    series.color.map_or(Color32::GRAY, |number| {
        let [r, g, b] = COLORS[number % COLORS.len()];
        Color32::from_rgb(r, g, b)
    })
}

fn draw<'a>(ui: &mut egui_plot::PlotUi<'a>, panel: &'a Panel, series: &'a Series) {
    let color = color(series);
    let at = |x: f64, y: f64| [along(&panel.x, x), along(&panel.y, y)];
    let points: Vec<[f64; 2]> = series.points.iter().map(|point| at(point.x, point.y)).collect();
    let style = match series.style {
        Style::Measured => LineStyle::Solid,
        Style::Published => LineStyle::dashed_dense(),
        Style::Law => LineStyle::dotted_dense(),
    };
    ui.line(Line::new(series.label.clone(), points.clone()).color(color).style(style).width(1.5));
    if series.style == Style::Law {
        return;
    }
    for point in &series.points {
        if let Some([low, high]) = point.bar {
            // The quartiles; without a name they are in no legend.
            ui.line(Line::new("", vec![at(point.x, low), at(point.x, high)]).color(color).width(3.0));
        }
    }
    let markers = Points::new(series.label.clone(), PlotPoints::from(points)).color(color).radius(3.5);
    ui.points(markers.filled(series.style == Style::Measured).shape(MarkerShape::Circle));
}

/// A number's place along an axis.
fn along(axis: &Axis, value: f64) -> f64 {
    match axis.scale {
        Scale::Linear => value,
        Scale::Logarithmic => libm::log10(value.max(f64::MIN_POSITIVE)),
    }
}

/// Lines of the grid where the axis has its numbers.
fn marks(axis: &Axis) -> Vec<GridMark> {
    let step = (along(axis, axis.high) - along(axis, axis.low)) / axis.ticks.len().max(1) as f64;
    axis.ticks.iter().map(|tick| GridMark { value: along(axis, tick.at), step_size: step }).collect()
}

/// The number that the axis has at a line of the grid.
fn label(axis: &Axis, mark: GridMark) -> String {
    let near = |place: f64| (place - mark.value).abs() <= 1e-9 * (1.0 + mark.value.abs());
    let tick = axis.ticks.iter().find(|tick| near(along(axis, tick.at)));
    tick.map(|tick| tick.label.clone()).unwrap_or_default()
}
