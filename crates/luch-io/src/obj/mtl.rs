//! MTL material libraries: the colour and the gloss of each material.
//!
//! `Kd` is the colour. The tools that write it disagree about what its numbers mean; here they are sRGB, as a viewer
//! shows that puts them on the screen unchanged, so `Kd 0.5 0.5 0.5` is the middle grey `#808080`.
//!
//! `Ks` and `Ns` make the gloss: the largest component of `Ks` times `ln(1 + Ns) / ln(1001)`, so that `Ks 1 1 1` with
//! `Ns 1000` is 1 and each tenfold of `Ns` adds a third. `illum 0` and `illum 1` mean no highlight. A material without
//! `Ks` says nothing of gloss.
//!
//! Nothing in a library is an error: what cannot be used is left out with a warning, and the model is still shown.

use super::cursor::Cursor;
use super::number::float;
use super::place::{line_of, shown};
use super::text;
use crate::report::Report;
use glam::Vec3;
use luch_scene::color::linear_from_srgb;
use luch_scene::{Color, Unit};
use std::path::Path;

/// The most materials of one library that are kept.
const MOST_MATERIALS: usize = 1 << 20;

/// A material as its library describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct MtlMaterial {
    /// Its name, as bytes: libraries come in any encoding.
    pub name: Vec<u8>,
    /// `Kd` in linear light.
    pub color: Option<Color>,
    /// The largest component of `Ks`, in 0..=1.
    pub highlight: Option<f32>,
    /// `Ns`, in 0..=1000.
    pub exponent: Option<f32>,
    /// Whether `illum` says that there is no highlight.
    pub is_matt: bool,
}

impl MtlMaterial {
    /// The gloss that `Ks` and `Ns` mean; `None` if the library says nothing of it.
    #[must_use]
    pub fn gloss(&self) -> Option<Unit> {
        if self.is_matt {
            return Some(Unit::ZERO);
        }
        let highlight = self.highlight?;
        // Ns 10 is what most tools give a material when they are asked for nothing.
        let exponent = self.exponent.unwrap_or(10.0);
        Some(Unit::clamped(highlight * libm::logf(1.0 + exponent) / libm::logf(1001.0)))
    }
}

/// Reads a library and adds its materials to `materials`. `file` is for warnings.
pub fn read(bytes: &[u8], file: &Path, materials: &mut Vec<MtlMaterial>, report: &mut Report) {
    let text = match text::checked(bytes, file) {
        Ok(text) => text,
        Err(error) => {
            return report.warn("material libraries that are no text are left out", || {
                format!("{}: {}", file.display(), error.text)
            });
        }
    };
    let mut reader = Reader { cursor: Cursor::new(text), statement: 0, file, report };
    reader.read_all(materials);
}

struct Reader<'a, 'r> {
    cursor: Cursor<'a>,
    statement: usize,
    file: &'r Path,
    report: &'r mut Report,
}

impl Reader<'_, '_> {
    fn read_all(&mut self, materials: &mut Vec<MtlMaterial>) {
        // Statements before the first material belong to none.
        let first = materials.len();
        loop {
            self.cursor.skip_to_statement();
            self.statement = self.cursor.offset();
            if self.cursor.rest().is_empty() {
                return;
            }
            if self.cursor.at_line_end() {
                self.cursor.skip_line();
                continue;
            }
            let keyword = self.cursor.token();
            if keyword == b"newmtl" {
                let name = self.cursor.name().to_vec();
                if materials.len() >= MOST_MATERIALS {
                    return self.warn("materials beyond 1048576 are left out", String::new());
                }
                materials.push(MtlMaterial { name, color: None, highlight: None, exponent: None, is_matt: false });
            } else if let Some(material) = materials.get_mut(first..).and_then(<[_]>::last_mut) {
                self.statement_of(material, keyword);
            } else {
                self.warn("statements before the first newmtl are skipped", shown(keyword));
            }
            self.cursor.skip_line();
        }
    }

    fn statement_of(&mut self, material: &mut MtlMaterial, keyword: &[u8]) {
        match keyword {
            b"Kd" => {
                let color = self.color().map(|srgb| Vec3::from_array(srgb.map(linear_from_srgb)));
                material.color = color.and_then(|linear| Color::linear(linear).ok()).or(material.color);
            }
            b"Ks" => {
                let largest = self.color().map(|[r, g, b]| r.max(g).max(b));
                material.highlight = largest.or(material.highlight);
            }
            b"Ns" => {
                let exponent = self.number().map(|value| self.clamped(value, 1000.0));
                material.exponent = exponent.or(material.exponent);
            }
            b"illum" => {
                let model = self.number();
                material.is_matt = matches!(model, Some(m) if m == 0.0 || m == 1.0);
            }
            b"d" => {
                if self.number().is_some_and(|value| value < 1.0) {
                    self.warn("transparency is left out", String::new());
                }
            }
            b"Tr" => {
                if self.number().is_some_and(|value| value > 0.0) {
                    self.warn("transparency is left out", String::new());
                }
            }
            b"Ka" | b"Ke" | b"Ni" | b"Tf" | b"sharpness" | b"Pr" | b"Pm" | b"Ps" | b"Pc" | b"Pcr" | b"aniso"
            | b"anisor" | b"Km" => {}
            _ if keyword.starts_with(b"map_")
                || matches!(keyword, b"bump" | b"disp" | b"decal" | b"refl" | b"norm") =>
            {
                self.warn("textures are left out", shown(keyword));
            }
            _ => self.warn("unknown statements of a library are skipped", format!("\"{}\"", shown(keyword))),
        }
    }

    /// One or three numbers in 0..=1; one stands for all three.
    fn color(&mut self) -> Option<[f32; 3]> {
        self.cursor.skip_blanks();
        if matches!(self.cursor.peek_token(), b"spectral" | b"xyz") {
            let word = shown(self.cursor.peek_token());
            self.warn("colours that are spectra or CIE XYZ are left out", word);
            return None;
        }
        let first = self.number()?;
        self.cursor.skip_blanks();
        let [g, b] = if self.cursor.at_line_end() { [first; 2] } else { [self.number()?, self.number()?] };
        Some([first, g, b].map(|value| self.clamped(value, 1.0)))
    }

    fn clamped(&mut self, value: f32, most: f32) -> f32 {
        let clamped = value.clamp(0.0, most);
        if (clamped - value).abs() > 1e-6 {
            self.warn("numbers out of range are moved to its nearer end", format!("{value}"));
        }
        clamped
    }

    /// A finite number; a warning and `None` for anything else.
    fn number(&mut self) -> Option<f32> {
        self.cursor.skip_blanks();
        let here = self.cursor;
        if let Some((value, rest)) = float(here.rest()) {
            self.cursor.jump(rest);
            if self.cursor.at_delimiter() && value.is_finite() {
                return Some(value);
            }
            self.cursor = here;
        }
        let word = if here.at_line_end() { "nothing".to_owned() } else { format!("\"{}\"", shown(here.peek_token())) };
        self.warn("words of a library that should be numbers are left out", word);
        None
    }

    fn warn(&mut self, kind: &'static str, what: String) {
        let (file, text, statement) = (self.file, self.cursor.text(), self.statement);
        self.report.warn(kind, move || {
            let line = line_of(text, statement);
            let place = format!("{}:{line}", file.display());
            if what.is_empty() { place } else { format!("{what} ({place})") }
        });
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read_text(text: &str) -> (Vec<MtlMaterial>, Report) {
        let (mut materials, mut report) = (Vec::new(), Report::default());
        read(text.as_bytes(), Path::new("a.mtl"), &mut materials, &mut report);
        (materials, report)
    }

    #[test]
    fn colours_are_srgb_and_gloss_comes_from_the_highlight() {
        let (materials, report) = read_text(
            "# c\nnewmtl red\nKd 1 0.5 0\nKs 1 1 1 # bright\nNs 1000\nillum 2\n\n newmtl grey\r\n\tKd .5\r\nNi 1\r\n\
             newmtl matt\nKs 1\nillum 1\n",
        );
        assert!(report.is_empty(), "{:?}", report.lines());
        assert_eq!(materials.len(), 3);
        assert_eq!(materials[0].color.unwrap().to_srgb8(), [255, 128, 0]);
        assert_eq!(materials[0].gloss(), Some(Unit::ONE));
        assert_eq!(materials[1].color.unwrap().to_srgb8(), [128, 128, 128]);
        assert_eq!(materials[1].gloss(), None);
        assert_eq!(materials[2].gloss(), Some(Unit::ZERO));
    }

    #[test]
    fn what_is_out_of_range_is_told_and_moved() {
        let (materials, report) =
            read_text("Ka 1\nnewmtl a\nKd nan 0 0\nKs -1 0 1e39\nNs 1e30\nKd 2 -1 0.5\nd 0.5\nmap_Kd a.png\n");
        assert_eq!(materials[0].color.unwrap().get().to_array()[..2], [1.0, 0.0]);
        assert_eq!(materials[0].highlight, None, "1e39 is no number");
        assert_eq!(materials[0].exponent, Some(1000.0));
        let text = report.lines().join("\n");
        for word in ["\"nan\" (a.mtl:3)", "a.mtl:4", "transparency", "textures", "newmtl", "nearer end: -1 (a.mtl:6)"] {
            assert!(text.contains(word), "{word} in {text}");
        }
    }
}
