//! Formulas as LaTeX.

use super::{Expr, Symbol, Value, look_up};
use crate::number;

/// Writes a formula, symbols of known number as that.
pub(super) fn write(expr: &Expr, numbers: &[(Symbol, Value)]) -> String {
    let part = |part: &Expr, least: u8| inside(part, least, numbers);
    match expr {
        Expr::Symbol(symbol) => look_up(*symbol, numbers).map_or_else(|| symbol.latex(), value),
        Expr::Constant(constant) => number(*constant),
        Expr::Sum(parts) => parts.iter().map(|p| part(p, 0)).collect::<Vec<_>>().join(" + "),
        Expr::Difference(pair) => format!("{} - {}", part(&pair[0], 0), part(&pair[1], 1)),
        Expr::Product(parts) => parts.iter().map(|p| part(p, 1)).collect::<Vec<_>>().join(" \\cdot "),
        Expr::Quotient(pair) => format!("\\frac{{{}}}{{{}}}", part(&pair[0], 0), part(&pair[1], 0)),
        Expr::Power(pair) => {
            let base = match &pair[0] {
                Expr::Symbol(symbol) if symbol.is_function() && look_up(*symbol, numbers).is_none() => {
                    format!("({})", symbol.latex())
                }
                other => part(other, 3),
            };
            format!("{base}^{{{}}}", part(&pair[1], 0))
        }
    }
}

/// A number or triple.
pub(crate) fn value(value: Value) -> String {
    match value {
        Value::Number(single) => number(single),
        Value::Triple(triple) => {
            let [a, b, c] = triple.map(number);
            format!("({a},\\ {b},\\ {c})")
        }
    }
}

fn number(value: f32) -> String {
    let short = number::short(value).replace('∞', "\\infty");
    match short.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa} \\cdot 10^{{{exponent}}}"),
        None => short,
    }
}

/// A part, in brackets if it binds less tightly than it must or is a negative number or power of ten behind a sign.
fn inside(expr: &Expr, least: u8, numbers: &[(Symbol, Value)]) -> String {
    let written = write(expr, numbers);
    let negative = least > 0 && written.starts_with('-');
    let ten = least > 2 && written.contains("\\cdot 10^");
    if expr.binding() < least || negative || ten { format!("({written})") } else { written }
}
