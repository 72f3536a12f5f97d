//! Small scenes that tests share.

use glam::Vec3;
use luch_scene::*;
use std::sync::Arc;

/// A point from three coordinates.
pub fn point(x: f32, y: f32, z: f32) -> Point {
    Point::new(Vec3::new(x, y, z)).expect("coordinates in range")
}

/// A length.
pub fn size(length: f32) -> Size {
    Size::new(length).expect("a length in range")
}

/// A share.
pub fn unit(share: f32) -> Unit {
    Unit::new(share).expect("a share in range")
}

/// An object of a colour.
pub fn object(name: &str, shape: Shape, hex: &str) -> Object {
    let mut object = Object::new(name, shape);
    object.material.color = Some(Color::from_hex(hex).expect("a colour"));
    object
}

/// A sphere.
pub fn sphere(name: &str, center: Point, radius: f32, hex: &str) -> Object {
    object(name, Shape::Sphere { center, radius: size(radius) }, hex)
}

/// An unbounded wall.
pub fn wall(name: &str, point: Point, normal: Vec3, hex: &str) -> Object {
    object(name, Shape::Wall { point, normal: Direction::new(normal).expect("a direction"), size: None }, hex)
}

/// A placed mesh.
pub fn mesh(name: &str, mesh: &Arc<Mesh>, position: Point, hex: &str) -> Object {
    let instance = MeshInstance {
        mesh: Arc::clone(mesh),
        path: format!("{name}.obj"),
        position,
        rotation: Rotation::NONE,
        scale: Size::ONE,
    };
    object(name, Shape::Mesh(instance), hex)
}

/// A ball of `rings` times `2 * rings` quads around the origin, radius 1, normals of the true sphere.
pub fn ball(rings: u32) -> Arc<Mesh> {
    let columns = rings * 2;
    let mut data = MeshData::default();
    for ring in 0..=rings {
        let polar = std::f64::consts::PI * f64::from(ring) / f64::from(rings);
        for column in 0..columns {
            let turn = std::f64::consts::TAU * f64::from(column) / f64::from(columns);
            let p = [polar.sin() * turn.cos(), polar.cos(), polar.sin() * turn.sin()].map(|c| c as f32);
            data.positions.push(p);
            data.normals.push(p);
        }
    }
    for ring in 0..rings {
        for column in 0..columns {
            let at = |r: u32, c: u32| r * columns + c % columns;
            let [a, b, c, d] = [at(ring, column), at(ring, column + 1), at(ring + 1, column + 1), at(ring + 1, column)];
            if ring > 0 {
                data.triangles.push([a, b, c]);
            }
            if ring + 1 < rings {
                data.triangles.push([a, c, d]);
            }
        }
    }
    Arc::new(Mesh::new(data).expect("a ball is a mesh"))
}

/// A room with a patterned floor, a turned box, two mirror balls, a coarse mesh ball, and two coloured lights: every
/// shape, every term.
pub fn of_everything(shading: Shading) -> Scene {
    let mut scene = Scene::new("Of everything");
    scene.background = Color::from_hex("#203040").expect("a colour");
    scene.settings.shading = shading;
    let mut floor = wall("Floor", Point::ORIGIN, Vec3::Y, "#d0d0d0");
    floor.material.checker = Some(Checker { size: size(1.0), color: Color::from_hex("#404850").expect("a colour") });
    let mut back = wall("Back", point(0.0, 0.0, -4.0), Vec3::new(0.2, 0.0, 1.0), "#a08070");
    back.material.reflection = unit(0.15);
    let mut panel = object(
        "Panel",
        Shape::Wall {
            point: point(-3.0, 1.5, -1.0),
            normal: Direction::new(Vec3::new(1.0, 0.2, 0.5)).expect("a direction"),
            size: Some([size(1.5), size(2.0)]),
        },
        "#40a060",
    );
    panel.material.gloss = Some(unit(0.3));
    let mut red = sphere("Red", point(-1.3, 1.0, 0.0), 1.0, "#c83232");
    red.material.reflection = unit(0.5);
    red.material.gloss = Some(unit(0.6));
    let mut blue = sphere("Blue", point(0.4, 0.7, 1.0), 0.7, "#3264c8");
    blue.material.reflection = unit(0.3);
    blue.material.gloss = Some(unit(0.9));
    let mut cube = object(
        "Box",
        Shape::Cuboid {
            center: point(1.9, 0.6, -0.8),
            size: [size(1.0), size(1.2), size(0.8)],
            rotation: Rotation::new(Vec3::new(0.0, 30.0, 0.0)).expect("angles in range"),
        },
        "#e0c060",
    );
    cube.material.reflection = unit(0.2);
    let mut lump = mesh("Lump", &ball(6), point(-0.3, 1.6, -1.8), "#d8c8b0");
    lump.material.gloss = Some(unit(0.5));
    lump.material.reflection = unit(0.1);
    if let Shape::Mesh(instance) = &mut lump.shape {
        instance.scale = size(1.2);
        instance.rotation = Rotation::new(Vec3::new(10.0, 20.0, 30.0)).expect("angles in range");
    }
    scene.objects = vec![floor, back, panel, red, blue, cube, lump];
    let mut key = Light::new("Key", point(3.0, 5.0, 4.0));
    key.color = Color::from_hex("#fff0d8").expect("a colour");
    let mut fill = Light::new("Fill", point(-4.0, 3.0, 2.5));
    fill.intensity = NonNegative::new(0.4).expect("an intensity");
    fill.color = Color::from_hex("#c0d0ff").expect("a colour");
    scene.lights = vec![key, fill];
    scene.cameras = vec![Camera::new("Camera", point(0.3, 1.8, 6.0), Aim::At(point(0.0, 0.9, 0.0)))];
    scene
}

/// Mirrors all around, so that a ray never ends, and many lights that every one of its surfaces asks for.
pub fn hall_of_mirrors(lights: u32) -> Scene {
    let mut scene = of_everything(Shading::Phong);
    scene.objects.clear();
    for axis in 0..6 {
        let mut normal = Vec3::ZERO;
        normal[axis / 2] = if axis % 2 == 0 { 1.0 } else { -1.0 };
        let [x, y, z] = (normal * -8.0).to_array();
        let mut mirror = wall(&format!("Mirror {axis}"), point(x, y, z), normal, "#ffffff");
        mirror.material.reflection = unit(1.0);
        scene.objects.push(mirror);
    }
    scene.lights = (0..lights).map(|k| Light::new(format!("Lamp {k}"), point(0.01 * k as f32, 1.0, 0.0))).collect();
    scene
}
