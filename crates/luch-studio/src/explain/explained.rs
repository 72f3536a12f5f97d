//! An account together with the scene that it speaks of.

use super::plan::Plan;
use crate::l10n::Texts;
use luch_explain::Explanation;
use luch_render::CompiledScene;
use luch_render::explain::{PixelAccount, RayEnd};
use luch_render::session::live::Epoch;
use luch_scene::{Camera, Scene};
use std::sync::Arc;

/// The account of a pixel, and what it was made from. Objects and lights are those of its own scene, which may be older
/// than the one at hand.
#[derive(Debug)]
pub(crate) struct Explained {
    pub(crate) account: PixelAccount,
    pub(crate) scene: Arc<Scene>,
    pub(crate) compiled: Arc<CompiledScene>,
    pub(crate) camera: Camera,
    /// The picture that it explains.
    pub(crate) epoch: Epoch,
    /// The scene from above.
    pub(crate) plan: Arc<Plan>,
}

impl Explained {
    pub(crate) fn new(
        account: PixelAccount,
        scene: Arc<Scene>,
        compiled: Arc<CompiledScene>,
        camera: Camera,
        epoch: Epoch,
        plan: Arc<Plan>,
    ) -> Self {
        Self { account, scene, compiled, camera, epoch, plan }
    }

    /// For those who write it out.
    pub(crate) fn explanation(&self) -> Explanation<'_> {
        Explanation { account: &self.account, scene: &self.scene, compiled: &self.compiled, camera: &self.camera.name }
    }

    /// The name of an object.
    pub(crate) fn object(&self, index: u32) -> &str {
        self.scene.objects.get(index as usize).map_or("", |object| &object.name)
    }

    /// The name of a light.
    pub(crate) fn light(&self, index: u32) -> &str {
        self.scene.lights.get(index as usize).map_or("", |light| &light.name)
    }

    /// Where a ray ends, in a few words.
    pub(crate) fn end_of(&self, ray: u32, texts: &Texts) -> String {
        match self.account.rays[ray as usize].end {
            RayEnd::Surface(surface) => self.object(self.account.surfaces[surface as usize].object).to_owned(),
            RayEnd::Nothing => texts.explain_ends_nowhere(),
            RayEnd::DepthUsedUp => texts.explain_ends_depth(),
            RayEnd::Light(entry) => texts.explain_ends_light(self.light(self.account.lights[entry as usize].light)),
            RayEnd::Blocked { light, blocker } => {
                let light = self.light(self.account.lights[light as usize].light);
                texts.explain_ends_blocked(light, self.object(blocker.object))
            }
        }
    }

    /// How far along the ray it ends, if it ends.
    pub(crate) fn t_of(&self, ray: u32) -> Option<f32> {
        let account = &self.account.rays[ray as usize];
        match account.end {
            RayEnd::Surface(surface) => Some(self.account.surfaces[surface as usize].t),
            RayEnd::Light(_) => Some(account.reach),
            RayEnd::Blocked { blocker, .. } => Some(blocker.t),
            RayEnd::Nothing | RayEnd::DepthUsedUp => None,
        }
    }
}
