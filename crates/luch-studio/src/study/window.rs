//! The study window: what is to be measured, how far it is, and the plots.

use super::form::Form;
use super::{StudyCommand, StudyDesk, plot, words};
use crate::command::Command;
use crate::l10n::Texts;
use crate::panels::built_in_name;
use crate::state::Desk;
use crate::widgets::row;
use egui::{ComboBox, Context, Id, ProgressBar, ScrollArea, TextEdit, Ui, Window, vec2};
use luch_study::{Kind, charts, sentences};
use std::path::PathBuf;

/// Shows the window if it is open.
pub(crate) fn show(ctx: &Context, desk: &mut Desk<'_>) {
    let study = &desk.state.study;
    if !study.open {
        return;
    }
    let mut open = true;
    Window::new(desk.texts.study_title())
        .id(Id::unique("study"))
        .open(&mut open)
        .default_pos([28.0, 64.0])
        .default_size([620.0, 420.0])
        .min_width(420.0)
        .show(ctx, |ui| {
            ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| {
                let form = form(ui, desk);
                buttons(ui, desk, &form);
                results(ui, desk);
            });
        });
    if !open {
        desk.send(Command::Study(StudyCommand::Open(false)));
    }
}

/// The fields. What stands in them is the window's own business until a study begins.
fn form(ui: &mut Ui, desk: &Desk<'_>) -> Form {
    let texts = desk.texts;
    let id = Id::unique("study form");
    let mut form: Form = ui.data(|d| d.get_temp(id)).unwrap_or_else(|| Form::of(Kind::Threads));
    ui.add_enabled_ui(!desk.state.study.is_running(), |ui| {
        row::labelled(ui, &texts.study_question(), "", |ui, label| {
            let combo = ComboBox::from_id_salt("study kind")
                .width(ui.available_width())
                .selected_text(question(texts, form.kind));
            let response = combo.show_ui(ui, |ui| {
                for kind in Kind::ALL {
                    if ui.selectable_label(form.kind == kind, question(texts, kind)).clicked() && form.kind != kind {
                        form = Form::of(kind);
                    }
                }
            });
            response.response.labelled_by(label.id);
        });
        if form.kind != Kind::Triangles {
            row::labelled(ui, &texts.study_scenes(), "", |ui, _| {
                ui.horizontal_wrapped(|ui| {
                    for scene in luch_io::builtin::ids() {
                        let mut on = form.scenes.contains(&scene);
                        if ui.checkbox(&mut on, built_in_name(scene, texts)).changed() {
                            form.toggle(scene, on);
                        }
                    }
                });
            });
        }
        let values = match form.kind {
            Kind::Threads => texts.study_threads_values(),
            Kind::Triangles => texts.study_triangles_values(),
            Kind::Rays => texts.study_rays_values(),
            Kind::Tiles => texts.study_tiles_values(),
        };
        text_row(ui, &values, &mut form.values, f32::INFINITY);
        if form.kind != Kind::Threads {
            text_row(ui, &texts.threads(), &mut form.threads, 64.0);
        }
        text_row(ui, &texts.study_runs(), &mut form.runs, 64.0);
        row::labelled(ui, &texts.picture_size(), "", |ui, _| {
            let size = vec2(64.0, ui.spacing().interact_size.y);
            let sides = [(&mut form.width, texts.picture_width()), (&mut form.height, texts.picture_height())];
            for (index, (text, name)) in sides.into_iter().enumerate() {
                if index == 1 {
                    ui.label("×");
                }
                let response = ui.add_sized(size, TextEdit::singleline(text).char_limit(8));
                response.ctx.accesskit_node_builder(response.id, |node| node.set_label(name));
            }
        });
    });
    ui.data_mut(|d| d.insert_temp(id, form.clone()));
    form
}

fn question(texts: &Texts, kind: Kind) -> String {
    match kind {
        Kind::Threads => texts.study_threads(),
        Kind::Triangles => texts.study_triangles(),
        Kind::Rays => texts.study_rays(),
        Kind::Tiles => texts.study_tiles(),
    }
}

fn text_row(ui: &mut Ui, name: &str, text: &mut String, width: f32) {
    row::labelled(ui, name, "", |ui, label| {
        let width = width.min(ui.available_width());
        let size = vec2(width, ui.spacing().interact_size.y);
        ui.add_sized(size, TextEdit::singleline(text).char_limit(400)).labelled_by(label.id);
    });
}

/// Start or stop, and how far it is.
fn buttons(ui: &mut Ui, desk: &mut Desk<'_>, form: &Form) {
    let texts = desk.texts;
    let Some(running) = &desk.state.study.running else {
        let plan = form.plan(texts, words(desk.state.preferences.language));
        if let Err(error) = &plan {
            row::complaint(ui, error);
        }
        if ui.add_enabled(plan.is_ok(), egui::Button::new(texts.study_start())).clicked()
            && let Ok(plan) = plan
        {
            desk.send(Command::Study(StudyCommand::Start(Box::new(plan))));
        }
        return;
    };
    let (done, total) = (running.progress.done(), running.progress.total());
    let share = if total == 0 { 0.0 } else { done as f32 / total as f32 };
    let elapsed = running.began.elapsed();
    let mut text = format!("{:.0} %", share * 100.0);
    if share > 0.02 {
        let left = crate::panels::duration(elapsed.mul_f32((1.0 - share) / share), texts);
        text = texts.progress_left(text, left);
    }
    ui.horizontal(|ui| {
        if ui.button(texts.study_stop()).clicked() {
            desk.send(Command::Study(StudyCommand::Cancel));
        }
        ui.add(ProgressBar::new(share).text(text).desired_width(ui.available_width()));
    });
    ui.weak(texts.study_hands_off());
}

/// Sentences, plots, and a place to keep them.
fn results(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let StudyDesk { findings: Some(findings), .. } = &desk.state.study else {
        ui.separator();
        ui.weak(texts.study_nothing_yet());
        return;
    };
    let language = words(desk.state.preferences.language);
    ui.separator();
    for chart in charts(findings, language) {
        ui.strong(&chart.title);
        for (index, panel) in chart.panels.iter().enumerate() {
            if let Some(title) = &panel.title {
                ui.label(title);
            }
            plot::show(ui, &format!("{}-{index}", chart.stem), panel);
        }
        ui.add_space(6.0);
    }
    for sentence in sentences(findings, language) {
        ui.label(sentence);
    }
    ui.separator();
    let id = Id::unique("study folder");
    let mut folder: String = ui.data(|d| d.get_temp(id)).unwrap_or_else(|| "luch-study".to_owned());
    text_row(ui, &texts.study_folder(), &mut folder, f32::INFINITY);
    let ready = !folder.trim().is_empty() && desk.state.study.saving.is_none() && !desk.state.study.is_running();
    if ui.add_enabled(ready, egui::Button::new(texts.study_save())).on_hover_text(texts.study_save_tip()).clicked() {
        desk.send(Command::Study(StudyCommand::Save(PathBuf::from(folder.trim()))));
    }
    ui.data_mut(|d| d.insert_temp(id, folder));
}
