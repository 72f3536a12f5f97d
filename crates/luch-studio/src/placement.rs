//! Where something new goes: before the camera, at what the middle of the picture shows, standing on what is there, as
//! large as is seen well.

use crate::l10n::Texts;
use glam::Vec3;
use luch_io::Model;
use luch_render::session::live::{Pick, Snapshot, pick};
use luch_render::{CompiledScene, RenderJob};
use luch_scene::{
    Aim, Camera, Color, Direction, Edit, FieldOfView, ImageSize, Light, Material, MeshInstance, NonNegative, Object,
    Point, Rotation, Scene, Shape, Size, Unit,
};

/// Something that can be put into a scene without a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Addition {
    Sphere,
    Cube,
    Wall,
    Light,
}

impl Addition {
    pub(crate) const ALL: [Self; 4] = [Self::Sphere, Self::Cube, Self::Wall, Self::Light];

    /// What a menu calls it, and the first of its kind in a scene.
    pub(crate) fn name(self, texts: &Texts) -> String {
        match self {
            Self::Sphere => texts.new_sphere_name(),
            Self::Cube => texts.new_cube_name(),
            Self::Wall => texts.new_wall_name(),
            Self::Light => texts.new_lamp_name(),
        }
    }
}

/// Half of a new thing's size as a part of what is seen at its distance.
const HALF: f32 = 0.09;

/// The place that the middle of the picture shows.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Spot<'a> {
    scene: Option<&'a CompiledScene>,
    eye: Vec3,
    forward: Vec3,
    point: Vec3,
    /// Away from the surface there; up where there is none.
    normal: Vec3,
    /// The height of what is seen at that distance.
    reach: f32,
}

impl<'a> Spot<'a> {
    /// The spot that a picture shows; without a picture, the one that the camera is focused on.
    pub(crate) fn of(scene: &Scene, camera: &Camera, picture: Option<&'a Snapshot>) -> Self {
        let camera = picture.map_or(camera, |picture| &picture.job.camera);
        let hit = picture.and_then(|picture| {
            let size = picture.job.size;
            pick(&picture.compiled, &picture.job, size.width() / 2, size.height() / 2)
        });
        let (eye, forward) = (camera.position.get(), camera.direction());
        let (point, normal) = match hit {
            Some(Pick { point, normal, .. }) => (point, normal),
            None => (eye + forward * distance_of_nothing(scene, camera), Vec3::Y),
        };
        let distance = (point - eye).dot(forward).max(1e-6);
        let reach = 2.0 * distance * half_view(camera.fov);
        Self { scene: picture.map(|picture| &*picture.compiled), eye, forward, point, normal, reach }
    }

    /// The edit that puts something there.
    pub(crate) fn add(&self, what: Addition, scene: &Scene, texts: &Texts) -> Edit {
        let name = scene.free_name(&what.name(texts));
        let half = nice(self.reach * HALF);
        let shape = match what {
            Addition::Light => {
                // Halfway to the spot and above the view: in the open, and its mark is seen.
                let place = self.eye + (self.point - self.eye) * 0.5 + Vec3::Y * (self.reach * 0.17);
                let light = Light { intensity: NonNegative::clamped(0.5), ..Light::new(name, Point::clamped(place)) };
                return Edit::AddLight(scene.lights.len(), light);
            }
            Addition::Sphere => {
                let center = Point::clamped(self.stand(Vec3::splat(half), true));
                Shape::Sphere { center, radius: Size::clamped(half) }
            }
            Addition::Cube => {
                let center = Point::clamped(self.stand(Vec3::splat(half), false));
                Shape::Cuboid { center, size: [Size::clamped(2.0 * half); 3], rotation: Rotation::NONE }
            }
            Addition::Wall => {
                let facing = Vec3::new(-self.forward.x, 0.0, -self.forward.z);
                let normal = Direction::new(facing).or_else(|_| Direction::new(Vec3::Z)).unwrap_or(Direction::UP);
                let [width, height] = [4.0 * half, 3.0 * half];
                let point = Point::clamped(self.stand(Vec3::new(0.0, height * 0.5, 0.0), false));
                Shape::Wall { point, normal, size: Some([Size::clamped(width), Size::clamped(height)]) }
            }
        };
        let material = Material { gloss: Some(Unit::clamped(0.4)), ..Material::matt(Color::srgb8([0x5b, 0x8f, 0xd0])) };
        let object = Object { material, ..Object::new(name, shape) };
        Edit::AddObject(scene.objects.len(), Box::new(object))
    }

    /// The edit that puts a model there. One that is far from the scene's size is made larger or smaller.
    pub(crate) fn add_model(&self, model: Model, scene: &Scene) -> Edit {
        let [lo, hi] = model.mesh.bounds();
        let natural = (hi - lo).max_element();
        let fits = (0.02..1.2).contains(&(natural / self.reach));
        let scale = if fits || natural <= 0.0 { 1.0 } else { nice(self.reach * 0.35 / natural) };
        let half = (hi - lo) * (0.5 * scale);
        let middle = self.stand(half, false);
        let position = Point::clamped(middle - (lo + hi) * (0.5 * scale));
        let (rotation, scale) = (Rotation::NONE, Size::clamped(scale));
        let shape = Shape::Mesh(MeshInstance { mesh: model.mesh, path: model.path, position, rotation, scale });
        let object = Object { material: model.material, ..Object::new(scene.free_name(&model.name), shape) };
        Edit::AddObject(scene.objects.len(), Box::new(object))
    }

    /// The middle of a box (or a ball) with these half sides that touches the surface at the spot; if that leaves it in the
    /// air above something near, it is let down.
    fn stand(&self, half: Vec3, round: bool) -> Vec3 {
        let extent = |normal: Vec3| if round { half.x } else { half.dot(normal.abs()) };
        let middle = self.point + self.normal * extent(self.normal);
        let below = self.scene.and_then(|scene| first_hit(scene, middle, Vec3::NEG_Y));
        match below.filter(|hit| hit.t > half.y && hit.t - half.y < self.reach) {
            Some(hit) => Vec3::new(middle.x, hit.point.y + half.y, middle.z),
            None => middle,
        }
    }
}

/// How far something is put where nothing is seen: at the focus, or where the scene's middle is.
fn distance_of_nothing(scene: &Scene, camera: &Camera) -> f32 {
    if camera.focal_distance.is_some() || matches!(camera.aim, Aim::At(_)) {
        return camera.focus();
    }
    let middle = scene.bounds().map(|[lo, hi]| (lo + hi) * 0.5);
    let along = middle.map(|middle| (middle - camera.position.get()).dot(camera.direction()));
    along.filter(|&along| along > 1e-3).unwrap_or_else(|| camera.focus())
}

/// The first thing that a ray meets.
fn first_hit(scene: &CompiledScene, from: Vec3, along: Vec3) -> Option<Pick> {
    let aim = Aim::Along(Direction::new(along).ok()?);
    let mut empty = Scene::new("a ray");
    empty.cameras.push(Camera::new("a ray", Point::clamped(from), aim));
    let job = RenderJob { size: ImageSize::new(1, 1).ok()?, ..RenderJob::of_scene(&empty, 0) };
    pick(scene, &job, 0, 0)
}

/// Half the height of what is seen at distance 1.
fn half_view(fov: FieldOfView) -> f32 {
    (f64::from(fov.get()).to_radians() * 0.5).tan() as f32
}

/// The nearest of 1, 1.5, 2, 3, 5, 7 times a power of ten: a number that people would choose.
fn nice(value: f32) -> f32 {
    let value = f64::from(value.clamp(1e-8, 1e8));
    let power = 10.0_f64.powf(value.log10().floor());
    let steps = [1.0, 1.5, 2.0, 3.0, 5.0, 7.0, 10.0];
    let off = |step: &f64| (value / power - step).abs();
    let step = steps.into_iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(1.0);
    (step * power) as f32
}
