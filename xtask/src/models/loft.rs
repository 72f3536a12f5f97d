//! A limb: a solid swept along a plane curve with elliptic sections, mirrored in that plane.

use glam::{DVec2, DVec3};

/// A section of a limb.
#[derive(Clone, Copy, Debug)]
pub struct Section {
    /// Where the spine passes: forward and up, millimetres.
    pub at: DVec2,
    /// Half the section's extent in the plane, across the spine.
    pub depth: f64,
    /// Half the section's extent across the plane.
    pub width: f64,
    /// How much wider (relative) the section is on the left of the spine than in its middle, narrower on the right.
    pub lean: f64,
}

/// A section from plain numbers: forward, up, depth, width, lean.
#[must_use]
pub fn section(forward: f64, up: f64, depth: f64, width: f64, lean: f64) -> Section {
    Section { at: DVec2::new(forward, up), depth, width, lean }
}

/// One channel of the spline: values and second derivatives at the sections.
#[derive(Clone, Debug)]
struct Channel {
    y: Vec<f64>,
    m: Vec<f64>,
}

impl Channel {
    /// The natural cubic spline through `y` at 0, 1, 2, ... (the tridiagonal system solved by Thomas' algorithm).
    fn new(y: Vec<f64>) -> Self {
        let n = y.len();
        let mut m = vec![0.0; n];
        let mut c = vec![0.0; n];
        for i in 1..n - 1 {
            let rhs = 6.0 * (y[i - 1] - 2.0 * y[i] + y[i + 1]);
            let w = 1.0 / (4.0 - c[i - 1]);
            c[i] = w;
            m[i] = (rhs - m[i - 1]) * w;
        }
        for i in (1..n - 1).rev() {
            m[i] -= c[i] * m[i + 1];
        }
        Self { y, m }
    }

    /// Value, first and second derivative at t.
    fn eval(&self, t: f64) -> [f64; 3] {
        let i = (t as usize).min(self.y.len() - 2);
        let (u, v) = (t - i as f64, 1.0 - (t - i as f64));
        let (y0, y1, m0, m1) = (self.y[i], self.y[i + 1], self.m[i], self.m[i + 1]);
        [
            v * y0 + u * y1 + ((v * v * v - v) * m0 + (u * u * u - u) * m1) / 6.0,
            y1 - y0 + ((1.0 - 3.0 * v * v) * m0 + (3.0 * u * u - 1.0) * m1) / 6.0,
            v * m0 + u * m1,
        ]
    }
}

/// A limb through its sections.
#[derive(Clone, Debug)]
pub struct Loft {
    channels: [Channel; 5],
    seeds: Vec<DVec2>,
}

/// Seeds per section for the search of the nearest spine point.
const SEEDS: usize = 6;

/// The nearest spine point to a point of the plane.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// Parameter along the spine: 0 at the first section, 1 at the second, ...
    pub t: f64,
    /// Offset from the spine.
    pub offset: DVec2,
    /// Signed distance across the spine, positive on its left.
    pub across: f64,
}

impl Loft {
    /// Makes a limb. Its sections are superellipses of power 2.5, a little fuller than ellipses.
    #[must_use]
    pub fn new(sections: &[Section]) -> Self {
        let channel = |f: fn(&Section) -> f64| Channel::new(sections.iter().map(f).collect());
        let channels =
            [channel(|s| s.at.x), channel(|s| s.at.y), channel(|s| s.depth), channel(|s| s.width), channel(|s| s.lean)];
        let count = (sections.len() - 1) * SEEDS;
        let seeds = (0..=count)
            .map(|i| {
                let t = i as f64 / SEEDS as f64;
                DVec2::new(channels[0].eval(t)[0], channels[1].eval(t)[0])
            })
            .collect();
        Self { channels, seeds }
    }

    /// The spine at t: the point and the tangent.
    #[must_use]
    pub fn spine(&self, t: f64) -> (DVec2, DVec2) {
        let (x, y) = (self.channels[0].eval(t), self.channels[1].eval(t));
        (DVec2::new(x[0], y[0]), DVec2::new(x[1], y[1]))
    }

    /// Depth, width and lean at t.
    #[must_use]
    pub fn extent(&self, t: f64) -> [f64; 3] {
        [2, 3, 4].map(|i| self.channels[i].eval(t)[0])
    }

    /// Finds the nearest spine point.
    #[must_use]
    pub fn nearest(&self, p: DVec2) -> Nearest {
        let mut best = (0, f64::INFINITY);
        for (i, seed) in self.seeds.iter().enumerate() {
            let d = seed.distance_squared(p);
            if d < best.1 {
                best = (i, d);
            }
        }
        let end = (self.channels[0].y.len() - 1) as f64;
        let mut t = best.0 as f64 / SEEDS as f64;
        for _ in 0..3 {
            let (x, y) = (self.channels[0].eval(t), self.channels[1].eval(t));
            let (q, d1, d2) = (DVec2::new(x[0], y[0]) - p, DVec2::new(x[1], y[1]), DVec2::new(x[2], y[2]));
            let slope = d1.dot(d1) + q.dot(d2);
            let step = q.dot(d1) / if slope > 0.1 * d1.dot(d1) { slope } else { d1.dot(d1) };
            t = (t - step.clamp(-0.2, 0.2)).clamp(0.0, end);
        }
        let (point, tangent) = self.spine(t);
        let offset = p - point;
        Nearest { t, offset, across: tangent.normalize_or_zero().perp_dot(offset) }
    }

    /// The distance, nearly, from a point (forward, up, aside).
    #[must_use]
    pub fn at(&self, p: DVec3) -> f64 {
        self.at_nearest(&self.nearest(p.truncate()), p.z)
    }

    /// The same with the nearest spine point known.
    #[must_use]
    pub fn at_nearest(&self, nearest: &Nearest, aside: f64) -> f64 {
        let [depth, width, lean] = self.extent(nearest.t);
        let width = width * (1.0 + lean * (nearest.across / depth).clamp(-1.3, 1.3));
        // The section is the unit ball of a norm; its value less one over its slope is nearly the distance.
        let (u, v) = (nearest.offset.length() / depth, aside.abs() / width);
        let (un, vn) = (u * libm::sqrt(u), v * libm::sqrt(v));
        let f = libm::pow(un * u + vn * v, 0.4).max(1e-6);
        let scale = 1.0 / (f * libm::sqrt(f));
        let slope = libm::hypot(un * scale / depth, vn * scale / width);
        (f - 1.0) / slope.max(1e-3)
    }
}
