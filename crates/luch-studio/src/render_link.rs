//! The wire to the renderer: asks for pictures, takes the newest one, keeps it as a texture.

use crate::texture::Texture;
use egui::Context;
use luch_render::session::live::{Epoch, LiveRequest, LiveSession, LiveStatus, Snapshot};
use luch_render::{Integrator, RenderJob, SimdLevel};
use luch_scene::{Camera, Scene};
use std::sync::Arc;

/// The session, what was asked of it, and what it has shown last.
pub(crate) struct RenderLink {
    session: LiveSession,
    asked: Option<Epoch>,
    shown: Option<Arc<Snapshot>>,
    texture: Option<Texture>,
    /// The picture that was asked for last and was told to have failed.
    told: Option<Epoch>,
}

impl RenderLink {
    /// Starts the session's thread.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn start(ctx: &Context) -> std::io::Result<Self> {
        let ctx = ctx.clone();
        let session = LiveSession::start(move || ctx.request_repaint())?;
        Ok(Self { session, asked: None, shown: None, texture: None, told: None })
    }

    /// Asks for a picture of the scene through this camera; it replaces the one under way.
    pub(crate) fn ask(&mut self, scene: &Arc<Scene>, camera: Camera, integrator: Integrator, threads: usize) {
        let job = job(scene, camera, integrator, threads);
        self.asked = Some(self.session.show(LiveRequest { scene: Arc::clone(scene), job }));
    }

    /// Whether any picture was asked for yet.
    pub(crate) const fn has_asked(&self) -> bool {
        self.asked.is_some()
    }

    /// Stops the picture under way; what it has shown stays.
    pub(crate) fn stop(&self) {
        self.session.stop();
    }

    /// Takes the newest picture, if there is one that was not shown yet.
    pub(crate) fn poll(&mut self, ctx: &Context) {
        let Some(newest) = self.session.latest() else { return };
        if self.shown.as_ref().is_some_and(|shown| Arc::ptr_eq(shown, &newest)) {
            return;
        }
        self.texture = Some(Texture::of(&newest, self.texture.take(), ctx));
        self.shown = Some(newest);
    }

    /// The picture that is shown, and its texture.
    pub(crate) fn picture(&self) -> Option<(&Arc<Snapshot>, &Texture)> {
        self.shown.as_ref().zip(self.texture.as_ref())
    }

    /// How far the picture is that was asked for last.
    pub(crate) fn status(&self) -> LiveStatus {
        self.session.status()
    }

    /// Whether there is nothing left to wait for: what was asked for last has ended and is shown.
    pub(crate) fn is_settled(&self) -> bool {
        let status = self.session.status();
        let Some(asked) = self.asked else { return true };
        if status.epoch != asked || status.ended.is_none() {
            return false;
        }
        let shown = self.shown.as_ref().map(|shown| (shown.epoch, shown.finished));
        let newest = self.session.latest().map(|newest| (newest.epoch, newest.finished));
        shown == newest
    }

    /// What the renderer said if the picture asked for last has failed; once for each picture.
    pub(crate) fn failure(&mut self) -> Option<String> {
        use luch_render::session::live::LiveEnd;
        let status = self.session.status();
        if self.told == Some(status.epoch) {
            return None;
        }
        match status.ended {
            Some(LiveEnd::Failed(message)) => {
                self.told = Some(status.epoch);
                Some(message)
            }
            _ => None,
        }
    }
}

/// The whole picture of a scene with its own settings.
pub(crate) fn job(scene: &Scene, camera: Camera, integrator: Integrator, threads: usize) -> RenderJob {
    let settings = &scene.settings;
    RenderJob {
        camera,
        size: settings.size,
        crop: None,
        depth: settings.depth,
        antialiasing: settings.antialiasing,
        depth_of_field: settings.depth_of_field,
        integrator,
        threads,
        simd: SimdLevel::Auto,
        tile_size: RenderJob::TILE_SIZE,
    }
}
