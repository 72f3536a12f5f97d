//! The scenes that a study measures.

use crate::bumpy_sphere;
use glam::Vec3;
use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::{Report, SceneSource, load_scene};
use luch_scene::{
    Aim, Camera, Color, Direction, Light, Material, MeshInstance, NonNegative, Object, Point, Positive, Rotation,
    Scene, Shape, Size, Unit,
};
use std::sync::Arc;

/// A scene under study, seen by its first camera.
#[derive(Debug, Clone, PartialEq)]
pub struct Subject {
    /// What it is called by: the id of a built-in scene, or the path of a file.
    pub id: String,
    /// The scene.
    pub scene: Scene,
}

impl Subject {
    /// The scenes of the published study: what the second mirroring sphere costs is seen by comparing the two.
    pub const SPHERES: [&'static str; 2] = ["one-sphere", "two-spheres"];

    /// A built-in scene.
    ///
    /// # Errors
    /// `Forbidden` for an id that is none of [`luch_io::builtin::ids`].
    pub fn built_in(id: &str) -> luch_io::Result<Self> {
        let known = luch_io::builtin::ids().find(|known| *known == id);
        let id = known
            .ok_or_else(|| luch_io::Error::new(luch_io::ErrorKind::Forbidden, id, "there is no such built-in scene"))?;
        let (mut library, mut budget, mut report) = (MeshLibrary::new(), Budget::default(), Report::default());
        let scene = load_scene(&SceneSource::BuiltIn(id), &mut library, &mut budget, &mut report)?;
        Ok(Self { id: id.to_owned(), scene })
    }

    /// A bumpy sphere of about so many triangles on a floor, seen from near.
    #[must_use]
    pub fn bumpy_sphere(about: u64) -> Self {
        let mesh = Arc::new(bumpy_sphere::mesh(about));
        let id = format!("bumpy-sphere-{}", mesh.triangles().len());
        let sphere = Shape::Mesh(MeshInstance {
            mesh,
            path: format!("{id}.obj"),
            position: Point::clamped(Vec3::new(0.0, 1.1, 0.0)),
            rotation: Rotation::NONE,
            scale: Size::ONE,
        });
        let mut ball = Object::new("Bumpy sphere", sphere);
        ball.material = Material { gloss: Some(Unit::clamped(0.6)), ..Material::matt(Color::srgb8([217, 150, 46])) };
        let floor = Shape::Wall { point: Point::ORIGIN, normal: Direction::UP, size: None };
        let mut floor = Object::new("Floor", floor);
        floor.material = Material::matt(Color::srgb8([208, 208, 208]));
        let mut lamp = Light::new("Lamp", Point::clamped(Vec3::new(3.0, 6.0, 4.0)));
        lamp.intensity = NonNegative::clamped(0.9);
        let eye = Point::clamped(Vec3::new(0.0, 1.6, 3.4));
        let mut scene = Scene::new("Bumpy sphere");
        scene.background = Color::srgb8([16, 20, 28]);
        scene.attenuation = Positive::clamped(40.0);
        scene.objects = vec![ball, floor];
        scene.lights = vec![lamp];
        scene.cameras = vec![Camera::new("Camera", eye, Aim::At(Point::clamped(Vec3::new(0.0, 1.0, 0.0))))];
        Self { id, scene }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn built_in_scenes_are_found_and_others_are_not() {
        assert_eq!(Subject::built_in("one-sphere").unwrap().scene.name, "One sphere");
        assert_eq!(Subject::built_in("three-spheres").unwrap_err().kind, luch_io::ErrorKind::Forbidden);
    }

    #[test]
    fn the_mirrors_of_the_published_study_reflect_a_half() {
        for id in Subject::SPHERES {
            let scene = Subject::built_in(id).unwrap().scene;
            let balls: Vec<&Object> =
                scene.objects.iter().filter(|o| matches!(o.shape, Shape::Sphere { .. })).collect();
            assert!(!balls.is_empty() && balls.iter().all(|o| o.material.reflection == Unit::clamped(0.5)), "{id}");
        }
    }
}
