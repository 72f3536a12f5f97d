//! The head of the panel: the pixel, its colour in every form, and how its samples differ.

use crate::command::Command;
use crate::explain::numbers::{Digits, color32, srgb8};
use crate::explain::{Copier, ExplainCommand, Explained, Format};
use crate::state::Desk;
use crate::studio::PATIENCE;
use egui::{Align, Button, Layout, RichText, Sense, Ui, vec2};

/// The width of the panel below which the head takes more lines, in points.
const NARROW: f32 = 440.0;

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>, [x, y]: [u32; 2]) {
    let texts = desk.texts;
    let is_narrow = ui.available_width() < NARROW;
    ui.horizontal(|ui| {
        let title = texts.explain_pixel(x.to_string(), y.to_string());
        ui.strong(title).on_hover_text(texts.explain_pixel_tip());
        notes(ui, desk);
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            if ui.button(texts.explain_close()).on_hover_text(texts.explain_close_tip()).clicked() {
                desk.send(Command::Explain(ExplainCommand::Close));
            }
            copy_menu(ui, desk);
            if !is_narrow {
                every_digit(ui, desk);
            }
        });
    });
    if let Some(answer) = desk.state.explain.answer.clone() {
        ui.horizontal_wrapped(|ui| {
            color(ui, desk, &answer);
            if is_narrow {
                every_digit(ui, desk);
            }
        });
    }
}

/// Whether numbers are written to the last digit.
fn every_digit(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let mut every = desk.state.explain.every_digit;
    let box_ = ui.checkbox(&mut every, texts.explain_every_digit());
    if box_.on_hover_text(texts.explain_every_digit_tip()).changed() {
        desk.send(Command::Explain(ExplainCommand::SetEveryDigit(every)));
    }
}

/// The account as text of some form.
fn copy_menu(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    let rays = desk.state.explain.answer.as_ref().map_or(0, |answer| answer.account.rays.len());
    ui.menu_button(texts.explain_copy(), |ui| {
        for format in Format::ALL {
            let (name, tip) = match format {
                Format::Text => (texts.explain_copy_text(), texts.explain_copy_sample_tip()),
                Format::Markdown => (texts.explain_copy_markdown(), texts.explain_copy_sample_tip()),
                Format::Latex => (texts.explain_copy_latex(), texts.explain_copy_sample_tip()),
                Format::Json => (texts.explain_copy_json(), texts.explain_copy_json_tip()),
            };
            let fits = rays > 0 && (format != Format::Json || rays <= Copier::MOST_RAYS);
            let button = ui.add_enabled(fits, Button::new(name));
            if button.on_hover_text(tip).on_disabled_hover_text(texts.explain_copy_too_many()).clicked() {
                desk.send(Command::Explain(ExplainCommand::Copy(format)));
            }
        }
    })
    .response
    .on_hover_text(texts.explain_copy_tip());
}

/// What must be known before the numbers are believed.
fn notes(ui: &mut Ui, desk: &Desk<'_>) {
    let (texts, explain) = (desk.texts, &desk.state.explain);
    let shown = desk.render.picture().map(|(snapshot, _)| snapshot);
    if explain.asked.is_some_and(|(since, _)| since.elapsed() >= PATIENCE) {
        ui.spinner();
        ui.weak(texts.explain_working());
    } else if let (Some(answer), Some(shown)) = (&explain.answer, shown)
        && answer.epoch != shown.epoch
    {
        let color = ui.visuals().warn_fg_color;
        ui.colored_label(color, texts.explain_older()).on_hover_text(texts.explain_older_tip());
    }
    if shown.is_some_and(|shown| shown.job.integrator != luch_render::Integrator::Classic) {
        ui.weak(texts.explain_other_view()).on_hover_text(texts.explain_other_view_tip());
    }
}

/// The pixel's colour, and how its samples differ.
fn color(ui: &mut Ui, desk: &Desk<'_>, answer: &Explained) {
    let (texts, account) = (desk.texts, &answer.account);
    patch(ui, account.pixel);
    // The pixel's own numbers always stand whole: they are what everything below adds up to.
    let linear = Digits::EVERY.color(account.pixel).join("  ");
    ui.label(texts.explain_linear()).on_hover_text(texts.explain_linear_tip());
    ui.label(RichText::new(linear).monospace());
    ui.separator();
    let [r, g, b] = srgb8(account.pixel);
    ui.label(texts.explain_srgb()).on_hover_text(texts.explain_srgb_tip());
    ui.label(RichText::new(format!("{r} {g} {b}  #{r:02x}{g:02x}{b:02x}")).monospace());
    ui.separator();
    let samples = account.samples.len();
    ui.label(texts.explain_samples(samples)).on_hover_text(texts.explain_samples_tip());
    if samples > 1 {
        let digits = desk.state.explain.digits();
        let spread = &account.spread;
        ui.label(texts.explain_spread(digits.triple(spread.std_dev)))
            .on_hover_text(texts.explain_spread_tip(digits.triple(spread.min), digits.triple(spread.max)));
    }
}

/// A square of a colour.
pub(super) fn patch(ui: &mut Ui, color: [f32; 3]) {
    let (rect, _) = ui.allocate_exact_size(vec2(18.0, 18.0), Sense::hover());
    let border = ui.visuals().widgets.noninteractive.bg_stroke;
    ui.painter().rect(rect.shrink(1.0), 2.0, color32(color), border, egui::StrokeKind::Outside);
}
