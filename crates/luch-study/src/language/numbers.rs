//! How a language writes numbers.

/// The marks within a number.
pub(crate) struct Numbers {
    /// Between units and tenths.
    pub(crate) decimal: &'static str,
    /// Between groups of three digits.
    pub(crate) group: &'static str,
    /// The fewest digits that are grouped.
    pub(crate) grouped_from: usize,
}

impl Numbers {
    /// A number with so many decimals, the minus of typographers before it if it is negative.
    pub(crate) fn fixed(&self, value: f64, decimals: usize) -> String {
        let text = format!("{:.decimals$}", value.abs());
        let (units, tenths) = text.split_once('.').unwrap_or((&text, ""));
        // What is rounded to nothing has no sign.
        let negative = value < 0.0 && text.bytes().any(|b| (b'1'..=b'9').contains(&b));
        let mut written = if negative { "\u{2212}".to_owned() } else { String::new() };
        written += &self.grouped(units);
        if !tenths.is_empty() {
            written += self.decimal;
            written += tenths;
        }
        written
    }

    /// A whole number.
    pub(crate) fn whole(&self, value: u64) -> String {
        self.grouped(&value.to_string())
    }

    /// A time: three digits or four, whatever its size.
    pub(crate) fn time(&self, ms: f64) -> String {
        self.fixed(
            ms,
            if ms < 10.0 {
                3
            } else if ms < 100.0 {
                2
            } else {
                1
            },
        )
    }

    /// A percentage of change, its sign told.
    pub(crate) fn change(&self, percent: f64) -> String {
        let text = self.fixed(percent, 1);
        if percent > 0.0 && text.bytes().any(|b| (b'1'..=b'9').contains(&b)) { format!("+{text}") } else { text }
    }

    /// As few decimals as tell the number, and no more than needed: for the ticks of an axis.
    pub(crate) fn short(&self, value: f64) -> String {
        let text = format!("{value:.6}");
        let decimals = text.trim_end_matches('0').rsplit_once('.').map_or(0, |(_, tenths)| tenths.len());
        self.fixed(value, decimals)
    }

    fn grouped(&self, digits: &str) -> String {
        if digits.len() < self.grouped_from {
            return digits.to_owned();
        }
        let mut written = String::new();
        for (place, digit) in digits.char_indices() {
            if place > 0 && (digits.len() - place).is_multiple_of(3) {
                written += self.group;
            }
            written.push(digit);
        }
        written
    }
}

#[cfg(test)]
mod tests {
    use crate::language::Language;

    #[test]
    fn numbers_are_written_as_the_language_does() {
        let [en, ru] = Language::ALL.map(|language| &language.text().numbers);
        assert_eq!((en.fixed(1234.5, 2), ru.fixed(1234.5, 2)), ("1,234.50".into(), "1234,50".into()));
        assert_eq!((en.whole(1_234_567), ru.whole(1_234_567)), ("1,234,567".into(), "1\u{a0}234\u{a0}567".into()));
        assert_eq!((en.whole(999), ru.whole(12_345)), ("999".into(), "12\u{a0}345".into()));
        assert_eq!(en.fixed(-0.04, 1), "0.0", "no minus before nothing");
        assert_eq!(en.fixed(-1.25, 1), "\u{2212}1.2");
        assert_eq!(
            (en.time(1.23456), en.time(12.3456), en.time(123.456)),
            ("1.235".into(), "12.35".into(), "123.5".into())
        );
        assert_eq!(
            (ru.change(8.44), ru.change(-0.26), ru.change(0.01)),
            ("+8,4".into(), "\u{2212}0,3".into(), "0,0".into())
        );
        assert_eq!(
            (en.short(0.5), en.short(200.0), ru.short(0.125), en.short(1e6)),
            ("0.5".into(), "200".into(), "0,125".into(), "1,000,000".into())
        );
    }
}
