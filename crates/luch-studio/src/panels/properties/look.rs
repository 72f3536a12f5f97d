//! The look of an object: colour, mirror, highlight, shading model.

use crate::command::Command;
use crate::panels::parameters::shading_name;
use crate::state::Desk;
use crate::undo::Gesture;
use crate::widgets::check::NumberFormat;
use crate::widgets::number::NumberField;
use crate::widgets::{color, row};
use egui::{ComboBox, Ui};
use luch_scene::{Checker, Edit, Material, ObjectEdit, Shading, Shape, Size, Unit};

pub(super) fn show(ui: &mut Ui, desk: &mut Desk<'_>, index: usize) {
    let texts = desk.texts;
    let Some(object) = desk.scene().objects.get(index) else { return };
    let (material, shading) = (object.material, object.shading);
    let is_mesh = matches!(object.shape, Shape::Mesh(_));
    let mut send = |edit, gesture| desk.send(Command::Edit(Edit::Object(index, edit), gesture));

    let shown = material.color.unwrap_or(Material::DEFAULT_COLOR);
    if let Some((value, gesture)) = color::field(ui, texts, &texts.color(), &texts.color_tip(), shown) {
        send(ObjectEdit::SetColor(Some(value)), gesture);
    }
    if let Some((share, gesture)) = share(ui, texts, &texts.reflection(), &texts.reflection_tip(), material.reflection)
    {
        send(ObjectEdit::SetReflection(share), gesture);
    }
    let gloss = material.gloss.unwrap_or(Unit::ZERO);
    if let Some((share, gesture)) = share(ui, texts, &texts.gloss(), &texts.gloss_tip(), gloss) {
        send(ObjectEdit::SetGloss(Some(share)), gesture);
    }
    checker(ui, desk, index, material.checker);
    if is_mesh {
        own_shading(ui, desk, index, shading);
    }
}

/// A share in percent.
fn share(ui: &mut Ui, texts: &crate::l10n::Texts, name: &str, tip: &str, value: Unit) -> Option<(Unit, Gesture)> {
    let format = NumberFormat { range: 0.0..=100.0, decimals: 1, suffix: " %" };
    let field = NumberField::new(name, f64::from(value.get()) * 100.0, format).tooltip(tip).slider(0.0..=100.0);
    let (percent, gesture) = field.show(ui, texts)?;
    Some((Unit::try_from(percent / 100.0).ok()?, gesture))
}

/// A second colour in squares.
fn checker(ui: &mut Ui, desk: &mut Desk<'_>, index: usize, checker: Option<Checker>) {
    let texts = desk.texts;
    let mut send = |checker, gesture| {
        desk.send(Command::Edit(Edit::Object(index, ObjectEdit::SetChecker(checker)), gesture));
    };
    let mut on = checker.is_some();
    if ui.checkbox(&mut on, texts.checker()).on_hover_text(texts.checker_tip()).changed() {
        let first = Checker { size: Size::ONE, color: luch_scene::Color::srgb8([64; 3]) };
        send(on.then_some(first), Gesture::Single);
    }
    let Some(checker) = checker else { return };
    ui.indent("checker", |ui| {
        if let Some((color, gesture)) =
            color::field(ui, texts, &texts.checker_color(), &texts.checker_color_tip(), checker.color)
        {
            send(Some(Checker { color, ..checker }), gesture);
        }
        let format = NumberFormat { range: 1e-9..=1e9, decimals: 3, suffix: "" };
        let (name, tip) = (texts.checker_size(), texts.checker_size_tip());
        let field = NumberField::new(&name, f64::from(checker.size.get()), format).tooltip(&tip);
        let field = field.slider(0.05..=10.0).logarithmic();
        if let Some((value, gesture)) = field.show(ui, texts)
            && let Ok(size) = Size::try_from(value)
        {
            send(Some(Checker { size, ..checker }), gesture);
        }
    });
}

/// The shading model of a mesh: its own, or the scene's.
fn own_shading(ui: &mut Ui, desk: &mut Desk<'_>, index: usize, current: Option<Shading>) {
    let texts = desk.texts;
    let name = |choice: Option<Shading>| choice.map_or_else(|| texts.shading_of_scene(), |s| shading_name(texts, s));
    row::labelled(ui, &texts.shading_own(), &texts.shading_tip(), |ui, label| {
        let combo = ComboBox::from_id_salt("shading").width(ui.available_width()).selected_text(name(current));
        let response = combo.show_ui(ui, |ui| {
            for choice in std::iter::once(None).chain(Shading::ALL.map(Some)) {
                if ui.selectable_label(current == choice, name(choice)).clicked() && current != choice {
                    let edit = Edit::Object(index, ObjectEdit::SetShading(choice));
                    desk.send(Command::Edit(edit, Gesture::Single));
                }
            }
        });
        row::tip(&response.response.labelled_by(label.id), &texts.shading_tip());
    });
}
