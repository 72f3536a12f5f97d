//! A number: a slider, and a field to type it into. What is typed is checked and taken at Enter or when the field is
//! left; what is wrong is said below the field, and the last good number stays.

use super::check::NumberFormat;
use super::left::Left;
use super::row;
use crate::l10n::Texts;
use crate::undo::Gesture;
use egui::{Id, Response, Slider, TextEdit, Ui, vec2};
use std::ops::RangeInclusive;

/// A line with a number.
#[derive(Debug)]
pub(crate) struct NumberField<'a> {
    name: &'a str,
    tooltip: &'a str,
    value: f64,
    format: NumberFormat,
    slider: Option<RangeInclusive<f64>>,
    logarithmic: bool,
}

/// What a field remembers while it is typed into.
#[derive(Debug, Clone, Default)]
struct Typing {
    /// What stands in the field; `None`: the value itself.
    text: Option<String>,
    error: Option<String>,
    left: Left,
    /// The value that the error was about.
    about: f64,
}

impl<'a> NumberField<'a> {
    pub(crate) const fn new(name: &'a str, value: f64, format: NumberFormat) -> Self {
        Self { name, tooltip: "", value, format, slider: None, logarithmic: false }
    }

    pub(crate) const fn tooltip(mut self, tooltip: &'a str) -> Self {
        self.tooltip = tooltip;
        self
    }

    /// Adds a slider over a part of the range.
    pub(crate) const fn slider(mut self, range: RangeInclusive<f64>) -> Self {
        self.slider = Some(range);
        self
    }

    /// Makes the steps of the slider grow with the number.
    pub(crate) const fn logarithmic(mut self) -> Self {
        self.logarithmic = true;
        self
    }

    /// Shows the line; answers with a new number when there is one.
    pub(crate) fn show(self, ui: &mut Ui, texts: &Texts) -> Option<(f64, Gesture)> {
        self.show_with(ui, texts, 0.0, |_| ())
    }

    /// The same with something more at the end of the line, which takes so many points.
    pub(crate) fn show_with(
        self,
        ui: &mut Ui,
        texts: &Texts,
        room: f32,
        more: impl FnOnce(&mut Ui),
    ) -> Option<(f64, Gesture)> {
        let id = ui.scope_id().with(("number", self.name));
        let changed = row::labelled(ui, self.name, self.tooltip, |ui, label| {
            let field = 72.0;
            let mut slid = None;
            if let Some(range) = self.slider.clone() {
                ui.spacing_mut().slider_width =
                    (ui.available_width() - field - room - ui.spacing().item_spacing.x).max(24.0);
                let mut value = self.value;
                let slider = Slider::new(&mut value, range).show_value(false).logarithmic(self.logarithmic);
                let slider = if self.format.decimals == 0 { slider.step_by(1.0) } else { slider };
                let response = ui.add(slider).labelled_by(label.id);
                row::tip(&response, self.tooltip);
                if response.changed() {
                    slid = Some((self.rounded(value), Gesture::Ongoing(response.id)));
                }
            }
            let (response, typed) = field_of(ui, id, self.value, &self.format, field, texts);
            row::tip(&response.labelled_by(label.id), self.tooltip);
            more(ui);
            slid.or(typed.map(|value| (value, Gesture::Single)))
        });
        show_complaint(ui, id, self.value);
        changed.filter(|(value, _)| *value != self.value)
    }

    /// The number with the digits that the field shows, so that what is seen is what is set.
    fn rounded(&self, value: f64) -> f64 {
        let scale = 10_f64.powi(i32::try_from(self.format.decimals).unwrap_or(0));
        (value * scale).round() / scale
    }
}

/// Shows a field for a number and answers with what was typed when it is good and done.
pub(crate) fn field_of(
    ui: &mut Ui,
    id: Id,
    value: f64,
    format: &NumberFormat,
    width: f32,
    texts: &Texts,
) -> (Response, Option<f64>) {
    let mut typing: Typing = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let field = id.with("field");
    if typing.error.is_some() && (typing.about != value || typing.left.has_gone_on(ui, field)) {
        typing.error = None;
    }
    let mut text = typing.text.clone().unwrap_or_else(|| format.write(value));
    // What is shown of the value itself is right.
    let wrong = typing.error.is_some() && typing.text.is_some();
    let edit = TextEdit::singleline(&mut text).id(field).desired_width(width).char_limit(40);
    let edit = if wrong { edit.text_color(ui.visuals().error_fg_color) } else { edit };
    let response = ui.add_sized(vec2(width, ui.spacing().interact_size.y), edit);
    let mut done = None;
    if response.gained_focus() {
        typing = Typing { text: Some(text.clone()), about: value, ..Typing::default() };
        select_all(ui, &response, &text);
    }
    if response.changed() {
        typing.error = format.read(&text, texts).err();
        typing.about = value;
        typing.text = Some(text.clone());
    }
    if response.lost_focus() {
        if ui.input(|i| i.key_pressed(egui::Key::Escape)) {
            typing = Typing::default();
        } else if typing.text.is_some() {
            match format.read(&text, texts) {
                Ok(number) => {
                    // What was shown rounded and not touched keeps its digits.
                    done = (text != format.write(value)).then_some(number);
                    typing = Typing::default();
                }
                Err(error) => typing = Typing { error: Some(error), about: value, ..Typing::default() },
            }
        }
    }
    ui.data_mut(|data| data.insert_temp(id, typing));
    (response, done)
}

/// Says below a field what is wrong with what was typed, if anything is.
pub(crate) fn show_complaint(ui: &mut Ui, id: Id, value: f64) {
    let typing: Typing = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    if let Some(error) = typing.error.filter(|_| typing.about == value) {
        row::complaint(ui, &error);
    }
}

fn select_all(ui: &Ui, response: &Response, text: &str) {
    let mut state = TextEdit::load_state(ui.ctx(), response.id).unwrap_or_default();
    let end = egui::text::CCursor::new(text.chars().count());
    state.cursor.set_char_range(Some(egui::text::CCursorRange::two(egui::text::CCursor::default(), end)));
    state.store(ui.ctx(), response.id);
}
