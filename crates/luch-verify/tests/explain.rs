//! The account of a pixel is the arithmetic that made it: sums and factors, bit for bit.

use glam::Vec3;
use luch_render::explain::{LightAccount, LightFactors, PixelAccount, RayEnd, RayKind, Visibility, explain};
use luch_render::{CompiledScene, MeshTrees, Progress, RenderJob, compile, render};
use luch_scene::{NonNegative, Scene, Shading};
use luch_verify::{built_in, built_in_ids, job, sampling, scenes};

const SIZE: [u32; 2] = [160, 120];

/// Every built-in scene under each shading model that its meshes can have, and a scene of everything.
fn all_scenes() -> Vec<Scene> {
    let mut all = Vec::new();
    for id in built_in_ids() {
        for shading in Shading::ALL {
            let mut scene = built_in(id);
            let meshes = scene.objects.iter().any(|o| matches!(o.shape, luch_scene::Shape::Mesh(_)));
            if !meshes && shading != Shading::Phong {
                continue;
            }
            scene.settings.shading = shading;
            scene.objects.iter_mut().for_each(|object| object.shading = None);
            all.push(scene);
        }
    }
    all.extend(Shading::ALL.map(scenes::of_everything));
    for camera in all.iter_mut().flat_map(|scene| &mut scene.cameras) {
        camera.lens_radius = NonNegative::new(0.1).unwrap();
    }
    all
}

/// Explains every pixel on two threads, and hands each account to `check` with the picture's pixel.
fn for_every_pixel(scene: &Scene, job: &RenderJob, check: impl Fn(&CompiledScene, &PixelAccount, [f32; 3]) + Sync) {
    let compiled = compile(scene, &mut MeshTrees::new(), 2);
    let linear = render(&compiled, job, &Progress::new()).unwrap().linear();
    let (width, height) = (job.size.width(), job.size.height());
    std::thread::scope(|scope| {
        for half in 0..2 {
            let (compiled, linear, check) = (&compiled, &linear, &check);
            scope.spawn(move || {
                for y in (half..height).step_by(2) {
                    for x in 0..width {
                        let at = (y * width + x) as usize * 3;
                        let account = explain(compiled, job, x, y).unwrap();
                        check(compiled, &account, [linear[at], linear[at + 1], linear[at + 2]]);
                    }
                }
            });
        }
    });
}

fn bits<const N: usize>(values: [f32; N]) -> [u32; N] {
    values.map(f32::to_bits)
}

fn assert_is_the_picture(scene: &Scene, account: &PixelAccount, pixel: [f32; 3]) {
    let place = || format!("{} ({:?}) {},{}", scene.name, scene.settings.shading, account.x, account.y);
    assert_eq!(bits(account.pixel), bits(pixel), "{}: the pixel", place());
    assert_eq!(bits(account.sum()), bits(pixel), "{}: the sum of the account", place());
}

#[test]
fn the_sum_of_the_account_is_the_picture_bit_for_bit() {
    for scene in all_scenes() {
        let job = job(&scene, 0, SIZE, 1);
        for_every_pixel(&scene, &job, |_, account, pixel| assert_is_the_picture(&scene, account, pixel));
    }
}

#[test]
fn the_sum_is_the_picture_with_antialiasing_and_depth_of_field_too() {
    for scene in all_scenes() {
        let cameras = 0..scene.cameras.len();
        // The first at full size, the others small: what they differ in is not where a pixel lies.
        for (camera, (size, antialiasing, blur)) in cameras.zip([(SIZE, 2, 3), ([54, 40], 5, 1), ([54, 40], 1, 3)]) {
            let mut job = job(&scene, camera, size, antialiasing);
            job.depth_of_field = sampling(blur);
            for_every_pixel(&scene, &job, |_, account, pixel| {
                assert_is_the_picture(&scene, account, pixel);
                assert_eq!(account.samples.len(), job.rays_per_pixel() as usize);
            });
        }
    }
}

/// x x' + y y' + z z', in the order of the kernels.
fn dot(a: Vec3, b: Vec3) -> f32 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// The factors follow from each other as the notes on light say, bit for bit.
fn assert_factors(account: &PixelAccount, light: &LightAccount, f: &LightFactors, [k_s, n]: [f32; 2]) {
    let (k, source) = (account.setting.attenuation, account.setting.lights.iter().find(|s| s.light == light.light));
    let source = source.unwrap();
    assert_eq!(bits([f.falloff, f.strength]), bits([k / (f.distance + k), f.falloff * source.intensity]));
    assert_eq!(f.cos_theta.to_bits(), dot(f.normal, f.to_light).to_bits());
    let lit = f.cos_theta > 0.0;
    assert_eq!(f.diffuse.to_bits(), if lit { f.strength * f.cos_theta } else { 0.0 }.to_bits());
    let turned = f.normal * (f.cos_theta * 2.0) - f.to_light;
    assert_eq!(bits(f.mirrored.to_array()), bits(turned.to_array()));
    let cos_alpha = dot(f.mirrored, f.to_viewer).clamp(0.0, 1.0);
    assert_eq!(f.cos_alpha, cos_alpha);
    let glossy = lit && k_s > 0.0 && cos_alpha > 0.0;
    assert_eq!(f.specular.to_bits(), if glossy { f.strength * k_s * f.power } else { 0.0 }.to_bits());
    let power = if glossy { f64::from(cos_alpha).powf(f64::from(n)) } else { 0.0 };
    assert!((f64::from(f.power) - power).abs() <= 1e-4 * power + 1e-30, "{cos_alpha}^{n} is {power}, not {}", f.power);
}

#[test]
fn every_number_of_the_account_follows_from_those_before_it() {
    for scene in all_scenes() {
        let job = job(&scene, 0, [48, 36], 1);
        for_every_pixel(&scene, &job, |_, account, _| {
            for (place, surface) in (0..).zip(&account.surfaces) {
                let ray = &account.rays[surface.ray as usize];
                assert_eq!(ray.end, RayEnd::Surface(place));
                for light in account.lights_of(place) {
                    let look = [surface.highlight, surface.exponent];
                    assert_factors(account, light, &light.factors, look);
                    let Some(vertices) = account.vertices_of(light) else {
                        assert_ne!(surface.shading, Some(Shading::Gouraud));
                        assert_eq!(light.factors.normal, surface.normal);
                        assert_eq!(light.factors.to_viewer, -ray.direction);
                        continue;
                    };
                    assert_eq!(surface.shading, Some(Shading::Gouraud));
                    let [a, b, c] = account.face_of(surface).unwrap().weights;
                    vertices.iter().for_each(|f| assert_factors(account, light, f, look));
                    let [p, q, r] = [&vertices[0], &vertices[1], &vertices[2]];
                    if light.visibility != Visibility::NotAsked {
                        assert_eq!(light.diffuse.to_bits(), (p.diffuse * a + q.diffuse * b + r.diffuse * c).to_bits());
                        let specular = p.specular * a + q.specular * b + r.specular * c;
                        assert_eq!(light.specular.to_bits(), specular.to_bits());
                    }
                }
            }
        });
    }
}

#[test]
fn rays_start_and_end_where_their_parents_and_surfaces_say() {
    for scene in [built_in("two-spheres"), built_in("knight"), scenes::of_everything(Shading::Gouraud)] {
        let job = job(&scene, 0, [40, 30], 3);
        for_every_pixel(&scene, &job, |compiled, account, _| {
            let mut below = vec![0; account.rays.len()];
            for (index, (ray, segment)) in account.rays.iter().zip(account.segments()).enumerate().rev() {
                assert_eq!(ray.descendants, below[index]);
                assert!(segment.end.is_finite() && segment.start == ray.origin && segment.ray as usize == index);
                if let Some(parent) = ray.parent {
                    assert!((parent as usize) < index && account.rays[parent as usize].depth + 1 == ray.depth);
                    below[parent as usize] += 1 + below[index];
                }
                assert_eq!(ray.kind == RayKind::Camera, ray.parent.is_none());
                match ray.end {
                    RayEnd::Surface(place) => {
                        let surface = &account.surfaces[place as usize];
                        let miss = (ray.origin + ray.direction * surface.t - surface.position).length();
                        assert!(miss <= 1e-4 * (1.0 + surface.t), "{miss}");
                        assert!(dot(surface.geometric_normal, ray.direction) <= 1e-6, "on the ray's side");
                    }
                    RayEnd::Light(place) => {
                        let position =
                            account.setting.lights.iter().find(|l| l.light == account.lights[place as usize].light);
                        let miss = (segment.end - position.unwrap().position).length();
                        assert!(miss <= 2e-4 * (1.0 + ray.reach), "{miss}");
                    }
                    RayEnd::Blocked { blocker, .. } => assert!(blocker.t < ray.reach && ray.color == [0.0; 3]),
                    RayEnd::Nothing => assert_eq!(ray.color, account.setting.background),
                    RayEnd::DepthUsedUp => assert_eq!(ray.depth, job.depth),
                }
            }
            let weights: f32 = account.samples.iter().map(|s| account.rays[s.ray as usize].weight).sum();
            assert!((weights - 1.0).abs() < 1e-6);
            for (index, _) in account.rays.iter().enumerate() {
                #[allow(clippy::cast_possible_truncation, reason = "few rays")]
                let children: Vec<u32> = account.children(index as u32).collect();
                assert!(children.iter().all(|&c| account.rays[c as usize].parent == Some(index as u32)));
            }
            let _ = compiled;
        });
    }
}

#[test]
fn the_account_of_ten_thousand_rays_takes_a_few_megabytes_and_no_recursion() {
    let scene = built_in("two-spheres");
    let compiled = compile(&scene, &mut MeshTrees::new(), 2);
    // Between the spheres, where each mirrors the other.
    let wide = job(&scene, 0, [960, 720], 4096);
    let account = explain(&compiled, &wide, 404, 348).unwrap();
    assert!(account.rays.len() > 10_000, "{}", account.rays.len());
    let bytes = account.memory_bytes() / account.rays.len();
    assert!(bytes < 300, "{bytes} bytes a ray");
    assert_eq!(bits(account.sum()), bits(account.pixel));
}
