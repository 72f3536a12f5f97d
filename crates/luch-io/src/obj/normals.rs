//! Normals for the corners that the file gives none.
//!
//! The corners that meet at a vertex fall into fans, and a fan has one normal: the sum of its facets' normals, each
//! weighted by its angle at the vertex, so that it does not matter how a surface is cut into triangles (Thuermer and
//! Wuethrich, "Computing vertex normals from polygonal facets", 1998). Which corners make a fan:
//! - the file has `s` statements: those of the same smoothing group; with `s off` none, the facet's own normal serves;
//! - it has none: those that reach each other over edges that bend by at most [`CREASE_DEGREES`].

use super::facing::{angle_of, at, dot, minus, unit_and_length};
use super::fans::{Facet, HALF_CREASE_COS, join_groups, join_over_soft_edges};
use super::triangles::{NO_NORMAL, NormalIndices, Triangles};
use super::weld::welded;
use crate::budget::{Budget, OverBudget};

/// An edge that bends by more is sharp, where the file says nothing of smoothing.
pub const CREASE_DEGREES: f32 = 40.0;
/// Gives every corner a normal. On return each normal index of `triangles` is in range.
pub(super) fn complete(
    positions: &[[f32; 3]],
    triangles: &mut Triangles,
    normals: &mut Vec<[f32; 3]>,
    budget: &mut Budget,
) -> Result<(), OverBudget> {
    let has_own = match &triangles.normals {
        NormalIndices::SameAsVertices => return Ok(()),
        NormalIndices::Own(list) if list.iter().all(|n| *n != [NO_NORMAL; 3]) => return Ok(()),
        NormalIndices::Own(_) => true,
        NormalIndices::Absent => {
            // Normals that no face names.
            normals.clear();
            false
        }
    };
    let groups = groups(triangles, budget)?;
    let own = match std::mem::take(&mut triangles.normals) {
        NormalIndices::Own(list) if has_own => Some(list),
        _ => None,
    };
    let mut completion = Completion { positions, vertices: &triangles.vertices, own, base: normals.len(), normals };
    let facing_alone = completion.give_faceted_corners_none(groups.as_deref(), budget)?;
    if !facing_alone {
        let weld = if groups.is_none() { welded(positions, triangles.vertices.len(), budget)? } else { None };
        completion.give_fans_theirs(groups.as_deref(), weld.as_deref(), budget)?;
        if let Some(list) = weld {
            budget.release_list(&list, list.capacity());
        }
    }
    let own = completion.own;
    if let Some(list) = groups {
        budget.release_list(&list, list.capacity());
    }
    triangles.normals = own.map_or(NormalIndices::SameAsVertices, NormalIndices::Own);
    Ok(())
}

/// The smoothing group of each triangle, where the file has `s` statements; 0 is off, also before the first.
fn groups(triangles: &Triangles, budget: &mut Budget) -> Result<Option<Vec<u32>>, OverBudget> {
    if triangles.smoothing.is_empty() {
        return Ok(None);
    }
    let mut list = Vec::new();
    budget.reserve(&mut list, triangles.len(), "smoothing groups")?;
    list.extend(triangles.smoothing.values(triangles.len(), 0));
    Ok(Some(list))
}

/// Normals in the making.
struct Completion<'a> {
    positions: &'a [[f32; 3]],
    vertices: &'a [[u32; 3]],
    /// The normal indices; `None` as long as they equal the vertex indices.
    own: Option<Vec<[u32; 3]>>,
    /// How many normals the file gives. The first fan of vertex v gets number `base + v`, further ones come after.
    base: usize,
    normals: &'a mut Vec<[f32; 3]>,
}

/// What is known of a vertex after one look at each triangle.
#[derive(Debug, Clone, Copy, Default)]
struct Place {
    /// Sum of the facets' normals, weighted by angle.
    sum: [f64; 3],
    /// The first facet's normal and group, once one was met.
    first: [f64; 3],
    group: u32,
    is_met: bool,
    /// Whether the facets may fall into several fans.
    is_split: bool,
}

impl Completion<'_> {
    fn needs(&self, triangle: usize) -> bool {
        self.own.as_ref().is_none_or(|list| list.get(triangle) == Some(&[NO_NORMAL; 3]))
    }

    /// Corners of `s off` share one normal, zero, which shading reads as "the facet's own". Answers whether no others
    /// are left.
    fn give_faceted_corners_none(&mut self, groups: Option<&[u32]>, budget: &mut Budget) -> Result<bool, OverBudget> {
        let Some(groups) = groups else { return Ok(false) };
        let count = self.vertices.len();
        let is_faceted = |triangle: usize| groups.get(triangle) == Some(&0);
        let needed = || (0..count).filter(|t| self.needs(*t));
        if !needed().any(is_faceted) {
            return Ok(false);
        }
        let none_left = needed().all(is_faceted);
        budget.reserve(self.normals, 1, "normals")?;
        let zero = u32::try_from(self.normals.len()).unwrap_or(u32::MAX);
        self.normals.push([0.0; 3]);
        self.base = self.normals.len();
        if self.own.is_none() {
            let mut list = Vec::new();
            budget.reserve(&mut list, count, "normal indices")?;
            list.resize(count, [NO_NORMAL; 3]);
            self.own = Some(list);
        }
        for (slot, group) in self.own.iter_mut().flatten().zip(groups) {
            if *group == 0 && *slot == [NO_NORMAL; 3] {
                *slot = [zero; 3];
            }
        }
        Ok(none_left)
    }

    fn give_fans_theirs(
        &mut self,
        groups: Option<&[u32]>,
        weld: Option<&[u32]>,
        budget: &mut Budget,
    ) -> Result<(), OverBudget> {
        let same = |vertex: u32| weld.map_or(vertex, |weld| at(weld, vertex));
        // Nearly all vertices of nearly all models have one fan: their sums need no list of corners.
        let mut places = Vec::new();
        budget.reserve(&mut places, self.positions.len(), "sums of normals")?;
        places.resize(self.positions.len(), Place::default());
        self.sum_at_vertices(&mut places, groups, &same);
        let is_split = |vertex: u32| at(&places, vertex).is_split;
        let split = if places.iter().any(|p| p.is_split) {
            Some(self.corners_by_vertex(|vertex| Some(same(vertex)).filter(|v| is_split(*v)), budget)?)
        } else {
            None
        };
        let count = self.positions.len();
        budget.reserve(self.normals, count, "normals")?;
        #[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
        self.normals.extend(places.iter().map(|p| p.sum.map(|c| c as f32)));
        if self.own.is_some() || weld.is_some() {
            self.name_unsplit_corners(&same, &is_split, budget)?;
        }
        budget.release_list(&places, places.capacity());
        drop(places);
        if let Some((ends, corners)) = split {
            self.give_split_vertices_theirs(&ends, &corners, groups, &same, budget)?;
            budget.release_list(&ends, ends.capacity());
            budget.release_list(&corners, corners.capacity());
        }
        Ok(())
    }

    /// Sums the facets at each vertex, and finds the vertices where they may fall into several fans.
    fn sum_at_vertices(&self, places: &mut [Place], groups: Option<&[u32]>, same: &impl Fn(u32) -> u32) {
        for (triangle, vertices) in self.vertices.iter().enumerate() {
            if !self.needs(triangle) {
                continue;
            }
            let [a, b, c] = vertices.map(|v| at(self.positions, v).map(f64::from));
            let (ab, bc, ca) = (minus(b, a), minus(c, b), minus(a, c));
            let Some((normal, sine)) = unit_and_length(ab, bc) else { continue };
            let cosines = [-dot(ca, ab), -dot(ab, bc), -dot(bc, ca)];
            let group = groups.and_then(|g| g.get(triangle)).copied().unwrap_or(0);
            for (vertex, cosine) in vertices.iter().zip(cosines) {
                let Some(place) = usize::try_from(same(*vertex)).ok().and_then(|v| places.get_mut(v)) else { continue };
                let angle = angle_of(sine, cosine);
                for (sum, n) in place.sum.iter_mut().zip(normal) {
                    *sum += n * angle;
                }
                if !place.is_met {
                    (place.is_met, place.first, place.group) = (true, normal, group);
                } else if groups.is_some() {
                    place.is_split |= place.group != group;
                } else {
                    // Within half the angle of one facet they are within the angle of each other.
                    place.is_split |= dot(place.first, normal) <= HALF_CREASE_COS;
                }
            }
        }
    }

    /// Tells the corners at vertices with one fan where its normal lies.
    fn name_unsplit_corners(
        &mut self,
        same: &impl Fn(u32) -> u32,
        is_split: &impl Fn(u32) -> bool,
        budget: &mut Budget,
    ) -> Result<(), OverBudget> {
        // Asked before the first answer: from then on there is a list, and it looks as if it had come from the file.
        let all = self.own.is_none();
        for (triangle, vertices) in self.vertices.iter().enumerate() {
            if !all && !self.needs(triangle) {
                continue;
            }
            for (k, vertex) in vertices.iter().enumerate() {
                let vertex = same(*vertex);
                let number = usize::try_from(vertex).ok().and_then(|v| self.base.checked_add(v));
                if let (false, Some(number)) = (is_split(vertex), number.and_then(|n| u32::try_from(n).ok())) {
                    self.set(triangle.saturating_mul(3).saturating_add(k), number, budget)?;
                }
            }
        }
        Ok(())
    }

    fn give_split_vertices_theirs(
        &mut self,
        ends: &[u32],
        corners: &[u32],
        groups: Option<&[u32]>,
        same: &impl Fn(u32) -> u32,
        budget: &mut Budget,
    ) -> Result<(), OverBudget> {
        let mut facets: Vec<Facet> = Vec::new();
        let mut order: Vec<(u32, usize)> = Vec::new();
        let mut start = 0_usize;
        for (vertex, end) in ends.iter().enumerate().take(self.positions.len()) {
            let end = usize::try_from(*end).unwrap_or(usize::MAX);
            let here = corners.get(start..end).unwrap_or(&[]);
            start = end;
            if here.is_empty() {
                continue;
            }
            facets.clear();
            facets.extend(here.iter().filter_map(|c| self.facet(*c, groups, same)));
            match groups {
                Some(_) => join_groups(&mut facets, &mut order),
                None => join_over_soft_edges(&mut facets, &mut order),
            }
            self.give_normals(vertex, &facets, &mut order, budget)?;
        }
        Ok(())
    }

    /// The corners without normals, sorted by vertex: where each vertex's end, and their places. `slot` is the vertex
    /// that a corner belongs to, if it is wanted.
    fn corners_by_vertex(
        &self,
        slot: impl Fn(u32) -> Option<u32>,
        budget: &mut Budget,
    ) -> Result<(Vec<u32>, Vec<u32>), OverBudget> {
        let mut ends: Vec<u32> = Vec::new();
        budget.reserve(&mut ends, self.positions.len().saturating_add(1), "corners of vertices")?;
        ends.resize(self.positions.len().saturating_add(1), 0);
        let wanted = || (0_u32..).zip(self.vertices).enumerate().filter(|(t, _)| self.needs(*t)).map(|(_, v)| v);
        let slot = |vertex: u32| slot(vertex).and_then(|v| usize::try_from(v).ok());
        let mut total = 0_usize;
        for vertex in wanted().flat_map(|(_, triangle)| triangle) {
            // One place further, so that the running sum below yields beginnings.
            if let Some(n) = slot(*vertex).and_then(|v| ends.get_mut(v.saturating_add(1))) {
                *n = n.saturating_add(1);
                total = total.saturating_add(1);
            }
        }
        let mut sum = 0_u32;
        for end in &mut ends {
            sum = sum.saturating_add(*end);
            *end = sum;
        }
        let mut corners = Vec::new();
        budget.reserve(&mut corners, total, "corners of vertices")?;
        corners.resize(total, 0_u32);
        for (t, triangle) in wanted() {
            for (k, vertex) in (0_u32..).zip(triangle) {
                if let Some(place) = slot(*vertex).and_then(|v| ends.get_mut(v)) {
                    if let Some(corner) = usize::try_from(*place).ok().and_then(|p| corners.get_mut(p)) {
                        *corner = t.saturating_mul(3).saturating_add(k);
                    }
                    *place = place.saturating_add(1);
                }
            }
        }
        Ok((ends, corners))
    }

    fn facet(&self, corner: u32, groups: Option<&[u32]>, same: &impl Fn(u32) -> u32) -> Option<Facet> {
        let corner = usize::try_from(corner).ok()?;
        let triangle = corner / 3;
        let [a, b, c] = *self.vertices.get(triangle)?;
        let [here, after, before] = match corner % 3 {
            0 => [a, b, c],
            1 => [b, c, a],
            _ => [c, a, b],
        };
        let place = |v: u32| at(self.positions, v).map(f64::from);
        let p = place(here);
        let (u, v) = (minus(place(after), p), minus(place(before), p));
        let (normal, angle) =
            unit_and_length(u, v).map_or(([0.0; 3], 0.0), |(n, length)| (n, angle_of(length, dot(u, v))));
        let group = groups.and_then(|g| g.get(triangle)).copied().unwrap_or(0);
        Some(Facet { corner, neighbours: [same(after), same(before)], group, normal, angle, fan: 0 })
    }

    /// Sums each fan and tells its corners where the sum lies.
    fn give_normals(
        &mut self,
        vertex: usize,
        facets: &[Facet],
        order: &mut Vec<(u32, usize)>,
        budget: &mut Budget,
    ) -> Result<(), OverBudget> {
        let first = self.base.saturating_add(vertex);
        if facets.iter().all(|f| f.fan == 0) {
            return self.give_fan_its_normal(first, facets.iter(), budget);
        }
        order.clear();
        order.extend(facets.iter().enumerate().map(|(i, f)| (u32::try_from(f.fan).unwrap_or(u32::MAX), i)));
        order.sort_unstable();
        for fan in order.chunk_by(|a, b| a.0 == b.0) {
            let number = if matches!(fan, [(0, _), ..]) { first } else { self.normals.len() };
            self.give_fan_its_normal(number, fan.iter().filter_map(|(_, i)| facets.get(*i)), budget)?;
        }
        Ok(())
    }

    fn give_fan_its_normal<'f>(
        &mut self,
        number: usize,
        fan: impl Iterator<Item = &'f Facet> + Clone,
        budget: &mut Budget,
    ) -> Result<(), OverBudget> {
        let mut sum = [0.0_f64; 3];
        for facet in fan.clone() {
            let [x, y, z] = facet.normal;
            sum = [sum[0] + x * facet.angle, sum[1] + y * facet.angle, sum[2] + z * facet.angle];
        }
        #[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
        let sum = sum.map(|c| c as f32);
        match self.normals.get_mut(number) {
            Some(slot) => *slot = sum,
            None => {
                if self.normals.len() == self.normals.capacity() {
                    budget.reserve(self.normals, (self.normals.len() / 2).max(64), "normals")?;
                }
                self.normals.push(sum);
            }
        }
        let number = u32::try_from(number).unwrap_or(u32::MAX);
        for facet in fan {
            self.set(facet.corner, number, budget)?;
        }
        Ok(())
    }

    /// Notes the normal of a corner. The list comes into being when the first differs from its vertex.
    fn set(&mut self, corner: usize, number: u32, budget: &mut Budget) -> Result<(), OverBudget> {
        let (triangle, k) = (corner / 3, corner % 3);
        if self.own.is_none() {
            if self.vertices.get(triangle).and_then(|v| v.get(k)) == Some(&number) {
                return Ok(());
            }
            let mut list = Vec::new();
            budget.reserve(&mut list, self.vertices.len(), "normal indices")?;
            list.extend_from_slice(self.vertices);
            self.own = Some(list);
        }
        if let Some(slot) = self.own.as_mut().and_then(|l| l.get_mut(triangle)).and_then(|t| t.get_mut(k)) {
            *slot = number;
        }
        Ok(())
    }
}
