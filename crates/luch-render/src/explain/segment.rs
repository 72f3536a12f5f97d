//! Rays as lines, for whoever draws them.

use super::account::{PixelAccount, RayEnd, RayKind};
use glam::Vec3;

/// The part of a ray that counts, in world space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Segment {
    /// The ray, its place in [`PixelAccount::rays`].
    pub ray: u32,
    /// Why there is the ray.
    pub kind: RayKind,
    /// Surfaces on the way from the lens to its start.
    pub depth: u32,
    /// Where it starts.
    pub start: Vec3,
    /// Where it ends: at a surface, at a light, at what blocks it, or far outside the scene.
    pub end: Vec3,
    /// Whether it goes on for ever, and `end` is just a place to stop drawing.
    pub open: bool,
    /// Whether it is a shadow ray that something blocks.
    pub blocked: bool,
}

impl PixelAccount {
    /// The line of each ray, in the order of the rays.
    pub fn segments(&self) -> impl DoubleEndedIterator<Item = Segment> + ExactSizeIterator + '_ {
        #[allow(clippy::cast_possible_truncation, reason = "an account's limit is far below 2^32")]
        (0..self.rays.len()).map(|ray| self.segment(ray as u32))
    }

    /// The line of one ray.
    #[must_use]
    pub fn segment(&self, ray: u32) -> Segment {
        let account = &self.rays[ray as usize];
        let (start, direction) = (account.origin, account.direction);
        let end = match account.end {
            RayEnd::Surface(surface) => self.surfaces[surface as usize].position,
            RayEnd::Light(_) => start + direction * account.reach,
            RayEnd::Blocked { blocker, .. } => start + direction * blocker.t,
            RayEnd::Nothing | RayEnd::DepthUsedUp => start + direction * self.far_from(start),
        };
        Segment {
            ray,
            kind: account.kind,
            depth: account.depth,
            start,
            end,
            open: matches!(account.end, RayEnd::Nothing | RayEnd::DepthUsedUp),
            blocked: matches!(account.end, RayEnd::Blocked { .. }),
        }
    }

    /// A length that leads from a place to beyond all bounded objects.
    fn far_from(&self, place: Vec3) -> f32 {
        let bounds = &self.setting.bounds;
        let far = if bounds.is_finite() {
            bounds.size().length() + (bounds.center() - place).length()
        } else {
            self.setting.attenuation
        };
        if far > 0.0 && far.is_finite() { far } else { 1.0 }
    }
}
