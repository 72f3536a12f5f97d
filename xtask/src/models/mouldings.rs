//! The mouldings that all pieces share, so that they read as one set.

use super::profile::Profile;

/// Radius of the base that the numbers below are drawn for, millimetres.
const DRAWN: f64 = 20.5;

/// Where [`base`] ends: (radius, height) of the foot of the stem, millimetres.
#[must_use]
pub fn base_top(radius: f64) -> (f64, f64) {
    let k = radius / DRAWN;
    (14.6 * k, 12.6 * k)
}

/// From the centre of the bottom face: a rounded plinth, a fillet, a cove and a bead, up to the foot of the stem.
#[must_use]
pub fn base(radius: f64) -> Profile {
    let k = radius / DRAWN;
    let (r, y) = base_top(radius);
    Profile::from(0.0, 0.0)
        .line(19.2 * k, 0.0)
        .arc(19.8 * k, 0.6 * k, 0.41)
        .arc(19.4 * k, 6.0 * k, 0.3)
        .line(18.2 * k, 6.2 * k)
        .line(18.2 * k, 6.9 * k)
        .arc(15.6 * k, 9.4 * k, -0.38)
        .line(15.9 * k, 9.7 * k)
        .arc(15.5 * k, 12.3 * k, 0.62)
        .line(r, y)
}

/// The stem: from its foot (see [`base_top`]) in a long hollow curve to the waist and gently out again to the neck; points
/// are (radius, height).
#[must_use]
pub fn stem(path: Profile, foot: (f64, f64), waist: (f64, f64), neck: (f64, f64)) -> Profile {
    let (lower, upper) = (waist.1 - foot.1, neck.1 - waist.1);
    path.curve((foot.0 - 0.6 * (foot.0 - waist.0), foot.1 + 0.1 * lower), (waist.0, foot.1 + 0.42 * lower), waist)
        .curve((waist.0, waist.1 + 0.45 * upper), (waist.0 + 0.3 * (neck.0 - waist.0), waist.1 + 0.75 * upper), neck)
}

/// A collar: a small bead, a wide thin disc, a small bead, from neck radius `neck` at height `y`; ends at the top bead.
#[must_use]
pub fn collar(path: Profile, neck: f64, y: f64, disc: f64, k: f64) -> Profile {
    path.line(neck + 0.5 * k, y)
        .arc(neck + 0.5 * k, y + 1.5 * k, 0.7)
        .line(neck + 0.9 * k, y + 1.7 * k)
        .curve((neck + 1.6 * k, y + 2.5 * k), (disc - 1.2 * k, y + 2.6 * k), (disc, y + 3.0 * k))
        .arc(disc - 0.1 * k, y + 4.3 * k, 0.75)
        .curve((disc - 1.2 * k, y + 4.6 * k), (neck + 2.0 * k, y + 4.8 * k), (neck + 1.0 * k, y + 5.5 * k))
        .line(neck + 0.9 * k, y + 5.7 * k)
        .arc(neck + 0.7 * k, y + 7.1 * k, 0.7)
        .line(neck, y + 7.3 * k)
}
