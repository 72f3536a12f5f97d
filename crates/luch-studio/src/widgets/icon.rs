//! Small drawings of the kinds of things in a scene. Fonts have no sign for them.

use crate::l10n::Texts;
use crate::selection::Part;
use egui::{Color32, Painter, Pos2, Rect, Response, Sense, Shape as Mark, Stroke, Ui, pos2, vec2};
use luch_scene::{Scene, Shape};

/// What is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Icon {
    Sphere,
    Cube,
    Wall,
    Mesh,
    Lamp,
    /// An open eye: the thing is in the picture.
    Shown,
    /// A closed eye.
    Hidden,
    /// A cross in a circle: a place to be clicked.
    Target,
}

impl Icon {
    /// The drawing of a thing's kind.
    pub(crate) fn of(part: Part, scene: &Scene) -> Self {
        match part {
            Part::Light(_) => Self::Lamp,
            Part::Object(index) => match scene.objects.get(index).map(|o| &o.shape) {
                Some(Shape::Cuboid { .. }) => Self::Cube,
                Some(Shape::Wall { .. }) => Self::Wall,
                Some(Shape::Mesh(_)) => Self::Mesh,
                Some(Shape::Sphere { .. }) | None => Self::Sphere,
            },
        }
    }

    /// What the kind of thing is called.
    fn kind(self, texts: &Texts) -> String {
        match self {
            Self::Sphere => texts.kind_sphere(),
            Self::Cube => texts.kind_cube(),
            Self::Wall => texts.kind_wall(),
            Self::Mesh => texts.kind_mesh(),
            Self::Lamp => texts.kind_lamp(),
            // These are no things; their buttons have names of their own.
            Self::Shown | Self::Hidden | Self::Target => String::new(),
        }
    }

    /// Draws it into a square of side 16.
    pub(crate) fn paint(self, painter: &Painter, rect: Rect, color: Color32) {
        let stroke = Stroke::new(1.3, color);
        let center = rect.center();
        let at = |x: f32, y: f32| center + vec2(x, y);
        let line = |points: &[Pos2]| painter.add(Mark::line(points.to_vec(), stroke));
        match self {
            Self::Sphere => {
                painter.circle_stroke(center, 6.0, stroke);
                painter.circle_filled(at(-2.0, -2.0), 1.5, color);
            }
            Self::Cube => {
                line(&[at(-6.0, -2.5), at(0.0, -6.0), at(6.0, -2.5), at(0.0, 1.0), at(-6.0, -2.5), at(-6.0, 4.0)]);
                line(&[at(-6.0, 4.0), at(0.0, 7.0), at(6.0, 4.0), at(6.0, -2.5)]);
                line(&[at(0.0, 1.0), at(0.0, 7.0)]);
            }
            Self::Wall => {
                line(&[at(-4.0, -4.0), at(7.0, -4.0), at(3.0, 5.0), at(-7.0, 5.0), at(-4.0, -4.0)]);
                line(&[at(-5.5, 0.5), at(5.0, 0.5)]);
            }
            Self::Mesh => {
                line(&[at(0.0, -6.5), at(6.0, 5.0), at(-6.0, 5.0), at(0.0, -6.5)]);
                line(&[at(-3.0, -0.8), at(3.0, -0.8), at(0.0, 5.0), at(-3.0, -0.8)]);
            }
            Self::Lamp => {
                painter.circle_stroke(at(0.0, -1.5), 4.2, stroke);
                line(&[at(-2.0, 4.5), at(2.0, 4.5)]);
                line(&[at(-1.2, 6.8), at(1.2, 6.8)]);
            }
            Self::Target => {
                painter.circle_stroke(center, 4.5, stroke);
                for (x, y) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
                    line(&[at(x * 2.5, y * 2.5), at(x * 7.0, y * 7.0)]);
                }
            }
            Self::Shown | Self::Hidden => {
                let lid = |bend: f32| (-6_i8..=6).map(f32::from).map(move |x| (x, bend * (1.0 - x * x / 36.0)));
                let curve = |bend: f32| lid(bend).map(|(x, y)| at(x, y)).collect::<Vec<_>>();
                line(&curve(4.0));
                if self == Self::Shown {
                    line(&curve(-4.0));
                    painter.circle_filled(center, 2.0, color);
                } else {
                    for x in [-3.5, 0.0, 3.5] {
                        line(&[at(x, 3.4), at(x * 1.35, 6.2)]);
                    }
                }
            }
        }
    }
}

/// The width of a drawing that can be clicked, in points.
pub(crate) const WIDTH: f32 = 20.0;

/// A drawing that can be clicked; `name` is what a screen reader says.
pub(crate) fn button(ui: &mut Ui, icon: Icon, name: &str) -> Response {
    sensing(ui, icon, name, false, Sense::click())
}

/// The same in a row of a list, which has the focus for its rows.
pub(crate) fn button_in_row(ui: &mut Ui, icon: Icon, name: &str, faint: bool) -> Response {
    sensing(ui, icon, name, faint, Sense::CLICK)
}

fn sensing(ui: &mut Ui, icon: Icon, name: &str, faint: bool, sense: Sense) -> Response {
    let (rect, response) = ui.allocate_exact_size(vec2(WIDTH, 18.0), sense);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Button, ui.is_enabled(), name));
    let visuals = ui.style().interact(&response);
    if response.hovered() || response.has_focus() {
        ui.painter().rect_stroke(rect, 3.0, visuals.bg_stroke, egui::StrokeKind::Inside);
    }
    let color = visuals.text_color();
    icon.paint(
        ui.painter(),
        Rect::from_center_size(rect.center(), vec2(16.0, 16.0)),
        if faint { color.gamma_multiply(0.5) } else { color },
    );
    response.on_hover_text(name)
}

/// A drawing that says of what kind a thing is, and does nothing.
pub(crate) fn kind(ui: &mut Ui, icon: Icon, texts: &Texts) {
    let (rect, response) = ui.allocate_exact_size(vec2(18.0, 18.0), Sense::hover());
    let name = icon.kind(texts);
    response.widget_info(|| egui::WidgetInfo::labeled(egui::Role::Image, true, &name));
    response.on_hover_text(name);
    icon.paint(
        ui.painter(),
        Rect::from_center_size(pos2(rect.center().x, rect.center().y), vec2(16.0, 16.0)),
        ui.visuals().text_color(),
    );
}
