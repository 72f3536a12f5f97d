//! The same bits, whatever the threads, tiles, instruction set, crops and runs.

use luch_render::{Crop, Integrator, RenderJob, SimdLevel};
use luch_scene::{Scene, Shading};
use luch_verify::{built_in, built_in_ids, hash, job, picture, sampling, scenes};

/// Small, but with antialiasing and depth of field, mirrors and shadows.
fn small(scene: &Scene) -> RenderJob {
    let mut job = job(scene, 0, [90, 61], 4);
    job.depth_of_field = sampling(3);
    job.threads = 1;
    job
}

fn scenes() -> Vec<Scene> {
    let mut scenes: Vec<Scene> = built_in_ids().into_iter().map(built_in).collect();
    scenes.extend([Shading::Flat, Shading::Gouraud, Shading::Phong].map(scenes::of_everything));
    for scene in &mut scenes {
        for camera in &mut scene.cameras {
            camera.lens_radius = luch_scene::NonNegative::new(0.1).unwrap();
        }
    }
    scenes
}

#[test]
fn threads_tiles_and_runs_do_not_change_a_bit() {
    for scene in scenes() {
        let base = small(&scene);
        let truth = hash(&scene, &base);
        for threads in [1, 2, 3, 8, 64] {
            assert_eq!(
                hash(&scene, &RenderJob { threads, ..base.clone() }),
                truth,
                "{}: {threads} threads",
                scene.name
            );
        }
        for tile_size in [8, 13, 16, 33, 64] {
            let job = RenderJob { tile_size, threads: 2, ..base.clone() };
            assert_eq!(hash(&scene, &job), truth, "{}: tiles of {tile_size}", scene.name);
        }
    }
}

#[test]
fn the_instruction_set_does_not_change_a_bit() {
    for scene in scenes() {
        for integrator in Integrator::ALL {
            // The cost view counts the work of the kernel at hand, which is the instruction set's own.
            if integrator == Integrator::Cost {
                continue;
            }
            let base = RenderJob { integrator, threads: 2, simd: SimdLevel::Scalar, ..small(&scene) };
            let truth = hash(&scene, &base);
            for simd in SimdLevel::available() {
                let job = RenderJob { simd, ..base.clone() };
                assert_eq!(hash(&scene, &job), truth, "{}: {} {}", scene.name, integrator.word(), simd.word());
            }
        }
    }
}

#[test]
fn a_picture_put_together_from_crops_is_the_picture() {
    for scene in scenes() {
        let base = small(&scene);
        let whole = picture(&scene, &base);
        let mut joined = vec![f32::NAN; whole.len()];
        for (x, width) in [(0, 17), (17, 40), (57, 33)] {
            for (y, height) in [(0, 30), (30, 31)] {
                let job = RenderJob { crop: Some(Crop { x, y, width, height }), ..base.clone() };
                for (row, values) in picture(&scene, &job).chunks_exact(width as usize * 3).enumerate() {
                    let start = ((y as usize + row) * 90 + x as usize) * 3;
                    joined[start..start + values.len()].copy_from_slice(values);
                }
            }
        }
        assert!(joined == whole, "{}", scene.name);
    }
}
