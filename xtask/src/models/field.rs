//! Solid shapes as scalar fields.

use glam::DVec3;

/// Half step of the numerical gradient, millimetres.
const STEP: f64 = 2e-3;

/// A solid: negative inside, positive outside, close to the distance in millimetres near the surface.
pub trait Field {
    /// The value at `p`.
    fn at(&self, p: DVec3) -> f64;

    /// The gradient at `p`, from four samples at the corners of a tetrahedron.
    fn gradient(&self, p: DVec3) -> DVec3 {
        let corners =
            [DVec3::new(1.0, -1.0, -1.0), DVec3::new(-1.0, -1.0, 1.0), DVec3::new(-1.0, 1.0, -1.0), DVec3::ONE];
        corners.iter().map(|&c| c * self.at(p + c * STEP)).sum::<DVec3>() / (4.0 * STEP)
    }

    /// The point of the surface near `p`, by Newton's method along the gradient; moves at most `reach`.
    fn project(&self, p: DVec3, reach: f64) -> DVec3 {
        let mut q = p;
        for _ in 0..2 {
            let g = self.gradient(q);
            q -= g * (self.at(q) / g.length_squared().max(1e-6));
        }
        if q.distance(p) <= reach { q } else { p }
    }
}

impl<F: Fn(DVec3) -> f64> Field for F {
    fn at(&self, p: DVec3) -> f64 {
        self(p)
    }
}
