//! Which object is where in a picture.

use super::mailbox::LiveRequest;
use crate::compiled::have_same_shapes;
use crate::math::ray::NO_OBJECT;
use luch_scene::{Camera, ImageSize, Scene};
use std::fmt;
use std::sync::Arc;

/// The object at each pixel of a picture: what the ray through the pixel's centre, from the centre of the lens, meets
/// first.
#[derive(Clone, PartialEq, Eq)]
pub struct ObjectMap {
    size: ImageSize,
    shrink: u32,
    columns: u32,
    /// By rows of blocks.
    objects: Vec<u32>,
}

impl ObjectMap {
    /// `objects` has one object for each block of `shrink` times `shrink` pixels, by rows.
    pub(super) fn new(size: ImageSize, shrink: u32, objects: Vec<u32>) -> Self {
        Self { size, shrink, columns: size.width().div_ceil(shrink), objects }
    }

    /// Pixels in a row.
    #[must_use]
    pub const fn width(&self) -> u32 {
        self.size.width()
    }

    /// Rows.
    #[must_use]
    pub const fn height(&self) -> u32 {
        self.size.height()
    }

    /// Pixels along the side of the blocks that share a ray: 1 except in the map of a preview.
    #[must_use]
    pub const fn shrink(&self) -> u32 {
        self.shrink
    }

    /// The object at a pixel, by its place in the scene's list; `None` where there is none, and outside the picture.
    #[must_use]
    pub fn at(&self, x: u32, y: u32) -> Option<usize> {
        if x >= self.size.width() || y >= self.size.height() {
            return None;
        }
        let place = (y / self.shrink) as usize * self.columns as usize + (x / self.shrink) as usize;
        self.objects.get(place).filter(|&&object| object != NO_OBJECT).map(|&object| object as usize)
    }
}

impl fmt::Debug for ObjectMap {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { size, shrink, .. } = self;
        f.debug_struct("ObjectMap").field("size", size).field("shrink", shrink).finish_non_exhaustive()
    }
}

/// The map of a full picture, with what it depends on: it holds for the next picture too if only looks have changed.
pub(super) struct Sight {
    scene: Arc<Scene>,
    camera: Camera,
    map: Arc<ObjectMap>,
}

impl Sight {
    pub(super) fn new(request: &LiveRequest, map: Arc<ObjectMap>) -> Self {
        Self { scene: Arc::clone(&request.scene), camera: request.job.camera.clone(), map }
    }

    pub(super) const fn map(&self) -> &Arc<ObjectMap> {
        &self.map
    }

    /// The same for another request, if its objects stand where they stood and are seen as they were.
    pub(super) fn through(self, request: &LiveRequest) -> Option<Self> {
        let (old, new) = (&self.camera, &request.job.camera);
        let same_view = old.position == new.position && old.aim == new.aim && old.fov == new.fov;
        let holds = same_view && self.map.size == request.job.size && have_same_shapes(&self.scene, &request.scene);
        holds.then(|| Self::new(request, self.map))
    }
}
