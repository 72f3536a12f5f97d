//! What good scene files may look like, and what they get where they say nothing.

use glam::Vec3;
use luch_io::{Error, ErrorKind, Place, Report, parse_scene, read_scene};
use luch_scene::*;
use std::path::Path;
use std::sync::Arc;

fn triangle() -> Arc<Mesh> {
    let data = MeshData {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..MeshData::default()
    };
    Arc::new(Mesh::new(data).unwrap())
}

fn read(text: &str) -> (Scene, Vec<String>) {
    let mut report = Report::default();
    let scene = parse_scene(text.as_bytes(), Path::new("a/Still life.toml"), &mut |_, _| Ok(triangle()), &mut report);
    (scene.unwrap_or_else(|e| panic!("{e}")), report.lines())
}

#[test]
fn a_file_that_says_only_its_format_is_an_empty_scene_with_warnings() {
    for text in ["luch = 1", "luch = 1\n", "\u{feff}luch = 1\n", "# x\r\n\r\nluch = 1 # y\r\n", "\"luch\" = 1"] {
        let (scene, warnings) = read(text);
        let cameras = scene.cameras.clone();
        let expected = Scene { cameras: cameras.clone(), ..Scene::new("Still life") };
        assert_eq!(scene, expected, "{text:?}");
        assert_eq!(cameras.iter().map(|c| c.name.as_str()).collect::<Vec<_>>(), ["Camera 1", "Camera 2", "Camera 3"]);
        assert_eq!(
            warnings,
            [
                "the scene has no camera: a/Still life.toml: three are placed around it",
                "the scene has no light: a/Still life.toml: only ambient light shows its objects",
                "the scene has no object: a/Still life.toml: the picture shows the background only",
            ]
        );
    }
}

/// The example of the format's description, with every key.
const WHOLE: &str = r##"
luch = 1
name = "Knight, cube and sphere"
background = "#10141c"
ambient = 0.12             # I_a
attenuation = 4.0          # K
[[light]]
name = "Lamp"
position = [3.0, 6.0, 4.0]
intensity = 0.8
color = "#ffffff"
[[camera]]
name = "Camera 1"
position = [0.0, 2.0, 7.0]
look_at = [0.0, 1.0, 0.0]
fov = 45.0
focal_distance = 6.0
lens_radius = 0.1
[[camera]]
position = [0, 2, 7]
direction = [0, -0.14, -1]
[[object]]
name = "Sphere"
sphere = { center = [-1.5, 1.0, 0.0], radius = 1.0 }
color = "#c83232"
reflection = 0.5
gloss = 0.6
[[object]]
name = "Cube"
cube = { center = [1.5, 0.5, 0.0], side = 1.0 }
color = "#3264c8"
[[object]]
box = { center = [1.5, 0.5, 0.0], size = [1, 2, 3] }
rotation = [0, 45, 0]
color = [0.25, 0.5, 1]
hidden = true
[[object]]
name = "Floor"
wall = { point = [0.0, 0.0, 0.0], normal = [0.0, 1.0, 0.0] }
color = "#d0d0d0"
pattern = { checker = { size = 1.0, color = "#404040" } }
[[object]]
wall = { point = [0.0, 0.0, -3.0], normal = [0.0, 0.0, 1.0], size = [4, 3] }
[[object]]
name = "Knight"
mesh = "../models/knight.obj"
position = [0.0, 0.0, 0.0]
rotation = [0.0, 30.0, 0.0]
scale = 1.5
shading = "gouraud"
color = "#e8d8b0"
[render]
size = [640, 480]
depth = 7
antialiasing = { on = true, rays = 16 }
depth_of_field = { rays = 32 }
shading = "flat"
"##;

#[test]
fn every_key_arrives_where_it_belongs() {
    let (scene, warnings) = read(WHOLE);
    assert_eq!(warnings, [""; 0]);
    assert_eq!((scene.name.as_str(), scene.background), ("Knight, cube and sphere", Color::srgb8([0x10, 0x14, 0x1c])));
    assert_eq!((scene.ambient.get(), scene.attenuation.get()), (0.12, 4.0));
    let light = &scene.lights[0];
    assert_eq!(
        (light.name.as_str(), light.position.get(), light.intensity.get()),
        ("Lamp", Vec3::new(3.0, 6.0, 4.0), 0.8)
    );
    let [one, two] = scene.cameras.as_slice() else { panic!("two cameras") };
    assert_eq!((one.fov.get(), one.focal_distance.unwrap().get(), one.lens_radius.get()), (45.0, 6.0, 0.1));
    assert_eq!(one.aim, Aim::At(Point::new(Vec3::Y).unwrap()));
    assert_eq!(two.aim, Aim::Along(Direction::new(Vec3::new(0.0, -0.14, -1.0)).unwrap()));
    assert_eq!((two.name.as_str(), two.focal_distance, two.fov), ("Camera 2", None, FieldOfView::DEFAULT));

    let names: Vec<_> = scene.objects.iter().map(|o| (o.name.as_str(), o.shape.kind())).collect();
    let expected = [
        ("Sphere", "sphere"),
        ("Cube", "cube"),
        ("Box 1", "box"),
        ("Floor", "wall"),
        ("Wall 1", "wall"),
        ("Knight", "mesh"),
    ];
    assert_eq!(names, expected);
    let [sphere, cube, bar, floor, wall, knight] = scene.objects.as_slice() else { panic!("six objects") };
    assert_eq!((sphere.material.reflection.get(), sphere.material.gloss.unwrap().get()), (0.5, 0.6));
    assert_eq!((cube.material.reflection, cube.material.gloss, cube.hidden), (Unit::ZERO, None, false));
    assert_eq!(bar.material.color, Some(Color::linear(Vec3::new(0.25, 0.5, 1.0)).unwrap()));
    assert!(bar.hidden);
    assert_eq!(floor.material.checker.unwrap().color, Color::srgb8([0x40; 3]));
    assert_eq!(wall.material.color, None);
    let Shape::Wall { size: Some([width, height]), .. } = wall.shape else { panic!("bounded") };
    assert_eq!((width.get(), height.get()), (4.0, 3.0));
    let Shape::Mesh(instance) = &knight.shape else { panic!("a mesh") };
    assert_eq!((instance.path.as_str(), instance.scale.get()), ("../models/knight.obj", 1.5));
    assert_eq!((instance.rotation.degrees().y, knight.shading), (30.0, Some(Shading::Gouraud)));

    let settings = scene.settings;
    assert_eq!((settings.size.width(), settings.size.height(), settings.depth), (640, 480, 7));
    assert_eq!((settings.antialiasing.on, settings.antialiasing.rays.get()), (true, 16));
    assert_eq!((settings.depth_of_field.on, settings.depth_of_field.rays.get()), (false, 32));
    assert_eq!(settings.shading, Shading::Flat);
}

#[test]
fn the_ways_that_toml_has_to_say_one_thing_say_it() {
    let one = "luch = 1\n[[object]]\nname = \"A\"\nwall = { point = [0, 0, 0], normal = [0, 1, 0] }\npattern = { checker = { size = 2, color = \"#fff\" } }\n";
    for other in [
        "luch = 1\n[[object]]\nname = 'A'\nwall.point = [0, 0, 0]\nwall.normal = [0, 1, 0]\n[object.pattern.checker]\nsize = 2.0\ncolor = [1, 1, 1]\n",
        "luch = 1\nobject = [{ name = \"\\u0041\", wall = { point = [0, 0, 0], normal = [0, 1, 0] }, pattern.checker = { size = 0x2, color = \"#ffffff\" } }]\n",
        "luch = 1\r\n  [[ object ]]  # it\r\n\"name\" = \"\"\"\r\nA\"\"\"\r\n[object.wall]\r\npoint = [\r\n0, # x\r\n0, 0,\r\n]\r\nnormal = [-0, 1e0, 0.0_0]\r\n[object.pattern]\r\nchecker = { size = 2e+0, color = \"#FFF\" }\r\n",
    ] {
        let (a, b) = (read(one).0, read(other).0);
        assert_eq!(a, b, "{other}");
    }
}

#[test]
fn a_name_that_the_file_gives_is_never_taken_by_one_that_it_does_not() {
    let sphere = "sphere = { center = [0, 1, 0], radius = 1 }\n";
    let text = format!(
        "luch = 1\n[[object]]\n{sphere}[[object]]\nname = \"Sphere 1\"\n{sphere}[[light]]\nposition = [0, 9, 0]\n[[object]]\nname = \"Light 1\"\n{sphere}[[object]]\n{sphere}"
    );
    let (scene, _) = read(&text);
    assert_eq!(
        scene.objects.iter().map(|o| o.name.as_str()).collect::<Vec<_>>(),
        ["Sphere 2", "Sphere 1", "Light 1", "Sphere 3"]
    );
    assert_eq!(scene.lights[0].name, "Light 2");
}

#[test]
fn numbers_are_read_to_the_nearest_f32() {
    for (text, value) in [
        ("16777217", 16_777_216.0),
        ("1_000", 1_000.0),
        ("0x10", 16.0),
        ("0o17", 15.0),
        ("0b101", 5.0),
        ("+0.1", 0.1),
        ("1e-50", 0.0),
        ("3.4028235e38", f32::MAX),
        // Halfway between two f32 but for the last digit: by way of f64 this rounds to the other side.
        ("1.00000017881393432617187499", 1.000_000_1),
    ] {
        let (scene, _) = read(&format!("luch = 1\nambient = {text}\n"));
        assert_eq!(scene.ambient.get(), value, "{text}");
    }
}

#[test]
fn odd_but_harmless_things_are_warned_of() {
    let text = "luch = 1\n[[light]]\nposition = [0, 1, 0]\n[[camera]]\nposition = [0, 2, 7]\nlook_at = [0, 2, 7]\n\
                [[object]]\nsphere = { center = [0, 1, 0], radius = 1 }\nshading = \"flat\"\n";
    let (_, warnings) = read(text);
    assert_eq!(
        warnings,
        [
            "a camera looks at its own place: a/Still life.toml: \"Camera 1\" looks along -z instead",
            "a shading model has no effect here: a/Still life.toml:7: a sphere is exact",
        ]
    );
}

#[test]
fn a_mesh_is_asked_for_once_and_after_the_text_is_checked() {
    let object = "[[object]]\nmesh = \"a.obj\"\n";
    let text = format!("luch = 1\n{object}{object}{object}");
    let mut asked = Vec::new();
    let mut load = |path: &str, report: &mut Report| {
        asked.push(path.to_owned());
        report.warn("lines are skipped", || path.to_owned());
        Ok(triangle())
    };
    let mut report = Report::default();
    let scene = parse_scene(text.as_bytes(), Path::new("s.toml"), &mut load, &mut report).unwrap();
    assert_eq!((asked, report.count("lines are skipped")), (vec!["a.obj".to_owned()], 1));
    assert_eq!(scene.objects[2].name, "Mesh 3");
    let wrong = format!("luch = 1\n{object}[[object]]\n");
    let mut never = |_: &str, _: &mut Report| -> Result<Arc<Mesh>, Error> { panic!("the text is wrong") };
    assert!(parse_scene(wrong.as_bytes(), Path::new("s.toml"), &mut never, &mut Report::default()).is_err());
}

#[test]
fn an_error_inside_a_model_keeps_its_place_and_one_about_its_name_is_shown_in_the_scene() {
    let text = b"luch = 1\n[[object]]\nmesh = \"a.obj\"\n";
    let fail = |error: Error| {
        parse_scene(text, Path::new("s.toml"), &mut |_, _| Err(error.clone()), &mut Report::default()).unwrap_err()
    };
    let outside = fail(Error::new(ErrorKind::Forbidden, "a.obj", "lies outside the scene's folder").hint("copy it"));
    assert_eq!(
        outside.to_string(),
        "s.toml:3:8: a.obj: lies outside the scene's folder\n   |\n 3 | mesh = \"a.obj\"\n   |        ^^^^^^^\nhint: copy it"
    );
    assert_eq!(outside.exit_code(), 4);
    let place = Place::Text { line: 7, column: 1, source: "f 1 2 9".into(), length: 7 };
    let inside = Error::new(ErrorKind::Malformed, "a.obj", "there is no vertex 9").at(place);
    assert_eq!(fail(inside.clone()), inside);
}

#[test]
fn files_that_cannot_be_read_say_why() {
    let read = |path: &str| {
        let error = read_scene(Path::new(path), &mut |_, _| Ok(triangle()), &mut Report::default()).unwrap_err();
        (error.exit_code(), error.text)
    };
    assert_eq!(read("src").0, 4);
    assert_eq!(read("no/such/file.toml").0, 4);
    assert_eq!(read("").0, 4);
    if cfg!(unix) {
        assert_eq!(read("/dev/zero").0, 4, "a device would be read for ever");
    }
}
