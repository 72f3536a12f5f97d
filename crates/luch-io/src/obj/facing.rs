//! Which way a facet faces, and how wide its corners are.

/// Unit vector of the product of two edges, and the product's length; `None` if they span no area.
#[inline]
pub(super) fn unit_and_length(u: [f64; 3], v: [f64; 3]) -> Option<([f64; 3], f64)> {
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let square = dot(n, n);
    // Below f64's own rounding the direction would be noise. Written so that NaN has no area, either.
    if square > dot(u, u) * dot(v, v) * 1e-28 {
        let length = square.sqrt();
        let inverse = 1.0 / length;
        return Some((n.map(|c| c * inverse), length));
    }
    None
}

/// The angle of which `sine` (not below zero) and `cosine` are multiples, to 2e-5: plenty for a weight. Only products and
/// a quotient, so that every machine finds the same bits (Abramowitz and Stegun, 4.4.49).
#[inline]
pub(super) fn angle_of(sine: f64, cosine: f64) -> f64 {
    let (least, most) = if sine < cosine.abs() { (sine, cosine.abs()) } else { (cosine.abs(), sine) };
    let x = least / most;
    let q = x * x;
    let arc = x * (0.999_866_0 + q * (-0.330_299_5 + q * (0.180_141_0 + q * (-0.085_133_0 + q * 0.020_835_1))));
    let acute = if sine < cosine.abs() { arc } else { std::f64::consts::FRAC_PI_2 - arc };
    if cosine < 0.0 { std::f64::consts::PI - acute } else { acute }
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

pub(super) fn at<T: Copy + Default>(list: &[T], i: u32) -> T {
    usize::try_from(i).ok().and_then(|i| list.get(i)).copied().unwrap_or_default()
}
