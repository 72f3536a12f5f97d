//! The pictures of today are those of yesterday: hashes of small pictures of every built-in scene and camera, and of the
//! scene of everything. A change of a scene or of the renderer's arithmetic shows here.
//!
//! After a change that is meant, look at the pictures first, then bless:
//! `LUCH_BLESS=1 cargo test -p luch-verify --test goldens`.

use luch_render::RenderJob;
use luch_scene::{Scene, Shading};
use luch_verify::{built_in, built_in_ids, hash, job, sampling, scenes};
use std::fmt::Write as _;

const GOLDEN: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/goldens/hashes.txt");

#[test]
fn the_pictures_are_those_that_were_blessed() {
    let mut actual = String::new();
    for id in built_in_ids() {
        let scene = built_in(id);
        for camera in 0..scene.cameras.len() {
            let line = line(&format!("{id} camera {}", camera + 1), &scene, camera);
            writeln!(actual, "{line}").expect("a string takes all");
        }
    }
    for shading in Shading::ALL {
        let line = line(&format!("of everything, {}", shading.word()), &scenes::of_everything(shading), 0);
        writeln!(actual, "{line}").expect("a string takes all");
    }
    if std::env::var_os("LUCH_BLESS").is_some() {
        std::fs::write(GOLDEN, &actual).expect("the golden file can be written");
    }
    let expected = std::fs::read_to_string(GOLDEN).expect("the golden file can be read");
    for (actual, expected) in actual.lines().zip(expected.lines()) {
        assert_eq!(actual, expected, "a picture changed: look at it, then bless (see the head of this file)");
    }
    assert_eq!(actual.lines().count(), expected.lines().count());
}

fn line(name: &str, scene: &Scene, camera: usize) -> String {
    let sharp = job(scene, camera, [96, 72], 1);
    let soft = RenderJob { depth_of_field: sampling(4), ..job(scene, camera, [96, 72], 4) };
    format!("{name}: {} {}", &hash(scene, &sharp)[..16], &hash(scene, &soft)[..16])
}
