//! Where things are by now, in lines over an older picture: while changes wait for the button, a drag of the view or of a
//! handle would otherwise show nothing.

use super::frame::PictureFrame;
use super::lookup::same_object;
use crate::selection::Part;
use crate::state::Desk;
use crate::view::extent::Extent;
use egui::{Color32, Painter, Pos2, Rect, Stroke};
use glam::DVec3;
use luch_render::session::live::Snapshot;
use luch_scene::Camera;

/// Things that are drawn, at most: those first in the scene.
const MOST: usize = 300;
/// Lines that a circle is drawn in.
const PIECES: u32 = 48;
const COLOR: Color32 = Color32::from_rgb(255, 255, 255);
/// The picture below is old: it steps back.
const VEIL: Color32 = Color32::from_black_alpha(110);

/// Draws the room of what is not where the picture shows it: of everything if the camera has moved, else of the selection.
pub(super) fn draw(painter: &Painter, picture: Rect, snapshot: &Snapshot, desk: &Desk<'_>) {
    let Some(camera) = desk.state.camera().filter(|_| desk.state.pending) else { return };
    let frame = PictureFrame::new(picture, &camera, snapshot.job.size);
    let painter = painter.with_clip_rect(painter.clip_rect().intersect(picture));
    let selected = desk.state.selection;
    if has_moved(&camera, &snapshot.job.camera) {
        painter.rect_filled(picture, 0.0, VEIL);
        let scene = desk.scene();
        let shown = scene.objects.iter().enumerate().filter(|(_, object)| !object.hidden).take(MOST);
        for (index, _) in shown.filter(|(index, _)| selected != Some(Part::Object(*index))) {
            outline(&painter, &frame, Part::Object(index), desk, COLOR.gamma_multiply(0.6));
        }
        selected.into_iter().for_each(|part| outline(&painter, &frame, part, desk, super::outline::COLOR));
    } else if let Some(part) = selected.filter(|part| differs(*part, snapshot, desk)) {
        outline(&painter, &frame, part, desk, super::outline::COLOR);
    }
}

fn has_moved(camera: &Camera, before: &Camera) -> bool {
    (camera.position, camera.aim, camera.fov) != (before.position, before.aim, before.fov)
}

/// Whether an object has another shape or place than in the picture.
fn differs(part: Part, snapshot: &Snapshot, desk: &Desk<'_>) -> bool {
    let Part::Object(index) = part else { return false };
    let before = same_object(desk.scene(), index, &snapshot.scene).and_then(|index| snapshot.scene.objects.get(index));
    let now = desk.scene().objects.get(index);
    now.map(|object| &object.shape) != before.map(|object| &object.shape)
}

/// Draws the room of a thing; an endless wall has none.
fn outline(painter: &Painter, frame: &PictureFrame, part: Part, desk: &Desk<'_>, color: Color32) {
    let Some(extent) = Extent::of(part, desk.scene()).filter(|_| matches!(part, Part::Object(_))) else { return };
    for [a, b] in lines(&extent, frame) {
        if let Some(line) = seen(frame, a, b) {
            painter.line_segment(line, Stroke::new(1.5, color));
        }
    }
}

/// The edges of a box, or the outline of a ball.
fn lines(extent: &Extent, frame: &PictureFrame) -> Vec<[DVec3; 2]> {
    if let Some(radius) = extent.radius() {
        // The eye sees a circle that is nearer and smaller than the greatest.
        let way = frame.eye - extent.center;
        let away = way.length();
        if away <= radius {
            return Vec::new();
        }
        let center = extent.center + way * (radius / away).powi(2);
        let u = way.any_orthonormal_vector() * radius * (1.0 - (radius / away).powi(2)).sqrt();
        let v = (way / away).cross(u);
        let place = |piece: u32| {
            let (sin, cos) = (std::f64::consts::TAU * f64::from(piece) / f64::from(PIECES)).sin_cos();
            center + u * cos + v * sin
        };
        return (0..PIECES).map(|piece| [place(piece), place(piece + 1)]).collect();
    }
    let corners = extent.corners();
    // Two corners whose numbers differ in one bit share an edge.
    let edges = (0..8_usize).flat_map(|corner| [1, 2, 4].map(|bit| (corner, corner | bit)));
    edges.filter(|(a, b)| a != b).map(|(a, b)| [corners[a], corners[b]]).collect()
}

/// The part of a line that lies before the eye, in the window.
fn seen(frame: &PictureFrame, a: DVec3, b: DVec3) -> Option<[Pos2; 2]> {
    let (near, far) = (frame.depth_of(a), frame.depth_of(b));
    let farther = near.max(far);
    if farther.is_nan() || farther <= 0.0 {
        return None;
    }
    let least = farther * 1e-3;
    let cut = |from: DVec3, depth: f64, to: DVec3, other: f64| {
        if depth < least { from + (to - from) * ((least - depth) / (other - depth)) } else { from }
    };
    Some([frame.project(cut(a, near, b, far))?, frame.project(cut(b, far, a, near))?])
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::vec2;
    use glam::Vec3;
    use luch_scene::{Aim, Direction, ImageSize, Object, Point, Rotation, Scene, Shape, Size};

    fn frame(from: Vec3) -> PictureFrame {
        let along = Aim::Along(Direction::new(Vec3::NEG_Z).unwrap());
        let camera = Camera::new("c", Point::new(from).unwrap(), along);
        let rect = Rect::from_min_size(Pos2::ZERO, vec2(400.0, 300.0));
        PictureFrame::new(rect, &camera, ImageSize::new(400, 300).unwrap())
    }

    fn extent(shape: Shape) -> Extent {
        let mut scene = Scene::new("s");
        scene.objects.push(Object::new("o", shape));
        Extent::of(Part::Object(0), &scene).unwrap()
    }

    #[test]
    fn a_box_has_twelve_edges_and_a_ball_the_outline_that_is_seen() {
        let size = [Size::ONE; 3];
        let cube = extent(Shape::Cuboid { center: Point::ORIGIN, size, rotation: Rotation::NONE });
        let frame = frame(Vec3::Z * 5.0);
        let edges = lines(&cube, &frame);
        assert_eq!(edges.len(), 12);
        assert!(edges.iter().all(|[a, b]| ((*a - *b).length() - 1.0).abs() < 1e-9));
        let ball = extent(Shape::Sphere { center: Point::ORIGIN, radius: Size::ONE });
        // A ray that grazes the ball is square to the way from its middle.
        for [a, _] in lines(&ball, &frame) {
            assert!((a.length() - 1.0).abs() < 1e-9 && a.dot(a - frame.eye).abs() < 1e-9);
        }
    }

    #[test]
    fn lines_end_before_the_eye() {
        let frame = frame(Vec3::ZERO);
        assert!(seen(&frame, DVec3::Z, DVec3::Z * 2.0).is_none());
        assert!(seen(&frame, DVec3::new(1.0, 0.0, 5.0), DVec3::new(1.0, 0.0, -5.0)).is_some());
        assert!(seen(&frame, DVec3::NAN, DVec3::NAN).is_none());
    }
}
