//! What is told of the ray that is looked at: where it goes, what it hits, and the lighting sum with its numbers.

use super::equation::{self, Meanings, show_lines};
use super::header::patch;
use super::typeset::{Setter, lines};
use crate::explain::numbers::Digits;
use crate::explain::{Explained, looks::Look};
use crate::l10n::{Language, Texts};
use crate::state::Desk;
use egui::{CollapsingHeader, Grid, Id, RichText, ScrollArea, Ui, vec2};
use luch_explain::{Block, Document, Explanation, Options};
use luch_render::explain::RayKind;
use std::sync::Arc;

/// The width of the column of names, in points.
const NAMES: f32 = 132.0;

/// What was told last: the same as long as the ray, the account and the language are.
#[derive(Clone)]
struct Told {
    answer: Arc<Explained>,
    ray: u32,
    language: Language,
    document: Arc<Document>,
    meanings: Arc<Meanings>,
    /// The width that it was laid out in, and how high each block came out.
    width: f32,
    heights: Vec<f32>,
}

pub(super) fn show(ui: &mut Ui, desk: &Desk<'_>, answer: &Arc<Explained>) {
    let id = Id::unique("told of a ray");
    let (ray, language) = (desk.state.explain.ray, desk.state.preferences.language);
    let known: Option<Told> = ui.data(|d| d.get_temp(id));
    let same = |told: &Told| Arc::ptr_eq(&told.answer, answer) && told.ray == ray && told.language == language;
    let mut told = known.filter(same).unwrap_or_else(|| tell(answer, ray, language));
    ScrollArea::both().auto_shrink([false, false]).id_salt("told").show(ui, |ui| {
        let width = ui.available_width();
        if told.width != width {
            told.heights.clear();
            told.width = width;
        }
        told.heights.resize(told.document.blocks.len(), 0.0);
        title(ui, desk, answer, ray);
        if answer.account.surface_of(ray).is_some() {
            equation::show_model(ui, desk.texts, &told.meanings);
        }
        let document = Arc::clone(&told.document);
        let digits = desk.state.explain.digits();
        let mut facts_before = 0;
        for (place, (block, height)) in document.blocks.iter().zip(&mut told.heights).enumerate() {
            // Of a scene with a thousand lights those in sight alone are laid out.
            let top = ui.cursor().min;
            let rect = egui::Rect::from_min_size(top, vec2(width, *height));
            if *height > 0.0 && !ui.is_rect_visible(rect) {
                ui.allocate_space(vec2(width, *height));
                facts_before += usize::from(matches!(block, Block::Facts(_)));
                continue;
            }
            let how = How { texts: desk.texts, digits, meanings: &told.meanings, facts_before };
            let used = ui.push_id(place, |ui| show_block(ui, block, &how)).response.rect;
            *height = used.height();
            facts_before += usize::from(matches!(block, Block::Facts(_)));
        }
        contribution(ui, desk, answer, ray);
        ui.add_space(8.0);
    });
    ui.data_mut(|d| d.insert_temp(id, told));
}

fn tell(answer: &Arc<Explained>, ray: u32, language: Language) -> Told {
    let explanation = answer.explanation();
    let options = Options { language: words_of(language), ..Options::default() };
    let document = explanation.ray(ray, &options);
    Told {
        answer: Arc::clone(answer),
        ray,
        language,
        document: Arc::new(document),
        meanings: meanings(&explanation, &options),
        width: 0.0,
        heights: Vec::new(),
    }
}

/// The language of the explanation that is the window's.
pub(in crate::explain) const fn words_of(language: Language) -> luch_explain::Language {
    match language {
        Language::En => luch_explain::Language::English,
        Language::Ru => luch_explain::Language::Russian,
    }
}

/// What the letters mean.
fn meanings(explanation: &Explanation<'_>, options: &Options) -> Arc<Meanings> {
    let blocks = explanation.document(options).blocks.into_iter();
    let mut rows = blocks.filter_map(|block| match block {
        Block::Symbols { rows, .. } => Some(rows),
        _ => None,
    });
    rows.next().unwrap_or_default().into()
}

/// How a block is shown.
#[derive(Clone, Copy)]
struct How<'a> {
    texts: &'a Texts,
    digits: Digits,
    meanings: &'a Meanings,
    /// The lists of facts that stand above it.
    facts_before: usize,
}

/// What kind of ray it is, where it ends, and what it brings.
fn title(ui: &mut Ui, desk: &Desk<'_>, answer: &Explained, ray: u32) {
    let account = &answer.account.rays[ray as usize];
    ui.horizontal(|ui| {
        patch(ui, account.color);
        let kind = Look::of(&answer.account, ray).name(desk.texts);
        ui.label(RichText::new(format!("{kind}: {}", answer.end_of(ray, desk.texts))).strong().size(15.0));
        ui.weak(desk.state.explain.digits().triple(account.color));
    });
}

fn show_block(ui: &mut Ui, block: &Block, how: &How<'_>) {
    let How { texts, digits, meanings, facts_before } = *how;
    match block {
        // The title says it already, with the drawing of its kind.
        Block::Heading { level: ..=2, .. } => {}
        Block::Heading { text, .. } => {
            ui.add_space(6.0);
            ui.strong(text);
        }
        Block::Paragraph(text) => {
            ui.label(sentence(text));
        }
        // Closed at first, so that the sum itself is in sight.
        Block::Facts(facts) => {
            let title = match facts_before {
                0 => texts.explain_facts_ray(),
                1 => texts.explain_facts_surface(),
                _ => texts.explain_facts_directions(),
            };
            CollapsingHeader::new(title).id_salt("facts").show(ui, |ui| show_facts(ui, facts));
        }
        Block::Equations(equations) => {
            for one in equations {
                equation::show(ui, one, digits, meanings);
            }
        }
        Block::Verdict { text, dark } => {
            let color = if *dark { ui.visuals().warn_fg_color } else { ui.visuals().text_color() };
            ui.label(RichText::new(sentence(text)).color(color));
        }
        Block::Table { head, rows } => show_table(ui, head, rows),
        // Those stand in the explanation as a whole only.
        Block::Symbols { .. } | Block::Model(_) => {}
    }
}

/// With a capital letter in front, unless it begins with a formula.
fn sentence(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map(|first| first.to_uppercase().chain(letters).collect()).unwrap_or_default()
}

fn show_facts(ui: &mut Ui, facts: &[(String, String)]) {
    for (name, value) in facts {
        ui.horizontal_top(|ui| {
            let width = NAMES.min(ui.available_width() * 0.4);
            ui.allocate_ui(vec2(width, 16.0), |ui| {
                ui.set_width(width);
                ui.weak(name);
            });
            ui.add(egui::Label::new(value.replace('-', "−")).wrap().selectable(true));
        });
    }
}

fn show_table(ui: &mut Ui, head: &[String], rows: &[Vec<String>]) {
    ScrollArea::horizontal().id_salt("table").show(ui, |ui| {
        Grid::new("table").striped(true).spacing([12.0, 2.0]).show(ui, |ui| {
            for name in head {
                ui.weak(name);
            }
            ui.end_row();
            for row in rows {
                for cell in row {
                    ui.label(cell.replace('-', "−"));
                }
                ui.end_row();
            }
        });
    });
}

/// What of the ray's colour comes through to the pixel.
fn contribution(ui: &mut Ui, desk: &Desk<'_>, answer: &Explained, ray: u32) {
    let texts: &Texts = desk.texts;
    let account = &answer.account.rays[ray as usize];
    // A light's share in the surface is told there.
    if account.kind == RayKind::Shadow {
        return;
    }
    ui.add_space(6.0);
    ui.strong(texts.explain_contribution()).on_hover_text(texts.explain_contribution_tip());
    let digits = desk.state.explain.digits();
    let reaches = account.color.map(|channel| channel * account.weight);
    let painter = ui.painter().clone();
    let setter = Setter { painter: &painter, size: 14.0, color: ui.visuals().text_color() };
    let weight = setter.number(&digits.number(account.weight));
    let (gap, dot) = (setter.gap(), setter.upright("·"));
    let product = weight.then(dot, gap).then(setter.column(digits.color(account.color)), gap);
    let equals = setter.upright("=").then(setter.column(digits.color(reaches)), gap);
    let said =
        format!("{} · {} = {}", digits.number(account.weight), digits.triple(account.color), digits.triple(reaches));
    let set = lines(vec![product, equals], gap, ui.available_width(), gap);
    show_lines(ui, &setter, &set, &said);
}
