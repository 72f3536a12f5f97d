//! A bare model is a scene, too: stood on a floor, lit, and framed by three cameras.

use crate::budget::Budget;
use crate::error::Result;
use crate::library::MeshLibrary;
use crate::report::Report;
use crate::resolve::{SceneFile, SceneFolder, encode_name};
use glam::{DVec3, Vec3};
use luch_scene::{
    Aim, Camera, Color, Direction, FieldOfView, Light, Material, Mesh, MeshInstance, NonNegative, Object, Point,
    Positive, Rotation, Scene, Shape, Size, Unit,
};
use std::path::Path;
use std::sync::Arc;

/// Reads a model and makes a scene of it, in the model's own units.
///
/// The model's lowest point touches the floor (y = 0), its middle stands on the y axis. Lights, cameras and the
/// attenuation keep their proportion to its size, so that a model of a millimetre and one of a thousand kilometres give
/// the same picture. The user named `path`, so it may lie anywhere; its material libraries lie behind the fence of its
/// folder.
///
/// # Errors
/// `Forbidden` if there is no such file, and as [`MeshLibrary::mesh`].
pub fn scene_of_model(
    path: &Path,
    library: &mut MeshLibrary,
    budget: &mut Budget,
    report: &mut Report,
) -> Result<Scene> {
    let (file, folder) = (SceneFile::of_user(path)?, SceneFolder::of_file(path)?);
    let mesh = library.mesh_of_file(&folder, &file, budget, report)?;
    let file_name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    Ok(around(&mesh, &file_name))
}

/// A model to be put into a scene that is there already.
#[derive(Debug, Clone)]
pub struct Model {
    /// Its file's name without the ending.
    pub name: String,
    /// The triangles.
    pub mesh: Arc<Mesh>,
    /// A path to name it by until the scene is saved.
    pub path: String,
    /// Its look, where its file says nothing.
    pub material: Material,
}

/// Reads a model to be put into a scene.
///
/// # Errors
/// As [`scene_of_model`].
pub fn load_model(path: &Path, library: &mut MeshLibrary, budget: &mut Budget, report: &mut Report) -> Result<Model> {
    let (file, folder) = (SceneFile::of_user(path)?, SceneFolder::of_file(path)?);
    let mesh = library.mesh_of_file(&folder, &file, budget, report)?;
    let file_name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy().into_owned();
    Ok(Model { name: shown_name(&file_name), material: look(&mesh), path: encode_name(&file_name), mesh })
}

/// The scene around a mesh that came from the file `file_name`.
#[must_use]
pub fn around(mesh: &Arc<Mesh>, file_name: &str) -> Scene {
    let name = shown_name(file_name);
    let stage = Stage::of(mesh);
    let mut scene = Scene::new(name.clone());
    scene.background = Color::srgb8([0x1a, 0x1f, 0x27]);
    scene.ambient = NonNegative::clamped(0.16);
    // The lamp stands at four and a half radii: K / (d + K) is 0.73 there, and falls off gently behind the model.
    scene.attenuation = Positive::clamped(12.0 * stage.radius);
    scene.lights = stage.lights();
    scene.objects.push(floor());
    let object = Object {
        material: look(mesh),
        ..Object::new(
            scene.free_name(&name),
            Shape::Mesh(MeshInstance {
                mesh: Arc::clone(mesh),
                path: encode_name(file_name),
                position: stage.position,
                rotation: Rotation::NONE,
                scale: Size::ONE,
            }),
        )
    };
    scene.objects.push(object);
    scene.cameras = stage.cameras(mesh);
    scene
}

/// Where the model stands, and how large it is.
struct Stage {
    position: Point,
    /// Middle of the box around it, once it stands.
    middle: Vec3,
    /// Distance from there to the farthest vertex of a triangle.
    radius: f32,
}

/// A lamp of the stage.
struct Lamp {
    name: &'static str,
    /// Direction to it from the model's middle.
    towards: [f32; 3],
    /// Its distance in radii of the model.
    radii: f32,
    intensity: f32,
    srgb: [u8; 3],
}

/// A warm lamp from above left, as a painter's window, and a cool soft one from the right.
const LAMPS: [Lamp; 2] = [
    Lamp { name: "Lamp", towards: [-0.55, 0.95, 0.8], radii: 4.5, intensity: 1.0, srgb: [0xff, 0xf1, 0xde] },
    Lamp { name: "Fill", towards: [0.95, 0.45, 0.6], radii: 5.5, intensity: 0.3, srgb: [0xdc, 0xe8, 0xff] },
];

/// Directions from the model's middle to the cameras.
const VIEWS: [(&str, [f32; 3]); 3] =
    [("Three-quarter view", [0.75, 0.5, 1.0]), ("Front", [0.0, 0.18, 1.0]), ("High side", [-1.0, 0.95, 0.4])];

const FIELD_OF_VIEW: f32 = 36.0;

#[allow(clippy::arithmetic_side_effects, reason = "vectors of floats neither overflow nor panic")]
impl Stage {
    fn of(mesh: &Mesh) -> Self {
        // In f64, where the sum of two far corners and the square of a diagonal are exact enough.
        let [lo, hi] = mesh.bounds().map(Vec3::as_dvec3);
        let (middle, half) = ((lo + hi) * 0.5, (hi - lo) * 0.5);
        let square_of = |v: &u32| (place(mesh, *v) - middle).length_squared();
        let square = mesh.triangles().iter().flatten().map(square_of).fold(0.0, f64::max);
        Self {
            position: Point::clamped(DVec3::new(-middle.x, -lo.y, -middle.z).as_vec3()),
            middle: DVec3::new(0.0, half.y, 0.0).as_vec3(),
            radius: narrow(square.sqrt()).max(1e-6),
        }
    }

    fn lights(&self) -> Vec<Light> {
        let light = |lamp: Lamp| Light {
            intensity: NonNegative::clamped(lamp.intensity),
            color: Color::srgb8(lamp.srgb),
            ..Light::new(lamp.name, self.towards(lamp.towards, lamp.radii))
        };
        LAMPS.map(light).into()
    }

    fn cameras(&self, mesh: &Mesh) -> Vec<Camera> {
        // The sphere around the model touches the picture's edges at radius / sin(fov / 2); a little air beside it.
        let radii = 1.12 / libm::sinf(FIELD_OF_VIEW.to_radians() * 0.5);
        let camera = |(name, towards): (&str, [f32; 3])| {
            let position = self.towards(towards, radii);
            let camera = Camera::new(name, position, Aim::At(Point::clamped(self.middle)));
            let eye = position.get() - self.position.get();
            let sharp = first_hit(mesh, eye, camera.direction()).unwrap_or(radii * self.radius);
            Camera {
                fov: FieldOfView::clamped(FIELD_OF_VIEW),
                focal_distance: Some(Positive::clamped(sharp)),
                lens_radius: NonNegative::clamped(0.05 * self.radius),
                ..camera
            }
        };
        VIEWS.map(camera).into()
    }

    /// The point so many radii from the middle.
    fn towards(&self, direction: [f32; 3], radii: f32) -> Point {
        let direction = Vec3::from_array(direction).normalize_or(Vec3::Z);
        Point::clamped(self.middle + direction * (radii * self.radius))
    }
}

fn place(mesh: &Mesh, vertex: u32) -> DVec3 {
    let place = usize::try_from(vertex).ok().and_then(|v| mesh.positions().get(v));
    Vec3::from_array(place.copied().unwrap_or_default()).as_dvec3()
}

/// The nearest distance from `eye` along `direction` at which the mesh is: where the picture should be sharp.
///
/// Looks at every triangle (Moeller and Trumbore, 1997): there is no tree yet, and it is three rays in all.
#[allow(clippy::arithmetic_side_effects, reason = "vectors of floats neither overflow nor panic")]
fn first_hit(mesh: &Mesh, eye: Vec3, direction: Vec3) -> Option<f32> {
    let (eye, direction) = (eye.as_dvec3(), direction.as_dvec3());
    let hit = |triangle: &[u32; 3]| {
        let [a, b, c] = triangle.map(|v| place(mesh, v));
        let (ab, ac) = (b - a, c - a);
        let p = direction.cross(ac);
        let inverse = ab.dot(p).recip();
        let from_a = eye - a;
        let u = from_a.dot(p) * inverse;
        let q = from_a.cross(ab);
        let v = direction.dot(q) * inverse;
        let t = ac.dot(q) * inverse;
        // A ray in the triangle's plane makes NaN here, which is no hit.
        (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0 && t.is_finite()).then_some(t)
    };
    let nearest = mesh.triangles().iter().filter_map(hit).fold(f64::INFINITY, f64::min);
    nearest.is_finite().then(|| narrow(nearest))
}

#[allow(clippy::cast_possible_truncation, reason = "rounding to the nearest f32 is meant")]
fn narrow(value: f64) -> f32 {
    value as f32
}

/// Warm clay for a model that says nothing of its look; else what its file says.
fn look(mesh: &Mesh) -> Material {
    if mesh.materials().is_empty() {
        let clay = Color::srgb8([0xd9, 0xb8, 0x96]);
        return Material { gloss: Some(Unit::clamped(0.4)), ..Material::matt(clay) };
    }
    Material::default()
}

fn floor() -> Object {
    let stone = Color::srgb8([0xa9, 0xa3, 0x99]);
    Object {
        material: Material {
            reflection: Unit::clamped(0.06),
            gloss: Some(Unit::clamped(0.2)),
            ..Material::matt(stone)
        },
        ..Object::new("Floor", Shape::Wall { point: Point::ORIGIN, normal: Direction::UP, size: None })
    }
}

/// The file's name without its ending, as a name that a scene may have.
fn shown_name(file_name: &str) -> String {
    let stem = Path::new(file_name).file_stem().unwrap_or_default().to_string_lossy();
    let mut name = String::new();
    for c in stem.chars().map(|c| if c.is_control() { ' ' } else { c }) {
        if name.len().saturating_add(c.len_utf8()) > Scene::MAX_NAME {
            break;
        }
        name.push(c);
    }
    let name = name.trim();
    if name.is_empty() { "Model".to_owned() } else { name.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::MeshData;

    /// An octahedron of radius `r` about `middle`.
    fn octahedron(middle: Vec3, r: f32) -> Arc<Mesh> {
        let ends = [Vec3::X, Vec3::NEG_X, Vec3::Y, Vec3::NEG_Y, Vec3::Z, Vec3::NEG_Z];
        let faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
        let positions: Vec<[f32; 3]> = ends.iter().map(|e| (middle + *e * r).to_array()).collect();
        let normals = ends.iter().map(|e| e.to_array()).collect();
        Arc::new(Mesh::new(MeshData { positions, normals, triangles: faces.to_vec(), ..MeshData::default() }).unwrap())
    }

    #[test]
    fn a_model_of_any_size_stands_on_the_floor_and_is_seen_whole() {
        for size in [1e-3_f32, 1.0, 30.0, 1e6] {
            let scene = around(&octahedron(Vec3::new(3.0, -7.0, 2.0) * size, size), "a.obj");
            let [lo, hi] = scene.bounds().unwrap();
            assert!(lo.y.abs() < 1e-5 * size && (lo.x + hi.x).abs() < 1e-5 * size && (lo.z + hi.z).abs() < 1e-5 * size);
            let (middle, radius) = ((lo + hi) * 0.5, size);
            assert_eq!(scene.cameras.len(), 3);
            for camera in &scene.cameras {
                let to_middle = middle - camera.position.get();
                let angle = (radius / to_middle.length()).asin();
                assert!(angle < camera.fov.radians() * 0.5, "{}: the sphere around it is in the picture", camera.name);
                assert!(angle > camera.fov.radians() * 0.35, "{}: and fills it", camera.name);
                assert!(camera.position.get().y > 0.0);
                let focus = camera.focus() / to_middle.length();
                assert!((0.6..1.0).contains(&focus), "sharp on the side that is seen: {focus}");
            }
            for light in &scene.lights {
                let d = (light.position.get() - middle).length();
                let strength = scene.attenuation.get() / (d + scene.attenuation.get());
                assert!((0.6..0.8).contains(&strength), "{strength} at any size");
            }
        }
    }

    #[test]
    fn names_come_from_the_file() {
        let name = |file: &str| around(&octahedron(Vec3::ZERO, 1.0), file).objects[1].name.clone();
        assert_eq!(name("Stanford bunny.obj"), "Stanford bunny");
        assert_eq!(name("Floor.obj"), "Floor 2");
        assert_eq!(name(".obj"), ".obj");
        assert_eq!(
            name(
                "
.obj"
            ),
            "Model"
        );
        assert_eq!(name(&"ä".repeat(300)).len(), 256);
    }
}
