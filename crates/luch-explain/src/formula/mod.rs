//! Formulas: a small tree of symbols that is written twice, once with letters and once with their numbers.

mod latex;
mod symbol;
mod text;

pub use symbol::Symbol;

use crate::number;

/// What a symbol stands for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// A number.
    Number(f32),
    /// A colour, or a vector.
    Triple([f32; 3]),
}

impl Value {
    fn text(self) -> String {
        match self {
            Self::Number(number) => number::short(number),
            Self::Triple(triple) => number::triple(triple),
        }
    }
}

/// A formula.
#[derive(Debug, Clone, PartialEq)]
pub enum Expr {
    /// A letter.
    Symbol(Symbol),
    /// A number that is part of the formula itself.
    Constant(f32),
    /// a + b + ...
    Sum(Vec<Self>),
    /// a - b
    Difference(Box<[Self; 2]>),
    /// a · b · ...
    Product(Vec<Self>),
    /// a / b
    Quotient(Box<[Self; 2]>),
    /// a to the power of b
    Power(Box<[Self; 2]>),
}

impl Expr {
    /// With letters, in plain text.
    #[must_use]
    pub fn text(&self) -> String {
        text::write(self, &[])
    }

    /// With letters, as LaTeX for mathematics mode.
    #[must_use]
    pub fn latex(&self) -> String {
        latex::write(self, &[])
    }

    /// a - b
    #[must_use]
    pub fn minus(a: Self, b: Self) -> Self {
        Self::Difference(Box::new([a, b]))
    }

    /// a / b
    #[must_use]
    pub fn over(a: Self, b: Self) -> Self {
        Self::Quotient(Box::new([a, b]))
    }

    /// a to the power of b
    #[must_use]
    pub fn power(a: Self, b: Self) -> Self {
        Self::Power(Box::new([a, b]))
    }

    /// How tightly it binds: what is written inside something tighter needs brackets.
    const fn binding(&self) -> u8 {
        match self {
            Self::Sum(_) | Self::Difference(_) => 0,
            Self::Product(_) | Self::Quotient(_) => 1,
            Self::Power(_) => 2,
            Self::Symbol(_) | Self::Constant(_) => 3,
        }
    }
}

impl From<Symbol> for Expr {
    fn from(symbol: Symbol) -> Self {
        Self::Symbol(symbol)
    }
}

/// `result = formula = formula with numbers = value`.
#[derive(Debug, Clone, PartialEq)]
pub struct Equation {
    /// What is worked out.
    pub result: Symbol,
    /// How.
    pub formula: Expr,
    /// The numbers of the formula's symbols.
    pub numbers: Vec<(Symbol, Value)>,
    /// What comes out: the renderer's number, not one worked out here.
    pub value: Value,
}

impl Equation {
    /// In plain text, as in `D = s · cos θ = 0.5528 · 0.7321 = 0.4047`.
    #[must_use]
    pub fn text(&self) -> String {
        let letters = text::write(&self.formula, &[]);
        let numbers = text::write(&self.formula, &self.numbers);
        let value = self.value.text();
        if numbers == value {
            return format!("{} = {letters} = {value}", self.result.text());
        }
        format!("{} = {letters} = {numbers} = {value}", self.result.text())
    }

    /// As LaTeX for mathematics mode, in lines that a display of equations breaks at `\\` and aligns at `&`.
    #[must_use]
    pub fn latex(&self) -> String {
        let (letters, numbers) = (latex::write(&self.formula, &[]), latex::write(&self.formula, &self.numbers));
        let value = latex::value(self.value);
        let result = self.result.latex();
        if numbers == value {
            return format!("{result} &= {letters} = {value}");
        }
        // Colours are long: one step a line.
        if numbers.contains(',') {
            return format!("{result} &= {letters}\\\\\n  &= {numbers}\\\\\n  &= {value}");
        }
        format!("{result} &= {letters} = {numbers} = {value}")
    }
}

/// The number of a symbol, if it is known.
fn look_up(symbol: Symbol, numbers: &[(Symbol, Value)]) -> Option<Value> {
    numbers.iter().find(|(known, _)| *known == symbol).map(|(_, value)| *value)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn specular(cos_alpha: f32) -> Equation {
        Equation {
            result: Symbol::Specular,
            formula: Expr::Product(vec![
                Symbol::Strength.into(),
                Symbol::Highlight.into(),
                Expr::power(Symbol::CosAlpha.into(), Symbol::Exponent.into()),
            ]),
            numbers: vec![
                (Symbol::Strength, Value::Number(0.5)),
                (Symbol::Highlight, Value::Number(0.25)),
                (Symbol::CosAlpha, Value::Number(cos_alpha)),
                (Symbol::Exponent, Value::Number(8.0)),
            ],
            value: Value::Number(0.125),
        }
    }

    #[test]
    fn a_formula_is_written_with_letters_and_with_numbers() {
        assert_eq!(specular(1.0).text(), "S = s · k_s · (cos α)^n = 0.5 · 0.25 · 1^8 = 0.125");
        assert_eq!(
            specular(1.0).latex(),
            "S &= s \\cdot k_s \\cdot (\\cos\\alpha)^{n} = 0.5 \\cdot 0.25 \\cdot 1^{8} = 0.125"
        );
    }

    #[test]
    fn brackets_stand_where_they_are_needed_and_nowhere_else() {
        let mix = Equation {
            result: Symbol::Result,
            formula: Expr::Sum(vec![
                Expr::Product(vec![Expr::minus(Expr::Constant(1.0), Symbol::Reflection.into()), Symbol::Local.into()]),
                Expr::Product(vec![Symbol::Reflection.into(), Symbol::Mirrored.into()]),
            ]),
            numbers: vec![
                (Symbol::Reflection, Value::Number(0.5)),
                (Symbol::Local, Value::Triple([1.0, 0.0, -0.5])),
                (Symbol::Mirrored, Value::Triple([0.0; 3])),
            ],
            value: Value::Triple([0.5, 0.0, -0.25]),
        };
        let numbers = "(1 - 0.5) · (1, 0, -0.5) + 0.5 · (0, 0, 0)";
        assert_eq!(mix.text(), format!("C = (1 - r) · C_l + r · C_m = {numbers} = (0.5, 0, -0.25)"));
        let quotient = Expr::over(
            Symbol::Attenuation.into(),
            Expr::Sum(vec![Symbol::Distance.into(), Symbol::Attenuation.into()]),
        );
        assert_eq!(text::write(&quotient, &[]), "K / (d + K)");
        assert_eq!(latex::write(&quotient, &[]), "\\frac{K}{d + K}");
        let negative = Expr::Product(vec![Symbol::Strength.into(), Symbol::CosTheta.into()]);
        let numbers = [(Symbol::Strength, Value::Number(0.5)), (Symbol::CosTheta, Value::Number(-0.25))];
        assert_eq!(text::write(&negative, &numbers), "0.5 · (-0.25)");
    }

    #[test]
    fn numbers_in_latex_have_powers_of_ten() {
        assert_eq!(latex::value(Value::Number(1.5e-7)), "1.5 \\cdot 10^{-7}");
        assert_eq!(latex::value(Value::Triple([0.5, 1e30, 0.0])), "(0.5,\\ 1 \\cdot 10^{30},\\ 0)");
    }
}
