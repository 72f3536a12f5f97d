//! Typed access to a TOML table: every refusal names the key, shows the text and says what belongs there.

use super::suggest::nearest;
use super::text::{SceneText, quote};
use crate::error::{Error, Result};
use glam::Vec3;
use luch_scene::{Color, FieldOfView, Finite, NonNegative, NumberError, Positive, Size, Unit};
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeArray, DeTable, DeValue};

/// The text that a section's spans point into.
#[derive(Debug, Clone, Copy)]
pub(super) struct Context<'a> {
    /// The whole file.
    pub(super) text: SceneText<'a>,
    /// Where the section starts in it; TOML's spans count from here.
    pub(super) base: usize,
}

/// A kind of table: what to call it and the keys that it may have, in the order of the documentation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Schema {
    /// With its article: `an object`.
    pub(super) what: &'static str,
    /// Every key that it may have.
    pub(super) keys: &'static [&'static str],
    /// What to say of a misplaced key: the key and where it belongs.
    pub(super) elsewhere: &'static [(&'static str, &'static str)],
}

/// A table whose keys are all known ones.
#[derive(Debug, Clone)]
pub(super) struct Fields<'a, 'i> {
    /// The text around it.
    pub(super) context: Context<'a>,
    /// The table's place, for what is missing from it.
    pub(super) place: Range<usize>,
    schema: Schema,
    table: &'a DeTable<'i>,
}

/// A key with its value.
#[derive(Debug, Clone, Copy)]
pub(super) struct Field<'a, 'i> {
    context: Context<'a>,
    /// The key.
    pub(super) key: &'static str,
    /// Where the key itself stands, in the whole file.
    key_start: usize,
    key_end: usize,
    value: &'a Spanned<DeValue<'i>>,
}

impl<'a> Context<'a> {
    /// A span of the section as a span of the file.
    pub(super) fn span(self, span: &Range<usize>) -> Range<usize> {
        span.start.saturating_add(self.base)..span.end.saturating_add(self.base)
    }

    /// A malformed file, at a span of the file.
    pub(super) fn error(self, span: &Range<usize>, text: impl Into<String>) -> Error {
        self.text.error(span, text)
    }

    /// The text of a value as it was written.
    fn written(self, value: &Spanned<DeValue<'_>>) -> &'a str {
        self.text.text.get(self.span(&value.span())).unwrap_or_default()
    }
}

impl Schema {
    /// The words of an unknown key.
    fn unknown(&self, context: Context<'_>, key: &str, span: &Range<usize>) -> Error {
        let quoted = quote(key);
        let elsewhere = self.elsewhere.iter().find(|(k, _)| *k == key);
        // A key that belongs elsewhere is no slip of the pen, however near to another it is.
        if elsewhere.is_none()
            && let Some(known) = nearest(key, self.keys.iter().copied())
        {
            return context.error(span, format!("unknown key {quoted}, did you mean `{known}`?"));
        }
        let error = context.error(span, format!("unknown key {quoted} in {}", self.what));
        match elsewhere {
            Some((_, place)) => error.hint(*place),
            None => error.hint(format!("{} may have: {}", self.what, self.keys.join(", "))),
        }
    }
}

impl<'a, 'i> Fields<'a, 'i> {
    /// Checks that every key of the table is one of the schema's.
    ///
    /// # Errors
    /// `Malformed` at the first key in the file that is not.
    pub(super) fn new(
        context: Context<'a>,
        schema: Schema,
        table: &'a DeTable<'i>,
        place: Range<usize>,
    ) -> Result<Self> {
        let unknown = table.keys().filter(|k| !schema.keys.contains(&k.get_ref().as_ref()));
        match unknown.min_by_key(|k| k.span().start) {
            Some(key) => Err(schema.unknown(context, key.get_ref(), &context.span(&key.span()))),
            None => Ok(Self { context, place, schema, table }),
        }
    }

    /// The field of that key, if it is given.
    pub(super) fn get(&self, key: &'static str) -> Option<Field<'a, 'i>> {
        let (found, value) = self.table.get_key_value(key)?;
        let span = self.context.span(&found.span());
        Some(Field { context: self.context, key, key_start: span.start, key_end: span.end, value })
    }

    /// The field of that key.
    ///
    /// # Errors
    /// `Malformed` at the table if it is not given; `example` shows how to give it.
    pub(super) fn need(&self, key: &'static str, example: &str) -> Result<Field<'a, 'i>> {
        self.get(key).ok_or_else(|| self.missing(&format!("`{key}`"), example))
    }

    /// What is missing from this table, with an example of it.
    pub(super) fn missing(&self, what: &str, example: &str) -> Error {
        self.context
            .error(&self.place, format!("{} needs {what}", self.schema.what))
            .hint(format!("for example: {example}"))
    }
}

/// Numbers of luch-scene by their range.
pub(super) trait Ranged: Sized {
    /// The range in words.
    const EXPECTED: &'static str;
    /// Takes a number of the range.
    fn take(value: f32) -> std::result::Result<Self, NumberError>;
}

macro_rules! ranged {
    ($($name:ident),*) => {$(
        impl Ranged for $name {
            const EXPECTED: &'static str = $name::EXPECTED;
            fn take(value: f32) -> std::result::Result<Self, NumberError> {
                $name::new(value)
            }
        }
    )*};
}
ranged!(Finite, Unit, NonNegative, Positive, Size, FieldOfView);

impl<'a, 'i> Field<'a, 'i> {
    /// Where the key stands in the file.
    pub(super) fn key_span(&self) -> Range<usize> {
        self.key_start..self.key_end
    }

    /// Where the value stands in the file.
    pub(super) fn span(&self) -> Range<usize> {
        self.context.span(&self.value.span())
    }

    /// A malformed file, at the value.
    pub(super) fn error(&self, text: impl Into<String>) -> Error {
        self.context.error(&self.span(), text)
    }

    /// A malformed file, at the key.
    pub(super) fn key_error(&self, text: impl Into<String>) -> Error {
        self.context.error(&self.key_span(), text)
    }

    /// The context of a table in this list, and the table's place in the file.
    pub(super) fn item(&self, item: &Spanned<DeValue<'_>>) -> (Context<'a>, Range<usize>) {
        (self.context, self.context.span(&item.span()))
    }

    /// The value is of another type: `reflection must be a number from 0 to 1, not a string`.
    fn mistyped(&self, value: &Spanned<DeValue<'_>>, expected: &str) -> Error {
        let found = match value.get_ref() {
            DeValue::String(_) => "the string",
            DeValue::Integer(_) => "the whole number",
            DeValue::Float(_) => "the number",
            DeValue::Boolean(_) => "the truth value",
            DeValue::Datetime(_) => "the date",
            DeValue::Array(_) => "the list",
            DeValue::Table(_) => "the table",
        };
        let written = quote(self.context.written(value));
        let span = self.context.span(&value.span());
        self.context.error(&span, format!("`{}` must be {expected}, not {found} {written}", self.key))
    }

    /// A number of the type's range. Whole numbers are numbers too.
    pub(super) fn number<T: Ranged>(&self) -> Result<T> {
        self.number_of(self.value)
    }

    fn number_of<T: Ranged>(&self, value: &Spanned<DeValue<'_>>) -> Result<T> {
        // Read as f32 straight from the digits: by way of f64 some numbers would be rounded twice.
        let number = match value.get_ref() {
            DeValue::Float(float) => float.as_str().parse::<f32>().ok(),
            DeValue::Integer(whole) if whole.radix() == 10 => whole.as_str().parse::<f32>().ok(),
            DeValue::Integer(whole) => i64::from_str_radix(whole.as_str(), whole.radix()).ok().map(nearest_f32),
            _ => {
                let error = self.mistyped(value, T::EXPECTED);
                return Err(match value.get_ref() {
                    DeValue::String(text) if text.trim().replace(',', ".").parse::<f32>().is_ok() => {
                        error.hint("numbers stand without quotes, with a point: 0.5")
                    }
                    _ => error,
                });
            }
        };
        let span = self.context.span(&value.span());
        let written = quote(self.context.written(value));
        let refused = |expected| self.context.error(&span, format!("`{}`: {written} is not {expected}", self.key));
        number.ok_or_else(|| refused(T::EXPECTED)).and_then(|n| T::take(n).map_err(|e| refused(e.expected)))
    }

    /// A whole number that `take` accepts.
    pub(super) fn whole<T>(
        &self,
        expected: &'static str,
        take: impl Fn(u32) -> std::result::Result<T, NumberError>,
    ) -> Result<T> {
        self.whole_of(self.value, expected, take)
    }

    fn whole_of<T>(
        &self,
        value: &Spanned<DeValue<'_>>,
        expected: &'static str,
        take: impl Fn(u32) -> std::result::Result<T, NumberError>,
    ) -> Result<T> {
        let DeValue::Integer(whole) = value.get_ref() else {
            let error = self.mistyped(value, expected);
            return Err(if matches!(value.get_ref(), DeValue::Float(_)) {
                error.hint("a whole number stands without a point")
            } else {
                error
            });
        };
        let number = u32::from_str_radix(whole.as_str(), whole.radix()).ok();
        number.and_then(|n| take(n).ok()).ok_or_else(|| {
            let written = quote(self.context.written(value));
            let span = self.context.span(&value.span());
            self.context.error(&span, format!("`{}`: {written} is not {expected}", self.key))
        })
    }

    /// A truth value.
    pub(super) fn truth(&self) -> Result<bool> {
        self.value.get_ref().as_bool().ok_or_else(|| self.mistyped(self.value, "true or false"))
    }

    /// A string; `expected` says of what.
    pub(super) fn string(&self, expected: &str) -> Result<&'a str> {
        self.value.get_ref().as_str().ok_or_else(|| self.mistyped(self.value, expected))
    }

    /// A list of exactly N values; `form` shows it.
    fn list<const N: usize>(&self, form: &str) -> Result<[&'a Spanned<DeValue<'i>>; N]> {
        let Some(list) = self.value.get_ref().as_array() else {
            return Err(self.mistyped(self.value, form));
        };
        let values: Vec<_> = list.iter().take(N.saturating_add(1)).collect();
        values.try_into().map_err(|_| self.error(format!("`{}` must be {form}, not {} values", self.key, list.len())))
    }

    /// Three numbers, each in the type's range.
    pub(super) fn triple<T: Ranged>(&self) -> Result<[T; 3]> {
        let [x, y, z] = self.list("[x, y, z]")?;
        Ok([self.number_of(x)?, self.number_of(y)?, self.number_of(z)?])
    }

    /// Two lengths.
    pub(super) fn pair_of_sizes(&self) -> Result<[Size; 2]> {
        let [width, height] = self.list("[width, height]")?;
        Ok([self.number_of(width)?, self.number_of(height)?])
    }

    /// Two whole numbers from 1 to `most`.
    pub(super) fn pair_of_pixels(&self, most: u32) -> Result<[u32; 2]> {
        let expected = "a whole number of pixels from 1 to 65535";
        let take = |n| if (1..=most).contains(&n) { Ok(n) } else { Err(NumberError { value: 0.0, expected }) };
        let [width, height] = self.list("[width, height]")?;
        Ok([self.whole_of(width, expected, take)?, self.whole_of(height, expected, take)?])
    }

    /// Three coordinates as a vector that `take` accepts.
    pub(super) fn vector<T>(&self, take: impl Fn(Vec3) -> std::result::Result<T, NumberError>) -> Result<T> {
        let vector = Vec3::from_array(self.triple::<Finite>()?.map(Finite::get));
        take(vector).map_err(|e| {
            self.error(format!("`{}`: {} is not {}", self.key, quote(self.context.written(self.value)), e.expected))
        })
    }

    /// A colour: `"#rrggbb"` in sRGB, or `[r, g, b]` in linear light.
    pub(super) fn color(&self) -> Result<Color> {
        const FORM: &str = "a colour like \"#c83232\", or [r, g, b] from 0 to 1 in linear light";
        match self.value.get_ref() {
            DeValue::String(text) => Color::from_hex(text).ok_or_else(|| {
                let error = self.error(format!("`{}`: {} is not a colour", self.key, quote(text)));
                error.hint("write \"#rrggbb\" with hexadecimal digits, or [r, g, b] from 0 to 1 in linear light")
            }),
            DeValue::Array(_) => {
                let rgb = self.triple::<Unit>()?.map(Unit::get);
                Color::linear(Vec3::from_array(rgb)).map_err(|e| self.error(e.to_string()))
            }
            _ => Err(self.mistyped(self.value, FORM)),
        }
    }

    /// A word of a closed set.
    pub(super) fn word<T: Copy>(&self, words: &[(&'static str, T)]) -> Result<T> {
        let list = || words.iter().map(|(w, _)| format!("\"{w}\"")).collect::<Vec<_>>().join(", ");
        let text = self.string(&format!("one of {}", list()))?;
        if let Some((_, found)) = words.iter().find(|(w, _)| *w == text) {
            return Ok(*found);
        }
        let quoted = quote(text);
        Err(match nearest(text, words.iter().map(|(w, _)| *w)) {
            Some(word) => self.error(format!("`{}`: unknown word {quoted}, did you mean \"{word}\"?", self.key)),
            None => self.error(format!("`{}`: unknown word {quoted}", self.key)).hint(format!("one of {}", list())),
        })
    }

    /// A table of the schema.
    pub(super) fn table(&self, schema: Schema, example: &str) -> Result<Fields<'a, 'i>> {
        match self.value.get_ref() {
            DeValue::Table(table) => Fields::new(self.context, schema, table, self.key_span()),
            _ => Err(self.mistyped(self.value, "a table").hint(format!("for example: {} = {example}", self.key))),
        }
    }

    /// The value as it was read.
    pub(super) fn value(&self) -> &'a DeValue<'i> {
        self.value.get_ref()
    }

    /// The list of tables under this key (`[[object]]`).
    pub(super) fn tables(&self) -> Result<&'a DeArray<'i>> {
        let form = || format!("write [[{}]] in double brackets", self.key);
        match self.value.get_ref() {
            DeValue::Array(list) => Ok(list),
            DeValue::Table(_) if self.context.text.text.get(self.key_end..).is_some_and(|t| t.starts_with('.')) => {
                let error = format!("this belongs to an `{}`, but stands under none", self.key);
                Err(self
                    .context
                    .error(&self.key_span(), error)
                    .hint(format!("put it right under its [[{}]]", self.key)))
            }
            DeValue::Table(_) => {
                Err(self.context.error(&self.key_span(), format!("`{}` is a list of tables", self.key)).hint(form()))
            }
            _ => Err(self.mistyped(self.value, "a list of tables").hint(form())),
        }
    }
}

/// The f32 nearest to a whole number.
fn nearest_f32(whole: i64) -> f32 {
    #[allow(clippy::cast_precision_loss, reason = "rounding to the nearest f32 is meant")]
    let rounded = whole as f32;
    rounded
}
