//! The triangles as they are read: corners, and run lengths of what holds for many in a row.

use crate::budget::{Budget, OverBudget};

/// Stands for "this corner's normal is to be computed" in lists of normal indices.
pub(super) const NO_NORMAL: u32 = u32::MAX;

/// A corner of a face: indices from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Corner {
    pub(super) vertex: u32,
    /// [`NO_NORMAL`] where the face gives none.
    pub(super) normal: u32,
}

/// Triangles, and where their normals lie.
#[derive(Debug, Default)]
pub(super) struct Triangles {
    pub(super) vertices: Vec<[u32; 3]>,
    pub(super) normals: NormalIndices,
    /// The smoothing group of each triangle; empty where the file has no `s`.
    pub(super) smoothing: Runs,
    /// The material of each triangle, by its number in the order of first use.
    pub(super) materials: Runs,
}

/// Normal indices, in as little memory as the file allows.
#[derive(Debug, Default)]
pub(super) enum NormalIndices {
    /// No triangle has any so far.
    #[default]
    Absent,
    /// They equal the vertex indices.
    SameAsVertices,
    /// A list of their own.
    Own(Vec<[u32; 3]>),
}

impl Triangles {
    /// How many there are.
    pub(super) const fn len(&self) -> usize {
        self.vertices.len()
    }

    /// Adds a triangle. `text_left` bounds how many more can come.
    #[inline]
    pub(super) fn push(
        &mut self,
        corners: [Corner; 3],
        text_left: usize,
        budget: &mut Budget,
    ) -> Result<(), OverBudget> {
        let vertices = corners.map(|c| c.vertex);
        let normals = corners.map(|c| c.normal);
        let fits = match self.normals {
            NormalIndices::Absent => normals == [NO_NORMAL; 3],
            NormalIndices::SameAsVertices => normals == vertices,
            NormalIndices::Own(_) => true,
        };
        if !fits {
            self.give_normals_a_list(vertices == normals, budget)?;
        }
        // Two bytes of text, a blank and a digit, make a corner at the least, and a corner one triangle at the most.
        grow(&mut self.vertices, text_left / 2, "triangles", budget)?;
        self.vertices.push(vertices);
        if let NormalIndices::Own(list) = &mut self.normals {
            grow(list, text_left / 2, "normal indices", budget)?;
            list.push(normals);
        }
        Ok(())
    }

    #[cold]
    fn give_normals_a_list(&mut self, same: bool, budget: &mut Budget) -> Result<(), OverBudget> {
        if same && self.vertices.is_empty() {
            self.normals = NormalIndices::SameAsVertices;
            return Ok(());
        }
        let mut list = Vec::new();
        budget.reserve(&mut list, self.vertices.len(), "normal indices")?;
        match self.normals {
            NormalIndices::SameAsVertices => list.extend_from_slice(&self.vertices),
            _ => list.resize(self.vertices.len(), [NO_NORMAL; 3]),
        }
        self.normals = NormalIndices::Own(list);
        Ok(())
    }

    /// The vertex indices, and the normal indices where they differ.
    pub(super) fn into_lists(self) -> (Vec<[u32; 3]>, Option<Vec<[u32; 3]>>) {
        match self.normals {
            NormalIndices::Own(list) => (self.vertices, Some(list)),
            NormalIndices::Absent | NormalIndices::SameAsVertices => (self.vertices, None),
        }
    }
}

/// Makes room for one more, doubling, but for no more than `most` more.
#[inline]
pub(super) fn grow<T>(
    list: &mut Vec<T>,
    most: usize,
    what: &'static str,
    budget: &mut Budget,
) -> Result<(), OverBudget> {
    if list.len() < list.capacity() {
        return Ok(());
    }
    grow_now(list, most, what, budget)
}

#[cold]
fn grow_now<T>(list: &mut Vec<T>, most: usize, what: &'static str, budget: &mut Budget) -> Result<(), OverBudget> {
    let double = list.len().max(1024);
    budget.reserve(list, double.min(most.saturating_add(1)), what)
}

/// A value for each triangle, told only where it changes.
#[derive(Debug, Default)]
pub(super) struct Runs {
    /// First triangle of the run, and its value.
    runs: Vec<(u32, u32)>,
}

impl Runs {
    /// From triangle `first` on the value is `value`. `first` never falls.
    pub(super) fn set(&mut self, first: usize, value: u32, budget: &mut Budget) -> Result<(), OverBudget> {
        // More triangles than u32 counts are refused when they are pushed; the last run may then be wrong.
        let first = u32::try_from(first).unwrap_or(u32::MAX);
        match self.runs.last_mut() {
            Some((_, old)) if *old == value => return Ok(()),
            Some((start, old)) if *start == first => {
                *old = value;
                return Ok(());
            }
            _ => {}
        }
        grow(&mut self.runs, usize::MAX, "groups", budget)?;
        self.runs.push((first, value));
        Ok(())
    }

    /// The value now.
    pub(super) fn last(&self) -> Option<u32> {
        self.runs.last().map(|(_, value)| *value)
    }

    /// Whether nothing was ever set.
    pub(super) const fn is_empty(&self) -> bool {
        self.runs.is_empty()
    }

    /// The value of each of `count` triangles, in order; `before` until the first run.
    pub(super) fn values(&self, count: usize, before: u32) -> impl Iterator<Item = u32> {
        let mut runs = self.runs.iter().peekable();
        let mut value = before;
        (0..count).map(move |triangle| {
            let here = u32::try_from(triangle).unwrap_or(u32::MAX);
            while let Some((_, next)) = runs.next_if(|(first, _)| *first <= here) {
                value = *next;
            }
            value
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corners(v: [u32; 3], n: [u32; 3]) -> [Corner; 3] {
        [0, 1, 2].map(|i| Corner { vertex: v[i], normal: n[i] })
    }

    #[test]
    fn normal_indices_take_a_list_only_where_they_need_one() {
        let none = [NO_NORMAL; 3];
        let build = |faces: &[([u32; 3], [u32; 3])]| {
            let mut triangles = Triangles::default();
            for (v, n) in faces {
                triangles.push(corners(*v, *n), 100, &mut Budget::new(1 << 20)).unwrap();
            }
            triangles.into_lists().1
        };
        assert_eq!(build(&[([0, 1, 2], [0, 1, 2]), ([2, 1, 3], [2, 1, 3])]), None);
        assert_eq!(build(&[([0, 1, 2], none)]), None);
        assert_eq!(build(&[([0, 1, 2], none), ([0, 1, 3], [5, 6, 7])]), Some(vec![none, [5, 6, 7]]));
        assert_eq!(build(&[([0, 1, 2], [0, 1, 2]), ([0, 1, 3], none)]), Some(vec![[0, 1, 2], none]));
        assert_eq!(build(&[([0, 1, 2], none), ([0, 1, 3], [0, 1, 3])]), Some(vec![none, [0, 1, 3]]));
    }

    #[test]
    fn runs_give_each_triangle_its_value() {
        let mut budget = Budget::new(1 << 20);
        let mut runs = Runs::default();
        for (first, value) in [(1, 7), (1, 8), (3, 8), (3, 9)] {
            runs.set(first, value, &mut budget).unwrap();
        }
        assert_eq!(runs.values(5, 0).collect::<Vec<_>>(), [0, 8, 8, 9, 9]);
        assert_eq!(runs.last(), Some(9));
    }
}
