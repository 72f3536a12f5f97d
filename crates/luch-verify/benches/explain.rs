//! How long an answer takes when somebody asks why a pixel has its colour.
//!
//! `cargo bench -p luch-verify --bench explain`. The pixels are busy ones: between the two spheres, where each mirrors
//! the other, and on a chess piece. Loading and compiling the scene are not in the figures.

use divan::{Bencher, black_box};
use luch_explain::{Explanation, Options, plain};
use luch_render::explain::explain;
use luch_render::{CompiledScene, MeshTrees, RenderJob, compile};
use luch_scene::Scene;
use luch_verify::{built_in, job};

fn main() {
    divan::main();
}

/// A scene, and a pixel of its first camera at 960 x 720.
const SUBJECTS: [(&str, [u32; 2]); 2] = [("two-spheres", [404, 348]), ("chess", [380, 430])];

fn subject(id: &'static str, rays: u32) -> (Scene, CompiledScene, RenderJob, [u32; 2]) {
    let scene = built_in(id);
    let compiled = compile(&scene, &mut MeshTrees::new(), 1);
    let job = job(&scene, 0, [960, 720], rays);
    let pixel = SUBJECTS.iter().find(|(name, _)| *name == id).map_or([0, 0], |(_, pixel)| *pixel);
    (scene, compiled, job, pixel)
}

/// The account alone, by rays per pixel.
#[divan::bench(args = [1, 64, 4096], consts = [0, 1])]
fn account<const SUBJECT: usize>(bencher: Bencher<'_, '_>, rays: u32) {
    let (_, compiled, job, [x, y]) = subject(SUBJECTS[SUBJECT].0, rays);
    bencher.bench(|| explain(black_box(&compiled), &job, x, y).expect("an account"));
}

/// A form of an account of 64 rays: text and JSON, without and with the boxes of every ray's way.
#[divan::bench(args = ["text", "json", "json with boxes"], consts = [0, 1])]
fn form<const SUBJECT: usize>(bencher: Bencher<'_, '_>, form: &str) {
    let (scene, compiled, job, [x, y]) = subject(SUBJECTS[SUBJECT].0, 64);
    let account = explain(&compiled, &job, x, y).expect("an account");
    let explanation = Explanation { account: &account, scene: &scene, compiled: &compiled, camera: "Camera 1" };
    let options = Options { boxes: form.ends_with("boxes"), ..Options::default() };
    bencher.bench(|| {
        let mut bytes = Vec::new();
        match form {
            "text" => bytes = explanation.text(&options, &plain).into_bytes(),
            _ => explanation.json(&options, &mut bytes).expect("memory takes everything"),
        }
        bytes
    });
}
