//! Ray against box.

use crate::math::ray::Ray;
use glam::{Mat3, Vec3};

/// A box: half its sides, and how it is turned.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// The middle.
    pub center: Vec3,
    /// Half the side lengths along the box's own axes; not negative.
    pub half_size: Vec3,
    /// World from box axes, orthonormal; `None` for faces parallel to the coordinate planes.
    pub rotation: Option<Mat3>,
}

/// The smallest `t` in the ray's open interval at which it meets the surface, and the face: `2 * axis`, plus 1 on the
/// positive side.
///
/// Successive clipping of the ray by the three slabs (Kay, Kajiya, "Ray Tracing Complex Scenes", 1986). A ray parallel
/// to a slab is decided by where it starts, so no 0 * infinity arises; a ray in the plane of a face counts as inside.
pub fn intersect(cuboid: &Cuboid, ray: &Ray) -> Option<(f32, u32)> {
    let (origin, direction) = to_box(cuboid, ray);
    let (mut near, mut far) = (f32::NEG_INFINITY, f32::INFINITY);
    let (mut near_face, mut far_face) = (0, 0);
    for axis in 0..3 {
        let (o, d, half) = (origin[axis], direction[axis], cuboid.half_size[axis]);
        if d == 0.0 {
            if !(-half <= o && o <= half) {
                return None;
            }
            continue;
        }
        let (low, high) = ((-half - o) / d, (half - o) / d);
        let face = 2 * axis as u32;
        let (enter, leave, enter_face) = if d > 0.0 { (low, high, face) } else { (high, low, face + 1) };
        if enter > near {
            (near, near_face) = (enter, enter_face);
        }
        if leave < far {
            (far, far_face) = (leave, enter_face ^ 1);
        }
    }
    let inside = |t: f32| ray.t_min < t && t < ray.t_max;
    if near > far {
        None
    } else if inside(near) {
        Some((near, near_face))
    } else if inside(far) {
        Some((far, far_face))
    } else {
        None
    }
}

/// The ray relative to the box's centre and axes; `t` stays the same parameter.
fn to_box(cuboid: &Cuboid, ray: &Ray) -> (Vec3, Vec3) {
    let origin = ray.origin - cuboid.center;
    match &cuboid.rotation {
        None => (origin, ray.direction),
        Some(rotation) => {
            let turn = |v: Vec3| {
                let along = |axis: Vec3| (axis.x * v.x + axis.y * v.y) + axis.z * v.z;
                Vec3::new(along(rotation.x_axis), along(rotation.y_axis), along(rotation.z_axis))
            };
            (turn(origin), turn(ray.direction))
        }
    }
}
