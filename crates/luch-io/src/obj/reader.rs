//! The reader proper: one pass over the text, statement by statement.

mod faces;
mod faults;

use super::corner::Counts;
use super::cursor::Cursor;
use super::materials::MaterialNames;
use super::number::float;
use super::place::{line_of, shown};
use super::triangles::{Corner, Triangles, grow};
use super::{MAX_LINE, triangulate};
use crate::budget::{Budget, OverBudget};
use crate::error::{Error, ErrorKind, Result};
use crate::report::Report;
use luch_scene::number::MAX_COORDINATE;
use std::collections::BTreeSet;
use std::path::Path;

/// What the text says, before materials are looked up and missing normals computed.
#[derive(Debug, Default)]
pub(super) struct Parsed<'a> {
    pub(super) positions: Vec<[f32; 3]>,
    pub(super) normals: Vec<[f32; 3]>,
    pub(super) triangles: Triangles,
    pub(super) materials: MaterialNames<'a>,
}

/// How often the cancel flag is looked at, in bytes.
const POLL_BYTES: usize = 1 << 20;

/// Reads the statements of a model.
pub(super) fn parse<'a>(text: &'a [u8], file: &Path, budget: &mut Budget, report: &mut Report) -> Result<Parsed<'a>> {
    let mut reader = Reader {
        cursor: Cursor::new(text),
        statement: 0,
        file,
        budget,
        report,
        out: Parsed::default(),
        counts: Counts::default(),
        corners: Vec::new(),
        later: Vec::new(),
        points: 0,
        degenerate: 0,
        effort: triangulate::EFFORT,
        unknown: BTreeSet::new(),
    };
    reader.read_all()?;
    reader.check_what_was_named_early()?;
    reader.triangulate_what_came_early()?;
    reader.check_not_empty()?;
    Ok(reader.out)
}

struct Reader<'a, 'r> {
    cursor: Cursor<'a>,
    /// Offset of the statement being read.
    statement: usize,
    file: &'r Path,
    budget: &'r mut Budget,
    report: &'r mut Report,
    out: Parsed<'a>,
    counts: Counts,
    /// The corners of the face being read; one list for all faces.
    corners: Vec<Corner>,
    /// Polygons whose vertices were not all read yet.
    later: Vec<Polygon>,
    /// Lines and points that were skipped.
    points: u64,
    /// Faces without area that were dropped.
    degenerate: u64,
    /// What may still be spent on concave polygons.
    effort: u64,
    /// Unknown statements that were told.
    unknown: BTreeSet<&'a [u8]>,
}

struct Polygon {
    corners: Vec<Corner>,
    smoothing: Option<u32>,
    material: Option<u32>,
    statement: usize,
}

impl<'a> Reader<'a, '_> {
    fn read_all(&mut self) -> Result<()> {
        let mut next_poll = POLL_BYTES;
        loop {
            self.cursor.skip_to_statement();
            self.statement = self.cursor.offset();
            if self.statement >= next_poll {
                self.budget.check_cancelled(self.file)?;
                next_poll = self.statement.saturating_add(POLL_BYTES);
            }
            match self.cursor.rest() {
                [] => return Ok(()),
                [b'v', b' ' | b'\t', tail @ ..] => self.vertex(tail)?,
                [b'f', b' ' | b'\t', tail @ ..] | [b'f', b'o', b' ' | b'\t', tail @ ..] => self.face(tail)?,
                [b'v', b'n', b' ' | b'\t', tail @ ..] => self.normal(tail)?,
                [b'v', b't', b' ' | b'\t', ..] => {
                    self.counts.texture_coordinates.count = self.counts.texture_coordinates.count.saturating_add(1);
                    self.cursor.skip_line();
                }
                [b'#', ..] => self.cursor.skip_line(),
                _ => self.other_statement()?,
            }
            if self.cursor.offset().saturating_sub(self.statement) > MAX_LINE {
                let text = "a line is longer than 16 MiB";
                return Err(self.fault(ErrorKind::Limit, self.statement, 1, text.to_owned()));
            }
        }
    }

    /// `v x y z`, perhaps with a weight or a colour behind.
    fn vertex(&mut self, tail: &'a [u8]) -> Result<()> {
        self.cursor.jump(tail);
        let Some(position) = self.three_numbers(MAX_COORDINATE) else {
            return Err(
                self.number_fault("a vertex has three coordinates", "a coordinate is a number from -1e9 to 1e9")
            );
        };
        if !self.cursor.at_line_end() {
            self.more_about_a_vertex()?;
        }
        let left = self.cursor.rest().len() / 7;
        grow(&mut self.out.positions, left, "vertices", self.budget).map_err(|e| e.in_file(self.file))?;
        self.out.positions.push(position);
        self.counts.vertices.count = self.out.positions.len();
        Ok(())
    }

    /// `vn x y z`.
    fn normal(&mut self, tail: &'a [u8]) -> Result<()> {
        self.cursor.jump(tail);
        let Some(normal) = self.three_numbers(f32::MAX) else {
            return Err(self.number_fault("a normal has three components", "a component is a finite number"));
        };
        self.end_of_statement()?;
        let left = self.cursor.rest().len() / 8;
        grow(&mut self.out.normals, left, "normals", self.budget).map_err(|e| e.in_file(self.file))?;
        self.out.normals.push(normal);
        self.counts.normals.count = self.out.normals.len();
        Ok(())
    }

    /// Three numbers and the blanks behind them; `None` with the cursor where one should be.
    #[inline]
    fn three_numbers(&mut self, most: f32) -> Option<[f32; 3]> {
        let mut numbers = [0.0; 3];
        for number in &mut numbers {
            self.cursor.skip_blanks();
            *number = self.number(most)?;
        }
        self.cursor.skip_blanks();
        Some(numbers)
    }

    #[inline]
    fn number(&mut self, most: f32) -> Option<f32> {
        let mut after = self.cursor;
        let (value, rest) = float(self.cursor.rest())?;
        after.jump(rest);
        if !after.at_delimiter() || value.abs() > most {
            return None;
        }
        self.cursor = after;
        Some(value)
    }

    /// A fourth number is a weight, three or four are a colour: neither changes the picture.
    #[cold]
    fn more_about_a_vertex(&mut self) -> Result<()> {
        let mut extra = [0.0_f32; 4];
        let mut count = 0_usize;
        while !self.cursor.at_line_end() {
            let Some(value) = self.number(f32::MAX) else {
                return Err(self.number_fault("", "behind the coordinates come a weight or a colour, in numbers"));
            };
            if let Some(slot) = extra.get_mut(count) {
                *slot = value;
            }
            count = count.saturating_add(1);
            self.cursor.skip_blanks();
        }
        match (count, extra) {
            (1, [1.0, ..]) => {}
            (1, _) => self.warn("weights of vertices are left out", String::new()),
            (3 | 4, _) => self.warn("colours of vertices are left out", String::new()),
            _ => self.warn("more numbers than a vertex has are left out", String::new()),
        }
        Ok(())
    }

    /// Everything that is rare.
    #[cold]
    fn other_statement(&mut self) -> Result<()> {
        let keyword = self.cursor.token();
        let next = self.out.triangles.len();
        let over = |e: OverBudget| e.in_file(self.file);
        match keyword {
            // A keyword alone in its line, or before other blanks than those of the quick way.
            b"v" => return self.vertex(self.cursor.rest()),
            b"vn" => return self.normal(self.cursor.rest()),
            b"f" | b"fo" => return self.face(self.cursor.rest()),
            b"s" => {
                let group = self.smoothing_group();
                self.out.triangles.smoothing.set(next, group, self.budget).map_err(over)?;
            }
            b"usemtl" => {
                let name = self.cursor.name();
                if let Some(number) = self.out.materials.number_of(name) {
                    self.out.triangles.materials.set(next, number, self.budget).map_err(over)?;
                } else {
                    self.warn("materials beyond 65535 are left out", String::new());
                }
            }
            b"mtllib" => {
                let name = self.cursor.name();
                self.out.materials.add_library(name, self.statement);
            }
            b"l" | b"p" => {
                self.points = self.points.saturating_add(1);
                self.warn("lines and points are skipped", String::new());
            }
            b"o" | b"g" | b"mg" | b"bevel" | b"c_interp" | b"d_interp" | b"lod" | b"shadow_obj" | b"trace_obj"
            | b"maplib" | b"usemap" | b"vt" => {}
            b"vp" | b"cstype" | b"deg" | b"bmat" | b"step" | b"curv" | b"curv2" | b"surf" | b"parm" | b"trim"
            | b"hole" | b"scrv" | b"sp" | b"end" | b"con" | b"ctech" | b"stech" | b"bzp" | b"bsp" | b"cdc" | b"cdp"
            | b"res" => self.warn("curves and surfaces are skipped", shown(keyword)),
            b"call" | b"csh" => self.warn("commands in a model are never run", shown(keyword)),
            _ => {
                if self.unknown.len() < Report::SHOWN.saturating_add(1) && self.unknown.insert(keyword) {
                    self.warn("unknown statements are skipped", format!("\"{}\"", shown(keyword)));
                }
            }
        }
        self.cursor.skip_line();
        Ok(())
    }

    /// What follows `s`: a number, or `off`.
    fn smoothing_group(&mut self) -> u32 {
        self.cursor.skip_blanks();
        let word = self.cursor.peek_token();
        match word {
            b"off" | b"OFF" | b"Off" | b"null" => return 0,
            b"on" | b"ON" => return 1,
            _ => {}
        }
        let number = std::str::from_utf8(word).ok().and_then(|word| word.parse().ok());
        number.unwrap_or_else(|| {
            self.warn("smoothing groups that are no numbers count as off", shown(word));
            0
        })
    }

    /// Nothing but a comment may follow.
    fn end_of_statement(&mut self) -> Result<()> {
        if self.cursor.at_line_end() {
            return Ok(());
        }
        let token = self.cursor.peek_token();
        let text = format!("\"{}\" is more than the statement has", shown(token));
        Err(self.fault(ErrorKind::Malformed, self.cursor.offset(), token.len(), text))
    }

    fn check_what_was_named_early(&mut self) -> Result<()> {
        let Counts { vertices, texture_coordinates, normals } = &self.counts;
        for (list, what, plural) in [(vertices, "vertex", "vertices"), (normals, "normal", "normals")] {
            if let Some((index, offset)) = list.missing() {
                let text = format!("{what} {index} does not exist: the file has {} {plural}", list.count);
                let length = token_length(self.cursor.text(), offset);
                return Err(self.fault(ErrorKind::Malformed, offset, length, text).hint("indices count from 1"));
            }
        }
        if let Some((index, offset)) = texture_coordinates.missing() {
            let place = || format!("{index} at {}:{}", self.file.display(), line_of(self.cursor.text(), offset));
            self.report.warn("texture coordinates that do not exist are ignored", place);
        }
        Ok(())
    }

    fn check_not_empty(&self) -> Result<()> {
        if self.out.triangles.len() > 0 {
            return Ok(());
        }
        let vertices = self.out.positions.len();
        let text = match (vertices, self.points, self.degenerate) {
            (0, _, _) => "the file has no faces and no vertices: is it an OBJ model?".to_owned(),
            (_, _, 1..) => "the file has no faces with an area".to_owned(),
            (_, 0, _) => format!("the file has {vertices} vertices but no faces"),
            _ => format!("the file has {} lines and points but no faces", self.points),
        };
        Err(Error::new(ErrorKind::Malformed, self.file, text).hint("only faces (\"f\" statements) can be rendered"))
    }
}

fn token_length(text: &[u8], offset: usize) -> usize {
    text.get(offset..).map_or(1, |rest| Cursor::new(rest).peek_token().len())
}
