//! Which part of the ground is seen, and how large.

use egui::{Context, Id, Pos2, Rect, Vec2};

/// Free space around what fits, as a part of the area.
const MARGIN: f32 = 0.08;
/// The smallest and largest enlargement of what fits.
const ZOOM: [f32; 2] = [0.05, 2000.0];

/// A part of the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Map {
    /// What fitted at first.
    all: Rect,
    /// How much larger than that it is now.
    zoom: f32,
    /// How far it was moved, in points.
    moved: Vec2,
}

impl Map {
    fn id() -> Id {
        Id::unique("map from above")
    }

    pub(super) fn load(ctx: &Context) -> Option<Self> {
        ctx.data(|d| d.get_temp(Self::id()))
    }

    pub(super) fn store(self, ctx: &Context) {
        ctx.data_mut(|d| d.insert_temp(Self::id(), self));
    }

    /// Forgets it, so that all is seen next time.
    pub(super) fn forget(ctx: &Context) {
        ctx.data_mut(|d| d.remove::<Self>(Self::id()));
    }

    pub(super) fn around(all: Rect) -> Self {
        let all = if all.is_finite() && all.is_positive() {
            all
        } else {
            Rect::from_center_size(Pos2::ZERO, Vec2::splat(2.0))
        };
        Self { all, zoom: 1.0, moved: Vec2::ZERO }
    }

    /// Points for a unit of the scene.
    pub(super) fn scale(&self, area: Rect) -> f32 {
        let room = area.size() * (1.0 - 2.0 * MARGIN);
        // Never none, so that what is divided by it stays finite.
        (room / self.all.size()).min_elem().max(1e-12) * self.zoom
    }

    pub(super) fn to_screen(self, area: Rect, place: Pos2) -> Pos2 {
        area.center() + self.moved + (place - self.all.center()) * self.scale(area)
    }

    pub(super) fn pan(&mut self, by: Vec2) {
        self.moved += by;
    }

    /// Enlarges about a point of the window.
    pub(super) fn zoom(&mut self, area: Rect, about: Pos2, by: f32) {
        let new = (self.zoom * by).clamp(ZOOM[0], ZOOM[1]);
        let from = about - area.center();
        self.moved = from - (from - self.moved) * (new / self.zoom);
        self.zoom = new;
    }

    /// A round length that is about a fifth of the area wide, and its points.
    pub(super) fn bar(&self, area: Rect) -> (f32, f32) {
        let scale = self.scale(area);
        let wish = area.width() * 0.2 / scale;
        let ten = 10.0_f32.powi(wish.log10().floor() as i32);
        let length = [5.0, 2.0, 1.0].into_iter().map(|step| step * ten).find(|length| *length <= wish).unwrap_or(ten);
        (length, length * scale)
    }
}

/// The part of a line that lies in an area (Liang and Barsky, "A new concept and method for line clipping", 1984).
pub(super) fn cut([from, to]: [Pos2; 2], area: Rect) -> Option<[Pos2; 2]> {
    if !(from.is_finite() && to.is_finite()) {
        return None;
    }
    let way = to - from;
    let (mut enters, mut leaves) = (0.0_f32, 1.0_f32);
    let sides = [
        (-way.x, from.x - area.left()),
        (way.x, area.right() - from.x),
        (-way.y, from.y - area.top()),
        (way.y, area.bottom() - from.y),
    ];
    for (towards, room) in sides {
        if towards == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if towards < 0.0 {
            enters = enters.max(room / towards);
        } else {
            leaves = leaves.min(room / towards);
        }
    }
    let at = |t: f32| {
        if t <= 0.0 {
            from
        } else if t >= 1.0 {
            to
        } else {
            from + way * t
        }
    };
    (enters <= leaves).then(|| [at(enters), at(leaves)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{pos2, vec2};

    fn area() -> Rect {
        Rect::from_min_size(pos2(10.0, 20.0), vec2(200.0, 100.0))
    }

    #[test]
    fn all_fits_at_first_and_zooming_leaves_what_is_under_the_pointer() {
        let all = Rect::from_min_max(pos2(-4.0, -4.0), pos2(4.0, 8.0));
        let mut map = Map::around(all);
        for corner in [all.min, all.max] {
            assert!(area().contains(map.to_screen(area(), corner)));
        }
        let at = map.to_screen(area(), pos2(1.0, 2.0));
        map.zoom(area(), at, 3.0);
        assert!((map.to_screen(area(), pos2(1.0, 2.0)) - at).length() < 1e-3);
        for nothing in [Rect::NOTHING, Rect::from_min_size(Pos2::ZERO, Vec2::ZERO), Rect::EVERYTHING] {
            assert!(Map::around(nothing).to_screen(area(), pos2(1e6, -1e6)).is_finite());
        }
    }

    #[test]
    fn lines_end_where_the_area_does() {
        let cut = |a: [f32; 2], b: [f32; 2]| cut([a.into(), b.into()], area());
        let [a, b] = cut([0.0, 70.0], [300.0, 70.0]).unwrap();
        assert!(a.distance(pos2(10.0, 70.0)) < 1e-3 && b.distance(pos2(210.0, 70.0)) < 1e-3, "{a:?} {b:?}");
        assert_eq!(cut([20.0, 30.0], [30.0, 40.0]), Some([pos2(20.0, 30.0), pos2(30.0, 40.0)]));
        assert_eq!(cut([0.0, 0.0], [300.0, 10.0]), None);
        assert_eq!(cut([0.0, 0.0], [0.0, 300.0]), None);
        assert_eq!(cut([f32::NAN, 0.0], [30.0, 40.0]), None);
    }

    #[test]
    fn the_bar_has_a_round_length_at_any_scale() {
        for size in [1e-3_f32, 0.7, 12.0, 3e6] {
            let map = Map::around(Rect::from_center_size(Pos2::ZERO, Vec2::splat(size)));
            let (length, points) = map.bar(area());
            assert!(points > 10.0 && points < area().width() * 0.21, "{size}: {points}");
            let digit = length / 10.0_f32.powi((length * 1.001).log10().floor() as i32);
            assert!([1.0, 2.0, 5.0].iter().any(|d: &f32| (d - digit).abs() < 1e-3), "{length}");
        }
    }
}
