//! The boxes that a ray goes into, as wires over the picture, and the triangles that it is tested against.

use crate::explain::panel::hovered_step;
use crate::explain::{Explain, Explained};
use crate::viewport::PictureFrame;
use egui::{Color32, Painter, Shape as Mark, Stroke};
use glam::Vec3;
use luch_render::explain::{BOX_EDGES, BoxVisit, RayEnd, ShapeTest};
use luch_scene::Shape;

/// The most triangles that are drawn.
const MOST: usize = 2000;

/// The colour of a box: of nodes with more boxes in them, and of leaves.
pub(in crate::explain) const fn box_color(visit: &BoxVisit, on_dark: bool) -> Color32 {
    match (visit.leaf, on_dark) {
        (true, true) => Color32::from_rgb(240, 200, 66),
        (true, false) => Color32::from_rgb(176, 118, 0),
        (false, true) => Color32::from_rgb(86, 180, 233),
        (false, false) => Color32::from_rgb(0, 114, 178),
    }
}

pub(super) fn draw(painter: &Painter, frame: &PictureFrame, explain: &Explain, answer: &Explained) {
    let walk = &explain.walk;
    let deepest = walk.boxes.iter().map(|visit| visit.level).max().unwrap_or(0);
    let level = explain.level.min(deepest);
    let [hovered_box, hovered_test] = hovered_step(painter.ctx(), explain);
    let on_level = |visit: &BoxVisit| visit.level == level || (explain.outer_levels && visit.level < level);
    for visit in walk.boxes.iter().filter(|visit| on_level(visit)) {
        let faint = visit.level < level;
        wires(painter, frame, visit, if faint { 1.0 } else { 1.6 }, if faint { 0.5 } else { 1.0 });
    }
    let hit = match answer.account.rays.get(explain.ray as usize).map(|ray| ray.end) {
        Some(RayEnd::Surface(surface)) => {
            let surface = &answer.account.surfaces[surface as usize];
            Some([surface.object, surface.primitive])
        }
        Some(RayEnd::Blocked { blocker, .. }) => Some([blocker.object, blocker.primitive]),
        _ => None,
    };
    for test in walk.tests.iter().take(MOST) {
        if Some([test.object, test.primitive]) != hit {
            triangle(painter, frame, answer, test, Stroke::new(1.0, Color32::from_white_alpha(110)), false);
        }
    }
    for test in walk.tests.iter().filter(|test| Some([test.object, test.primitive]) == hit) {
        triangle(painter, frame, answer, test, Stroke::new(2.0, Color32::WHITE), true);
    }
    if let Some(visit) = hovered_box.and_then(|place| walk.boxes.get(place)) {
        wires(painter, frame, visit, 3.0, 1.0);
    }
    if let Some(test) = hovered_test.and_then(|place| walk.tests.get(place)) {
        triangle(painter, frame, answer, test, Stroke::new(3.0, Color32::from_rgb(240, 110, 40)), true);
    }
}

fn wires(painter: &Painter, frame: &PictureFrame, visit: &BoxVisit, width: f32, strength: f32) {
    let color = box_color(visit, true).gamma_multiply(strength);
    let edges = BOX_EDGES.iter().filter_map(|edge| frame.project_segment(edge.map(|corner| visit.corners[corner])));
    let edges: Vec<_> = edges.map(|edge| edge.points).collect();
    // The rims first, so that none lies over the line of another edge.
    for edge in &edges {
        painter.line_segment(*edge, Stroke::new(width + 1.6, Color32::from_black_alpha((110.0 * strength) as u8)));
    }
    for edge in &edges {
        painter.line_segment(*edge, Stroke::new(width, color));
    }
}

fn triangle(painter: &Painter, frame: &PictureFrame, answer: &Explained, test: &ShapeTest, stroke: Stroke, rim: bool) {
    let Some(corners) = corners(answer, test) else { return };
    let sides = [[0, 1], [1, 2], [2, 0]].map(|side| side.map(|corner: usize| corners[corner]));
    for side in sides.into_iter().filter_map(|side| frame.project_segment(side)) {
        if rim {
            painter.line_segment(side.points, Stroke::new(stroke.width + 1.6, Color32::from_black_alpha(140)));
        }
        painter.add(Mark::line_segment(side.points, stroke));
    }
}

/// The corners of a triangle in the scene.
fn corners(answer: &Explained, test: &ShapeTest) -> Option<[Vec3; 3]> {
    let Shape::Mesh(instance) = &answer.scene.objects.get(test.object as usize)?.shape else { return None };
    let triangle = instance.mesh.triangles().get(test.primitive as usize)?;
    let world = instance.rotation.matrix() * instance.scale.get();
    let positions = instance.mesh.positions();
    let corner = |index: u32| Some(world * Vec3::from(*positions.get(index as usize)?) + instance.position.get());
    Some([corner(triangle[0])?, corner(triangle[1])?, corner(triangle[2])?])
}
