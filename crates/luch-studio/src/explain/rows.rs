//! The tree of rays as a list of rows, without what is folded away.

use luch_render::explain::PixelAccount;

/// Which rays have a row.
#[derive(Debug, Clone, Default)]
pub(crate) struct Rows {
    /// For each ray whether what it caused is hidden.
    closed: Vec<bool>,
    /// The rays that are seen, in the order of the account.
    shown: Vec<u32>,
}

impl Rows {
    /// The rows of an account: of many samples only the first is open.
    pub(crate) fn of(account: &PixelAccount) -> Self {
        let mut closed = vec![false; account.rays.len()];
        for sample in account.samples.iter().skip(1) {
            closed[sample.ray as usize] = true;
        }
        Self::with(closed, account)
    }

    /// The rows of an account that comes in place of another: folded as they were, if the trees have one form.
    pub(crate) fn anew(self, before: &PixelAccount, account: &PixelAccount) -> Self {
        let alike = before.rays.len() == account.rays.len()
            && before.rays.iter().zip(&account.rays).all(|(a, b)| a.descendants == b.descendants);
        if alike { Self::with(self.closed, account) } else { Self::of(account) }
    }

    fn with(closed: Vec<bool>, account: &PixelAccount) -> Self {
        let mut rows = Self { closed, shown: Vec::new() };
        rows.list(account);
        rows
    }

    #[allow(clippy::cast_possible_truncation, reason = "an account's limit is far below 2^32")]
    fn list(&mut self, account: &PixelAccount) {
        self.shown.clear();
        let mut next = 0;
        while let Some(ray) = account.rays.get(next) {
            self.shown.push(next as u32);
            next += 1 + if self.closed[next] { ray.descendants as usize } else { 0 };
        }
    }

    /// The rays that have a row, from the top.
    pub(crate) fn shown(&self) -> &[u32] {
        &self.shown
    }

    /// The row of a ray, or of the one that hides it.
    pub(crate) fn place_of(&self, ray: u32) -> usize {
        self.shown.partition_point(|&shown| shown <= ray).saturating_sub(1)
    }

    pub(crate) fn is_closed(&self, ray: u32) -> bool {
        self.closed.get(ray as usize).copied().unwrap_or(false)
    }

    pub(crate) fn fold(&mut self, ray: u32, closed: bool, account: &PixelAccount) {
        if let Some(flag) = self.closed.get_mut(ray as usize) {
            *flag = closed;
            self.list(account);
        }
    }

    pub(crate) fn fold_all(&mut self, closed: bool, account: &PixelAccount) {
        self.closed.fill(closed);
        self.list(account);
    }

    /// Opens all that hides a ray.
    pub(crate) fn reveal(&mut self, ray: u32, account: &PixelAccount) {
        let mut parent = account.rays.get(ray as usize).and_then(|ray| ray.parent);
        let mut opened = false;
        while let Some(above) = parent {
            opened |= std::mem::replace(&mut self.closed[above as usize], false);
            parent = account.rays[above as usize].parent;
        }
        if opened {
            self.list(account);
        }
    }
}

/// The way to a ray: the sample, then which child each time.
pub(crate) fn way_to(ray: u32, account: &PixelAccount) -> Vec<u32> {
    let mut way = Vec::new();
    let mut here = ray;
    while let Some(parent) = account.rays.get(here as usize).and_then(|ray| ray.parent) {
        let place = account.children(parent).position(|child| child == here).unwrap_or(0);
        way.push(u32::try_from(place).unwrap_or(u32::MAX));
        here = parent;
    }
    way.push(account.rays.get(here as usize).map_or(0, |ray| ray.sample));
    way.reverse();
    way
}

/// The ray at the end of a way, or as near to it as this account goes.
pub(crate) fn follow(way: &[u32], account: &PixelAccount) -> u32 {
    let mut turns = way.iter();
    let sample = turns.next().and_then(|&sample| account.samples.get(sample as usize)).or(account.samples.first());
    let mut here = sample.map_or(0, |sample| sample.ray);
    for &turn in turns {
        let Some(child) = account.children(here).nth(turn as usize) else { break };
        here = child;
    }
    here
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_render::explain::explain;
    use luch_render::{MeshTrees, RenderJob, compile};
    use luch_scene::{Aim, Camera, Light, Object, Point, RayCount, Sampling, Scene, Shape, Size, Unit};

    /// Two samples of a mirror ball, each a camera ray with a shadow ray and a mirror ray that meets nothing.
    fn account() -> PixelAccount {
        let mut scene = Scene::new("s");
        let mut ball = Object::new("Ball", Shape::Sphere { center: Point::ORIGIN, radius: Size::ONE });
        ball.material.reflection = Unit::new(0.5).unwrap();
        scene.objects.push(ball);
        scene.lights.push(Light::new("Lamp", Point::clamped([0.0, 0.0, 5.0].into())));
        scene.cameras.push(Camera::new("c", Point::clamped([0.0, 0.0, 5.0].into()), Aim::At(Point::ORIGIN)));
        let job = RenderJob {
            antialiasing: Sampling { on: true, rays: RayCount::new(2).unwrap() },
            ..RenderJob::of_scene(&scene, 0)
        };
        let (width, height) = (job.size.width(), job.size.height());
        explain(&compile(&scene, &mut MeshTrees::new(), 1), &job, width / 2, height / 2).unwrap()
    }

    #[test]
    fn of_many_samples_the_first_is_open_and_folding_hides_and_shows() {
        let account = account();
        assert_eq!(account.rays.len(), 6);
        let mut rows = Rows::of(&account);
        assert_eq!(rows.shown(), [0, 1, 2, 3]);
        rows.fold(0, true, &account);
        assert_eq!(rows.shown(), [0, 3]);
        assert_eq!((rows.place_of(0), rows.place_of(2), rows.place_of(3), rows.place_of(5)), (0, 0, 1, 1));
        rows.reveal(5, &account);
        assert_eq!(rows.shown(), [0, 3, 4, 5]);
        rows.fold_all(false, &account);
        assert_eq!(rows.shown(), [0, 1, 2, 3, 4, 5]);
        rows.fold_all(true, &account);
        assert_eq!(rows.shown(), [0, 3]);
    }

    #[test]
    fn folds_are_kept_for_an_account_of_the_same_form() {
        let account = account();
        let mut rows = Rows::of(&account);
        rows.fold(0, true, &account);
        assert_eq!(rows.clone().anew(&account, &account).shown(), [0, 3]);
        let other = PixelAccount {
            rays: account.rays[..3].to_vec(),
            samples: account.samples[..1].to_vec(),
            ..account.clone()
        };
        assert_eq!(rows.anew(&account, &other).shown(), [0, 1, 2]);
    }

    #[test]
    fn a_way_leads_to_its_ray_or_as_near_as_there_are_rays() {
        let account = account();
        for ray in 0..6 {
            assert_eq!(follow(&way_to(ray, &account), &account), ray);
        }
        assert_eq!(follow(&[1, 1, 0, 7], &account), 5);
        assert_eq!(follow(&[9, 1], &account), 2);
        assert_eq!(follow(&[], &account), 0);
    }
}
