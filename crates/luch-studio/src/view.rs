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

    /// Keeps the view on a camera that exists.
    pub(crate) fn stay_within(&mut self, scene: &Scene) {
        let last = scene.cameras.len().saturating_sub(1);
        if self.index > last {
            *self = Self { index: last, pose: None };
        }
    }

    /// What must be known of the camera to find it again after the list has changed.
    pub(crate) fn anchor(&self, scene: &Scene) -> CameraAnchor {
        let name = scene.cameras.get(self.index).map(|camera| camera.name.clone());
        CameraAnchor { name, count: scene.cameras.len() }
    }

    /// Keeps the view on the camera that it was on. If that is gone, another takes its place, seen from where it stands.
    pub(crate) fn follow(&mut self, anchor: &CameraAnchor, scene: &Scene) {
        let named = anchor.name.as_deref().and_then(|name| scene.camera_named(name));
        if let Some(index) = named {
            self.index = index;
        } else if anchor.count != scene.cameras.len() {
            self.pose = None;
        }
        // With as many cameras as before it has only another name.
        self.stay_within(scene);
    }
}

/// A camera by its name.
#[derive(Debug, Clone)]
pub(crate) struct CameraAnchor {
    name: Option<String>,
    count: usize,
}

/// Half the height of a camera's picture at distance 1.
pub(crate) fn slope_of(camera: &Camera) -> f64 {
    (f64::from(camera.fov.get()).to_radians() * 0.5).tan()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> Scene {
        let mut scene = Scene::new("s");
        for name in ["a", "b", "c"] {
            scene.cameras.push(Camera::new(name, Point::ORIGIN, Aim::At(Point::ORIGIN)));
        }
        scene
    }

    fn moved(index: usize) -> View {
        View { index, pose: Some(Pose { position: Point::ORIGIN, aim: Aim::At(Point::ORIGIN) }) }
    }

    /// The name of the camera that a view is on after an edit, and whether it keeps its pose.
    fn after(mut view: View, edit: Edit) -> (String, bool) {
        let mut scene = scene();
        let anchor = view.anchor(&scene);
        edit.apply(&mut scene).unwrap();
        view.follow(&anchor, &scene);
        (view.camera(&scene).unwrap().name, view.pose.is_some())
    }

    #[test]
    fn a_view_stays_on_its_camera_whatever_happens_to_the_others() {
        assert_eq!(after(moved(2), Edit::RemoveCamera(0)), ("c".into(), true));
        assert_eq!(after(moved(0), Edit::RemoveCamera(2)), ("a".into(), true));
        let another = Camera::new("d", Point::ORIGIN, Aim::At(Point::ORIGIN));
        assert_eq!(after(moved(1), Edit::AddCamera(0, another)), ("b".into(), true));
        let rename = |index| Edit::Camera(index, CameraEdit::Rename("d".into()));
        assert_eq!(after(moved(1), rename(1)), ("d".into(), true));
        assert_eq!(after(moved(1), rename(0)), ("b".into(), true));
    }

    #[test]
    fn the_pose_of_a_camera_that_is_gone_is_not_given_to_another() {
        assert_eq!(after(moved(1), Edit::RemoveCamera(1)), ("c".into(), false));
        assert_eq!(after(moved(2), Edit::RemoveCamera(2)), ("b".into(), false));
    }
}
