//! The button, how far the picture is, and how it is made.

use crate::command::Command;
use crate::l10n::Texts;
use crate::preferences::Preferences;
use crate::state::Desk;
use crate::undo::Gesture;
use crate::widgets::check::NumberFormat;
use crate::widgets::number::NumberField;
use crate::widgets::size::size_field;
use egui::{Button, ProgressBar, Ui, vec2};
use luch_render::session::live::{LivePhase, LiveStatus};
use luch_scene::{Edit, RenderSettings, SettingsEdit};
use std::time::Duration;

pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    ui.add_space(4.0);
    size_fields(ui, desk);
    depth_field(ui, desk);
    threads_field(ui, desk);
    let texts = desk.texts;
    let status = desk.render.status();
    let busy = status.phase != LivePhase::Idle || desk.loading.is_some() || desk.files.is_adding();
    ui.horizontal(|ui| {
        let width = ui.available_width();
        let cancel = 110.0;
        let mut name = egui::RichText::new(texts.command_render()).strong();
        if desk.state.pending {
            name = name.color(ui.visuals().warn_fg_color);
        }
        let button = Button::new(name).min_size(vec2(width - cancel - ui.spacing().item_spacing.x, 30.0));
        if ui.add(button).on_hover_text(texts.render_tip()).clicked() {
            desk.send(Command::Render);
        }
        let button = Button::new(texts.command_cancel()).min_size(vec2(cancel, 30.0));
        if ui.add_enabled(busy, button).clicked() {
            desk.send(Command::Cancel);
        }
    });
    ui.horizontal(|ui| {
        let mut live = desk.state.preferences.live;
        if ui.checkbox(&mut live, texts.live_update()).on_hover_text(texts.live_update_tip()).changed() {
            desk.send(Command::SetLive(live));
        }
        progress(ui, desk, &status);
    });
    ui.add_space(4.0);
}

/// The bar: how much of the picture is made and how long the rest takes.
fn progress(ui: &mut Ui, desk: &Desk<'_>, status: &LiveStatus) {
    let texts = desk.texts;
    let share = if status.total == 0 { 0.0 } else { status.done as f32 / status.total as f32 };
    let text = if desk.loading.is_some() {
        texts.scene_loading()
    } else if desk.files.is_adding() {
        texts.files_reading()
    } else if desk.files.is_saving() {
        texts.files_saving()
    } else if desk.state.pending {
        texts.changes_wait()
    } else {
        match status.phase {
            LivePhase::Compiling => texts.progress_preparing(),
            LivePhase::Rendering => match time_left(share, status.elapsed) {
                Some(left) => texts.progress_left(percent(share), duration(left, texts)),
                None => percent(share),
            },
            LivePhase::Idle => duration(desk.state.figures.elapsed(status.elapsed), texts),
        }
    };
    let name = texts.progress();
    let bar = ProgressBar::new(share).text(text.clone()).desired_height(18.0).desired_width(ui.available_width());
    // What is done asks for no attention.
    let is_done = status.phase == LivePhase::Idle && desk.loading.is_none();
    let response = ui.add(if is_done { bar.fill(ui.visuals().widgets.inactive.bg_fill) } else { bar });
    response.widget_info(|| {
        let mut info = egui::WidgetInfo::labeled(egui::Role::ProgressIndicator, true, &name);
        info.current_text_value = Some(text.clone());
        info
    });
}

pub(super) fn percent(share: f32) -> String {
    format!("{:.0} %", share * 100.0)
}

/// How long the rest takes if it goes on as it went. Nothing is said before there is something to go by.
pub(super) fn time_left(share: f32, elapsed: Duration) -> Option<Duration> {
    let enough = share > 0.02 && elapsed > Duration::from_millis(300);
    enough.then(|| elapsed.mul_f32((1.0 - share) / share))
}

/// A duration as people say it.
pub(crate) fn duration(duration: Duration, texts: &Texts) -> String {
    let seconds = duration.as_secs_f64();
    if seconds < 1.0 {
        texts.milliseconds(format!("{:.0}", seconds * 1e3))
    } else if seconds < 100.0 {
        texts.seconds(format!("{seconds:.1}"))
    } else {
        texts.minutes(format!("{:.0}", (seconds / 60.0).floor()), format!("{:.0}", seconds % 60.0))
    }
}

fn size_fields(ui: &mut Ui, desk: &mut Desk<'_>) {
    if let Some(size) = size_field(ui, desk.scene().settings.size, desk.texts) {
        desk.send(Command::Edit(Edit::Settings(SettingsEdit::SetSize(size)), Gesture::Single));
    }
}

fn depth_field(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let (name, tip) = (texts.depth(), texts.depth_tip());
    let format = NumberFormat { range: 0.0..=f64::from(RenderSettings::MAX_DEPTH), decimals: 0, suffix: "" };
    let field = NumberField::new(&name, f64::from(desk.scene().settings.depth), format).tooltip(&tip);
    if let Some((depth, gesture)) = field.slider(0.0..=16.0).show(ui, texts) {
        desk.send(Command::Edit(Edit::Settings(SettingsEdit::SetDepth(depth as u32)), gesture));
    }
}

fn threads_field(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let cores = desk.state.figures.cores();
    let (name, tip) = (texts.threads(), texts.threads_tip(cores));
    let format = NumberFormat { range: 1.0..=Preferences::MAX_THREADS as f64, decimals: 0, suffix: "" };
    let most = (cores * 2).max(8) as f64;
    let field = NumberField::new(&name, desk.state.preferences.threads_in_use() as f64, format).tooltip(&tip);
    if let Some((threads, _)) = field.slider(1.0..=most).show(ui, texts) {
        let threads = threads as usize;
        desk.send(Command::SetThreads((threads != cores).then_some(threads)));
    }
}
