//! The outline of a turned piece: a path of lines, arcs and Bezier curves in the half plane (radius, height).
//!
//! A path runs from the bottom upwards with the material on its left, so that the outward normal of the tangent (tr, ty) is
//! (ty, -tr). Where the tangent turns by more than `CREASE_COS` allows the edge is sharp.

use glam::DVec2;

/// Tangents that differ by more than this (15 degrees, as a cosine) make a crease.
const CREASE_COS: f64 = 0.966;
/// The largest distance between the curve and its chords, millimetres.
const SAGITTA: f64 = 0.012;
/// The largest turn between two samples, radians.
const MAX_TURN: f64 = 0.34;

/// A point of the sampled outline with the outward normals of the pieces below and above it (equal where smooth).
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Radius and height, millimetres.
    pub point: DVec2,
    /// Outward unit normal of the part before this point.
    pub normal_before: DVec2,
    /// Outward unit normal of the part after this point.
    pub normal_after: DVec2,
}

/// One piece of the path.
#[derive(Clone, Copy, Debug)]
pub enum Segment {
    /// A straight line.
    Line(DVec2, DVec2),
    /// A cubic Bezier curve.
    Curve([DVec2; 4]),
    /// A circular arc: centre, radius, start angle, signed sweep (radians).
    Arc {
        /// The centre.
        center: DVec2,
        /// The radius.
        radius: f64,
        /// The angle of the start point.
        start: f64,
        /// The signed sweep.
        sweep: f64,
    },
}

impl Segment {
    /// The point at parameter t in [0, 1].
    #[must_use]
    pub fn point(&self, t: f64) -> DVec2 {
        match *self {
            Self::Line(a, b) => a + (b - a) * t,
            Self::Curve([a, b, c, d]) => {
                let s = 1.0 - t;
                a * (s * s * s) + b * (3.0 * s * s * t) + c * (3.0 * s * t * t) + d * (t * t * t)
            }
            Self::Arc { center, radius, start, sweep } => center + polar(start + sweep * t) * radius,
        }
    }

    /// The derivative by t.
    #[must_use]
    pub fn derivative(&self, t: f64) -> DVec2 {
        match *self {
            Self::Line(a, b) => b - a,
            Self::Curve([a, b, c, d]) => {
                let s = 1.0 - t;
                ((b - a) * (s * s) + (c - b) * (2.0 * s * t) + (d - c) * (t * t)) * 3.0
            }
            Self::Arc { radius, start, sweep, .. } => polar(start + sweep * t).perp() * (radius * sweep),
        }
    }

    /// The outward unit normal at t.
    fn normal(&self, t: f64) -> DVec2 {
        -self.derivative(t).perp().normalize()
    }

    /// Parameters of samples that keep the chords within the tolerances; starts with 0 and ends with 1.
    fn parameters(&self) -> Vec<f64> {
        let count = match *self {
            Self::Line(..) => 1,
            Self::Arc { radius, sweep, .. } => {
                let step = 2.0 * libm::acos((1.0 - SAGITTA / radius).max(0.0));
                libm::ceil(sweep.abs() / step.min(MAX_TURN)).max(1.0) as usize
            }
            Self::Curve(_) => return self.curve_parameters(),
        };
        (0..=count).map(|i| i as f64 / count as f64).collect()
    }

    fn curve_parameters(&self) -> Vec<f64> {
        let mut parameters = vec![0.0];
        self.bisect(0.0, 1.0, 0, &mut parameters);
        parameters
    }

    fn bisect(&self, t0: f64, t1: f64, depth: u32, out: &mut Vec<f64>) {
        let (a, b) = (self.point(t0), self.point(t1));
        let chord = b - a;
        // Two inner points: an S-curve may cross its chord in the middle.
        let sag = [0.3, 0.5, 0.7]
            .map(|s| (self.point(t0 + (t1 - t0) * s) - a).perp_dot(chord).abs() / chord.length().max(1e-9));
        let turn = libm::acos(self.normal(t0).dot(self.normal(t1)).clamp(-1.0, 1.0));
        if depth < 2 || (depth < 12 && (sag.iter().any(|s| *s > SAGITTA) || turn > MAX_TURN)) {
            let middle = 0.5 * (t0 + t1);
            self.bisect(t0, middle, depth + 1, out);
            self.bisect(middle, t1, depth + 1, out);
        } else {
            out.push(t1);
        }
    }

    /// A lower bound of the distance from `p`.
    fn distance_bound(&self, p: DVec2) -> f64 {
        let from_box = |low: DVec2, high: DVec2| (p - p.clamp(low, high)).length();
        match *self {
            Self::Line(a, b) => from_box(a.min(b), a.max(b)),
            Self::Arc { center, radius, .. } => (p.distance(center) - radius).abs(),
            Self::Curve([a, b, c, d]) => from_box(a.min(b).min(c).min(d), a.max(b).max(c).max(d)),
        }
    }

    /// The parameter of the point nearest to `p`: exact for lines and arcs, Newton from sampled seeds for curves.
    fn nearest(&self, p: DVec2) -> f64 {
        match *self {
            Self::Line(a, b) => ((p - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0),
            Self::Arc { center, start, sweep, .. } => {
                let d = p - center;
                let middle = start + 0.5 * sweep;
                let m = polar(middle);
                let off = libm::atan2(m.perp_dot(d), m.dot(d));
                (0.5 + off / sweep).clamp(0.0, 1.0)
            }
            Self::Curve(c) => {
                let seeds = 16;
                let mut best = 0.0;
                let mut best_distance = f64::INFINITY;
                for i in 0..=seeds {
                    let t = f64::from(i) / f64::from(seeds);
                    let distance = self.point(t).distance_squared(p);
                    if distance < best_distance {
                        (best, best_distance) = (t, distance);
                    }
                }
                for _ in 0..4 {
                    let (q, d1) = (self.point(best) - p, self.derivative(best));
                    let d2 = ((c[2] - c[1] * 2.0 + c[0]) * (1.0 - best) + (c[3] - c[2] * 2.0 + c[1]) * best) * 6.0;
                    let slope = d1.dot(d1) + q.dot(d2);
                    let step = q.dot(d1) / if slope > 1e-9 { slope } else { d1.dot(d1).max(1e-9) };
                    best = (best - step.clamp(-0.1, 0.1)).clamp(0.0, 1.0);
                }
                best
            }
        }
    }
}

/// A path under construction or finished.
#[derive(Clone, Debug)]
pub struct Profile {
    /// The pieces, end to end.
    pub segments: Vec<Segment>,
    at: DVec2,
}

impl Profile {
    /// Starts a path at (radius, height).
    #[must_use]
    pub fn from(r: f64, y: f64) -> Self {
        Self { segments: Vec::new(), at: DVec2::new(r, y) }
    }

    /// A straight line to (r, y).
    #[must_use]
    pub fn line(mut self, r: f64, y: f64) -> Self {
        let to = DVec2::new(r, y);
        self.segments.push(Segment::Line(self.at, to));
        self.at = to;
        self
    }

    /// An arc to (r, y). `bulge` is its height over half its chord: 1 is a half circle, positive bulges outwards (a bead),
    /// negative inwards (a cove).
    #[must_use]
    pub fn arc(mut self, r: f64, y: f64, bulge: f64) -> Self {
        let to = DVec2::new(r, y);
        let chord = to - self.at;
        let right = -chord.perp().normalize();
        let half = 0.5 * chord.length();
        let radius = half * (1.0 + bulge * bulge) / (2.0 * bulge.abs());
        let offset = half * bulge - radius * bulge.signum();
        let center = (self.at + to) * 0.5 + right * offset;
        let start = self.at - center;
        let sweep = 4.0 * libm::atan(bulge);
        self.segments.push(Segment::Arc { center, radius, start: libm::atan2(start.y, start.x), sweep });
        self.at = to;
        self
    }

    /// A cubic Bezier curve with inner control points `c1`, `c2`, to `to`.
    #[must_use]
    pub fn curve(mut self, c1: (f64, f64), c2: (f64, f64), to: (f64, f64)) -> Self {
        let to = DVec2::from(to);
        self.segments.push(Segment::Curve([self.at, c1.into(), c2.into(), to]));
        self.at = to;
        self
    }

    /// The part of [`Self::curve`] from its start to parameter `t` (de Casteljau's split).
    #[must_use]
    pub fn curve_until(self, t: f64, c1: (f64, f64), c2: (f64, f64), to: (f64, f64)) -> Self {
        let [a, b, c, d] = [self.at, c1.into(), c2.into(), to.into()];
        let (ab, bc, cd) = (a.lerp(b, t), b.lerp(c, t), c.lerp(d, t));
        let (abc, bcd) = (ab.lerp(bc, t), bc.lerp(cd, t));
        self.curve(ab.into(), abc.into(), abc.lerp(bcd, t).into())
    }

    /// An arc of the circle around (0, `y`) through the current point up to its top on the axis: a ball.
    #[must_use]
    pub fn ball(self, y: f64) -> Self {
        let radius = self.at.distance(DVec2::new(0.0, y));
        let sweep = 0.5 * std::f64::consts::PI - libm::atan2(self.at.y - y, self.at.x);
        self.arc(0.0, y + radius, libm::tan(0.25 * sweep))
    }

    /// Samples of the whole path, finer where it bends.
    #[must_use]
    pub fn samples(&self) -> Vec<Sample> {
        let mut samples: Vec<Sample> = Vec::new();
        for segment in &self.segments {
            for t in segment.parameters() {
                let (point, normal) = (segment.point(t), segment.normal(t));
                match samples.last_mut() {
                    Some(last) if t == 0.0 => {
                        let before = last.normal_before;
                        if before.dot(normal) > CREASE_COS {
                            let smooth = (before + normal).normalize();
                            (last.normal_before, last.normal_after) = (smooth, smooth);
                        } else {
                            last.normal_after = normal;
                        }
                    }
                    _ => samples.push(Sample { point, normal_before: normal, normal_after: normal }),
                }
            }
        }
        samples
    }

    /// Signed distance from (radius, height) to the path, negative on the material's side.
    #[must_use]
    pub fn distance(&self, p: DVec2) -> f64 {
        let mut best = f64::INFINITY;
        let mut side = 0.0;
        for (i, segment) in self.segments.iter().enumerate() {
            if segment.distance_bound(p) >= best {
                continue;
            }
            let t = segment.nearest(p);
            let offset = p - segment.point(t);
            let distance = offset.length();
            if distance < best {
                best = distance;
                // At a joint the bisector of the two normals decides.
                let mut normal = segment.normal(t);
                if t >= 1.0 && i + 1 < self.segments.len() {
                    normal += self.segments[i + 1].normal(0.0);
                } else if t <= 0.0 && i > 0 {
                    normal += self.segments[i - 1].normal(1.0);
                }
                side = offset.dot(normal);
            }
        }
        if side < 0.0 { -best } else { best }
    }
}

/// The unit vector at an angle.
fn polar(angle: f64) -> DVec2 {
    let (sin, cos) = libm::sincos(angle);
    DVec2::new(cos, sin)
}
