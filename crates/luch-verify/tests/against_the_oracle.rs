//! Whole pictures against the brute-force f64 renderer, and against values worked out by hand.

use glam::Vec3;
use luch_scene::*;
use luch_verify::scenes::{ball, object, of_everything, point, size, sphere, unit, wall};
use luch_verify::{job, oracle, picture};

/// The share of pixels that differ by more than `tolerance` in any channel.
fn share_of_different(a: &[f32], b: &[f32], tolerance: f32) -> f64 {
    let differs = |(p, q): (&[f32], &[f32])| p.iter().zip(q).any(|(p, q)| (p - q).abs() > tolerance * (1.0 + q.abs()));
    let different = a.chunks_exact(3).zip(b.chunks_exact(3)).filter(|&pair| differs(pair)).count();
    different as f64 / (a.len() / 3) as f64
}

#[test]
fn the_picture_of_everything_is_the_oracles() {
    for shading in Shading::ALL {
        let scene = of_everything(shading);
        let job = job(&scene, 0, [160, 120], 1);
        let different = share_of_different(&picture(&scene, &job), &oracle::picture(&scene, &job), 1e-4);
        // Where an edge or a shadow's border runs through the middle of a pixel, f32 and f64 may fall on either side.
        assert!(different < 1e-3, "{}: {different}", shading.word());
    }
}

#[test]
fn the_depth_limit_is_the_oracles() {
    let scene = of_everything(Shading::Phong);
    for depth in [0, 1, 2, 3, 9] {
        let mut job = job(&scene, 0, [80, 60], 1);
        job.depth = depth;
        let different = share_of_different(&picture(&scene, &job), &oracle::picture(&scene, &job), 1e-4);
        assert!(different < 1e-3, "depth {depth}: {different}");
    }
}

/// A floor of colour 0.5 lit from height 3, seen from straight above; one pixel.
fn floor_below_a_lamp(intensity: f32, gloss: f32) -> Scene {
    let mut scene = Scene::new("Floor");
    scene.ambient = NonNegative::new(0.1).unwrap();
    scene.attenuation = Positive::new(6.0).unwrap();
    let mut floor = wall("Floor", Point::ORIGIN, Vec3::Y, "#ffffff");
    floor.material.color = Some(Color::linear(Vec3::splat(0.5)).unwrap());
    floor.material.gloss = Some(unit(gloss));
    scene.objects.push(floor);
    let mut lamp = Light::new("Lamp", point(0.0, 3.0, 0.0));
    lamp.intensity = NonNegative::new(intensity).unwrap();
    scene.lights.push(lamp);
    let down = Aim::Along(Direction::new(Vec3::NEG_Y).unwrap());
    scene.cameras.push(Camera::new("Above", point(0.0, 2.0, 0.0), down));
    scene
}

fn only_pixel(scene: &Scene) -> f32 {
    picture(scene, &job(scene, 0, [1, 1], 1))[0]
}

#[test]
fn the_lighting_sum_is_what_the_hand_gets() {
    // d = 3, K = 6: falloff 6 / 9. cos theta = 1, cos alpha = 1.
    // 0.1 * 0.5 + (0.5 * 1 + 0) * 0.75 * 2/3 = 0.05 + 0.25
    assert!((only_pixel(&floor_below_a_lamp(0.75, 0.0)) - 0.3).abs() < 1e-6);
    // With gloss 0.4, k_s = 0.4: the mirror direction is the viewer's, so 0.4 * 1 * 0.5 more.
    assert!((only_pixel(&floor_below_a_lamp(0.75, 0.4)) - 0.5).abs() < 1e-6);
    // A light of intensity 1 gives one half at d = K.
    let mut scene = floor_below_a_lamp(1.0, 0.0);
    scene.attenuation = Positive::new(3.0).unwrap();
    assert!((only_pixel(&scene) - (0.05 + 0.25)).abs() < 1e-6);
    // Seen from the other side: surfaces are two-sided, but the lamp is behind, so only the ambient term stays.
    let mut scene = floor_below_a_lamp(1.0, 0.5);
    scene.cameras[0].position = point(0.0, -2.0, 0.0);
    scene.cameras[0].aim = Aim::Along(Direction::UP);
    assert!((only_pixel(&scene) - 0.05).abs() < 1e-7);
    // In the shadow of a ball between lamp and floor, the same.
    let mut scene = floor_below_a_lamp(1.0, 0.5);
    scene.objects.push(sphere("Ball", point(0.0, 2.5, 0.0), 0.25, "#ffffff"));
    assert!((only_pixel(&scene) - 0.05).abs() < 1e-7);
}

#[test]
fn mirrors_mix_as_written() {
    // A mirror of reflection 0.4 sees the background 0.25 straight above: 0.6 * local + 0.4 * 0.25.
    let mut scene = floor_below_a_lamp(0.75, 0.0);
    scene.background = Color::linear(Vec3::splat(0.25)).unwrap();
    scene.objects[0].material.reflection = unit(0.4);
    assert!((only_pixel(&scene) - (0.6 * 0.3 + 0.4 * 0.25)).abs() < 1e-6);
    // Depth 1: the mirror ray is not followed, and shows the background all the same.
    scene.objects.push(wall("Ceiling", point(0.0, 5.0, 0.0), Vec3::NEG_Y, "#ffffff"));
    scene.settings.depth = 1;
    assert!((only_pixel(&scene) - (0.6 * 0.3 + 0.4 * 0.25)).abs() < 1e-6);
    scene.settings.depth = 2;
    assert!((only_pixel(&scene) - (0.6 * 0.3 + 0.4 * 0.25)).abs() > 0.05);
}

#[test]
fn a_white_closed_room_under_ambient_light_alone_is_white_everywhere() {
    let mut scene = of_everything(Shading::Phong);
    scene.lights.clear();
    scene.ambient = NonNegative::ONE;
    scene.background = Color::WHITE;
    for object in &mut scene.objects {
        object.material.color = Some(Color::WHITE);
        object.material.checker = None;
    }
    let white = picture(&scene, &job(&scene, 0, [80, 60], 4));
    assert!(white.iter().all(|v| (v - 1.0).abs() < 1e-6));
}

#[test]
fn no_scale_shows_acne_or_leaks() {
    let reference = {
        let scene = of_everything(Shading::Phong);
        picture(&scene, &job(&scene, 0, [120, 90], 1))
    };
    for scale in [1e-3_f32, 0.1, 30.0, 1e3, 1e6] {
        let scene = scaled(of_everything(Shading::Phong), scale);
        let different = share_of_different(&picture(&scene, &job(&scene, 0, [120, 90], 1)), &reference, 2e-3);
        assert!(different < 2e-3, "scale {scale}: {different}");
    }
}

/// The same scene in other units.
fn scaled(mut scene: Scene, by: f32) -> Scene {
    let place = |p: Point| Point::new(p.get() * by).unwrap();
    scene.attenuation = Positive::new(scene.attenuation.get() * by).unwrap();
    for light in &mut scene.lights {
        light.position = place(light.position);
    }
    for camera in &mut scene.cameras {
        camera.position = place(camera.position);
        if let Aim::At(target) = camera.aim {
            camera.aim = Aim::At(place(target));
        }
    }
    for object in &mut scene.objects {
        object.shape.set_position(place(object.shape.position()));
        if let Some(checker) = &mut object.material.checker {
            checker.size = size(checker.size.get() * by);
        }
        match &mut object.shape {
            Shape::Sphere { radius, .. } => *radius = size(radius.get() * by),
            Shape::Cuboid { size: sides, .. } => *sides = sides.map(|s| size(s.get() * by)),
            Shape::Wall { size: Some(sides), .. } => *sides = sides.map(|s| size(s.get() * by)),
            Shape::Wall { .. } => {}
            Shape::Mesh(instance) => instance.scale = size(instance.scale.get() * by),
        }
    }
    scene
}

/// A coarse ball lit from the side: without care, the flat faces shadow each other in a jagged band where the light
/// grazes the smooth surface that they stand for.
#[test]
fn smooth_meshes_have_no_jagged_shadow_border() {
    let mut scene = Scene::new("Terminator");
    scene.ambient = NonNegative::ZERO;
    scene.objects.push(luch_verify::scenes::mesh("Ball", &ball(8), Point::ORIGIN, "#ffffff"));
    scene.lights.push(Light::new("Lamp", point(60.0, 5.0, 10.0)));
    scene.cameras.push(Camera::new("Camera", point(0.0, 0.0, 4.0), Aim::At(Point::ORIGIN)));
    let job = job(&scene, 0, [200, 200], 1);
    let lit = picture(&scene, &job);
    let normals = picture(&scene, &luch_render::RenderJob { integrator: luch_render::Integrator::Normal, ..job });
    let to_lamp = Vec3::new(60.0, 5.0, 10.0).normalize_or_zero();
    let (mut facing, mut black) = (0, 0);
    for (pixel, normal) in lit.chunks_exact(3).zip(normals.chunks_exact(3)) {
        let normal = Vec3::from_slice(normal) * 2.0 - 1.0;
        if normal.length() > 0.9 && normal.length() < 1.1 && normal.dot(to_lamp) > 0.05 {
            facing += 1;
            black += i32::from(pixel[0] == 0.0);
        }
    }
    assert!(facing > 5000, "{facing}");
    assert_eq!(black, 0, "of {facing} pixels whose normal faces the lamp");
}

/// A coarse ball before a lamp in each shading model: its red channel, 240 pixels square.
fn coarse_balls(gloss: f32) -> [Vec<f32>; 3] {
    Shading::ALL.map(|shading| {
        let mut scene = Scene::new("Highlight");
        scene.settings.shading = shading;
        let mut lump = luch_verify::scenes::mesh("Ball", &ball(5), Point::ORIGIN, "#808080");
        lump.material.gloss = Some(unit(gloss));
        scene.objects.push(lump);
        scene.lights.push(Light::new("Lamp", point(2.0, 3.0, 5.0)));
        scene.cameras.push(Camera::new("Camera", point(0.0, 0.0, 4.0), Aim::At(Point::ORIGIN)));
        picture(&scene, &job(&scene, 0, [240, 240], 1)).chunks_exact(3).map(|c| c[0]).collect()
    })
}

#[test]
fn a_coarse_balls_highlight_is_crisp_under_phong_and_smeared_under_gouraud() {
    let [_, gouraud, phong] = coarse_balls(0.7);
    let peak = |p: &[f32]| p.iter().copied().fold(0.0, f32::max);
    // The true highlight lies between vertices: Phong finds its peak, Gouraud blends the weaker light of the corners.
    assert!(peak(&phong) > 1.3 * peak(&gouraud), "phong {} gouraud {}", peak(&phong), peak(&gouraud));
}

#[test]
fn facets_show_under_flat_shading_only() {
    // The largest step between neighbours in the lit middle of the ball.
    let step = |p: &Vec<f32>| {
        let rows = (90..150_usize).flat_map(|y| (90..150_usize).map(move |x| y * 240 + x));
        rows.map(|i| (p[i] - p[i + 1]).abs()).fold(0.0, f32::max)
    };
    let [flat, gouraud, phong] = coarse_balls(0.0).each_ref().map(step);
    assert!(flat > 5.0 * gouraud && flat > 5.0 * phong, "flat {flat}, gouraud {gouraud}, phong {phong}");
}

#[test]
fn a_box_turned_by_a_quarter_is_the_box() {
    let make = |degrees: f32| {
        let mut scene = of_everything(Shading::Phong);
        let turned = Rotation::new(Vec3::new(0.0, degrees, 0.0)).unwrap();
        let shape = Shape::Cuboid { center: point(1.9, 0.6, -0.8), size: [size(1.0); 3], rotation: turned };
        scene.objects[5] = object("Box", shape, "#e0c060");
        picture(&scene, &job(&scene, 0, [80, 60], 1))
    };
    assert!(share_of_different(&make(90.0), &make(0.0), 1e-5) < 1e-3);
}
