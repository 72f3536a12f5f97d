//! Ray against triangle, without leaks.

use crate::math::ray::Ray;
use glam::Vec3;

/// Parameter and barycentric weights of a hit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TriangleHit {
    /// The ray's parameter.
    pub t: f32,
    /// Weight of vertex 1.
    pub u: f32,
    /// Weight of vertex 2. Vertex 0 has the rest.
    pub v: f32,
}

/// What the triangle test needs of a ray, computed once per ray: the frame in which the ray is the z axis.
#[derive(Clone, Copy, Debug)]
pub struct ShearedRay {
    /// The axis along which the direction is longest, and the two others.
    pub kz: usize,
    /// The axis after `kz`.
    pub kx: usize,
    /// The axis after `kx`.
    pub ky: usize,
    /// Shear along x and y, and scale along z, that take the direction to (0, 0, 1).
    pub shear: [f32; 3],
}

impl ShearedRay {
    /// The frame of a direction. A zero direction gives one that hits nothing.
    pub fn new(direction: Vec3) -> Self {
        let size = direction.abs();
        let kz = if size.y > size.x {
            if size.z > size.y { 2 } else { 1 }
        } else if size.z > size.x {
            2
        } else {
            0
        };
        let (kx, ky) = ((kz + 1) % 3, (kz + 2) % 3);
        let scale = 1.0 / direction[kz];
        // Products, not quotients: any shear will do that is the same for all triangles.
        Self { kz, kx, ky, shear: [direction[kx] * scale, direction[ky] * scale, scale] }
    }
}

/// The hit with a triangle, both sides, edges and vertices included. A zero-area or non-finite triangle is never hit.
///
/// The test of Woop, Benthin, Wald, "Watertight Ray/Triangle Intersection" (JCGT 2013), instead of Möller and
/// Trumbore's: the vertices are brought into the frame where the ray is the z axis, by arithmetic that knows nothing of
/// the triangle, so a vertex shared by two triangles lands on the same point for both; there the ray is inside when the
/// signs of three products `a*b - c*d` agree. Such a difference, rounded twice, has the true sign or is 0 because
/// rounding is monotonic, and 0 is accepted on both sides: a ray can slip through no shared edge or vertex. Möller and
/// Trumbore's weights are rounded for each triangle separately, and a mesh shows pinholes where the sky shines through.
/// (The paper recomputes zeros in f64 to give an edge to one side only; here ties go to the smaller index instead.)
pub fn intersect(vertices: [Vec3; 3], ray: &Ray, sheared: &ShearedRay) -> Option<TriangleHit> {
    let [a, b, c] = vertices.map(|vertex| to_ray_frame(vertex, ray.origin, sheared));
    let u = c[0] * b[1] - c[1] * b[0];
    let v = a[0] * c[1] - a[1] * c[0];
    let w = b[0] * a[1] - b[1] * a[0];
    let inside = (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
    let determinant = (u + v) + w;
    if !inside || determinant == 0.0 {
        return None;
    }
    let scale = 1.0 / determinant;
    let t = ((u * a[2] + v * b[2]) + w * c[2]) * scale;
    let hit = ray.t_min < t && t < ray.t_max;
    hit.then_some(TriangleHit { t, u: v * scale, v: w * scale })
}

/// A vertex in the frame where the ray starts at 0 and points along z with length 1.
fn to_ray_frame(vertex: Vec3, origin: Vec3, sheared: &ShearedRay) -> [f32; 3] {
    let p = vertex - origin;
    let [sx, sy, sz] = sheared.shear;
    let z = p[sheared.kz];
    [p[sheared.kx] - sx * z, p[sheared.ky] - sy * z, sz * z]
}
