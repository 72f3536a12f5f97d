//! How each kind of ray is drawn: told apart by dashes and width as well as by colour, for people who see fewer colours
//! and for prints in grey.

use crate::l10n::Texts;
use egui::{Color32, Painter, Pos2, Shape, Stroke, Vec2};
use luch_render::explain::{PixelAccount, RayEnd, RayKind};

/// What a ray is drawn as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Look {
    Camera,
    Mirror,
    /// A shadow ray that reaches its light.
    Lit,
    /// A shadow ray that something blocks.
    Blocked,
}

impl Look {
    pub(crate) const ALL: [Self; 4] = [Self::Camera, Self::Mirror, Self::Lit, Self::Blocked];

    pub(crate) fn of(account: &PixelAccount, ray: u32) -> Self {
        let ray = &account.rays[ray as usize];
        match (ray.kind, ray.end) {
            (RayKind::Camera, _) => Self::Camera,
            (RayKind::Mirror, _) => Self::Mirror,
            (RayKind::Shadow, RayEnd::Blocked { .. }) => Self::Blocked,
            (RayKind::Shadow, _) => Self::Lit,
        }
    }

    pub(crate) fn name(self, texts: &Texts) -> String {
        match self {
            Self::Camera => texts.explain_camera_ray(),
            Self::Mirror => texts.explain_mirror_ray(),
            Self::Lit => texts.explain_lit_ray(),
            Self::Blocked => texts.explain_blocked_ray(),
        }
    }

    /// Colours that stay apart under every kind of colour blindness (Okabe and Ito, "Color universal design", 2008),
    /// darkened where they lie on white.
    pub(crate) const fn color(self, on_dark: bool) -> Color32 {
        match (self, on_dark) {
            (Self::Camera, true) => Color32::from_rgb(240, 240, 240),
            (Self::Camera, false) => Color32::from_rgb(40, 40, 40),
            (Self::Mirror, true) => Color32::from_rgb(86, 180, 233),
            (Self::Mirror, false) => Color32::from_rgb(0, 114, 178),
            (Self::Lit, true) => Color32::from_rgb(240, 200, 66),
            (Self::Lit, false) => Color32::from_rgb(176, 118, 0),
            (Self::Blocked, true) => Color32::from_rgb(240, 110, 40),
            (Self::Blocked, false) => Color32::from_rgb(200, 70, 0),
        }
    }

    /// Lengths of dashes and gaps in turn; none for a line without gaps.
    const fn dashes(self) -> Option<[&'static [f32]; 2]> {
        match self {
            Self::Camera => None,
            Self::Mirror => Some([&[11.0], &[4.0]]),
            Self::Lit => Some([&[2.5], &[3.5]]),
            Self::Blocked => Some([&[8.0, 2.0], &[4.0, 4.0]]),
        }
    }

    const fn width(self) -> f32 {
        match self {
            Self::Camera => 2.2,
            Self::Mirror => 2.0,
            Self::Lit | Self::Blocked => 1.7,
        }
    }
}

/// How much a line says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Stress {
    /// It belongs to what is looked at.
    Plain,
    /// It is looked at.
    Strong,
}

/// Draws rays between two points of the window.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pen {
    /// Whether a dark rim keeps the line apart from what it lies over.
    pub(crate) rim: bool,
    /// Whether the ground is dark.
    pub(crate) on_dark: bool,
}

impl Pen {
    /// Over the picture.
    pub(crate) const PICTURE: Self = Self { rim: true, on_dark: true };

    /// Draws the line with an arrow; `ends` says whether it ends there, or goes on unseen.
    pub(crate) fn line(self, painter: &Painter, [from, to]: [Pos2; 2], look: Look, stress: Stress, ends: bool) {
        let along = (to - from).normalized();
        let width = look.width() * if stress == Stress::Strong { 1.45 } else { 1.0 };
        let head = (4.0 + 2.2 * width).min((to - from).length() * 0.9);
        let end = to - along * head * 0.8;
        let color = look.color(self.on_dark);
        let color = if stress == Stress::Strong { color } else { color.gamma_multiply(0.9) };
        if self.rim {
            painter.line_segment([from, end], Stroke::new(width + 2.0, Color32::from_black_alpha(110)));
        }
        match look.dashes() {
            None => {
                painter.line_segment([from, end], Stroke::new(width, color));
            }
            Some([dashes, gaps]) => {
                let stretch = |lengths: &[f32]| lengths.iter().map(|l| l * width / 1.7).collect::<Vec<_>>();
                let stroke = Stroke::new(width, color);
                painter.extend(Shape::dashed_line_with_offset(
                    &[from, end],
                    stroke,
                    &stretch(dashes),
                    &stretch(gaps),
                    0.0,
                ));
            }
        }
        if head > 1.0 {
            self.arrowhead(painter, to, along, head, color);
        }
        if look == Look::Blocked && ends {
            cross(painter, to, 3.0 + width, Stroke::new(width, color), self.rim);
        }
    }

    fn arrowhead(self, painter: &Painter, tip: Pos2, along: Vec2, length: f32, color: Color32) {
        let back = tip - along * length;
        let side = along.rot90() * length * 0.42;
        let rim = if self.rim { Stroke::new(1.0, Color32::from_black_alpha(160)) } else { Stroke::NONE };
        painter.add(Shape::convex_polygon(vec![tip, back + side, back - side], color, rim));
    }
}

/// A cross where a ray is blocked.
fn cross(painter: &Painter, at: Pos2, reach: f32, stroke: Stroke, rim: bool) {
    for arm in [Vec2::new(1.0, 1.0), Vec2::new(1.0, -1.0)] {
        let ends = [at - arm * reach * 0.7, at + arm * reach * 0.7];
        if rim {
            painter.line_segment(ends, Stroke::new(stroke.width + 2.0, Color32::from_black_alpha(140)));
        }
        painter.line_segment(ends, stroke);
    }
}
