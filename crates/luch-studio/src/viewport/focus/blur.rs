//! How blurred a thin lens shows what lies out of focus.

use crate::view::slope_of;
use luch_scene::{Camera, ImageSize};

/// The lens of a picture: gives the circle of confusion at a distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Blur {
    pub(super) focus: f64,
    /// Pixels for a disk of radius 1 on the lens that is seen at distance 1.
    strength: f64,
}

impl Blur {
    pub(super) fn of(camera: &Camera, size: ImageSize) -> Self {
        let radius = f64::from(camera.lens_radius.get());
        Self { focus: f64::from(camera.focus()), strength: 2.0 * radius * pixels_at_one(camera, size) }
    }

    /// A closed lens opened so far that what is up to 2 % nearer or farther than the focus stays sharp: enough to show
    /// where the focus lies.
    pub(super) fn opened(self) -> Self {
        if self.strength > 0.0 { self } else { Self { strength: SHARP * self.focus * 50.0, ..self } }
    }

    pub(super) fn is_closed(&self) -> bool {
        self.strength == 0.0
    }

    /// The diameter of the disk, in pixels of the picture, that a point at a distance along the view is spread over.
    ///
    /// The cone of rays from the lens through the point meets the plane of focus in a disk of radius r |z - f| / z, which
    /// is seen from f away. Farther than everything, that is r / f.
    pub(super) fn diameter(&self, depth: f64) -> f64 {
        let apart = (1.0 / self.focus - 1.0 / depth).abs();
        // Nothing lies at the eye or behind it.
        if depth > 0.0 { self.strength * apart } else { 0.0 }
    }
}

/// The largest circle of confusion that counts as sharp, in pixels: what a pixel shows as a point.
pub(super) const SHARP: f64 = 1.0;

/// How many pixels something of size 1 at distance 1 takes.
fn pixels_at_one(camera: &Camera, size: ImageSize) -> f64 {
    f64::from(size.height()) / (2.0 * slope_of(camera))
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::Vec3;
    use luch_scene::{Aim, FieldOfView, NonNegative, Point, Positive};

    fn camera() -> Camera {
        let mut camera = Camera::new("c", Point::clamped(Vec3::new(0.0, 0.0, 5.0)), Aim::At(Point::ORIGIN));
        camera.fov = FieldOfView::new(90.0).unwrap();
        camera.lens_radius = NonNegative::new(0.1).unwrap();
        camera.focal_distance = Some(Positive::new(4.0).unwrap());
        camera
    }

    fn size() -> ImageSize {
        ImageSize::new(960, 720).unwrap()
    }

    #[test]
    fn the_circle_is_that_of_the_cone_through_the_point() {
        let blur = Blur::of(&camera(), size());
        // At 90 degrees 360 pixels span a length of 1 at distance 1.
        for depth in [0.5, 1.0, 3.0, 4.0, 4.1, 8.0, 100.0_f64] {
            let radius_at_focus = f64::from(0.1_f32) * (depth - 4.0).abs() / depth;
            let expected = 2.0 * radius_at_focus / 4.0 * 360.0;
            assert!((blur.diameter(depth) - expected).abs() < 1e-6, "{depth}");
        }
        assert!((blur.diameter(f64::INFINITY) - 2.0 * 0.1 / 4.0 * 360.0).abs() < 1e-4);
        assert_eq!(blur.diameter(4.0), 0.0);
        assert_eq!(blur.diameter(0.0), 0.0);
        assert_eq!(blur.diameter(-1.0), 0.0);
    }

    #[test]
    fn a_closed_lens_blurs_nothing_until_it_is_opened_to_look() {
        let closed = Blur::of(&Camera { lens_radius: NonNegative::ZERO, ..camera() }, size());
        assert!(closed.is_closed() && closed.diameter(100.0) == 0.0);
        let opened = closed.opened();
        assert!(opened.diameter(4.0 * 1.01) < SHARP && opened.diameter(4.0 * 1.03) > SHARP);
        let open = Blur::of(&camera(), size());
        assert_eq!(open.opened(), open);
    }
}
