//! The scenes that the studio makes itself.

use crate::l10n::Texts;
use luch_scene::{Aim, Camera, Light, Point, Scene};

/// The scene that a window starts with.
pub(super) const FIRST: &str = "two-spheres";

/// The first built-in scene; it has no models, so it is there at once.
pub(super) fn first() -> Scene {
    let mut no_models = |path: &str, _: &mut luch_io::Report| {
        Err(luch_io::Error::new(luch_io::ErrorKind::Forbidden, path, "the first scene has no models"))
    };
    luch_io::builtin::load(FIRST, &mut no_models, &mut luch_io::Report::default()).unwrap_or_else(|_| Scene::new(FIRST))
}

/// An empty scene that one can put things into: a lamp and a camera.
pub(super) fn new(texts: &Texts) -> Scene {
    let mut scene = Scene::new(texts.new_scene_name());
    scene.lights.push(Light::new(texts.new_lamp_name(), Point::clamped([3.0, 6.0, 4.0].into())));
    scene.cameras.push(default_camera(&scene, texts));
    scene
}

/// A camera that has the whole scene in view.
pub(super) fn default_camera(scene: &Scene, texts: &Texts) -> Camera {
    let [lo, hi] = scene.bounds().unwrap_or([glam::Vec3::splat(-1.0), glam::Vec3::splat(1.0)]);
    let (middle, reach) = ((lo + hi) * 0.5, ((hi - lo).length() * 0.5).max(1e-3));
    let from = middle + glam::vec3(0.0, 0.35, 1.0).normalize_or_zero() * reach * 3.0;
    Camera::new(
        scene.free_camera_name(&texts.new_camera_name("1")),
        Point::clamped(from),
        Aim::At(Point::clamped(middle)),
    )
}
