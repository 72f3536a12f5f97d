//! Vertices at one place, for models where each face brings its own: STL files turned into OBJ are full of them.

use crate::budget::{Budget, OverBudget};

/// For each vertex the first one at the same place; `None` if the model's faces share their vertices already.
///
/// Only smoothing looks at it: the mesh keeps its vertices.
pub(super) fn welded(
    positions: &[[f32; 3]],
    triangles: usize,
    budget: &mut Budget,
) -> Result<Option<Vec<u32>>, OverBudget> {
    // A surface whose faces share vertices has about half as many of them as triangles.
    if positions.len() <= triangles {
        return Ok(None);
    }
    let mut first = Vec::new();
    budget.reserve(&mut first, positions.len(), "vertices at one place")?;
    let slots = positions.len().saturating_mul(2).next_power_of_two();
    let mut table: Vec<u32> = Vec::new();
    budget.reserve(&mut table, slots, "vertices at one place")?;
    table.resize(slots, EMPTY);
    let mask = slots.wrapping_sub(1);
    for (number, place) in (0_u32..).zip(positions) {
        let key = place.map(bits);
        let mut slot = hash(key) & mask;
        let mut found = number;
        // Places made to collide must not cost the square of their number: after some steps a vertex stays its own.
        for _ in 0..MOST_STEPS {
            match table.get_mut(slot) {
                Some(entry) if *entry == EMPTY => {
                    *entry = number;
                    break;
                }
                Some(entry) => {
                    let other = usize::try_from(*entry).ok().and_then(|i| positions.get(i));
                    if other.is_some_and(|p| p.map(bits) == key) {
                        found = *entry;
                        break;
                    }
                }
                None => break,
            }
            slot = slot.wrapping_add(1) & mask;
        }
        first.push(found);
    }
    budget.release_list(&table, table.capacity());
    Ok(Some(first))
}

const EMPTY: u32 = u32::MAX;
/// The most slots that are looked at for one vertex.
const MOST_STEPS: usize = 64;

/// The bits of a coordinate, with one zero instead of two.
fn bits(c: f32) -> u32 {
    (c + 0.0).to_bits()
}

fn hash([x, y, z]: [u32; 3]) -> usize {
    let mix = |h: u64, v: u32| (h ^ u64::from(v)).wrapping_mul(0x9e37_79b9_7f4a_7c15).rotate_left(29);
    let h = mix(mix(mix(0x51ce, x), y), z);
    usize::try_from((h ^ (h >> 31)) & 0x7fff_ffff_ffff).unwrap_or(0)
}
