//! The scene from above, with the rays of the sample that is looked at.

mod map;

use super::hovered_ray;
use crate::explain::Explained;
use crate::explain::looks::{Look, Pen, Stress};
use crate::explain::plan::{Figure, from_above};
use crate::state::Desk;
use crate::widgets::icon::Icon;
use egui::{
    Align2, Color32, Context, EventFilter, FontId, Galley, Id, Key, Modifiers, Painter, Pos2, Rect, Response, Role,
    Sense, Shape, Stroke, Ui, Vec2, WidgetInfo, pos2, vec2,
};
use luch_render::explain::RayEnd;
use map::Map;
use std::collections::HashSet;
use std::sync::Arc;

/// The most rays that are drawn besides the one that is looked at.
const MOST: usize = 1000;
/// The most names.
const NAMES: usize = 60;
/// How far an arrow key moves the map, in points, and how much plus and minus enlarge it.
const STEP: f32 = 40.0;
const ZOOM: f32 = 1.25;

/// Sees all of the next scene at first.
pub(super) fn forget(ctx: &Context) {
    Map::forget(ctx);
}

pub(super) fn show(ui: &mut Ui, desk: &Desk<'_>, answer: &Arc<Explained>) {
    let texts = desk.texts;
    let area = ui.available_rect_before_wrap();
    let response = ui.interact(area, Id::unique("scene from above"), Sense::click_and_drag());
    ui.advance_cursor_after_rect(area);
    let name = texts.explain_page_top();
    response.widget_info(|| WidgetInfo::labeled(Role::Image, true, &name));
    let ray = hovered_ray(ui.ctx()).unwrap_or(desk.state.explain.ray);
    let mut map = Map::load(ui.ctx()).unwrap_or_else(|| Map::around(everything(answer, desk.state.explain.ray)));
    let fits = take_input(ui, &response, &mut map);
    if fits {
        map = Map::around(everything(answer, desk.state.explain.ray));
    }
    map.store(ui.ctx());
    let response = response.on_hover_text(texts.explain_top_tip());
    let painter = ui.painter_at(area);
    let ground = ui.visuals().extreme_bg_color;
    painter.rect_filled(area, 2.0, ground);
    let (dark, ink) = (ui.visuals().dark_mode, ui.visuals().text_color());
    let sheet = Sheet { painter: &painter, area, map, dark, ink, ground };
    sheet.objects(answer);
    sheet.camera(answer);
    sheet.rays(answer, ray);
    sheet.lights(answer);
    sheet.names(answer, ray);
    sheet.scale();
    if response.has_focus() {
        painter.rect_stroke(area, 2.0, ui.visuals().selection.stroke, egui::StrokeKind::Inside);
    }
}

/// What must be seen at first: all objects, lights and the camera, and the rays.
fn everything(answer: &Explained, ray: u32) -> Rect {
    let account = &answer.account;
    let mut all = answer.plan.bounds.unwrap_or(Rect::NOTHING);
    all.extend_with(from_above(answer.camera.position.get()));
    for light in &account.setting.lights {
        all.extend_with(from_above(light.position));
    }
    for other in sample_of(answer, ray).take(MOST) {
        let segment = account.segment(other);
        all.extend_with(from_above(segment.start));
        if !segment.open {
            all.extend_with(from_above(segment.end));
        }
    }
    all
}

/// The rays of the sample that a ray belongs to.
fn sample_of(answer: &Explained, ray: u32) -> impl Iterator<Item = u32> {
    let account = &answer.account;
    let sample = account.rays.get(ray as usize).and_then(|ray| account.samples.get(ray.sample as usize));
    let first = sample.map_or(0, |sample| sample.ray);
    let count = account.rays.get(first as usize).map_or(0, |ray| 1 + ray.descendants);
    first..first + count
}

/// Moves and enlarges by mouse and keys; answers whether all is to be seen again.
fn take_input(ui: &Ui, response: &Response, map: &mut Map) -> bool {
    if response.clicked() {
        response.request_focus();
    }
    if response.dragged() {
        map.pan(response.drag_delta());
    }
    if response.contains_pointer()
        && let Some(at) = response.hover_pos()
    {
        let (scroll, zoom) = ui.input(|i| (i.smooth_scroll_delta().y, i.zoom_delta()));
        map.zoom(response.rect, at, zoom * (scroll / 200.0).exp2());
        ui.input_mut(|i| i.smooth_scroll_delta = Vec2::ZERO);
    }
    let mut fits = response.double_clicked();
    if response.has_focus() {
        let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
        ui.memory_mut(|m| m.set_focus_lock_filter(response.id, arrows));
        let pressed = |key: Key| ui.input_mut(|i| i.consume_key(Modifiers::NONE, key));
        for (key, way) in [
            (Key::ArrowLeft, Vec2::RIGHT),
            (Key::ArrowRight, Vec2::LEFT),
            (Key::ArrowUp, Vec2::DOWN),
            (Key::ArrowDown, Vec2::UP),
        ] {
            if pressed(key) {
                map.pan(way * STEP);
            }
        }
        for (key, by) in [(Key::Plus, ZOOM), (Key::Equals, ZOOM), (Key::Minus, 1.0 / ZOOM)] {
            if pressed(key) {
                map.zoom(response.rect, response.rect.center(), by);
            }
        }
        fits |= pressed(Key::Num0);
    }
    fits
}

/// What is drawn on.
struct Sheet<'a> {
    painter: &'a Painter,
    area: Rect,
    map: Map,
    dark: bool,
    ink: Color32,
    ground: Color32,
}

impl Sheet<'_> {
    fn at(&self, place: Pos2) -> Pos2 {
        self.map.to_screen(self.area, place)
    }

    fn objects(&self, answer: &Explained) {
        for part in &answer.plan.parts {
            let [r, g, b] = part.color.to_srgb8();
            let color = Color32::from_rgb(r, g, b);
            // Dark things on a dark ground, and light ones on a light ground, keep an edge that is seen.
            let edge = Stroke::new(1.3, color.lerp_to_gamma(self.ink, 0.35));
            let fill = color.gamma_multiply(0.30);
            match &part.figure {
                Figure::Circle { center, radius } => {
                    self.painter.circle(self.at(*center), radius * self.map.scale(self.area), fill, edge);
                }
                Figure::Polygon(points) => {
                    let points = points.iter().map(|&point| self.at(point)).collect();
                    self.painter.add(Shape::convex_polygon(points, fill, edge));
                }
                Figure::Segment(ends) => {
                    self.painter.line_segment(ends.map(|end| self.at(end)), Stroke::new(2.5, edge.color));
                }
                Figure::Line { .. } => {
                    if let Some(ends) = self.wall(&part.figure) {
                        self.painter.line_segment(ends, Stroke::new(2.5, edge.color));
                    }
                }
            }
        }
    }

    /// The part of an endless wall that is in sight.
    fn wall(&self, figure: &Figure) -> Option<[Pos2; 2]> {
        let Figure::Line { point, along } = figure else { return None };
        let at = self.at(*point);
        let reach = (at - self.area.center()).length() + self.area.size().length();
        map::cut([at - *along * reach, at + *along * reach], self.area)
    }

    /// The camera and how wide it looks.
    fn camera(&self, answer: &Explained) {
        let camera = &answer.camera;
        let size = answer.account.size;
        let [right, _, forward] = camera.frame();
        let half = (f64::from(camera.fov.get()).to_radians() * 0.5).tan() as f32;
        let wide = half * size.width() as f32 / size.height() as f32;
        let eye = self.at(from_above(camera.position.get()));
        let reach = self.area.size().length();
        let faint = Stroke::new(1.0, self.ink.gamma_multiply(0.45));
        for side in [-1.0, 1.0] {
            let way = (forward + right * wide * side).normalize_or_zero();
            let way = vec2(way.x, way.z);
            if let Some(ends) = map::cut([eye, eye + way * reach], self.area)
                && way.length() > 0.05
            {
                self.painter.line_segment(ends, faint);
            }
        }
        let ahead = vec2(forward.x, forward.z);
        let ahead = if ahead.length() > 1e-3 { ahead.normalized() } else { vec2(0.0, -1.0) };
        let side = ahead.rot90();
        let body = [eye + ahead * 3.0, eye - ahead * 9.0 + side * 6.0, eye - ahead * 9.0 - side * 6.0];
        let ink = Stroke::new(1.0, self.ground);
        self.painter.add(Shape::convex_polygon(body.to_vec(), self.ink, ink));
    }

    fn rays(&self, answer: &Explained, ray: u32) {
        for other in sample_of(answer, ray).take(MOST).filter(|&other| other != ray) {
            self.ray(answer, other, Stress::Plain);
        }
        if (ray as usize) < answer.account.rays.len() {
            self.ray(answer, ray, Stress::Strong);
        }
    }

    fn ray(&self, answer: &Explained, ray: u32, stress: Stress) {
        let segment = answer.account.segment(ray);
        let ends = [segment.start, segment.end].map(|end| self.at(from_above(end)));
        let Some(seen) = map::cut(ends, self.area) else { return };
        let look = Look::of(&answer.account, ray);
        let pen = Pen { rim: false, on_dark: self.dark };
        // A ray straight up or down is a point from above.
        if seen[0].distance(seen[1]) < 2.0 {
            self.painter.circle_filled(seen[1], 3.0, look.color(self.dark));
        } else {
            pen.line(self.painter, seen, look, stress, seen[1] == ends[1]);
        }
    }

    fn lights(&self, answer: &Explained) {
        for light in &answer.account.setting.lights {
            let at = self.at(from_above(light.position));
            self.painter.circle_filled(at, 9.0, Color32::from_black_alpha(170));
            let color = crate::explain::numbers::color32(light.color);
            Icon::Lamp.paint(self.painter, Rect::from_center_size(at, vec2(16.0, 16.0)), color);
        }
    }

    /// The names of what the rays meet, and of what has room for its name.
    fn names(&self, answer: &Explained, ray: u32) {
        let mut names = Names { sheet: self, taken: Vec::new() };
        let eye = self.at(from_above(answer.camera.position.get()));
        names.put(&answer.camera.name, eye + vec2(0.0, 12.0), Align2::CENTER_TOP);
        for light in &answer.account.setting.lights {
            let at = self.at(from_above(light.position)) + vec2(12.0, 0.0);
            names.put(answer.light(light.light), at, Align2::LEFT_CENTER);
        }
        let account = &answer.account;
        let met = sample_of(answer, ray).take(MOST).filter_map(|ray| match account.rays[ray as usize].end {
            RayEnd::Surface(surface) => Some(account.surfaces[surface as usize].object),
            RayEnd::Blocked { blocker, .. } => Some(blocker.object),
            _ => None,
        });
        let met: HashSet<u32> = met.collect();
        for first in [true, false] {
            for part in answer.plan.parts.iter().filter(|part| met.contains(&part.object) == first) {
                let name = answer.object(part.object);
                if let Some([a, b]) = self.wall(&part.figure) {
                    names.put(name, a + (b - a) * 0.5, Align2::CENTER_CENTER);
                } else if let Some(bounds) = part.figure.bounds() {
                    let at = self.at(bounds.center());
                    let room = bounds.width() * self.map.scale(self.area);
                    if self.area.contains(at) && (first || names.width(name) < room) {
                        names.put(name, at, Align2::CENTER_CENTER);
                    }
                }
            }
        }
    }

    /// A bar that says how long something is, and which way x and z go.
    fn scale(&self) {
        let (length, points) = self.map.bar(self.area);
        let from = self.area.left_bottom() + vec2(12.0, -12.0);
        let stroke = Stroke::new(1.5, self.ink);
        let to = from + vec2(points, 0.0);
        self.painter.line_segment([from, to], stroke);
        for end in [from, to] {
            self.painter.line_segment([end - vec2(0.0, 4.0), end + vec2(0.0, 4.0)], stroke);
        }
        let font = FontId::proportional(11.0);
        let text = luch_explain::short(length);
        self.painter.text(
            pos2((from.x + to.x) * 0.5, from.y - 3.0),
            Align2::CENTER_BOTTOM,
            text,
            font.clone(),
            self.ink,
        );
        let corner = self.area.right_top() + vec2(-34.0, 14.0);
        for (way, name) in [(vec2(18.0, 0.0), "x"), (vec2(0.0, 18.0), "z")] {
            self.painter.arrow(corner, way, Stroke::new(1.3, self.ink));
            self.painter.text(corner + way * 1.5, Align2::CENTER_CENTER, name, font.clone(), self.ink);
        }
    }
}

/// Names that do not lie on each other.
struct Names<'a> {
    sheet: &'a Sheet<'a>,
    taken: Vec<Rect>,
}

impl Names<'_> {
    const SIZE: f32 = 11.5;

    fn set(&self, name: &str) -> Arc<Galley> {
        self.sheet.painter.layout_no_wrap(name.to_owned(), FontId::proportional(Self::SIZE), self.sheet.ink)
    }

    fn width(&self, name: &str) -> f32 {
        self.set(name).size().x
    }

    /// Puts a name where it fits into the area, unless another is there.
    fn put(&mut self, name: &str, at: Pos2, align: Align2) {
        let galley = self.set(name);
        let rect = align.anchor_size(at, galley.size());
        let inside = self.sheet.area.shrink(2.0);
        let rect = rect.translate((inside.min - rect.min).max(Vec2::ZERO) + (inside.max - rect.max).min(Vec2::ZERO));
        if self.taken.len() >= NAMES || self.taken.iter().any(|other| other.intersects(rect)) {
            return;
        }
        self.taken.push(rect.expand(1.0));
        self.sheet.painter.rect_filled(rect.expand(1.0), 2.0, self.sheet.ground.gamma_multiply(0.55));
        self.sheet.painter.galley(rect.min, galley, self.sheet.ink);
    }
}
