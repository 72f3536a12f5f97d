//! Notices over the lower left of the picture, where they cover no control.

use crate::command::Command;
use crate::notices::Severity;
use crate::state::Desk;
use egui::{Align2, Area, Context, Frame, Id, Rect, RichText, ScrollArea, vec2};

pub(crate) fn show(ctx: &Context, picture: Rect, desk: &mut Desk<'_>) {
    let list: Vec<_> = desk.state.notices.iter().cloned().collect();
    if list.is_empty() {
        return;
    }
    let corner = picture.left_bottom() + vec2(12.0, -12.0);
    Area::new(Id::unique("notices")).pivot(Align2::LEFT_BOTTOM).fixed_pos(corner).show(ctx, |ui| {
        for notice in list {
            Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_width(380.0);
                ui.push_id(notice.id, |ui| {
                    ui.horizontal(|ui| {
                        let color = match notice.severity {
                            Severity::Done => ui.visuals().strong_text_color(),
                            Severity::Warning => ui.visuals().warn_fg_color,
                            Severity::Error => ui.visuals().error_fg_color,
                        };
                        ui.label(RichText::new(&notice.title).strong().color(color));
                        ui.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
                            if ui.small_button(desk.texts.notice_dismiss()).clicked() {
                                desk.send(Command::DismissNotice(notice.id));
                            }
                        });
                    });
                    if !notice.details.is_empty() {
                        ScrollArea::vertical().max_height(140.0).show(ui, |ui| {
                            ui.label(RichText::new(&notice.details).monospace().size(11.5));
                        });
                    }
                });
            });
        }
    });
}
