//! From points of the window to pixels of the picture and back, and from the scene to the window.

use crate::view::slope_of;
use egui::{Pos2, Rect, Vec2, vec2};
use glam::{DVec3, Vec3};
use luch_scene::{Camera, ImageSize};

/// Where the picture lies in the window, and through which camera it was made.
#[derive(Debug, Clone)]
pub(crate) struct PictureFrame {
    pub(crate) rect: Rect,
    size: ImageSize,
    pub(super) eye: DVec3,
    /// Right, up and forward.
    pub(super) axes: [DVec3; 3],
    /// Half the height of the picture at distance 1.
    reach: f64,
}

impl PictureFrame {
    pub(super) fn new(rect: Rect, camera: &Camera, size: ImageSize) -> Self {
        let axes = camera.frame().map(|axis| axis.as_dvec3());
        Self { rect, size, eye: camera.position.get().as_dvec3(), axes, reach: slope_of(camera) }
    }

    /// The pixel at a point of the window.
    pub(super) fn pixel_at(&self, at: Pos2) -> Option<[u32; 2]> {
        let part = (at - self.rect.min) / self.rect.size();
        // Written so that NaN, which fails every comparison, is outside.
        if !((0.0..1.0).contains(&part.x) && (0.0..1.0).contains(&part.y)) {
            return None;
        }
        let pixel = |part: f32, side: u32| ((part * side as f32) as u32).min(side - 1);
        Some([pixel(part.x, self.size.width()), pixel(part.y, self.size.height())])
    }

    /// The point of the window at a place in the picture, in pixels from its upper left corner.
    pub(crate) fn point_of_pixel(&self, x: f32, y: f32) -> Pos2 {
        let size = self.rect.size() / vec2(self.size.width() as f32, self.size.height() as f32);
        self.rect.min + vec2(x, y) * size
    }

    /// How far to the right and up a point of the window is seen, at distance 1.
    pub(super) fn slope_at(&self, at: Pos2) -> [f64; 2] {
        self.slope_of_points(at - self.rect.center())
    }

    /// The same for a way in the window.
    pub(super) fn slope_of_points(&self, way: Vec2) -> [f64; 2] {
        let scale = 2.0 * self.reach / f64::from(self.rect.height());
        [f64::from(way.x) * scale, -f64::from(way.y) * scale]
    }

    /// The direction, of unit length, in which a point of the window is seen.
    pub(super) fn direction_at(&self, at: Pos2) -> DVec3 {
        let [right, up] = self.slope_at(at);
        // Never zero: it has a part of 1 along the view.
        (self.axes[2] + self.axes[0] * right + self.axes[1] * up).normalize_or_zero()
    }

    /// How far along the view a place lies.
    pub(super) fn depth_of(&self, place: DVec3) -> f64 {
        (place - self.eye).dot(self.axes[2])
    }

    /// The length in the scene of one point of the window, at a distance along the view.
    pub(super) fn length_of_point(&self, depth: f64) -> f64 {
        2.0 * self.reach * depth / f64::from(self.rect.height())
    }

    /// Where a place in the scene is seen; `None` behind the camera.
    pub(super) fn project(&self, place: DVec3) -> Option<Pos2> {
        let [right, up, forward] = self.axes.map(|axis| axis.dot(place - self.eye));
        // Nothing at the eye itself can be seen, and NaN is nowhere.
        if forward.is_nan() || forward <= 1e-9 {
            return None;
        }
        let points = 1.0 / self.length_of_point(forward);
        let at = self.rect.center() + vec2((right * points) as f32, (-up * points) as f32);
        at.is_finite().then_some(at)
    }

    /// The part of a straight line that is seen in the picture; `None` if nothing of it is. Cut before it is projected:
    /// what is behind the camera would come out in front of it, and what is just before the eye at any distance.
    pub(crate) fn project_segment(&self, ends: [Vec3; 2]) -> Option<SeenSegment> {
        let of_camera = |place: Vec3| DVec3::from(self.axes.map(|axis| axis.dot(place.as_dvec3() - self.eye)));
        let [from, to] = ends.map(of_camera);
        let (high, wide) = (self.reach, self.reach * f64::from(self.rect.width() / self.rect.height()));
        let near = 1e-6 * from.length().max(to.length());
        // How far inside each of the five planes around what is seen: near, right, left, above, below.
        let inside = |p: DVec3| [p.z - near, wide * p.z - p.x, wide * p.z + p.x, high * p.z - p.y, high * p.z + p.y];
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for (a, b) in inside(from).into_iter().zip(inside(to)) {
            match (a < 0.0, b < 0.0) {
                (true, true) => return None,
                (true, false) => enters = enters.max(a / (a - b)),
                (false, true) => leaves = leaves.min(a / (a - b)),
                (false, false) => {}
            }
        }
        if enters > leaves {
            return None;
        }
        let at = |t: f64| {
            let p = from + (to - from) * t;
            let points = 1.0 / self.length_of_point(p.z.max(near * 0.5));
            self.rect.center() + vec2((p.x * points) as f32, (-p.y * points) as f32)
        };
        let points = [at(enters), at(leaves)];
        // NaN passes the planes, and ends here.
        let finite = points.iter().all(|point| point.is_finite());
        finite.then_some(SeenSegment { points, cut: [enters > 0.0, leaves < 1.0] })
    }
}

/// The part of a line that is seen.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SeenSegment {
    /// Its ends in the window.
    pub(crate) points: [Pos2; 2],
    /// Whether the line goes on beyond each end, unseen.
    pub(crate) cut: [bool; 2],
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use luch_scene::{Aim, Point};

    fn frame() -> PictureFrame {
        let camera = Camera::new("c", Point::clamped(Vec3::new(0.0, 0.0, 5.0)), Aim::At(Point::ORIGIN));
        let rect = Rect::from_min_size(Pos2::new(100.0, 50.0), vec2(400.0, 300.0));
        PictureFrame::new(rect, &camera, ImageSize::new(800, 600).unwrap())
    }

    #[test]
    fn pixels_and_points_agree() {
        let frame = frame();
        assert_eq!(frame.pixel_at(Pos2::new(100.0, 50.0)), Some([0, 0]));
        assert_eq!(frame.pixel_at(Pos2::new(499.9, 349.9)), Some([799, 599]));
        assert_eq!(frame.pixel_at(Pos2::new(500.0, 100.0)), None);
        assert_eq!(frame.pixel_at(Pos2::new(99.9, 100.0)), None);
        assert_eq!(frame.pixel_at(Pos2::new(f32::NAN, 100.0)), None);
        assert_eq!(frame.point_of_pixel(400.0, 300.0), Pos2::new(300.0, 200.0));
    }

    #[test]
    fn slopes_are_those_of_the_field_of_view() {
        let frame = frame();
        let [right, up] = frame.slope_at(Pos2::new(500.0, 50.0));
        let tall = 0.414_213_562_373;
        assert!((up - tall).abs() < 1e-6 && (right - tall * 4.0 / 3.0).abs() < 1e-6, "{right} {up}");
        let [right, up] = frame.slope_at(Pos2::new(200.0, 250.0));
        let seen = frame.project(DVec3::new(right * 5.0, up * 5.0, 0.0)).unwrap();
        assert!((seen - Pos2::new(200.0, 250.0)).length() < 1e-3, "{seen:?}");
        let along = frame.direction_at(Pos2::new(200.0, 250.0));
        assert!((along * (5.0 / -along.z) - DVec3::new(right * 5.0, up * 5.0, -5.0)).length() < 1e-9);
        assert!((frame.length_of_point(5.0) - 5.0 * tall / 150.0).abs() < 1e-9);
    }

    #[test]
    fn what_is_looked_at_is_in_the_middle_and_what_is_behind_is_nowhere() {
        let frame = frame();
        assert_eq!(frame.project(DVec3::ZERO), Some(Pos2::new(300.0, 200.0)));
        let above = frame.project(DVec3::new(0.0, 5.0 * 0.414_213_56, 0.0)).unwrap();
        assert!((above - Pos2::new(300.0, 50.0)).length() < 1e-3, "{above:?}");
        assert!(frame.project(DVec3::X).unwrap().x > 300.0);
        assert_eq!(frame.project(DVec3::new(0.0, 0.0, 6.0)), None);
    }

    #[test]
    fn lines_are_cut_at_the_edge_of_what_is_seen() {
        let frame = frame();
        let seen = |from: Vec3, to: Vec3| frame.project_segment([from, to]);
        let whole = seen(Vec3::ZERO, Vec3::new(0.5, 0.0, 0.0)).unwrap();
        assert_eq!((whole.points[0], whole.cut), (Pos2::new(300.0, 200.0), [false, false]));
        // From before the camera to behind it: out at the right edge, not back in from the left.
        let behind = seen(Vec3::ZERO, Vec3::new(1.0, 0.0, 20.0)).unwrap();
        assert_eq!(behind.cut, [false, true]);
        assert!((behind.points[1] - Pos2::new(500.0, 200.0)).length() < 1e-2, "{behind:?}");
        // Across the picture from left to right.
        let across = seen(Vec3::new(-100.0, 0.0, 0.0), Vec3::new(100.0, 0.0, 0.0)).unwrap();
        assert_eq!(across.cut, [true, true]);
        assert!((across.points[0].x - 100.0).abs() < 1e-2 && (across.points[1].x - 500.0).abs() < 1e-2);
        // From the eye itself: a point.
        let ray = seen(Vec3::new(0.0, 0.0, 5.0), Vec3::new(0.5, 0.0, 0.0)).unwrap();
        assert!(ray.points[0].distance(ray.points[1]) < 1e-2, "{ray:?}");
        assert_eq!(seen(Vec3::new(0.0, 0.0, 6.0), Vec3::new(1.0, 1.0, 9.0)), None);
        assert_eq!(seen(Vec3::new(-100.0, 90.0, 0.0), Vec3::new(100.0, 90.0, 0.0)), None);
        assert_eq!(seen(Vec3::NAN, Vec3::ZERO), None);
    }
}
