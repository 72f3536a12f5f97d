//! An equation of the account, set as mathematics: with letters, with numbers, and what comes out.

use super::typeset::{Set, Setter, lines};
use crate::explain::numbers::Digits;
use crate::l10n::Texts;
use egui::{Role, Sense, Ui, WidgetInfo, pos2, vec2};
use luch_explain::{Equation, Expr, Symbol, Value};

/// What the letters mean.
pub(super) type Meanings = [(Symbol, String)];

/// The formula of an equation, to be set once with letters and once with numbers.
#[derive(Clone, Copy)]
struct Writer<'a> {
    setter: &'a Setter<'a>,
    digits: Digits,
    meanings: &'a Meanings,
    /// The numbers of the letters; empty to write letters.
    numbers: &'a [(Symbol, Value)],
}

/// Shows an equation, broken at its signs where it is too wide.
pub(super) fn show(ui: &mut Ui, equation: &Equation, digits: Digits, meanings: &Meanings) {
    let painter = ui.painter().clone();
    let setter = Setter { painter: &painter, size: 14.0, color: ui.visuals().text_color() };
    let letters = Writer { setter: &setter, digits, meanings, numbers: &[] };
    let numbers = Writer { numbers: &equation.numbers, ..letters };
    let result = letters.symbol(equation.result).then(setter.upright("="), setter.gap());
    let indent = result.width;
    let value = numbers.value(equation.value);
    let mut parts = vec![result.then(letters.expr(&equation.formula, 0), setter.gap())];
    let signed = |set: Set| setter.upright("=").then(set, setter.gap());
    // What is nothing but its own value is not said twice.
    if !matches!(equation.formula, Expr::Symbol(_) | Expr::Constant(_)) {
        let mut terms = numbers.terms(&equation.formula).into_iter();
        parts.extend(terms.next().map(signed));
        parts.extend(terms.map(|term| setter.upright("+").then(term, setter.gap())));
    }
    parts.push(signed(value));
    let said = equation.text();
    show_lines(ui, &setter, &lines(parts, setter.gap(), ui.available_width(), indent), &said);
}

/// Shows the whole sum with letters alone: what the equations of a surface work out step by step.
pub(super) fn show_model(ui: &mut Ui, texts: &Texts, meanings: &Meanings) {
    let painter = ui.painter().clone();
    let setter = Setter { painter: &painter, size: 14.0, color: ui.visuals().text_color() };
    let writer = Writer { setter: &setter, digits: Digits::EVERY, meanings, numbers: &[] };
    let (gap, near) = (setter.gap(), setter.size * 0.16);
    let product = |factors: Vec<Set>| {
        let mut factors = factors.into_iter();
        let first = factors.next().unwrap_or_default();
        factors.fold(first, |set, factor| set.then(setter.upright("·"), near).then(factor, near))
    };
    let letter = |symbol| writer.symbol(symbol);
    let strength = || {
        let below = Some(setter.small().letter("l"));
        setter.scripted(setter.letter("I"), below, None).tip(Some(texts.explain_strength_tip()))
    };
    let plus = || setter.upright("+");
    let alpha = writer.power(&Symbol::CosAlpha.into(), &Symbol::Exponent.into());
    let lights = product(vec![strength(), letter(Symbol::CosTheta), letter(Symbol::Color)])
        .then(plus(), gap)
        .then(product(vec![strength(), alpha, letter(Symbol::Highlight)]), gap);
    let reach = letter(Symbol::Distance).then(plus(), gap).then(letter(Symbol::Attenuation), gap);
    let small = setter.small();
    let sum = setter.over(setter.scaled(1.5).upright("Σ"), small.upright(&texts.explain_over_lights()));
    let parts = vec![
        letter(Symbol::Local)
            .then(setter.upright("="), gap)
            .then(product(vec![letter(Symbol::AmbientColor), letter(Symbol::Ambient)]), gap),
        plus().then(sum, gap).then(product(vec![letter(Symbol::LightColor), setter.fraction(lights, reach)]), near),
    ];
    let said = "C_l = k_a · I_a + Σ c · (I_l · cos θ · k_d + I_l · cosⁿ α · k_s) / (d + K)";
    show_lines(ui, &setter, &lines(parts, gap, ui.available_width(), 2.0 * gap), said);
}

/// Shows lines of mathematics; `said` is what a screen reader says for them.
pub(super) fn show_lines(ui: &mut Ui, setter: &Setter<'_>, lines: &[Set], said: &str) {
    let lead = 3.0;
    let height = lines.iter().map(|line| line.height() + lead).sum::<f32>();
    let width = lines.iter().map(|line| line.width).fold(0.0, f32::max);
    let (rect, response) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
    response.widget_info(|| WidgetInfo::labeled(Role::Math, true, said));
    if !ui.is_rect_visible(rect) {
        return;
    }
    let mut top = rect.top();
    let mut place = 0_usize;
    for line in lines {
        let origin = pos2(rect.left(), top + line.up + lead * 0.5);
        for (part, tip) in line.paint(setter, origin) {
            let over = ui.interact(part, response.id.with(place), Sense::hover());
            over.on_hover_text(tip);
            place += 1;
        }
        top += line.height() + lead;
    }
}

impl Writer<'_> {
    /// The terms of a sum, or the whole of what is none.
    fn terms(&self, expr: &Expr) -> Vec<Set> {
        match expr {
            Expr::Sum(terms) => terms.iter().map(|term| self.expr(term, 0)).collect(),
            other => vec![self.expr(other, 0)],
        }
    }

    /// Sets a formula; what binds less tightly than `least` stands in brackets.
    fn expr(&self, expr: &Expr, least: u8) -> Set {
        let set = match expr {
            Expr::Symbol(symbol) => return self.letter_or_number(*symbol, least),
            Expr::Constant(number) => return self.number(*number, least),
            Expr::Sum(terms) => self.joined(terms, "+", 0),
            Expr::Difference(pair) => self
                .expr(&pair[0], 0)
                .then(self.sign("−"), self.setter.gap())
                .then(self.expr(&pair[1], 1), self.setter.gap()),
            Expr::Product(factors) => self.joined(factors, "·", 1),
            // The bar holds its parts together.
            Expr::Quotient(pair) => return self.setter.fraction(self.expr(&pair[0], 0), self.expr(&pair[1], 0)),
            Expr::Power(pair) => self.power(&pair[0], &pair[1]),
        };
        if binding(expr) < least { self.setter.brackets(set) } else { set }
    }

    fn joined(&self, parts: &[Expr], sign: &str, least: u8) -> Set {
        let gap = if sign == "·" { self.setter.size * 0.16 } else { self.setter.gap() };
        let mut parts = parts.iter().map(|part| self.expr(part, least));
        let first = parts.next().unwrap_or_default();
        parts.fold(first, |set, part| set.then(self.sign(sign), gap).then(part, gap))
    }

    fn sign(&self, sign: &str) -> Set {
        self.setter.upright(sign)
    }

    /// The power of a cosine has its exponent behind the word, as people write it.
    fn power(&self, base: &Expr, exponent: &Expr) -> Set {
        let small = self.setter.small();
        let above = Writer { setter: &small, ..*self }.expr(exponent, 0);
        if let Expr::Symbol(symbol) = base
            && self.value_of(*symbol).is_none()
            && let Some((word, letter)) = symbol.text().split_once(' ')
        {
            let word = self.setter.scripted(self.setter.upright(word), None, Some(above));
            let set = word.then(self.setter.letter(letter), self.setter.size * 0.14);
            return set.tip(self.meaning(*symbol));
        }
        self.setter.scripted(self.expr(base, 3), None, Some(above))
    }

    fn value_of(&self, symbol: Symbol) -> Option<Value> {
        self.numbers.iter().find(|(known, _)| *known == symbol).map(|(_, value)| *value)
    }

    fn meaning(&self, symbol: Symbol) -> Option<String> {
        // Any light's share means the same.
        let known = if let Symbol::Share(_) = symbol { Symbol::Share(0) } else { symbol };
        let meaning = self.meanings.iter().find(|(other, _)| *other == known)?;
        Some(format!("{}: {}", symbol.text(), meaning.1))
    }

    fn letter_or_number(&self, symbol: Symbol, least: u8) -> Set {
        match self.value_of(symbol) {
            Some(Value::Number(number)) => self.number(number, least).tip(self.meaning(symbol)),
            Some(value) => self.value(value).tip(self.meaning(symbol)),
            None => self.symbol(symbol),
        }
    }

    /// A number; a negative one stands in brackets behind a sign.
    fn number(&self, number: f32, least: u8) -> Set {
        let set = self.setter.number(&self.digits.number(number));
        if number < 0.0 && least > 0 { self.setter.brackets(set) } else { set }
    }

    fn value(&self, value: Value) -> Set {
        match value {
            Value::Number(number) => self.number(number, 0),
            Value::Triple(triple) => self.setter.column(self.digits.color(triple)),
        }
    }

    /// A letter: `k_d` with a small d below, `cos θ` with an upright word.
    fn symbol(&self, symbol: Symbol) -> Set {
        let text = symbol.text();
        let set = if let Some((base, below)) = text.split_once('_') {
            let below = self.setter.small().letter(below);
            self.setter.scripted(self.setter.letter(base), Some(below), None)
        } else if let Some((word, letter)) = text.split_once(' ') {
            self.setter.upright(word).then(self.setter.letter(letter), self.setter.size * 0.14)
        } else {
            self.setter.letter(&text)
        };
        set.tip(self.meaning(symbol))
    }
}

/// How tightly a formula binds: 0 a sum, 1 a product, 2 a power, 3 a letter.
const fn binding(expr: &Expr) -> u8 {
    match expr {
        Expr::Sum(_) | Expr::Difference(_) => 0,
        Expr::Product(_) | Expr::Quotient(_) => 1,
        Expr::Power(_) => 2,
        Expr::Symbol(_) | Expr::Constant(_) => 3,
    }
}
