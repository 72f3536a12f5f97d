//! Formulas in plain text.

use super::{Expr, Symbol, Value, look_up};
use crate::number;

/// Writes a formula, symbols of known number as that.
pub(super) fn write(expr: &Expr, numbers: &[(Symbol, Value)]) -> String {
    let part = |part: &Expr, least: u8| inside(part, least, numbers);
    match expr {
        Expr::Symbol(symbol) => look_up(*symbol, numbers).map_or_else(|| symbol.text(), Value::text),
        Expr::Constant(number) => number::short(*number),
        Expr::Sum(parts) => parts.iter().map(|p| part(p, 0)).collect::<Vec<_>>().join(" + "),
        Expr::Difference(pair) => format!("{} - {}", part(&pair[0], 0), part(&pair[1], 1)),
        Expr::Product(parts) => parts.iter().map(|p| part(p, 1)).collect::<Vec<_>>().join(" · "),
        Expr::Quotient(pair) => format!("{} / {}", part(&pair[0], 1), part(&pair[1], 2)),
        Expr::Power(pair) => {
            let base = match &pair[0] {
                Expr::Symbol(symbol) if symbol.is_function() && look_up(*symbol, numbers).is_none() => {
                    format!("({})", symbol.text())
                }
                other => part(other, 3),
            };
            format!("{base}^{}", part(&pair[1], 3))
        }
    }
}

/// A part, in brackets if it binds less tightly than it must or is a negative number behind a sign.
fn inside(expr: &Expr, least: u8, numbers: &[(Symbol, Value)]) -> String {
    let written = write(expr, numbers);
    let negative = least > 0 && written.starts_with('-');
    if expr.binding() < least || negative { format!("({written})") } else { written }
}
