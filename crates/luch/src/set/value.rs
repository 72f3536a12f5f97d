//! The values of `--set`.

use super::colors;
use crate::values;
use glam::Vec3;
use luch_io::scene_file::nearest;
use luch_scene::{Checker, Color, Direction, NumberError, Point, Rotation, Size};

pub(super) use crate::values::{ranged as number, share};

/// `None` for the word that means "not given", else what `read` makes of the text.
pub(super) fn unless<T>(text: &str, word: &str, read: impl Fn(&str) -> Result<T, String>) -> Result<Option<T>, String> {
    if text == word { Ok(None) } else { read(text).map(Some) }
}

/// `#rrggbb`, `#rgb`, or a CSS colour's name.
pub(super) fn color(text: &str) -> Result<Color, String> {
    if let Some(color) = Color::from_hex(text).or_else(|| colors::named(text)) {
        return Ok(color);
    }
    let meant = nearest(text, colors::names()).map(|n| format!("; did you mean \"{n}\"?")).unwrap_or_default();
    Err(format!("\"{text}\" is no colour{meant} (write \"#rrggbb\" or a CSS name such as yellow)"))
}

/// `true` or `false`.
pub(super) fn yes_or_no(text: &str) -> Result<bool, String> {
    match text {
        "true" | "yes" | "on" => Ok(true),
        "false" | "no" | "off" => Ok(false),
        _ => Err(format!("\"{text}\" is neither true nor false")),
    }
}

/// `x,y,z`.
pub(super) fn point(text: &str) -> Result<Point, String> {
    Point::new(vector(text)?).map_err(|e| e.to_string())
}

/// `x,y,z`, not all zero.
pub(super) fn direction(text: &str) -> Result<Direction, String> {
    Direction::new(vector(text)?).map_err(|e| e.to_string())
}

/// `x,y,z` in degrees.
pub(super) fn rotation(text: &str) -> Result<Rotation, String> {
    Rotation::new(vector(text)?).map_err(|e| e.to_string())
}

/// `SIZE,COLOR`.
pub(super) fn checker(text: &str) -> Result<Checker, String> {
    let (size, second) = text.split_once(',').ok_or("write SIZE,COLOR as in 0.5,#404040, or off")?;
    Ok(Checker { size: number::<Size>(size.trim())?, color: color(second.trim())? })
}

/// `N` numbers with commas between them.
pub(super) fn numbers<T, const N: usize>(text: &str) -> Result<[T; N], String>
where
    T: TryFrom<f64, Error = NumberError>,
{
    let list: Vec<T> = text.split(',').map(values::ranged).collect::<Result<_, _>>()?;
    let count = list.len();
    list.try_into().map_err(|_| format!("{N} numbers are needed, with commas between them; there are {count}"))
}

fn vector(text: &str) -> Result<Vec3, String> {
    let numbers: [luch_scene::Finite; 3] = numbers(text.trim_start_matches(['[', '(']).trim_end_matches([']', ')']))?;
    Ok(Vec3::from_array(numbers.map(luch_scene::Finite::get)))
}
