//! From points of the window to pixels of the picture and back, and from the scene to the window.

use crate::view::slope_of;
use egui::{Pos2, Rect, Vec2, vec2};
use glam::Vec3;
use luch_scene::{Camera, ImageSize};

/// Where the picture lies in the window, and through which camera it was made.
#[derive(Debug, Clone)]
pub(super) struct PictureFrame {
    pub(super) rect: Rect,
    size: ImageSize,
    eye: Vec3,
    /// Right, up and forward.
    axes: [Vec3; 3],
    /// Half the height of the picture at distance 1.
    reach: f32,
}

impl PictureFrame {
    pub(super) fn new(rect: Rect, camera: &Camera, size: ImageSize) -> Self {
        Self { rect, size, eye: camera.position.get(), axes: camera.frame(), reach: slope_of(camera) as f32 }
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
    pub(super) fn point_of_pixel(&self, x: f32, y: f32) -> Pos2 {
        let size = self.rect.size() / vec2(self.size.width() as f32, self.size.height() as f32);
        self.rect.min + vec2(x, y) * size
    }

    /// How far to the right and up a point of the window is seen, at distance 1.
    pub(super) fn slope_at(&self, at: Pos2) -> [f64; 2] {
        self.slope_of_points(at - self.rect.center())
    }

    /// The same for a way in the window.
    pub(super) fn slope_of_points(&self, way: Vec2) -> [f64; 2] {
        let scale = 2.0 * f64::from(self.reach) / f64::from(self.rect.height());
        [f64::from(way.x) * scale, -f64::from(way.y) * scale]
    }

    /// Where a place in the scene is seen; `None` behind the camera.
    pub(super) fn project(&self, place: Vec3) -> Option<Pos2> {
        let [right, up, forward] = self.axes.map(|axis| axis.dot(place - self.eye));
        // Nothing at the eye itself can be seen, and NaN is nowhere.
        if forward.is_nan() || forward <= 1e-6 {
            return None;
        }
        let half = self.rect.height() * 0.5 / self.reach;
        let at = self.rect.center() + vec2(right, -up) * (half / forward);
        at.is_finite().then_some(at)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
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
        let tall = f64::from(0.414_213_56_f32);
        assert!((up - tall).abs() < 1e-6 && (right - tall * 4.0 / 3.0).abs() < 1e-6, "{right} {up}");
        let [right, up] = frame.slope_at(Pos2::new(200.0, 250.0));
        let seen = frame.project(Vec3::new(right as f32 * 5.0, up as f32 * 5.0, 0.0)).unwrap();
        assert!((seen - Pos2::new(200.0, 250.0)).length() < 1e-3, "{seen:?}");
    }

    #[test]
    fn what_is_looked_at_is_in_the_middle_and_what_is_behind_is_nowhere() {
        let frame = frame();
        assert_eq!(frame.project(Vec3::ZERO), Some(Pos2::new(300.0, 200.0)));
        let above = frame.project(Vec3::new(0.0, 5.0 * 0.414_213_56, 0.0)).unwrap();
        assert!((above - Pos2::new(300.0, 50.0)).length() < 1e-3, "{above:?}");
        assert!(frame.project(Vec3::X).unwrap().x > 300.0);
        assert_eq!(frame.project(Vec3::new(0.0, 0.0, 6.0)), None);
    }
}
