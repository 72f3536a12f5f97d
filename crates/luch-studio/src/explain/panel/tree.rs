//! The tree of rays: a list of rows, of which those in sight alone are laid out.

use super::set_hovered_ray;
use crate::command::Command;
use crate::explain::looks::Look;
use crate::explain::numbers::{Digits, color32, percent};
use crate::explain::{ExplainCommand, Explained, icons};
use crate::state::Desk;
use egui::text::{LayoutJob, TextWrapping};
use egui::{
    Align2, Context, EventFilter, FontId, Id, Key, Modifiers, Rect, Response, Role, ScrollArea, Sense, Shape,
    StrokeKind, TextStyle, Ui, WidgetInfo, pos2, vec2,
};

/// The height of a row, in points.
const ROW: f32 = 20.0;
/// How far a row is moved in for each mirror before it, and at most.
const INDENT: [f32; 2] = [14.0, 140.0];
/// The widths of the columns to the right: number, distance, share, colour.
const COLUMNS: [f32; 4] = [38.0, 62.0, 56.0, 24.0];
/// The width of the tree below which the number and the distance are left out for the name's sake.
const NARROW: f32 = 280.0;

fn tree_id() -> Id {
    Id::unique("tree of rays")
}

/// Whether the keys are the tree's.
pub(crate) fn has_focus(ctx: &Context) -> bool {
    ctx.memory(|m| m.has_focus(tree_id()))
}

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>, answer: &Explained) {
    let rows = desk.state.explain.rows.shown();
    ui.spacing_mut().item_spacing.y = 0.0;
    head(ui, desk);
    let id = tree_id();
    let page = (ui.available_height() / ROW).max(2.0) as usize - 1;
    let row = desk.state.explain.rows.place_of(desk.state.explain.ray);
    let moved = take_keys(ui, id, desk, answer, row, page);
    let mut area = ScrollArea::vertical().auto_shrink([false, false]).id_salt("rays");
    // A row that was gone to by key, or by an edit, is brought into sight.
    let shown_id = id.with("shown");
    let last: Option<u32> = ui.data(|d| d.get_temp(shown_id));
    if last != Some(desk.state.explain.ray) {
        ui.data_mut(|d| d.insert_temp(shown_id, desk.state.explain.ray));
        let offset: f32 = ui.data(|d| d.get_temp(id.with("offset"))).unwrap_or(0.0);
        let (top, height) = (row as f32 * ROW, ui.available_height());
        if top < offset {
            area = area.vertical_scroll_offset(top);
        } else if top + ROW > offset + height {
            area = area.vertical_scroll_offset(top + ROW - height);
        }
    }
    let (mut hovered, mut clicked) = (None, false);
    let output = area.show_rows(ui, ROW, rows.len(), |ui, range| {
        for place in range {
            let Some(&ray) = rows.get(place) else { continue };
            let row = show_row(ui, desk, answer, ray, id);
            clicked |= row.clicked();
            if row.hovered() {
                hovered = Some(ray);
            }
        }
    });
    ui.data_mut(|d| d.insert_temp(id.with("offset"), output.state.clamped_offset().y));
    let tree = ui.interact(output.inner_rect, id, Sense::focusable_noninteractive());
    let name = desk.texts.explain_tree();
    // Rows come and go with scrolling: the tree has the focus for them.
    if clicked {
        tree.request_focus();
    }
    tree.widget_info(|| WidgetInfo::labeled(Role::Tree, true, &name));
    let active = row_id(id, desk.state.explain.ray);
    ui.ctx().accesskit_node_builder(id, |node| node.set_active_descendant(active.accesskit_id()));
    if tree.has_focus() {
        let stroke = ui.visuals().selection.stroke;
        ui.painter().rect_stroke(output.inner_rect, 2.0, stroke, StrokeKind::Inside);
    }
    set_hovered_ray(ui.ctx(), if moved { None } else { hovered });
}

/// The names of the columns.
fn head(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    let columns = [
        (texts.explain_column_ray(), texts.explain_column_ray_tip()),
        (texts.explain_column_number(), texts.explain_column_number_tip()),
        (texts.explain_column_t(), texts.explain_column_t_tip()),
        (texts.explain_column_share(), texts.explain_column_share_tip()),
    ];
    let edges = edges(rect);
    fold_buttons(ui, desk, Rect::from_x_y_ranges(edges[1] - 40.0..=edges[1], rect.y_range()));
    for (place, (name, tip)) in columns.into_iter().enumerate() {
        let cell = Rect::from_x_y_ranges(edges[place]..=edges[place + 1], rect.y_range());
        if cell.width() <= 0.0 {
            continue;
        }
        let (align, at) = if place == 0 {
            (Align2::LEFT_CENTER, cell.left_center() + vec2(4.0, 0.0))
        } else {
            (Align2::RIGHT_CENTER, cell.right_center())
        };
        let color = ui.visuals().weak_text_color();
        let mut job = LayoutJob::simple_singleline(name.clone(), TextStyle::Small.resolve(ui.style()), color);
        // Before the buttons that fold the tree.
        let room = if place == 0 { cell.width() - 48.0 } else { cell.width() };
        job.wrap = TextWrapping::truncate_at_width(room.max(0.0));
        let galley = ui.painter().layout_job(job);
        ui.painter().galley(align.anchor_size(at, galley.size()).min, galley, color);
        let response = ui.interact(cell, ui.scope_id().with(("column", place)), Sense::hover());
        response.widget_info(|| WidgetInfo::labeled(Role::ColumnHeader, true, &name));
        response.on_hover_text(tip);
    }
}

/// Unfolds and folds the whole tree.
fn fold_buttons(ui: &mut Ui, desk: &mut Desk<'_>, area: Rect) {
    let texts = desk.texts;
    let buttons = [(false, texts.explain_unfold_all()), (true, texts.explain_fold_all())];
    for ((closed, name), place) in buttons.into_iter().zip(0_u8..) {
        let rect = Rect::from_center_size(
            pos2(area.left() + 10.0 + 20.0 * f32::from(place), area.center().y),
            vec2(18.0, 18.0),
        );
        let response = ui.interact(rect, ui.scope_id().with(("fold all", closed)), Sense::click());
        response.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
        let color = ui.style().interact(&response).text_color();
        for shift in [-2.5, 2.5] {
            let by = if closed { vec2(shift, 0.0) } else { vec2(0.0, shift) };
            triangle(ui, rect.translate(by), closed, color);
        }
        if response.on_hover_text(name).clicked() {
            desk.send(Command::Explain(ExplainCommand::FoldAll(closed)));
        }
    }
}

/// Where the columns begin, and where the last ends.
fn edges(rect: Rect) -> [f32; 6] {
    let right = rect.right() - 8.0;
    let colour = right - COLUMNS[3];
    let share = colour - COLUMNS[2];
    if rect.width() < NARROW {
        return [rect.left(), share, share, share, colour, right];
    }
    let distance = share - COLUMNS[1];
    [rect.left(), distance - COLUMNS[0], distance, share, colour, right]
}

fn row_id(tree: Id, ray: u32) -> Id {
    tree.with(("ray", ray))
}

fn show_row(ui: &mut Ui, desk: &mut Desk<'_>, answer: &Explained, ray: u32, tree: Id) -> Response {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::hover());
    let response = ui.interact(rect, row_id(tree, ray), Sense::CLICK);
    let explain = &desk.state.explain;
    let selected = explain.ray == ray;
    let account = &answer.account.rays[ray as usize];
    let look = Look::of(&answer.account, ray);
    let name = name_of(answer, ray, desk);
    let says = format!("{}: {name}, {}", look.name(desk.texts), percent(account.weight));
    response.widget_info(|| WidgetInfo::labeled(Role::TreeItem, true, &says));
    let (level, folds, closed) = (account.depth as usize + 1, account.descendants > 0, explain.rows.is_closed(ray));
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_selected(selected);
        node.set_level(level);
        if folds {
            node.set_expanded(!closed);
        }
    });

    let visuals = ui.visuals();
    if selected {
        ui.painter().rect_filled(rect, 2.0, visuals.selection.bg_fill);
    } else if response.hovered() {
        ui.painter().rect_filled(rect, 2.0, visuals.widgets.hovered.weak_bg_fill);
    }
    let text_color = if selected { visuals.selection.stroke.color } else { visuals.text_color() };
    let edges = edges(rect);
    let middle = rect.center().y;
    let left = rect.left() + 4.0 + (account.depth as f32 * INDENT[0]).min(INDENT[1]);
    let fold = Rect::from_center_size(pos2(left + 6.0, middle), vec2(14.0, ROW));
    if account.descendants > 0 {
        triangle(ui, fold, explain.rows.is_closed(ray), text_color);
    }
    let icon = Rect::from_center_size(pos2(left + 22.0, middle), vec2(16.0, 16.0));
    icons::paint(ui.painter(), icon, look, look.color(visuals.dark_mode));

    let font = TextStyle::Body.resolve(ui.style());
    let start = left + 34.0;
    let mut job = LayoutJob::simple_singleline(name, font, text_color);
    // The rest of a long name stands in the tooltip.
    job.wrap = TextWrapping::truncate_at_width((edges[1] - start).max(0.0));
    let galley = ui.painter().layout_job(job);
    let cut = galley.elided;
    ui.painter().galley(pos2(start, middle - galley.size().y * 0.5), galley, text_color);
    let small = FontId::proportional(12.0);
    let right = |column: usize, text: String| {
        let at = pos2(edges[column + 1], middle);
        ui.painter().text(at, Align2::RIGHT_CENTER, text, small.clone(), text_color);
    };
    if edges[1] < edges[2] {
        right(1, ray.to_string());
        right(2, answer.t_of(ray).map_or_else(|| "—".to_owned(), |t| Digits { every: false }.number(t)));
    }
    right(3, percent(account.weight));
    let patch = Rect::from_center_size(pos2(edges[5] - 9.0, middle), vec2(14.0, 14.0));
    ui.painter().rect(
        patch,
        2.0,
        color32(account.color),
        visuals.widgets.noninteractive.bg_stroke,
        StrokeKind::Outside,
    );

    if response.clicked() {
        let on_fold = response.interact_pointer_pos().is_some_and(|at| fold.contains(at));
        if on_fold && account.descendants > 0 {
            desk.send(Command::Explain(ExplainCommand::Fold(ray, !explain.rows.is_closed(ray))));
        } else {
            desk.send(Command::Explain(ExplainCommand::SelectRay(ray)));
        }
    }
    if response.double_clicked() {
        desk.send(Command::Explain(ExplainCommand::Fold(ray, !explain.rows.is_closed(ray))));
    }
    if cut { response.on_hover_text(says) } else { response }
}

/// What a row is called: where the ray ends, and the sample of a camera ray if there are several.
fn name_of(answer: &Explained, ray: u32, desk: &Desk<'_>) -> String {
    let account = &answer.account.rays[ray as usize];
    let end = answer.end_of(ray, desk.texts);
    if account.parent.is_none() && answer.account.samples.len() > 1 {
        return desk.texts.explain_sample_row((account.sample + 1).to_string(), end);
    }
    end
}

/// The sign of what is folded or open.
fn triangle(ui: &Ui, rect: Rect, closed: bool, color: egui::Color32) {
    let center = rect.center();
    let points = if closed {
        [vec2(-2.5, -4.0), vec2(3.5, 0.0), vec2(-2.5, 4.0)]
    } else {
        [vec2(-4.0, -2.5), vec2(4.0, -2.5), vec2(0.0, 3.5)]
    };
    ui.painter().add(Shape::convex_polygon(points.map(|p| center + p).to_vec(), color, egui::Stroke::NONE));
}

/// The keys of a tree, while it has the focus; answers whether one was pressed.
fn take_keys(ui: &Ui, id: Id, desk: &mut Desk<'_>, answer: &Explained, row: usize, page: usize) -> bool {
    if !ui.memory(|m| m.has_focus(id)) {
        return false;
    }
    let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..Default::default() };
    ui.memory_mut(|m| m.set_focus_lock_filter(id, arrows));
    let explain = &desk.state.explain;
    let (rows, ray) = (explain.rows.shown(), explain.ray);
    let Some(account) = answer.account.rays.get(ray as usize) else { return false };
    let pressed = |key: Key| ui.input_mut(|i| i.consume_key(Modifiers::NONE, key));
    let last = rows.len().saturating_sub(1);
    let folds = account.descendants > 0;
    let closed = explain.rows.is_closed(ray);
    let goes_to = if pressed(Key::ArrowDown) {
        Some(row + 1)
    } else if pressed(Key::ArrowUp) {
        Some(row.saturating_sub(1))
    } else if pressed(Key::PageDown) {
        Some(row + page)
    } else if pressed(Key::PageUp) {
        Some(row.saturating_sub(page))
    } else if pressed(Key::Home) {
        Some(0)
    } else if pressed(Key::End) {
        Some(last)
    } else {
        None
    };
    let command = if let Some(to) = goes_to {
        rows.get(to.min(last)).map(|&to| ExplainCommand::SelectRay(to))
    } else if pressed(Key::ArrowRight) {
        match (folds, closed) {
            (true, true) => Some(ExplainCommand::Fold(ray, false)),
            (true, false) => Some(ExplainCommand::SelectRay(ray + 1)),
            (false, _) => None,
        }
    } else if pressed(Key::ArrowLeft) {
        if folds && !closed {
            Some(ExplainCommand::Fold(ray, true))
        } else {
            account.parent.map(ExplainCommand::SelectRay)
        }
    } else {
        None
    };
    let Some(command) = command else { return false };
    desk.send(Command::Explain(command));
    true
}
