//! Every form of an assignment, on a scene with awkward names.

use super::*;
use luch_scene::{Aim, Camera, Color, Light, Mesh, MeshData, MeshInstance, Object, Point, Rotation, Shape, Size};
use std::sync::Arc;

fn mesh() -> Shape {
    let data = MeshData {
        positions: vec![[0.0; 3], [3.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..MeshData::default()
    };
    Shape::Mesh(MeshInstance {
        mesh: Arc::new(Mesh::new(data).unwrap()),
        path: "a.obj".to_owned(),
        position: Point::ORIGIN,
        rotation: Rotation::NONE,
        scale: Size::ONE,
    })
}

fn scene() -> Scene {
    let mut scene = Scene::new("s");
    let one = Size::ONE;
    let ball = || Shape::Sphere { center: Point::ORIGIN, radius: one };
    let cube = Shape::Cuboid { center: Point::ORIGIN, size: [one; 3], rotation: Rotation::NONE };
    let wall = Shape::Wall { point: Point::ORIGIN, normal: luch_scene::Direction::UP, size: None };
    scene.objects = vec![
        Object::new("Cube", cube),
        Object::new("Ball", ball()),
        Object::new("Ball.color", ball()),
        Object::new("White rook (a1)", mesh()),
        Object::new("a=b", ball()),
        Object::new("Floor", wall),
    ];
    scene.lights = vec![Light::new("Lamp", Point::ORIGIN)];
    scene.cameras = vec![Camera::new("Camera 1", Point::ORIGIN, Aim::At(Point::ORIGIN))];
    scene
}

fn edited(assignment: &str) -> Scene {
    let mut scene = scene();
    if let Err(failure) = apply(assignment, &mut scene) {
        panic!("{failure}");
    }
    scene
}

fn refusal(assignment: &str) -> String {
    let mut edited = scene();
    let failure = apply(assignment, &mut edited).expect_err(assignment);
    let names = |s: &Scene| s.objects.iter().map(|o| o.name.clone()).collect::<Vec<_>>();
    assert_eq!(names(&edited), names(&scene()), "{assignment}: a refused assignment changes nothing");
    assert_eq!(failure.code, crate::exit::Code::Usage, "{assignment}");
    failure.to_string()
}

#[test]
fn the_longest_name_is_meant() {
    let gold = Color::from_hex("#ffd700");
    assert_eq!(edited("Ball.color=gold").objects[1].material.color, gold);
    assert_eq!(edited("Ball.color.color=gold").objects[2].material.color, gold);
    assert_eq!(edited("a=b.color=gold").objects[4].material.color, gold);
    assert_eq!(edited("White rook (a1).color = #FFD700").objects[3].material.color, gold);
}

#[test]
fn looks() {
    assert_eq!(edited("Cube.reflection=95%").objects[0].material.reflection.get(), 0.95);
    assert_eq!(edited("Cube.reflection=0.95").objects[0].material.reflection.get(), 0.95);
    assert_eq!(edited("Cube.gloss=1").objects[0].material.gloss.map(luch_scene::Unit::get), Some(1.0));
    assert_eq!(edited("Cube.gloss=own").objects[0].material.gloss, None);
    assert_eq!(edited("Cube.color=Yellow").objects[0].material.color, Color::from_hex("#ff0"));
    assert_eq!(edited("Cube.color=own").objects[0].material.color, None);
    let checker = edited("Floor.checker=0.5, #404040").objects[5].material.checker.unwrap();
    assert_eq!((checker.size.get(), Some(checker.color)), (0.5, Color::from_hex("#404040")));
    assert_eq!(edited("Floor.checker=off").objects[5].material.checker, None);
    assert!(edited("Cube.hidden=true").objects[0].hidden);
    assert_eq!(edited("Cube.name=Box 1").objects[0].name, "Box 1");
    assert_eq!(edited("White rook (a1).shading=flat").objects[3].shading, Some(luch_scene::Shading::Flat));
}

#[test]
fn shapes() {
    let position = |s: &Scene, i: usize| s.objects[i].shape.position().get().to_array();
    for (assignment, index) in [
        ("Cube.position=1,2.5,-3", 0),
        ("Cube.center=1, 2.5, -3", 0),
        ("Ball.center=[1,2.5,-3]", 1),
        ("White rook (a1).position=(1,2.5,-3)", 3),
        ("Floor.point=1,2.5,-3", 5),
    ] {
        assert_eq!(position(&edited(assignment), index), [1.0, 2.5, -3.0], "{assignment}");
    }
    assert!(matches!(edited("Ball.radius=2").objects[1].shape, Shape::Sphere { radius, .. } if radius.get() == 2.0));
    let sizes = |assignment| match edited(assignment).objects[0].shape {
        Shape::Cuboid { size, .. } => size.map(Size::get),
        _ => panic!("no longer a box"),
    };
    assert_eq!(sizes("Cube.side=2"), [2.0; 3]);
    assert_eq!(sizes("Cube.size=1,2,3"), [1.0, 2.0, 3.0]);
    assert_eq!(edited("Cube.rotation=0,45,0").objects[0].shape.kind(), "box");
    let Shape::Mesh(rook) = &edited("White rook (a1).scale=1.5").objects[3].shape else { panic!("no longer a mesh") };
    assert_eq!(rook.scale.get(), 1.5);
    let Shape::Wall { size, .. } = edited("Floor.size=4,5").objects[5].shape else { panic!("no longer a wall") };
    assert_eq!(size.map(|s| s.map(Size::get)), Some([4.0, 5.0]));
    assert!(
        matches!(edited("Floor.normal=0,0,1").objects[5].shape, Shape::Wall { normal, .. } if normal.unit().z == 1.0)
    );
}

#[test]
fn lights_cameras_and_the_scene() {
    assert_eq!(edited("Lamp.intensity=80%").lights[0].intensity.get(), 0.8);
    assert_eq!(edited("Lamp.intensity=2.5").lights[0].intensity.get(), 2.5);
    assert_eq!(Some(edited("Lamp.color=#f00").lights[0].color), Color::from_hex("#ff0000"));
    assert_eq!(edited("Lamp.position=0,9,0").lights[0].position.get().y, 9.0);
    assert!(edited("Lamp.hidden=yes").lights[0].hidden);
    assert_eq!(edited("Camera 1.fov=90").cameras[0].fov.get(), 90.0);
    assert_eq!(edited("Camera 1.look_at=0,1,0").cameras[0].aim, Aim::At(Point::new(glam::Vec3::Y).unwrap()));
    assert_eq!(edited("Camera 1.focal_distance=auto").cameras[0].focal_distance, None);
    assert_eq!(edited("scene.ambient=30%").ambient.get(), 0.3);
    assert_eq!(Some(edited("scene.background=navy").background), Color::from_hex("#000080"));
}

#[test]
fn refusals_say_what_there_is() {
    for (assignment, words) in [
        (
            "Kube.color=red",
            &["nothing named \"Kube\"", "did you mean \"Cube\"?", "\"White rook (a1)\"", "\"Lamp\""][..],
        ),
        ("cube.color=red", &["did you mean \"Cube\"?"]),
        ("Nobody.color=red", &["nothing named \"Nobody\"", "objects: \"Cube\""]),
        ("color=red", &["no object is named", "--set 'OBJECT.key=value'", "\"Cube\""]),
        ("Cube", &["no assignment"]),
        ("", &["no assignment"]),
        ("=", &["no object is named"]),
        ("Cube.color", &["no ="]),
        ("Cube.=1", &["a cube has no ``", "reflection"]),
        ("Cube.colr=red", &["a cube has no `colr`", "did you mean `color`?", "its keys are color,"]),
        ("Cube.radius=1", &["a cube has no `radius`", "side"]),
        ("Ball.side=1", &["a sphere has no `side`", "radius"]),
        ("Ball.shading=flat", &["a sphere has no `shading`"]),
        ("Floor.radius=1", &["a wall has no `radius`"]),
        ("White rook (a1).radius=1", &["a mesh has no `radius`", "scale"]),
        ("White rook (a1).shading=Phong", &["none of flat, gouraud, phong"]),
        ("Lamp.reflection=1", &["a light has no `reflection`", "intensity"]),
        ("Camera 1.zoom=1", &["a camera has no `zoom`", "fov"]),
        ("scene.gravity=1", &["the scene has no `gravity`", "ambient"]),
        ("Cube.reflection=95", &["95 is not a number from 0 to 1", "write 95%"]),
        ("Cube.reflection=abc", &["\"abc\" is not a number"]),
        ("Cube.reflection=nan", &["not a number from 0 to 1"]),
        ("Cube.reflection=", &["\"\" is not a number"]),
        ("Cube.gloss=-1%", &["not a number from 0 to 1"]),
        ("Cube.color=yelow", &["no colour", "did you mean \"yellow\"?"]),
        ("Cube.color=#12345", &["no colour", "#rrggbb"]),
        ("Cube.position=1,2", &["3 numbers are needed", "there are 2"]),
        ("Cube.position=1,2,inf", &["inf is not a number from -1e9 to 1e9"]),
        ("Cube.side=0", &["0 is not a length"]),
        ("Floor.normal=0,0,0", &["direction"]),
        ("Floor.checker=1", &["SIZE,COLOR"]),
        ("Cube.hidden=maybe", &["neither true nor false"]),
        ("Cube.name=Ball", &["the name \"Ball\" is taken"]),
        ("Cube.name=", &["at least one visible character"]),
        ("White rook (a1).scale=1e9", &["reach beyond"]),
        ("Camera 1.fov=180", &["180 is not an angle"]),
    ] {
        let text = refusal(assignment);
        for word in words {
            assert!(text.contains(word), "{assignment}: \"{word}\" is not in: {text}");
        }
    }
}

#[test]
fn css_colours() {
    for (name, hex) in [("tomato", "#ff6347"), ("RebeccaPurple", "#663399"), ("white", "#fff"), ("black", "#000")] {
        assert_eq!(colors::named(name), Color::from_hex(hex), "{name}");
    }
    let names: Vec<_> = colors::names().collect();
    assert!(names.is_sorted() && names.len() == 148);
}
