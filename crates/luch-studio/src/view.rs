//! From where the picture is seen: a camera of the scene, and how far the mouse has moved away from it.

pub(crate) mod extent;
pub(crate) mod eye;
pub(crate) mod walls;

use crate::selection::Part;
use extent::Extent;
use eye::Eye;
use luch_scene::{Aim, Camera, CameraEdit, Edit, Point, Scene};
use walls::Walls;

/// A place and a direction to look from that differ from the camera's own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pose {
    pub(crate) position: Point,
    pub(crate) aim: Aim,
}

/// The camera in use. Its lens is the scene's; only its pose may have wandered off.
#[derive(Debug, Clone, PartialEq, Default)]
pub(crate) struct View {
    /// Place of the camera in the scene's list.
    pub(crate) index: usize,
    /// Where the mouse has moved it; `None`: where the scene has it.
    pub(crate) pose: Option<Pose>,
}

impl View {
    /// The camera to look through; `None` only for a scene without cameras.
    pub(crate) fn camera(&self, scene: &Scene) -> Option<Camera> {
        let mut camera = scene.cameras.get(self.index).or_else(|| scene.cameras.first())?.clone();
        if let Some(pose) = self.pose {
            camera.position = pose.position;
            camera.aim = pose.aim;
        }
        Some(camera)
    }

    /// The edit that makes the scene's camera stand where the mouse has moved it.
    pub(crate) fn store(&self) -> Option<Edit> {
        let pose = self.pose?;
        let set = |edit| Edit::Camera(self.index, edit);
        Some(Edit::Group(vec![set(CameraEdit::MoveTo(pose.position)), set(CameraEdit::SetAim(pose.aim))]))
    }

    /// The pose from which all of a part is in the picture, or all of the scene. `None` if nothing has bounds.
    pub(crate) fn framing(&self, scene: &Scene, part: Option<Part>) -> Option<Pose> {
        let camera = self.camera(scene)?;
        let extent = part.and_then(|part| Extent::of(part, scene)).or_else(|| Extent::of_scene(scene))?;
        let size = scene.settings.size;
        let tall = slope_of(&camera);
        let slopes = [tall * f64::from(size.width()) / f64::from(size.height()), tall];
        let framed = extent.framed(&Eye::of(&camera), slopes);
        // Rather too near than behind a wall.
        let free = Walls::of(scene).free_part(extent.center, framed.position);
        Some(framed.dolly(extent.center, free).pose())
    }

    /// Keeps the view on a camera that exists after the list has changed.
    pub(crate) fn stay_within(&mut self, scene: &Scene) {
        let last = scene.cameras.len().saturating_sub(1);
        if self.index > last {
            *self = Self { index: last, pose: None };
        }
    }
}

/// Half the height of a camera's picture at distance 1.
pub(crate) fn slope_of(camera: &Camera) -> f64 {
    (f64::from(camera.fov.get()).to_radians() * 0.5).tan()
}
