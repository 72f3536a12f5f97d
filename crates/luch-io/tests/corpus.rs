//! Bad and odd models, libraries and paths: each gives a picture or one clear error, at once, and never a panic.
//!
//! The files lie in tests/bad, with a line of expectation each. What cannot be a file of a repository (links, pipes,
//! huge ones) is made here; what nobody thought of comes from a seeded mutator.

use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::model_scene::scene_of_model;
use luch_io::resolve::{MAX_TEXT_BYTES, SceneFolder};
use luch_io::{Error, ErrorKind, Report, Result, obj};
use luch_scene::{Mesh, Scene};
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Instant;

fn bad(folder: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad").join(folder)
}

/// The lines of a folder's expectations: what is read, and the columns behind it.
fn expectations(folder: &str) -> Vec<(String, Vec<String>)> {
    let text = fs::read_to_string(bad(folder).join("expectations.txt")).unwrap();
    let lines = text.lines().filter(|l| !l.is_empty() && !l.starts_with('#'));
    let split = |line: &str| {
        let (name, rest) = line.split_once(" |").unwrap();
        (name.to_owned(), rest.split(" |").map(|c| c.trim().to_owned()).collect())
    };
    lines.map(split).collect()
}

/// Checks the outcome and the words; gives back what was said.
fn check<T>(name: &str, outcome: &str, words: &str, result: Result<T>, report: &Report) {
    let (kind, said) = match result {
        Ok(_) => ("picture", report.lines().join("\n")),
        Err(e) => {
            let kind = match e.kind {
                ErrorKind::Malformed => "malformed",
                ErrorKind::Forbidden => "forbidden",
                ErrorKind::Limit => "limit",
                ErrorKind::Output => "output",
                ErrorKind::Cancelled => "cancelled",
            };
            (kind, e.to_string())
        }
    };
    assert_eq!(kind, outcome, "{name}: {said}");
    for word in words.split("; ") {
        assert!(said.contains(word), "{name}: \"{word}\" is not in: {said}");
    }
}

/// A model as the program opens it; the limits are those of a small machine.
fn open(path: &Path, report: &mut Report) -> Result<Scene> {
    scene_of_model(path, &mut MeshLibrary::new(), &mut Budget::new(1 << 30), report)
}

/// Bytes as a model, with whatever libraries `open` finds.
fn read(bytes: Vec<u8>, report: &mut Report) -> Result<Mesh> {
    let mut none = |name: &str, _: &mut Budget| Err(Error::new(ErrorKind::Forbidden, name, "no such file"));
    let data = obj::read(bytes, Path::new("m.obj"), &mut none, &mut Budget::new(1 << 30), report)?;
    Ok(Mesh::new(data).expect("the reader checks all that the mesh checks"))
}

fn within_a_second(name: &str, start: Instant) {
    assert!(start.elapsed().as_secs_f32() < 1.0, "{name} took {:?}", start.elapsed());
}

#[test]
fn every_bad_model() {
    let cases = expectations("obj");
    assert!(cases.len() >= 100, "{}", cases.len());
    for (name, columns) in &cases {
        let (start, mut report) = (Instant::now(), Report::default());
        let result = open(&bad("obj").join(name), &mut report);
        check(name, &columns[0], &columns[1], result, &report);
        within_a_second(name, start);
    }
    let is_model = |path: &PathBuf| path.extension().is_some_and(|e| e == "obj");
    let files = fs::read_dir(bad("obj")).unwrap().map(|f| f.unwrap().path()).filter(is_model);
    assert_eq!(files.count(), cases.len(), "every file has its line");
}

#[test]
fn every_bad_library() {
    let cases = expectations("mtl");
    assert!(cases.len() >= 40, "{}", cases.len());
    let folder = SceneFolder::new(&bad("mtl")).unwrap();
    for (name, columns) in &cases {
        let (start, mut report) = (Instant::now(), Report::default());
        let mut library = |name: &str, budget: &mut Budget| folder.open(name, MAX_TEXT_BYTES, budget);
        let model = format!("mtllib {name}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n").into_bytes();
        let result = obj::read(model, Path::new("m.obj"), &mut library, &mut Budget::new(1 << 30), &mut report);
        check(name, "picture", &columns[0], result, &report);
        within_a_second(name, start);
    }
}

#[test]
fn every_path() {
    let cases = expectations("paths");
    assert!(cases.len() >= 50, "{}", cases.len());
    let folder = SceneFolder::new(&bad("paths")).unwrap();
    for (name, columns) in &cases {
        let mut report = Report::default();
        let result = MeshLibrary::new().mesh(&folder, name, &mut Budget::new(1 << 30), &mut report);
        check(name, &columns[0], &columns[1], result, &report);
    }
}

#[test]
fn built_in_models_are_read_once_and_from_anywhere() {
    let (folder, inside) = (SceneFolder::new(&bad("paths")).unwrap(), SceneFolder::built_in());
    let get = |folder: &SceneFolder| {
        MeshLibrary::new().mesh(folder, "../models/king.obj", &mut Budget::new(0), &mut Report::default()).unwrap()
    };
    assert_eq!(get(&folder).id(), get(&inside).id());
    let mut library = MeshLibrary::new();
    let mut twice = || library.mesh(&folder, "inside.obj", &mut Budget::new(1 << 20), &mut Report::default()).unwrap();
    assert_eq!(twice().id(), twice().id());
    let other = inside.find("inside.obj").unwrap_err();
    assert_eq!(other.kind, ErrorKind::Forbidden, "the scenes inside the program see no files");
}

/// An empty folder that goes with the test.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("luch-corpus-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(path.join("scene")).unwrap();
        Self(path)
    }

    fn scene(&self) -> PathBuf {
        self.0.join("scene")
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

#[cfg(unix)]
#[test]
fn links_pipes_devices_and_forbidden_files() {
    use std::os::unix::ffi::OsStrExt;
    use std::os::unix::fs::{PermissionsExt, symlink};
    let scratch = Scratch::new("links");
    let scene = scratch.scene();
    fs::write(scratch.0.join("outside.obj"), TRIANGLE).unwrap();
    fs::write(scene.join("inside.obj"), TRIANGLE).unwrap();
    fs::create_dir(scratch.0.join("folder")).unwrap();
    fs::write(scratch.0.join("folder/a.obj"), TRIANGLE).unwrap();
    fs::create_dir(scratch.0.join("scene-two")).unwrap();
    fs::write(scratch.0.join("scene-two/a.obj"), TRIANGLE).unwrap();
    let link = |to: &str, name: &str| symlink(to, scene.join(name)).unwrap();
    link("../outside.obj", "link-out.obj");
    link("../folder", "folder");
    link("../scene-two/a.obj", "link-neighbour.obj");
    link("/dev/zero", "zero.obj");
    link("inside.obj", "link-in.obj");
    link("loop-b.obj", "loop-a.obj");
    link("loop-a.obj", "loop-b.obj");
    link("nowhere.obj", "dangling.obj");
    let made = std::process::Command::new("mkfifo").arg(scene.join("pipe.obj")).status().is_ok_and(|s| s.success());
    fs::write(scene.join("secret.obj"), TRIANGLE).unwrap();
    fs::set_permissions(scene.join("secret.obj"), fs::Permissions::from_mode(0o0)).unwrap();
    let is_root = fs::read(scene.join("secret.obj")).is_ok();

    fs::write(scene.join("quote'\".obj"), TRIANGLE).unwrap();
    fs::write(scene.join("two\nlines.obj"), TRIANGLE).unwrap();
    let folder = SceneFolder::new(&scene).unwrap();
    let name_4000 = format!("{}.obj", "n".repeat(4000));
    for (name, outcome, words) in [
        ("inside.obj", "picture", ""),
        ("link-in.obj", "picture", ""),
        ("quote'\".obj", "picture", ""),
        ("two\nlines.obj", "picture", ""),
        ("link-out.obj", "forbidden", "leads out of the scene's folder"),
        ("folder/a.obj", "forbidden", "leads out of the scene's folder"),
        ("link-neighbour.obj", "forbidden", "leads out of the scene's folder"),
        ("zero.obj", "forbidden", "leads out of the scene's folder"),
        ("loop-a.obj", "forbidden", "loop of symbolic links"),
        ("dangling.obj", "forbidden", "no such file"),
        (&name_4000, "forbidden", "no such file: the name is too long"),
        ("pipe.obj", if made { "forbidden" } else { "" }, "is a pipe or a device"),
        ("secret.obj", if is_root { "" } else { "forbidden" }, "permission denied"),
    ] {
        if !outcome.is_empty() {
            let (start, mut report) = (Instant::now(), Report::default());
            let result = MeshLibrary::new().mesh(&folder, name, &mut Budget::new(1 << 30), &mut report);
            check(name, outcome, words, result, &report);
            within_a_second(name, start);
        }
    }
    // The user may name anything, but not everything is a model.
    for (path, words) in [
        (scene.clone(), "is a folder"),
        (PathBuf::from("/dev/zero"), "is a pipe or a device"),
        (scene.join("pipe.obj"), if made { "is a pipe or a device" } else { "no such file" }),
        (scene.join("none.obj"), "no such file"),
    ] {
        check(&path.display().to_string(), "forbidden", words, open(&path, &mut Report::default()), &Report::default());
    }
    check("link", "picture", "", open(&scene.join("link-out.obj"), &mut Report::default()), &Report::default());
    let name = std::ffi::OsStr::from_bytes(b"caf\xe9.obj");
    if fs::write(scene.join(name), TRIANGLE).is_ok() {
        let scene = open(&scene.join(name), &mut Report::default()).unwrap();
        assert_eq!(scene.objects[1].name, "caf\u{fffd}", "a name that is no UTF-8 is shown as far as it goes");
    }
    assert_eq!(SceneFolder::new(&scene.join("inside.obj")).unwrap_err().kind, ErrorKind::Forbidden);
}

#[test]
fn files_over_the_limits() {
    let mut report = Report::default();
    let mut limit = |what: &str, bytes: Vec<u8>, outcome: &str, words: &str| {
        let start = Instant::now();
        let result = read(bytes, &mut report);
        check(what, outcome, words, result, &Report::default());
        assert!(start.elapsed().as_secs_f32() < 10.0, "{what}: {:?}", start.elapsed());
    };
    let mib = 1 << 20;
    limit(
        "17 MiB comment",
        [b"#", &vec![b'x'; 17 * mib][..], TRIANGLE.as_bytes()].concat(),
        "limit",
        "longer than 16 MiB",
    );
    limit("17 MiB name", [b"usemtl ", &vec![b'x'; 17 * mib][..]].concat(), "limit", ":1:1: a line is longer");
    limit("15 MiB comment", [b"#", &vec![b'x'; 15 * mib][..], b"\n", TRIANGLE.as_bytes()].concat(), "picture", "");
    let corners = |n: usize| format!("{TRIANGLE}f {}", "1 2 3 ".repeat(n / 3)).into_bytes();
    limit("100,002 corners", corners(100_002), "limit", "more than 100000 corners");
    limit("99,999 corners", corners(99_999), "picture", "");
    let groups: String = (0..1_000_000).map(|i| format!("g {i}\ns {i}\n")).collect();
    limit("a million groups", format!("{groups}{TRIANGLE}").into_bytes(), "picture", "");
    let names: String = (0..70_000).map(|i| format!("usemtl {i}\n")).collect();
    limit("70,000 materials", format!("{names}{TRIANGLE}").into_bytes(), "picture", "");
}

#[test]
fn the_memory_limit_names_the_need_and_the_flag() {
    let folder = SceneFolder::new(&bad("paths")).unwrap();
    for limit in [0, 10, 100, 200] {
        let mesh = MeshLibrary::new().mesh(&folder, "inside.obj", &mut Budget::new(limit), &mut Report::default());
        check("inside.obj", "limit", "of memory for; the limit is; --memory", mesh, &Report::default());
    }
    let capped = folder.open("inside.obj", 10, &mut Budget::new(1000)).unwrap_err();
    assert_eq!((capped.kind, capped.text.as_str()), (ErrorKind::Limit, "has 32 bytes, the limit is 10 bytes"));
}

#[test]
fn a_load_can_be_stopped() {
    use std::sync::Arc;
    use std::sync::atomic::AtomicBool;
    let mut budget = Budget::new(1 << 30).cancelled_by(Arc::new(AtomicBool::new(true)));
    let path = bad("paths").join("inside.obj");
    let stopped = scene_of_model(&path, &mut MeshLibrary::new(), &mut budget, &mut Report::default()).unwrap_err();
    assert_eq!(stopped.kind, ErrorKind::Cancelled);
}

/// A small generator of noise with a seed, so that a failure comes again.
struct Noise(u64);

impl Noise {
    fn next(&mut self, below: usize) -> usize {
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        usize::try_from(self.0 >> 33).unwrap() % below.max(1)
    }
}

/// Every mutation of a seed: cut short, one byte changed, a number replaced.
fn mutations(seed: &[u8], noise: &mut Noise) -> Vec<Vec<u8>> {
    let mut all: Vec<Vec<u8>> = (0..64).map(|i| seed[..seed.len() * i / 64].to_vec()).collect();
    for _ in 0..256.min(seed.len() * 4) {
        let mut bytes = seed.to_vec();
        let at = noise.next(bytes.len());
        let interesting = b"\n\r \\/#-+.e09vnf\0\xff";
        bytes[at] = match noise.next(3) {
            0 => interesting[noise.next(interesting.len())],
            1 => bytes[at] ^ (1 << noise.next(8)),
            _ => u8::try_from(noise.next(256)).unwrap(),
        };
        all.push(bytes);
    }
    let numbers =
        ["0", "1", "-1", "2147483647", "4294967295", "4294967296", "-9223372036854775808", "1e38", "nan", "1e-45"];
    let is_digit = |i: usize| seed.get(i).is_some_and(u8::is_ascii_digit);
    let starts: Vec<usize> = (0..seed.len()).filter(|i| is_digit(*i) && (*i == 0 || !is_digit(i - 1))).collect();
    for _ in 0..64.min(starts.len() * 4) {
        let start = starts[noise.next(starts.len())];
        let end = (start..).find(|i| !is_digit(*i)).unwrap();
        let number = numbers[noise.next(numbers.len())];
        all.push([&seed[..start], number.as_bytes(), &seed[end..]].concat());
    }
    all
}

#[test]
fn mutated_files_never_panic() {
    let mut noise = Noise(0x4c75_6368);
    let mut runs = 0;
    let start = Instant::now();
    for folder in ["obj", "mtl"] {
        let mut files: Vec<PathBuf> = fs::read_dir(bad(folder)).unwrap().map(|f| f.unwrap().path()).collect();
        files.sort();
        for file in files.iter().filter(|f| f.extension().is_some_and(|e| e == folder)) {
            let seed = fs::read(file).unwrap();
            // Long files take their time and show nothing new.
            if seed.is_empty() || seed.len() > 2000 {
                continue;
            }
            for bytes in mutations(&seed, &mut noise) {
                runs += 1;
                let mut report = Report::default();
                if folder == "obj" {
                    if let Ok(mesh) = read(bytes, &mut report) {
                        assert!(
                            mesh.positions()
                                .iter()
                                .flatten()
                                .chain(mesh.normals().iter().flatten())
                                .all(|c| c.is_finite())
                        );
                    }
                } else {
                    let mut materials = Vec::new();
                    obj::mtl::read(&bytes, file, &mut materials, &mut report);
                    for material in &materials {
                        let _ = material.gloss();
                    }
                }
                let _ = report.lines();
            }
        }
    }
    assert!(runs > 20_000, "{runs}");
    assert!(start.elapsed().as_secs_f32() < 20.0, "{:?} for {runs} runs", start.elapsed());
}
