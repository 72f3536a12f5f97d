//! What the way of a ray through the trees cost: the boxes that it goes into and the shapes that it is tested against.

use crate::command::Command;
use crate::explain::{Explain, ExplainCommand, Explained};
use crate::l10n::Texts;
use crate::state::Desk;
use egui::{Align2, Context, Id, Rect, Role, ScrollArea, Sense, Slider, TextStyle, Ui, WidgetInfo, pos2, vec2};
use luch_render::explain::Walk;
use luch_scene::Shape;

/// The height of a row, in points.
const ROW: f32 = 18.0;
/// How far a row is moved in for each box around it.
const INDENT: f32 = 12.0;

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>, answer: &Explained) {
    let (texts, explain) = (desk.texts, &desk.state.explain);
    let walk = &explain.walk;
    let triangles = walk.tests.iter().filter(|test| is_mesh(answer, test.object)).count();
    ui.label(texts.explain_walk_counts(walk.boxes.len(), triangles, walk.tests.len() - triangles))
        .on_hover_text(texts.explain_walk_tip());
    let deepest = walk.boxes.iter().map(|visit| visit.level).max();
    let Some(deepest) = deepest else {
        ui.weak(texts.explain_no_boxes());
        list(ui, desk, answer);
        return;
    };
    ui.horizontal(|ui| {
        let label = ui.label(texts.explain_level()).on_hover_text(texts.explain_level_tip());
        let mut level = explain.level.min(deepest);
        let slider = ui.add(Slider::new(&mut level, 0..=deepest)).labelled_by(label.id);
        if slider.on_hover_text(texts.explain_level_tip()).changed() {
            desk.send(Command::Explain(ExplainCommand::SetLevel(level)));
        }
        let mut outer = explain.outer_levels;
        if ui.checkbox(&mut outer, texts.explain_outer_levels()).changed() {
            desk.send(Command::Explain(ExplainCommand::SetOuterLevels(outer)));
        }
        let here = walk.boxes.iter().filter(|visit| visit.level == level).count();
        ui.weak(texts.explain_boxes_here(here));
    });
    list(ui, desk, answer);
}

/// A line of the list, in the order of the ray's way.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Line {
    /// A box, by its place in the walk.
    Box(usize),
    /// A test.
    Test(usize),
}

/// Tests stand below the box that holds them; those that every ray makes come first.
fn lines(walk: &Walk) -> Vec<Line> {
    let mut lines = Vec::with_capacity(walk.boxes.len() + walk.tests.len());
    let mut tests = walk.tests.iter().enumerate().peekable();
    let mut take = |of: Option<u32>, lines: &mut Vec<Line>| {
        while let Some((place, _)) = tests.next_if(|(_, test)| test.in_box == of) {
            lines.push(Line::Test(place));
        }
    };
    take(None, &mut lines);
    for (place, number) in (0..walk.boxes.len()).zip(0_u32..) {
        lines.push(Line::Box(place));
        take(Some(number), &mut lines);
    }
    lines
}

fn list(ui: &mut Ui, desk: &Desk<'_>, answer: &Explained) {
    let walk = &desk.state.explain.walk;
    let lines = lines(walk);
    ui.spacing_mut().item_spacing.y = 0.0;
    let mut hovered = None;
    ScrollArea::vertical().auto_shrink([false, false]).id_salt("boxes").show_rows(ui, ROW, lines.len(), |ui, range| {
        for (place, line) in lines.iter().enumerate().take(range.end).skip(range.start) {
            if row(ui, desk, answer, *line, place) {
                hovered = Some(*line);
            }
        }
    });
    set_hovered(ui.ctx(), hovered);
}

/// Shows a line and answers whether the pointer is on it.
fn row(ui: &mut Ui, desk: &Desk<'_>, answer: &Explained, line: Line, place: usize) -> bool {
    let (texts, walk) = (desk.texts, &desk.state.explain.walk);
    let (level, text, end) = match line {
        Line::Box(number) => {
            let visit = &walk.boxes[number];
            let whose =
                visit.object.map_or_else(|| texts.explain_box_of_scene(), |object| answer.object(object).to_owned());
            let what = if visit.leaf { texts.explain_leaf(whose) } else { texts.explain_node(whose) };
            (visit.level, what, String::new())
        }
        Line::Test(number) => {
            let test = &walk.tests[number];
            let level = test.in_box.map_or(0, |holder| walk.boxes[holder as usize].level + 1);
            let digits = desk.state.explain.digits();
            let end = test.t.map_or_else(|| texts.explain_missed(), |t| format!("t = {}", digits.number(t)));
            (level, tested(answer, test.object, test.primitive, texts), end)
        }
    };
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    let said = if end.is_empty() { text.clone() } else { format!("{text}, {end}") };
    response.widget_info(|| WidgetInfo::labeled(Role::ListItem, true, &said));
    let visuals = ui.visuals();
    if response.hovered() {
        ui.painter().rect_filled(rect, 2.0, visuals.widgets.hovered.weak_bg_fill);
    } else if place % 2 == 1 {
        ui.painter().rect_filled(rect, 0.0, visuals.faint_bg_color);
    }
    let font = TextStyle::Body.resolve(ui.style());
    let left = rect.left() + 4.0 + (level as f32 * INDENT).min(rect.width() * 0.5);
    let strong = matches!(line, Line::Box(_));
    let color = if strong { visuals.strong_text_color() } else { visuals.text_color() };
    let middle = rect.center().y;
    if let Line::Box(number) = line {
        let side = Rect::from_center_size(pos2(left + 5.0, middle), vec2(9.0, 9.0));
        let stroke = egui::Stroke::new(1.5, crate::explain::overlay::box_color(&walk.boxes[number], visuals.dark_mode));
        ui.painter().rect_stroke(side, 0.0, stroke, egui::StrokeKind::Middle);
    }
    ui.painter().text(pos2(left + 16.0, middle), Align2::LEFT_CENTER, text, font.clone(), color);
    let met = matches!(line, Line::Test(number) if walk.tests[number].t.is_some());
    let color = if met { visuals.strong_text_color() } else { visuals.weak_text_color() };
    ui.painter().text(pos2(rect.right() - 10.0, middle), Align2::RIGHT_CENTER, end, font, color);
    response.hovered()
}

fn is_mesh(answer: &Explained, object: u32) -> bool {
    matches!(answer.scene.objects.get(object as usize).map(|object| &object.shape), Some(Shape::Mesh(_)))
}

/// What a shape that was tested is called: its object, and which triangle.
fn tested(answer: &Explained, object: u32, primitive: u32, texts: &Texts) -> String {
    let name = answer.object(object);
    if is_mesh(answer, object) { texts.explain_triangle(name, primitive.to_string()) } else { name.to_owned() }
}

fn hovered_id() -> Id {
    Id::unique("step under the pointer")
}

fn set_hovered(ctx: &Context, line: Option<Line>) {
    ctx.data_mut(|d| d.insert_temp(hovered_id(), line));
}

/// The box and the test that the pointer is on in the list, by their places in the walk.
pub(crate) fn hovered(ctx: &Context, explain: &Explain) -> [Option<usize>; 2] {
    match ctx.data(|d| d.get_temp::<Option<Line>>(hovered_id())).flatten() {
        Some(Line::Box(place)) => [Some(place).filter(|&place| place < explain.walk.boxes.len()), None],
        Some(Line::Test(place)) => [None, Some(place).filter(|&place| place < explain.walk.tests.len())],
        None => [None; 2],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_render::explain::{BoxVisit, ShapeTest};

    #[test]
    fn tests_stand_below_the_box_that_holds_them() {
        let visit = |level| BoxVisit { level, object: None, leaf: false, corners: [glam::Vec3::ZERO; 8] };
        let test = |in_box| ShapeTest { object: 0, primitive: 0, in_box, t: None };
        let walk = Walk {
            hit: None,
            boxes: vec![visit(0), visit(1), visit(1)],
            tests: vec![test(None), test(Some(1)), test(Some(1)), test(Some(2))],
        };
        use Line::{Box, Test};
        assert_eq!(lines(&walk), [Test(0), Box(0), Box(1), Test(1), Test(2), Box(2), Test(3)]);
    }
}
