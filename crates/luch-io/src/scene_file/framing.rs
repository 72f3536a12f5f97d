//! Cameras for a scene that has none.

use glam::Vec3;
use luch_scene::{Aim, Camera, FieldOfView, Point};

/// Three cameras that see a box whole: from the front and above, from the side, and from high above.
///
/// `bounds` are the lower and upper corner of what is to be seen; without any, a box around the origin.
#[must_use]
#[allow(clippy::arithmetic_side_effects, reason = "vectors of floats neither overflow nor panic")]
pub fn three_cameras(bounds: Option<[Vec3; 2]>) -> [Camera; 3] {
    let [lo, hi] = bounds.unwrap_or([Vec3::new(-1.0, 0.0, -1.0), Vec3::new(1.0, 2.0, 1.0)]);
    // Halved first: the sum of two far corners may not be finite.
    let target = lo * 0.5 + hi * 0.5;
    let radius = (hi * 0.5 - lo * 0.5).length().max(1e-6);
    // The sphere around the box touches the edges of the picture at radius / sin(fov / 2); a little air beside it.
    let half = f64::from(FieldOfView::DEFAULT.get()).to_radians() * 0.5;
    #[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
    let distance = radius * (1.1 / libm::sin(half)) as f32;
    let directions = [Vec3::new(0.25, 0.35, 1.0), Vec3::new(1.0, 0.3, 0.35), Vec3::new(-0.5, 1.0, 0.6)];
    let mut number = 0_u8;
    directions.map(|towards| {
        number = number.saturating_add(1);
        let position = Point::clamped(target + towards.normalize_or(Vec3::Z) * distance);
        Camera::new(format!("Camera {number}"), position, Aim::At(Point::clamped(target)))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_corner_of_the_box_is_in_every_picture() {
        for bounds in [
            None,
            Some([Vec3::splat(-1.0), Vec3::splat(1.0)]),
            Some([Vec3::new(100.0, 0.0, -3e5), Vec3::new(101.0, 4.0, 3e5)]),
            Some([Vec3::splat(2e-7), Vec3::splat(3e-7)]),
            Some([Vec3::ONE, Vec3::ONE]),
        ] {
            let [lo, hi] = bounds.unwrap_or([Vec3::new(-1.0, 0.0, -1.0), Vec3::new(1.0, 2.0, 1.0)]);
            for camera in three_cameras(bounds) {
                let [right, up, forward] = camera.frame();
                for corner in 0..8 {
                    let pick = |bit: u8, axis: usize| if corner & bit == 0 { lo[axis] } else { hi[axis] };
                    let p = Vec3::new(pick(1, 0), pick(2, 1), pick(4, 2)) - camera.position.get();
                    let reach = p.dot(forward) * libm::tanf(camera.fov.radians() * 0.5);
                    assert!(p.dot(right).abs() <= reach && p.dot(up).abs() <= reach, "{bounds:?} {}", camera.name);
                }
            }
        }
    }
}
