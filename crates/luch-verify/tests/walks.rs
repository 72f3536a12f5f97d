//! The account of a ray's way through the trees: it ends where the kernels end, and the heat maps count its steps.

use luch_render::explain::{RayEnd, RayKind, Walk, explain};
use luch_render::film::heat::{heat_color, heat_place};
use luch_render::math::bounds::Bounds;
use luch_render::{CompiledScene, Integrator, MeshTrees, Progress, RenderJob, compile, render};
use luch_scene::{Scene, Shading};
use luch_verify::{built_in, built_in_ids, job, scenes};

fn all_scenes() -> Vec<Scene> {
    let mut all: Vec<Scene> = built_in_ids().into_iter().map(built_in).collect();
    all.push(scenes::of_everything(Shading::Phong));
    all
}

fn for_every_walk(scene: &Scene, check: impl Fn(&CompiledScene, RayKind, RayEnd, &Walk, f32)) {
    let compiled = compile(scene, &mut MeshTrees::new(), 2);
    let job = job(scene, 0, [64, 48], 1);
    for y in 0..48 {
        for x in 0..64 {
            let account = explain(&compiled, &job, x, y).unwrap();
            for (index, ray) in (0..).zip(&account.rays) {
                let t = account.surface_of(index).map_or(f32::INFINITY, |surface| surface.t);
                check(&compiled, ray.kind, ray.end, &account.walk(&compiled, index), t);
                if let (Some(surface), Some(hit)) = (account.surface_of(index), account.walk(&compiled, index).hit) {
                    assert_eq!((hit.object, hit.primitive), (surface.object, surface.primitive));
                    if let Some(face) = account.face_of(surface) {
                        assert_eq!(
                            [hit.u.to_bits(), hit.v.to_bits()],
                            [face.weights[1], face.weights[2]].map(f32::to_bits)
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn a_walk_ends_where_the_kernels_end() {
    for scene in all_scenes() {
        for_every_walk(&scene, |_, _, end, walk, t| match end {
            RayEnd::Surface(_) => assert_eq!(walk.hit.unwrap().t.to_bits(), t.to_bits(), "{}", scene.name),
            RayEnd::Blocked { .. } => assert!(walk.hit.is_some(), "{}", scene.name),
            RayEnd::Light(_) | RayEnd::Nothing => assert_eq!(walk.hit, None, "{}", scene.name),
            RayEnd::DepthUsedUp => assert_eq!(*walk, Walk::default()),
        });
    }
}

#[test]
fn every_test_lies_in_the_box_that_was_entered_before_it() {
    let scene = scenes::of_everything(Shading::Phong);
    for_every_walk(&scene, |_, kind, _, walk, _| {
        for pair in walk.boxes.windows(2) {
            assert!(pair[1].level <= pair[0].level + 1, "nobody skips a level downwards");
        }
        for test in &walk.tests {
            if let Some(at) = test.in_box {
                let entered = &walk.boxes[at as usize];
                assert!(entered.leaf && entered.object.is_none_or(|object| object == test.object));
            }
        }
        let near = walk.tests.iter().filter_map(|test| test.t).fold(f32::INFINITY, f32::min);
        if kind != RayKind::Shadow {
            assert_eq!(walk.hit.map_or(f32::INFINITY, |hit| hit.t), near, "the nearest of what it met");
        }
    });
}

#[test]
fn boxes_lie_inside_the_boxes_around_them() {
    let scene = built_in("knight");
    for_every_walk(&scene, |compiled, _, _, walk, _| {
        for visit in walk.boxes.iter().filter(|visit| visit.object.is_none()) {
            let (whole, part) = (compiled.bounds(), Bounds::of_points(visit.corners));
            assert_eq!(whole.union(part), whole);
        }
    });
}

#[test]
fn the_heat_maps_count_the_steps_of_the_walk() {
    for scene in all_scenes() {
        let compiled = compile(&scene, &mut MeshTrees::new(), 2);
        let base = job(&scene, 0, [64, 48], 1);
        let picture = |integrator| {
            let job = RenderJob { integrator, ..base.clone() };
            render(&compiled, &job, &Progress::new()).unwrap().linear()
        };
        let (nodes, triangles) = (picture(Integrator::Nodes), picture(Integrator::Triangles));
        for (x, y) in (0..48).flat_map(|y| (0..64).map(move |x| (x, y))) {
            let walk = explain(&compiled, &base, x, y).unwrap().walk(&compiled, 0);
            let at = (y * 64 + x) as usize * 3;
            for (list, count) in [(&nodes, walk.boxes.len()), (&triangles, walk.tests.len())] {
                assert_eq!(
                    list[at..at + 3],
                    heat_color(heat_place(u32::try_from(count).unwrap())),
                    "{} {x},{y}",
                    scene.name
                );
            }
        }
    }
}
