//! The panel below the picture: the pixel, the tree of its rays, and what is told of the ray that is looked at.

mod boxes;
mod equation;
mod header;
mod sum;
mod top;
mod tree;
mod typeset;

pub(super) use boxes::hovered as hovered_step;
pub(super) use sum::words_of;
pub(crate) use tree::has_focus as tree_has_focus;

use super::{ExplainCommand, Page, Unexplained};
use crate::command::Command;
use crate::state::Desk;
use egui::{Context, Id, Panel, Ui};
use luch_render::explain::ExplainError;

/// The least height, the first at least and at most, in points.
const HEIGHT: [f32; 3] = [140.0, 300.0, 460.0];
/// The least and the first width of the tree.
const TREE: [f32; 2] = [150.0, 440.0];

/// Shows the panel while a pixel is explained. Its size is remembered.
pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let explain = &desk.state.explain;
    let Some(pixel) = explain.pixel else {
        set_hovered_ray(ui.ctx(), None);
        top::forget(ui.ctx());
        return;
    };
    let most = (ui.available_height() - 180.0).max(HEIGHT[0]);
    let first = (ui.available_height() * 0.42).clamp(HEIGHT[1], HEIGHT[2]);
    Panel::bottom("explain").resizable(true).min_size(HEIGHT[0]).default_size(first).max_size(most).show(ui, |ui| {
        // What it holds does not make it smaller than it was made.
        ui.set_min_size(ui.available_size());
        header::show(ui, desk, pixel);
        ui.separator();
        if let Some(why) = &explain.unexplained {
            set_hovered_ray(ui.ctx(), None);
            ui.label(why_not(why, desk));
            return;
        }
        let Some(answer) = explain.answer.as_ref() else { return };
        let widest = (ui.available_width() * 0.7).max(TREE[0]);
        let first = TREE[1].min(ui.available_width() * 0.48);
        let tree = Panel::left("explain rays").resizable(true).min_size(TREE[0]).default_size(first).max_size(widest);
        tree.frame(egui::Frame::NONE).show(ui, |ui| tree::show(ui, desk, answer));
        name_handle(ui, "explain rays", desk.texts.explain_tree_width());
        let rest = egui::Frame::NONE.inner_margin(egui::Margin { left: 10, ..Default::default() });
        egui::CentralPanel::default().frame(rest).show(ui, |ui| {
            tabs(ui, desk);
            match explain.page {
                Page::Sum => sum::show(ui, desk, answer),
                Page::Top => top::show(ui, desk, answer),
                Page::Boxes => boxes::show(ui, desk, answer),
            }
        });
    });
    name_handle(ui, "explain", desk.texts.explain_height());
}

/// Names the edge of a panel by which it is made larger: egui has an English name only.
fn name_handle(ui: &Ui, panel: &str, name: String) {
    let handle = ui.scope_id().with(panel).with("__resize");
    ui.ctx().accesskit_node_builder(handle, |node| node.set_label(name));
}

/// The sides of the account to choose from.
fn tabs(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    ui.horizontal_wrapped(|ui| {
        for page in Page::ALL {
            let (name, tip) = match page {
                Page::Sum => (texts.explain_page_sum(), texts.explain_page_sum_tip()),
                Page::Top => (texts.explain_page_top(), texts.explain_page_top_tip()),
                Page::Boxes => (texts.explain_page_boxes(), texts.explain_page_boxes_tip()),
            };
            if ui.selectable_label(desk.state.explain.page == page, name).on_hover_text(tip).clicked() {
                desk.send(Command::Explain(ExplainCommand::Show(page)));
            }
        }
    });
}

fn why_not(why: &Unexplained, desk: &Desk<'_>) -> String {
    let texts = desk.texts;
    match why {
        Unexplained::Refused(ExplainError::OutsidePicture { size, .. }) => {
            texts.explain_outside(size.width().to_string(), size.height().to_string())
        }
        Unexplained::Refused(ExplainError::TooManyRays) => texts.explain_too_many(),
        Unexplained::Refused(ExplainError::Stopped) => texts.explain_stopped(),
        Unexplained::Internal(message) => format!("{}: {message}", texts.notice_internal()),
    }
}

fn hovered_id() -> Id {
    Id::unique("ray under the pointer")
}

/// The ray whose row the pointer is on.
pub(super) fn hovered_ray(ctx: &Context) -> Option<u32> {
    ctx.data(|d| d.get_temp::<Option<u32>>(hovered_id())).flatten()
}

fn set_hovered_ray(ctx: &Context, ray: Option<u32>) {
    ctx.data_mut(|d| d.insert_temp(hovered_id(), ray));
}
