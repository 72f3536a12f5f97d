//! From a turned frame back to the three angles that a scene file writes.

use glam::{DMat3, DVec3};

/// Where the cosine of the middle angle is smaller, the other two turn about the same line: only their sum has a meaning.
const LOCKED: f64 = 1e-6;
/// Angles are rounded to a ten-thousandth of a degree, so that a turn by 15 degrees is written as 15.
const STEPS_A_DEGREE: f64 = 1e4;

/// The angles in degrees about x, y, z, applied in that order (`Rz * Ry * Rx`, as `luch_scene::Rotation` has them), that
/// give this rotation. Of all that do, the ones nearest to `near`.
pub(super) fn degrees_of(rotation: DMat3, near: DVec3) -> DVec3 {
    let DMat3 { x_axis, y_axis, z_axis } = rotation;
    let cosine = x_axis.x.hypot(x_axis.y);
    let y = (-x_axis.z).atan2(cosine).to_degrees();
    let angles = if cosine > LOCKED {
        let x = y_axis.z.atan2(z_axis.z).to_degrees();
        let z = x_axis.y.atan2(x_axis.x).to_degrees();
        // The same turn the other way around.
        [DVec3::new(x, y, z), DVec3::new(x + 180.0, 180.0 - y, z + 180.0)].map(|angles| nearest(angles, near))
    } else {
        // The angle about z is free: it stays.
        let z = near.z;
        let x = if y > 0.0 {
            z + y_axis.x.atan2(y_axis.y).to_degrees()
        } else {
            (-y_axis.x).atan2(y_axis.y).to_degrees() - z
        };
        [nearest(DVec3::new(x, y, z), near); 2]
    };
    let away = angles.map(|angles| (angles - near).abs().element_sum());
    let best = if away[1] < away[0] { angles[1] } else { angles[0] };
    (best * STEPS_A_DEGREE).round() / STEPS_A_DEGREE
}

/// The same angles up to whole turns, each within half a turn of `near`.
fn nearest(angles: DVec3, near: DVec3) -> DVec3 {
    angles + ((near - angles) / 360.0).round() * 360.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::Rotation;

    fn matrix(degrees: DVec3) -> DMat3 {
        Rotation::new(degrees.as_vec3()).unwrap().matrix().as_dmat3()
    }

    #[test]
    fn angles_come_back_as_they_were() {
        let all = [-170.0, -90.0, -45.0, 0.0, 15.0, 80.0, 90.0, 120.0, 180.0];
        for x in all {
            for y in all {
                for z in all {
                    let degrees = DVec3::new(x, y, z);
                    let back = degrees_of(matrix(degrees), degrees);
                    assert!((back - degrees).abs().max_element() < 2e-3, "{degrees}: {back}");
                }
            }
        }
    }

    #[test]
    fn any_start_gives_the_same_turn() {
        for degrees in [DVec3::new(10.0, 20.0, 30.0), DVec3::new(0.0, 90.0, 25.0), DVec3::new(40.0, -90.0, 0.0)] {
            for near in [DVec3::ZERO, DVec3::new(500.0, -700.0, 33.0), DVec3::new(-1e4, 0.0, 90.0)] {
                let back = degrees_of(matrix(degrees), near);
                let apart = (matrix(back) - matrix(degrees)).abs();
                let most = [apart.x_axis, apart.y_axis, apart.z_axis].map(DVec3::max_element);
                assert!(most.into_iter().all(|entry| entry < 1e-4), "{degrees} {near}: {back}");
                assert!((back - near).abs().max_element() <= 361.0, "{back} is not near {near}");
            }
        }
    }

    #[test]
    fn a_long_turn_about_one_axis_stays_one_about_it() {
        for axis in 0..3 {
            let mut last = DVec3::ZERO;
            for step in 1..=100 {
                let mut degrees = DVec3::ZERO;
                degrees[axis] = f64::from(step) * 7.5;
                last = degrees_of(matrix(degrees), last);
                assert!((last - degrees).abs().max_element() < 2e-3, "{degrees}: {last}");
            }
        }
    }
}
