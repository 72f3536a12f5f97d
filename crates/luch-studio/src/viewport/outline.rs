//! The outline of an object in the picture: traced around its pixels, drawn as a line of even width at any zoom.

use super::frame::PictureFrame;
use crate::selection::Part;
use crate::state::Desk;
use egui::{Color32, Id, Painter, Pos2, Shape, Stroke, pos2};
use luch_render::session::live::{ObjectMap, Snapshot};
use std::collections::HashMap;
use std::sync::Arc;

/// The colour of what is selected: told apart from any surface by its dark rim.
pub(super) const COLOR: Color32 = Color32::from_rgb(255, 170, 40);

/// How much an outline says.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Strength {
    /// The object is selected.
    Crisp,
    /// The pointer is on it.
    Faint,
}

/// The loops around an object's pixels, in blocks of the map.
type Loops = Arc<Vec<Vec<Pos2>>>;

/// What was traced last: for which picture, which object.
#[derive(Clone)]
struct Traced {
    map: Arc<ObjectMap>,
    object: usize,
    loops: Loops,
}

pub(super) fn draw(
    painter: &Painter,
    frame: &PictureFrame,
    snapshot: &Snapshot,
    desk: &Desk<'_>,
    part: Part,
    strength: Strength,
) {
    let Part::Object(index) = part else { return };
    let Some(map) = &snapshot.objects else { return };
    let Some(index) = super::lookup::same_object(desk.scene(), index, &snapshot.scene) else { return };
    let loops = traced(painter, map, index, strength);
    let (side, [width, height]) = (map.shrink() as f32, [map.width(), map.height()].map(|side| side as f32));
    // The last blocks of a preview may reach beyond the picture.
    let place = |p: &Pos2| frame.point_of_pixel((p.x * side).min(width), (p.y * side).min(height));
    for outline in loops.iter() {
        let points: Vec<Pos2> = outline.iter().map(place).collect();
        match strength {
            Strength::Crisp => {
                painter.add(Shape::closed_line(points.clone(), Stroke::new(4.0, Color32::from_black_alpha(140))));
                painter.add(Shape::closed_line(points, Stroke::new(2.0, COLOR)));
            }
            Strength::Faint => {
                painter.add(Shape::closed_line(points, Stroke::new(1.5, COLOR.gamma_multiply(0.55))));
            }
        }
    }
}

/// The loops of an object; traced once for each picture.
fn traced(painter: &Painter, map: &Arc<ObjectMap>, object: usize, strength: Strength) -> Loops {
    let id = Id::unique(("outline", strength == Strength::Crisp));
    if let Some(known) = painter.ctx().data(|d| d.get_temp::<Traced>(id))
        && Arc::ptr_eq(&known.map, map)
        && known.object == object
    {
        return known.loops;
    }
    let side = map.shrink();
    let inside = |x: u32, y: u32| map.at(x * side, y * side) == Some(object);
    let loops: Loops = Arc::new(trace(map.width().div_ceil(side), map.height().div_ceil(side), inside));
    let traced = Traced { map: Arc::clone(map), object, loops: Arc::clone(&loops) };
    painter.ctx().data_mut(|d| d.insert_temp(id, traced));
    loops
}

/// Directions along the edges of pixels, each a quarter turn to the right of the one before (y points down).
const STEPS: [[i32; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];

/// The closed loops around the pixels that are `inside`, through the middles of the pixels' edges.
fn trace(width: u32, height: u32, inside: impl Fn(u32, u32) -> bool) -> Vec<Vec<Pos2>> {
    let mut edges = edges(width, height, inside);
    let mut loops = Vec::new();
    while let Some((&start, &directions)) = edges.iter().next() {
        let begin = (start, first(directions));
        let mut outline = Vec::new();
        let (mut corner, mut direction) = begin;
        loop {
            let [dx, dy] = STEPS[direction];
            outline.push(pos2(corner[0] as f32 + dx as f32 * 0.5, corner[1] as f32 + dy as f32 * 0.5));
            // The first edge stays until the loop comes back to it.
            if (corner, direction) != begin {
                remove(&mut edges, corner, direction);
            }
            corner = [corner[0] + dx, corner[1] + dy];
            let next = edges.get(&corner).copied().unwrap_or(0);
            // Where two pixels touch at a corner only, the loop stays with its own pixel: it turns right.
            let turns = [(direction + 1) % 4, direction, (direction + 3) % 4];
            let Some(turn) = turns.into_iter().find(|d| next & (1 << d) != 0) else { break };
            direction = turn;
            if (corner, direction) == begin {
                break;
            }
        }
        remove(&mut edges, begin.0, begin.1);
        loops.push(straightened(&outline));
    }
    // The order of a hash table is nobody's business.
    loops.sort_by(|a, b| {
        (a.len(), a[0].x, a[0].y).partial_cmp(&(b.len(), b[0].x, b[0].y)).unwrap_or(std::cmp::Ordering::Equal)
    });
    loops
}

/// For each corner of a pixel the directions (as bits) of the edges that leave it with the inside to their right.
fn edges(width: u32, height: u32, inside: impl Fn(u32, u32) -> bool) -> HashMap<[i32; 2], u8> {
    let mut edges: HashMap<[i32; 2], u8> = HashMap::new();
    let mut add = |x: u32, y: u32, direction: u8| {
        *edges.entry([x as i32, y as i32]).or_default() |= 1 << direction;
    };
    for y in 0..height {
        for x in 0..width {
            if !inside(x, y) {
                continue;
            }
            if y == 0 || !inside(x, y - 1) {
                add(x, y, 0);
            }
            if x + 1 == width || !inside(x + 1, y) {
                add(x + 1, y, 1);
            }
            if y + 1 == height || !inside(x, y + 1) {
                add(x + 1, y + 1, 2);
            }
            if x == 0 || !inside(x - 1, y) {
                add(x, y + 1, 3);
            }
        }
    }
    edges
}

const fn first(directions: u8) -> usize {
    directions.trailing_zeros() as usize
}

fn remove(edges: &mut HashMap<[i32; 2], u8>, corner: [i32; 2], direction: usize) {
    if let Some(directions) = edges.get_mut(&corner) {
        *directions &= !(1 << direction);
        if *directions == 0 {
            edges.remove(&corner);
        }
    }
}

/// The same loop without the points between two others on a straight line.
fn straightened(outline: &[Pos2]) -> Vec<Pos2> {
    let count = outline.len();
    let bends = (0..count).filter(|&i| {
        let (before, here, after) = (outline[(i + count - 1) % count], outline[i], outline[(i + 1) % count]);
        here - before != after - here
    });
    let kept: Vec<Pos2> = bends.map(|i| outline[i]).collect();
    if kept.len() < 3 { outline.to_vec() } else { kept }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn traced(rows: &[&str]) -> Vec<Vec<Pos2>> {
        let inside = |x: u32, y: u32| rows[y as usize].as_bytes()[x as usize] == b'#';
        trace(rows[0].len() as u32, rows.len() as u32, inside)
    }

    /// Twice the area inside the loop, by the shoelace formula; positive for loops around an inside.
    fn area(outline: &[Pos2]) -> f32 {
        let next = outline.iter().cycle().skip(1);
        outline.iter().zip(next).map(|(a, b)| a.x * b.y - b.x * a.y).sum::<f32>()
    }

    #[test]
    fn a_pixel_has_one_loop_around_it() {
        let loops = traced(&["...", ".#.", "..."]);
        assert_eq!(loops.len(), 1);
        assert_eq!(loops[0].len(), 4);
        assert!(loops[0].contains(&pos2(1.5, 1.0)) && loops[0].contains(&pos2(1.0, 1.5)));
    }

    #[test]
    fn a_ring_has_two_loops_that_run_against_each_other() {
        let loops = traced(&["#####", "#...#", "#...#", "#####"]);
        assert_eq!(loops.len(), 2);
        let mut areas: Vec<f32> = loops.iter().map(|outline| area(outline)).collect();
        areas.sort_by(f32::total_cmp);
        assert!(areas[0] < 0.0 && areas[1] > 0.0, "{areas:?}");
    }

    #[test]
    fn pixels_that_touch_at_a_corner_have_loops_of_their_own() {
        assert_eq!(traced(&["#.", ".#"]).len(), 2);
        assert_eq!(traced(&[".#", "#."]).len(), 2);
    }

    #[test]
    fn an_object_that_fills_the_picture_is_outlined_at_its_border() {
        let loops = traced(&["####", "####"]);
        assert_eq!(loops.len(), 1);
        assert!(loops[0].iter().all(|p| (0.0..=4.0).contains(&p.x) && (0.0..=2.0).contains(&p.y)));
        assert!(traced(&["..", ".."]).is_empty());
    }
}
