//! From points of the window to pixels of the picture and back, and from the scene to the window.

use egui::{Pos2, Rect, vec2};
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
        let reach = (f64::from(camera.fov.get()).to_radians() * 0.5).tan() as f32;
        Self { rect, size, eye: camera.position.get(), axes: camera.frame(), reach }
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
    fn what_is_looked_at_is_in_the_middle_and_what_is_behind_is_nowhere() {
        let frame = frame();
        assert_eq!(frame.project(Vec3::ZERO), Some(Pos2::new(300.0, 200.0)));
        let above = frame.project(Vec3::new(0.0, 5.0 * 0.414_213_56, 0.0)).unwrap();
        assert!((above - Pos2::new(300.0, 50.0)).length() < 1e-3, "{above:?}");
        assert!(frame.project(Vec3::X).unwrap().x > 300.0);
        assert_eq!(frame.project(Vec3::new(0.0, 0.0, 6.0)), None);
    }
}
