//! Which of the corners that meet at a vertex share a normal.

use super::facing::dot;

/// Cosine of 40 degrees.
const CREASE_COS: f64 = 0.766_044_443_118_978;
/// Cosine of 20 degrees: facets within it of one facet are within 40 of each other.
pub(super) const HALF_CREASE_COS: f64 = 0.939_692_620_785_908_4;

/// A corner at a vertex.
pub(super) struct Facet {
    /// Its place: three times the triangle, plus 0, 1 or 2.
    pub(super) corner: usize,
    /// The vertices of its triangle before and after.
    pub(super) neighbours: [u32; 2],
    pub(super) group: u32,
    pub(super) normal: [f64; 3],
    /// Angle at the vertex in radians; 0 for a triangle without area.
    pub(super) angle: f64,
    /// The first facet of its fan.
    pub(super) fan: usize,
}

/// One fan for each smoothing group.
pub(super) fn join_groups(facets: &mut [Facet], order: &mut Vec<(u32, usize)>) {
    order.clear();
    order.extend(facets.iter().enumerate().map(|(i, f)| (f.group, i)));
    order.sort_unstable();
    for same in order.chunk_by(|a, b| a.0 == b.0) {
        let Some((_, first)) = same.first() else { continue };
        for (_, i) in same {
            if let Some(facet) = facets.get_mut(*i) {
                facet.fan = *first;
            }
        }
    }
}

/// One fan for all that hang together by edges that do not bend much.
pub(super) fn join_over_soft_edges(facets: &mut [Facet], order: &mut Vec<(u32, usize)>) {
    facets.iter_mut().enumerate().for_each(|(i, f)| f.fan = i);
    order.clear();
    order.extend(facets.iter().enumerate().flat_map(|(i, f)| f.neighbours.map(|n| (n, i))));
    order.sort_unstable();
    for pair in order.windows(2) {
        let [(v, i), (w, j)] = *pair else { continue };
        let normal = |i: usize| facets.get(i).map_or([0.0; 3], |f| f.normal);
        if v == w && dot(normal(i), normal(j)) >= CREASE_COS {
            let (a, b) = (root(facets, i), root(facets, j));
            if let Some(facet) = facets.get_mut(a.max(b)) {
                facet.fan = a.min(b);
            }
        }
    }
    for i in 0..facets.len() {
        let root = root(facets, i);
        if let Some(facet) = facets.get_mut(i) {
            facet.fan = root;
        }
    }
}

/// The first facet of the fan so far, with the path to it made shorter.
fn root(facets: &mut [Facet], mut i: usize) -> usize {
    loop {
        let parent = facets.get(i).map_or(i, |f| f.fan);
        if parent == i {
            return i;
        }
        let above = facets.get(parent).map_or(parent, |f| f.fan);
        if let Some(facet) = facets.get_mut(i) {
            facet.fan = above;
        }
        i = above;
    }
}
