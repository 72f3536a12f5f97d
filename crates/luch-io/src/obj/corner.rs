//! One corner of a face: `1`, `1/2`, `1//3`, `1/2/3`, with indices below zero counted backwards.

use super::number::integer;
use super::triangles::{Corner, NO_NORMAL};

/// How many of each were read so far, and the largest index that was named before it was read.
#[derive(Debug, Default)]
pub(super) struct Counts {
    pub(super) vertices: Forward,
    pub(super) texture_coordinates: Forward,
    pub(super) normals: Forward,
}

/// A list of which some items may be named before they come.
#[derive(Debug, Default)]
pub(super) struct Forward {
    /// Items read so far.
    pub(super) count: usize,
    /// The largest index from 0 that was named too early, and the byte offset where.
    pub(super) largest: Option<(u32, usize)>,
}

/// Why a corner is none.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum CornerFault {
    /// Not of the form.
    Form,
    /// An index of 0.
    Zero,
    /// An index below zero that reaches before the first one.
    Before {
        /// `vertex`, `texture coordinate` or `normal`.
        what: &'static str,
        /// The index.
        index: i64,
        /// How many there are.
        count: usize,
    },
    /// An index beyond what a mesh can have.
    Huge,
}

/// Reads a corner at the beginning of `text`; `offset` is where that lies in the file.
#[inline]
pub(super) fn corner<'a>(
    text: &'a [u8],
    offset: usize,
    counts: &mut Counts,
) -> Result<(Corner, &'a [u8]), CornerFault> {
    let (index, rest) = integer(text).ok_or(CornerFault::Form)?;
    let vertex = counts.vertices.resolve(index, "vertex", offset)?;
    let mut corner = Corner { vertex, normal: NO_NORMAL };
    let [b'/', rest @ ..] = rest else { return Ok((corner, rest)) };
    let rest = match integer(rest) {
        Some((index, rest)) => {
            counts.texture_coordinates.resolve(index, "texture coordinate", offset)?;
            rest
        }
        None => rest,
    };
    let [b'/', rest @ ..] = rest else { return Ok((corner, rest)) };
    match integer(rest) {
        Some((index, rest)) => {
            corner.normal = counts.normals.resolve(index, "normal", offset)?;
            Ok((corner, rest))
        }
        None => Ok((corner, rest)),
    }
}

impl Forward {
    /// The index from 0 that a written index means.
    #[inline]
    fn resolve(&mut self, index: i64, what: &'static str, offset: usize) -> Result<u32, CornerFault> {
        if index > 0 {
            let zero_based = u32::try_from(index.wrapping_sub(1)).ok().filter(|i| *i < NO_NORMAL);
            let zero_based = zero_based.ok_or(CornerFault::Huge)?;
            if usize::try_from(zero_based).is_ok_and(|i| i >= self.count) {
                self.note_early(zero_based, offset);
            }
            return Ok(zero_based);
        }
        if index == 0 {
            return Err(CornerFault::Zero);
        }
        let back = usize::try_from(index.unsigned_abs()).ok();
        let forward = back.and_then(|back| self.count.checked_sub(back)).and_then(|i| u32::try_from(i).ok());
        forward.ok_or(CornerFault::Before { what, index, count: self.count })
    }

    #[cold]
    fn note_early(&mut self, index: u32, offset: usize) {
        if self.largest.is_none_or(|(largest, _)| index > largest) {
            self.largest = Some((index, offset));
        }
    }

    /// The index that never came, counted from 1, and where it was named.
    pub(super) fn missing(&self) -> Option<(u64, usize)> {
        let (index, offset) = self.largest?;
        let missing = usize::try_from(index).is_ok_and(|i| i >= self.count);
        missing.then_some((u64::from(index).saturating_add(1), offset))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<(u32, u32, usize), CornerFault> {
        let mut counts = Counts::default();
        counts.vertices.count = 10;
        counts.texture_coordinates.count = 10;
        counts.normals.count = 5;
        corner(text.as_bytes(), 0, &mut counts).map(|(c, rest)| (c.vertex, c.normal, rest.len()))
    }

    #[test]
    fn every_form_of_a_corner() {
        assert_eq!(read("1"), Ok((0, NO_NORMAL, 0)));
        assert_eq!(read("1/2 "), Ok((0, NO_NORMAL, 1)));
        assert_eq!(read("1//3"), Ok((0, 2, 0)));
        assert_eq!(read("1/2/3"), Ok((0, 2, 0)));
        assert_eq!(read("-1/-1/-1"), Ok((9, 4, 0)));
        assert_eq!(read("-10"), Ok((0, NO_NORMAL, 0)));
        assert_eq!(read("1/"), Ok((0, NO_NORMAL, 0)));
        assert_eq!(read("1//"), Ok((0, NO_NORMAL, 0)));
        assert_eq!(read("1/2/3/4"), Ok((0, 2, 2)), "the caller finds that it does not end here");
        assert_eq!(read("12"), Ok((11, NO_NORMAL, 0)), "may come later");
    }

    #[test]
    fn what_is_no_corner() {
        assert_eq!(read("x"), Err(CornerFault::Form));
        assert_eq!(read("/1"), Err(CornerFault::Form));
        assert_eq!(read("0"), Err(CornerFault::Zero));
        assert_eq!(read("1//0"), Err(CornerFault::Zero));
        assert_eq!(read("-11"), Err(CornerFault::Before { what: "vertex", index: -11, count: 10 }));
        assert_eq!(read("1//-6"), Err(CornerFault::Before { what: "normal", index: -6, count: 5 }));
        assert_eq!(read("4294967296"), Err(CornerFault::Huge));
        assert_eq!(read("99999999999999999999"), Err(CornerFault::Huge));
    }
}
