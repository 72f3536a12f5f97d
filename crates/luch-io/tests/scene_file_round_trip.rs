//! What is written is read back as the same scene, whatever the scene.

use glam::Vec3;
use luch_io::{Report, builtin, parse_scene, write_scene};
use luch_scene::*;
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use std::path::Path;
use std::sync::{Arc, LazyLock};

/// Paths that a mesh may have in a file, each with its mesh.
static MESHES: LazyLock<Vec<(&str, Arc<Mesh>)>> = LazyLock::new(|| {
    let data = MeshData {
        positions: vec![[-1.0, 0.0, 0.0], [1.0, 0.0, 0.5], [0.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..MeshData::default()
    };
    ["../models/knight.obj", "кони/a \"b\" \\ c.obj", "a\tb\u{7f}\u{85}\u{2028}\n.obj", ""]
        .map(|path| (path, Arc::new(Mesh::new(data.clone()).unwrap())))
        .into()
});

fn read(text: &str) -> (Scene, Report) {
    let mut report = Report::default();
    let mut load = |path: &str, _: &mut Report| {
        let known = MESHES.iter().find(|(known, _)| *known == path).or_else(|| MESHES.first());
        Ok(Arc::clone(&known.unwrap().1))
    };
    let scene = parse_scene(text.as_bytes(), Path::new("scene.toml"), &mut load, &mut report);
    (scene.unwrap_or_else(|e| panic!("{e}\n{text}")), report)
}

/// Any number of a range: common ones, any bits, and the ends.
fn number(lo: f32, hi: f32) -> BoxedStrategy<f32> {
    let clamp = move |v: f32| if v.is_finite() { v.clamp(lo, hi) } else { lo };
    prop_oneof![
        3 => (-40_i16..40).prop_map(move |v| clamp(f32::from(v) / 4.0)),
        3 => any::<u32>().prop_map(move |bits| clamp(f32::from_bits(bits))),
        2 => (0.0_f32..=1.0).prop_map(move |t| clamp(lo + (hi - lo) * t)),
        1 => prop::sample::select(vec![lo, hi, 0.1, 1.0 / 3.0, -0.0, 1e-7, 16_777_216.0, f32::MIN_POSITIVE, 1e-45])
            .prop_map(clamp),
    ]
    .boxed()
}

fn vector() -> impl Strategy<Value = Vec3> {
    [coordinate(), coordinate(), coordinate()].prop_map(Vec3::from_array)
}

fn coordinate() -> BoxedStrategy<f32> {
    number(-1e9, 1e9)
}

fn point() -> impl Strategy<Value = Point> {
    vector().prop_map(|v| Point::new(v).unwrap())
}

fn direction() -> impl Strategy<Value = Direction> {
    vector().prop_filter_map("too short", |v| Direction::new(v).ok())
}

fn rotation() -> impl Strategy<Value = Rotation> {
    prop_oneof![Just(Rotation::NONE), vector().prop_map(|v| Rotation::new(v).unwrap())]
}

fn size() -> impl Strategy<Value = Size> {
    number(1e-9, 1e9).prop_map(|v| Size::new(v).unwrap())
}

fn positive() -> impl Strategy<Value = Positive> {
    number(1e-9, 1e9).prop_map(|v| Positive::new(v).unwrap())
}

fn non_negative() -> impl Strategy<Value = NonNegative> {
    number(0.0, f32::MAX).prop_map(|v| NonNegative::new(v).unwrap())
}

fn unit() -> impl Strategy<Value = Unit> {
    number(0.0, 1.0).prop_map(|v| Unit::new(v).unwrap())
}

fn color() -> impl Strategy<Value = Color> {
    let part = || number(0.0, 1.0);
    prop_oneof![
        any::<[u8; 3]>().prop_map(Color::srgb8),
        [part(), part(), part()].prop_map(|c| Color::linear(Vec3::from_array(c)).unwrap()),
    ]
}

/// A name that no other thing has, for the number in it.
fn name(number: usize) -> impl Strategy<Value = String> {
    let odd = prop::sample::select(vec![
        "\"", "\\", "'", "\"\"\"", "#", "=", "[[x]]", "я", "♞", "\u{2028}", "e\u{301}", "\u{feff}", " ",
    ]);
    (vec(prop_oneof![odd.prop_map(str::to_owned), "[a-zA-Z ]{0,9}".boxed()], 0..6), any::<bool>()).prop_map(
        move |(parts, front)| {
            let word = parts.concat();
            if front { format!("{number}{word}") } else { format!("{word}{number}.") }
        },
    )
}

fn shape() -> impl Strategy<Value = Shape> {
    let wall_size = option::of([size(), size()]);
    let mesh = prop::sample::select(MESHES.clone());
    prop_oneof![
        (point(), size()).prop_map(|(center, radius)| Shape::Sphere { center, radius }),
        (point(), size(), rotation()).prop_map(|(center, side, rotation)| Shape::Cuboid {
            center,
            size: [side; 3],
            rotation
        }),
        (point(), [size(), size(), size()], rotation()).prop_map(|(center, size, rotation)| Shape::Cuboid {
            center,
            size,
            rotation
        }),
        (point(), direction(), wall_size).prop_map(|(point, normal, size)| Shape::Wall { point, normal, size }),
        (mesh, point(), rotation(), size()).prop_map(|((path, mesh), position, rotation, scale)| {
            Shape::Mesh(MeshInstance { mesh, path: path.to_owned(), position, rotation, scale })
        }),
    ]
}

fn shading() -> impl Strategy<Value = Shading> {
    prop::sample::select(Shading::ALL.to_vec())
}

fn object(number: usize) -> impl Strategy<Value = Object> {
    let checker = (size(), color()).prop_map(|(size, color)| Checker { size, color });
    let material = (option::of(color()), unit(), option::of(unit()), option::of(checker))
        .prop_map(|(color, reflection, gloss, checker)| Material { color, reflection, gloss, checker });
    (name(number), shape(), material, option::of(shading()), any::<bool>())
        .prop_map(|(name, shape, material, shading, hidden)| Object { name, shape, material, shading, hidden })
        .prop_filter("reaches too far", Object::is_within_limits)
}

fn light(number: usize) -> impl Strategy<Value = Light> {
    (name(number), point(), non_negative(), color(), any::<bool>())
        .prop_map(|(name, position, intensity, color, hidden)| Light { name, position, intensity, color, hidden })
}

fn camera(number: usize) -> impl Strategy<Value = Camera> {
    let aim = prop_oneof![point().prop_map(Aim::At), direction().prop_map(Aim::Along)];
    let fov = self::number(0.01, 179.0).prop_map(|v| FieldOfView::new(v).unwrap());
    (name(number), point(), aim, fov, option::of(positive()), non_negative()).prop_map(
        |(name, position, aim, fov, focal_distance, lens_radius)| Camera {
            name,
            position,
            aim,
            fov,
            focal_distance,
            lens_radius,
        },
    )
}

fn settings() -> impl Strategy<Value = RenderSettings> {
    let sampling = || {
        (any::<bool>(), 1..=RayCount::MAX).prop_map(|(on, rays)| Sampling { on, rays: RayCount::new(rays).unwrap() })
    };
    let side = || 1..=ImageSize::MAX_SIDE;
    (side(), side(), 0..=RenderSettings::MAX_DEPTH, sampling(), sampling(), shading()).prop_map(
        |(width, height, depth, antialiasing, depth_of_field, shading)| RenderSettings {
            size: ImageSize::new(width, height).unwrap(),
            depth,
            antialiasing,
            depth_of_field,
            shading,
        },
    )
}

fn scene() -> impl Strategy<Value = Scene> {
    let lights = (0..3_usize).prop_flat_map(|n| (100..100 + n).map(light).collect::<Vec<_>>());
    // A scene file without cameras gets some, so there is one at least.
    let cameras = (1..4_usize).prop_flat_map(|n| (0..n).map(camera).collect::<Vec<_>>());
    let objects = (0..6_usize).prop_flat_map(|n| (0..n).map(object).collect::<Vec<_>>());
    (name(0), color(), non_negative(), positive(), lights, cameras, objects, settings()).prop_map(
        |(name, background, ambient, attenuation, lights, cameras, objects, settings)| Scene {
            name,
            background,
            ambient,
            attenuation,
            lights,
            cameras,
            objects,
            settings,
        },
    )
}

/// The bits of every number: equality of floats would take -0.0 for 0.0.
fn bits(scene: &Scene) -> String {
    format!("{scene:?}")
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1_000, failure_persistence: None, ..ProptestConfig::default() })]
    #[test]
    fn any_scene_is_written_and_read_back(scene in scene()) {
        let text = write_scene(&scene);
        let (again, _) = read(&text);
        prop_assert_eq!(&again, &scene, "{}", text);
        prop_assert_eq!(bits(&again), bits(&scene));
        prop_assert_eq!(write_scene(&again), text, "writing is stable");
    }
}

#[test]
fn every_f32_is_written_in_digits_that_say_it() {
    // Each exponent with mantissas that are awkward: the ends, the middle, and some between.
    for exponent in 0..0xff_u32 {
        for mantissa in [0, 1, 2, 0x2a_aaaa, 0x40_0000, 0x55_5555, 0x7f_fffe, 0x7f_ffff] {
            let v = f32::from_bits(exponent << 23 | mantissa);
            let mut scene = Scene::new("n");
            scene.ambient = NonNegative::new(v).unwrap();
            let (again, _) = read(&write_scene(&scene));
            assert_eq!(again.ambient.get().to_bits(), v.to_bits(), "{v:e}");
        }
    }
}

#[test]
fn the_built_in_scenes_are_read_without_a_warning_and_round_trip() {
    for id in builtin::ids() {
        let (scene, report) = read(builtin::text(id).unwrap());
        assert_eq!(report.lines(), [""; 0], "{id}");
        let (again, _) = read(&write_scene(&scene));
        assert_eq!(again, scene, "{id}");
        assert_eq!(scene.cameras.len(), 3, "{id}");
        assert!(!scene.lights.is_empty(), "{id}");
    }
    let files = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../../assets/scenes")).unwrap();
    let mut ids: Vec<String> =
        files.map(|f| f.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    ids.sort();
    let mut built_in: Vec<&str> = builtin::ids().collect();
    built_in.sort_unstable();
    assert_eq!(ids, built_in, "every scene of assets/scenes is built in");
}

#[test]
fn the_first_scene_has_what_the_functional_tests_change() {
    let (scene, _) = read(builtin::text("two-spheres").unwrap());
    let mirrors: Vec<_> = scene.objects.iter().filter(|o| matches!(o.shape, Shape::Sphere { .. })).collect();
    assert_eq!(mirrors.len(), 2);
    for sphere in mirrors {
        assert_eq!(sphere.material.reflection.get(), 0.5, "{}", sphere.name);
        assert!(sphere.material.gloss.unwrap().get() > 0.3, "{}", sphere.name);
    }
    let [light] = scene.lights.as_slice() else { panic!("one light") };
    assert!(light.intensity.get() < 0.8, "80 % makes it brighter");
    assert!(!scene.settings.antialiasing.on && !scene.settings.depth_of_field.on);
    let (one, _) = read(builtin::text("one-sphere").unwrap());
    assert_eq!(
        (one.objects.len() + 1, &one.cameras, &one.lights),
        (scene.objects.len(), &scene.cameras, &scene.lights)
    );
}
