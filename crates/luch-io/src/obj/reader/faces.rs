//! Faces: their corners, and the triangles that they become.

use super::super::corner::{CornerFault, corner};
use super::super::materials::MaterialNames;
use super::super::place::line_of;
use super::super::triangles::{Corner, NO_NORMAL, grow};
use super::super::{MAX_CORNERS, triangulate};
use super::{Polygon, Reader};
use crate::budget::OverBudget;
use crate::error::{ErrorKind, Result};

impl<'a> Reader<'a, '_> {
    /// `f` and its corners.
    pub(super) fn face(&mut self, tail: &'a [u8]) -> Result<()> {
        let text_left = self.cursor.rest().len();
        self.cursor.jump(tail);
        self.corners.clear();
        let mut without_normal = 0_usize;
        loop {
            self.cursor.skip_blanks();
            if self.cursor.at_line_end() {
                break;
            }
            let here = self.cursor;
            let read = corner(here.rest(), here.offset(), &mut self.counts);
            let (corner, rest) = read.map_err(|fault| self.corner_fault(fault))?;
            self.cursor.jump(rest);
            if !self.cursor.at_delimiter() {
                self.cursor = here;
                return Err(self.corner_fault(CornerFault::Form));
            }
            without_normal = without_normal.wrapping_add(usize::from(corner.normal == NO_NORMAL));
            if self.corners.len() == MAX_CORNERS {
                let text = format!("a face has more than {MAX_CORNERS} corners");
                return Err(self.fault(ErrorKind::Limit, here.offset(), here.peek_token().len(), text));
            }
            self.corners.push(corner);
        }
        if without_normal > 0 && without_normal < self.corners.len() {
            self.warn("faces where a corner lacks its normal get computed ones", String::new());
            self.corners.iter_mut().for_each(|c| c.normal = NO_NORMAL);
        }
        self.drop_repeated_corners();
        match *self.corners.as_slice() {
            [a, b, c] => self.out.triangles.push([a, b, c], text_left, self.budget).map_err(|e| e.in_file(self.file)),
            [_, _, _, _, ..] => self.polygon(text_left),
            _ => Ok(()),
        }
    }

    /// A corner that repeats its neighbour adds nothing; what has fewer than three corners is no face.
    #[inline]
    fn drop_repeated_corners(&mut self) {
        let corners = &mut self.corners;
        let read = corners.len();
        let closes = |list: &[Corner]| matches!(list, [first, .., last] if first.vertex == last.vertex);
        let repeats = |list: &[Corner]| list.windows(2).any(|w| matches!(w, [a, b] if a.vertex == b.vertex));
        if repeats(corners) || closes(corners) {
            corners.dedup_by_key(|c| c.vertex);
            while closes(corners) {
                corners.pop();
            }
        }
        let left = corners.len();
        if left < 3 {
            self.degenerate = self.degenerate.saturating_add(u64::from(read > 2));
            let kind = if read < 3 {
                "faces of fewer than three corners are skipped"
            } else {
                "faces without area are dropped"
            };
            self.warn(kind, format!("{read} corners"));
        } else if left < read {
            self.warn("corners that repeat their neighbour are dropped", String::new());
        }
    }

    /// More than three corners: now if their vertices are known, else at the end.
    fn polygon(&mut self, text_left: usize) -> Result<()> {
        let known = self.out.positions.len();
        let is_known = |c: &Corner| usize::try_from(c.vertex).is_ok_and(|v| v < known);
        if self.corners.iter().all(is_known) {
            let corners = std::mem::take(&mut self.corners);
            let done = self.add_polygon(&corners, text_left, self.statement);
            self.corners = corners;
            return done;
        }
        let over = |e: OverBudget| e.in_file(self.file);
        let mut corners = Vec::new();
        self.budget.reserve(&mut corners, self.corners.len(), "polygons").map_err(over)?;
        corners.extend_from_slice(&self.corners);
        grow(&mut self.later, text_left / 8, "polygons", self.budget).map_err(over)?;
        self.later.push(Polygon {
            corners,
            smoothing: self.out.triangles.smoothing.last(),
            material: self.out.triangles.materials.last(),
            statement: self.statement,
        });
        Ok(())
    }

    fn add_polygon(&mut self, corners: &[Corner], text_left: usize, statement: usize) -> Result<()> {
        let outline: Vec<[f32; 3]> = corners.iter().filter_map(|c| self.position(c.vertex)).collect();
        let result = triangulate::polygon(&outline, &mut self.effort);
        if result.is_tangled {
            let place = || format!("{}:{}", self.file.display(), line_of(self.cursor.text(), statement));
            self.report.warn("polygons that cross themselves are filled as well as can be", place);
        }
        for ears in result.triangles {
            let [Some(a), Some(b), Some(c)] = ears.map(|i| usize::try_from(i).ok().and_then(|i| corners.get(i))) else {
                continue;
            };
            // Outlines that touch themselves make such; they have no area.
            if a.vertex == b.vertex || b.vertex == c.vertex || c.vertex == a.vertex {
                continue;
            }
            let left = text_left.saturating_add(corners.len().saturating_mul(2));
            self.out.triangles.push([*a, *b, *c], left, self.budget).map_err(|e| e.in_file(self.file))?;
        }
        if corners.len() > 1000 {
            self.budget.check_cancelled(self.file)?;
        }
        Ok(())
    }

    fn position(&self, vertex: u32) -> Option<[f32; 3]> {
        self.out.positions.get(usize::try_from(vertex).ok()?).copied()
    }

    pub(super) fn triangulate_what_came_early(&mut self) -> Result<()> {
        for polygon in std::mem::take(&mut self.later) {
            let first = self.out.triangles.len();
            let over = |e: OverBudget| e.in_file(self.file);
            if let Some(group) = polygon.smoothing {
                self.out.triangles.smoothing.set(first, group, self.budget).map_err(over)?;
            } else if !self.out.triangles.smoothing.is_empty() {
                self.out.triangles.smoothing.set(first, 0, self.budget).map_err(over)?;
            }
            let material = polygon.material.unwrap_or(MaterialNames::NONE);
            self.out.triangles.materials.set(first, material, self.budget).map_err(over)?;
            self.add_polygon(&polygon.corners, 0, polygon.statement)?;
            self.budget.release_list(&polygon.corners, polygon.corners.capacity());
        }
        Ok(())
    }
}
