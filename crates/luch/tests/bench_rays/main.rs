//! `luch bench rays`.

#[path = "../support/mod.rs"]
mod support;

use support::Folder;

/// A square of side 2 in the plane z = 0.
const SQUARE: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nf 1 2 3 4\n";

/// Rays along -z from z = 5 at the given x, y, that end at `t_max`.
fn rays(places: &[[f32; 2]], t_max: f32) -> Vec<u8> {
    let numbers = places.iter().flat_map(|[x, y]| [*x, *y, 5.0, 0.0, 0.0, -1.0, 0.0, t_max]);
    numbers.flat_map(f32::to_le_bytes).collect()
}

fn bench(folder: &Folder, args: &[&str]) -> serde_json::Value {
    let mut all = vec!["bench", "rays", "--mesh", "square.obj", "--json"];
    all.extend(args);
    folder.ok(&all).json()
}

#[test]
fn hits_are_counted_and_summed() {
    let folder = Folder::new();
    folder.write("square.obj", SQUARE);
    folder.write("a.rays", rays(&[[0.5, 0.2], [-0.5, 0.1], [3.0, 0.0]], f32::INFINITY));
    let figures = bench(&folder, &["--rays", "a.rays", "--query", "closest", "--repeat", "2", "--threads", "1"]);
    let keys: Vec<&str> = figures.as_object().unwrap().keys().map(String::as_str).collect();
    let mut expected = ["tris", "build_ms", "rays", "hits", "sum_t", "mrays_per_s", "threads", "simd"];
    expected.sort_unstable();
    let mut keys = keys.clone();
    keys.sort_unstable();
    assert_eq!(keys, expected);
    for (key, value) in [("tris", 2.0), ("rays", 3.0), ("hits", 2.0), ("sum_t", 10.0), ("threads", 1.0)] {
        assert_eq!(figures[key].as_f64(), Some(value), "{key}");
    }
    assert!(figures["mrays_per_s"].as_f64().unwrap() > 0.0);
    let text = folder.ok(&["bench", "rays", "--mesh", "square.obj", "--rays", "a.rays", "--query", "any"]).stdout;
    assert!(text.contains("hits         2") && !text.contains("sum of t"), "{text}");
}

#[test]
fn the_end_of_a_ray_counts() {
    let folder = Folder::new();
    folder
        .write("square.obj", SQUARE)
        .write("short.rays", rays(&[[0.5, 0.2]], 4.0))
        .write("long.rays", rays(&[[0.5, 0.2]], 6.0));
    for query in ["closest", "any"] {
        assert_eq!(bench(&folder, &["--rays", "short.rays", "--query", query])["hits"], 0, "{query}");
        let figures = bench(&folder, &["--rays", "long.rays", "--query", query]);
        assert_eq!(figures["hits"], 1, "{query}");
        assert_eq!(figures.get("sum_t").is_some(), query == "closest", "{query}");
    }
}

#[test]
fn the_answers_depend_neither_on_threads_nor_on_hints_nor_on_the_instruction_set() {
    let folder = Folder::new();
    // More than two batches, the last one not full.
    let places: Vec<[f32; 2]> =
        (0..9001_u16).map(|i| [f32::from(i) / 4500.0 - 1.2, f32::from(i % 97) / 40.0 - 1.2]).collect();
    folder.write("square.obj", SQUARE).write("a.rays", rays(&places, 100.0));
    let figures = |args: &[&str]| {
        let mut all = vec!["--rays", "a.rays", "--query", "closest", "--repeat", "1"];
        all.extend(args);
        let f = bench(&folder, &all);
        (f["hits"].clone(), f["sum_t"].clone())
    };
    let truth = figures(&["--threads", "1", "--simd", "scalar"]);
    assert!(truth.0.as_u64().is_some_and(|hits| hits > 1000 && hits < 9001), "{truth:?}");
    for args in [&["--threads", "3"][..], &["--coherent"], &["--simd", "auto"], &["--threads", "64", "--coherent"]] {
        assert_eq!(figures(args), truth, "{args:?}");
    }
}

#[test]
fn what_cannot_be_measured_says_why() {
    let folder = Folder::new();
    let good = rays(&[[0.0, 0.0]], 9.0);
    let with = |place: usize, value: f32| {
        let mut bytes = [good.clone(), good.clone()].concat();
        bytes[32 + 4 * place..][..4].copy_from_slice(&value.to_le_bytes());
        bytes
    };
    folder
        .write("square.obj", SQUARE)
        .write("good.rays", &good)
        .write("short.rays", &good[..31])
        .write("empty.rays", "");
    folder.write("nan.rays", with(4, f32::NAN)).write("behind.rays", with(6, -1.0)).write("still.rays", with(5, 0.0));
    folder.write("bad.obj", "v 0 0 0\nf 1 2 3\n");
    let run = |mesh: &str, rays: &str, more: &[&str]| {
        let mut all = vec!["bench", "rays", "--mesh", mesh, "--rays", rays];
        all.extend(if more.contains(&"--query") { &[][..] } else { &["--query", "any"] });
        all.extend(more);
        folder.luch(&all)
    };
    for (mesh, rays, more, code, words) in [
        ("square.obj", "short.rays", &[][..], 3, "31 bytes are no rays"),
        ("square.obj", "empty.rays", &[], 3, "0 bytes are no rays"),
        ("square.obj", "nan.rays", &[], 3, "byte 32: ray 1 has a number that is not finite"),
        ("square.obj", "behind.rays", &[], 3, "ray 1 begins behind"),
        ("square.obj", "still.rays", &[], 3, "ray 1 has no direction"),
        ("square.obj", "gone.rays", &[], 4, "gone.rays"),
        ("square.obj", ".", &[], 4, "regular file"),
        ("gone.obj", "good.rays", &[], 4, "gone.obj"),
        ("bad.obj", "good.rays", &[], 3, "bad.obj:2"),
        ("square.obj", "good.rays", &["--threads", "0"], 2, "threads from 1 to 1024"),
        ("square.obj", "good.rays", &["--repeat", "0"], 2, "repeats from 1"),
        ("square.obj", "good.rays", &["--query", "nearest"], 2, "closest, any"),
        ("square.obj", "good.rays", &["--simd", "mmx"], 2, "possible values"),
    ] {
        let outcome = run(mesh, rays, more);
        assert_eq!((outcome.code, outcome.stdout.as_str()), (code, ""), "{mesh} {rays} {more:?}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{mesh} {rays} {more:?}: {}", outcome.stderr);
    }
}
