//! Bad scene files: each is one clear error, of the right kind, at the right place, with the right words.

use luch_io::{Error, ErrorKind, Place, Report, builtin, parse_scene};
use luch_scene::{Mesh, MeshData, Scene};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad/scene")
}

fn triangle() -> Arc<Mesh> {
    let data = MeshData {
        positions: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
        normals: vec![[0.0, 0.0, 1.0]; 3],
        triangles: vec![[0, 1, 2]],
        ..MeshData::default()
    };
    Arc::new(Mesh::new(data).unwrap())
}

fn parse(bytes: &[u8], file: &str) -> Result<Scene, Error> {
    let mesh = triangle();
    let mut load = |path: &str, _: &mut Report| match path {
        "good.obj" => Ok(Arc::clone(&mesh)),
        _ if path.starts_with("../models/") => Ok(Arc::clone(&mesh)),
        "huge.obj" => Err(Error::new(ErrorKind::Limit, path, "the model is too large")),
        _ => Err(Error::new(ErrorKind::Forbidden, path, "no such file")),
    };
    parse_scene(bytes, Path::new(file), &mut load, &mut Report::default())
}

/// A line of the index.
struct Case {
    file: String,
    kind: String,
    place: String,
    words: Vec<String>,
}

fn cases() -> Vec<Case> {
    let index = fs::read_to_string(folder().join("index.txt")).unwrap();
    let lines = index.lines().filter(|l| !l.starts_with('#'));
    lines
        .map(|line| {
            let parts: Vec<&str> = line.splitn(4, " | ").collect();
            let [file, kind, place, words] = parts.as_slice() else { panic!("four parts: {line}") };
            let words = words.split(';').map(|w| w.trim().to_owned()).collect();
            Case { file: (*file).into(), kind: (*kind).into(), place: (*place).into(), words }
        })
        .collect()
}

/// What is wrong with an error, compared with what the index wants.
fn differences(case: &Case, error: &Error) -> Vec<String> {
    let mut wrong = Vec::new();
    if format!("{:?}", error.kind) != case.kind {
        wrong.push(format!("kind {:?} instead of {}", error.kind, case.kind));
    }
    let place = match &error.place {
        Place::Text { line, .. } if !case.place.contains(':') => line.to_string(),
        Place::Text { line, column, .. } => format!("{line}:{column}"),
        _ => "-".into(),
    };
    if place != case.place {
        wrong.push(format!("place {place} instead of {}", case.place));
    }
    let said = format!("{} {}", error.text, error.hint.as_deref().unwrap_or_default());
    wrong.extend(case.words.iter().filter(|w| !said.contains(w.as_str())).map(|w| format!("no word `{w}`")));
    if error.file != Path::new(&case.file) {
        wrong.push(format!("file {}", error.file.display()));
    }
    wrong
}

#[test]
fn every_bad_file_is_one_clear_error() {
    let mut failures = String::new();
    for case in cases() {
        let start = Instant::now();
        let bytes = fs::read(folder().join(&case.file)).unwrap();
        match parse(&bytes, &case.file) {
            Ok(_) => failures += &format!("\n{}: was read without an error", case.file),
            Err(error) => {
                for wrong in differences(&case, &error) {
                    failures += &format!("\n{wrong} in: {error}\n");
                }
            }
        }
        assert!(start.elapsed() < Duration::from_secs(1), "{} takes too long", case.file);
    }
    assert!(failures.is_empty(), "{failures}");
}

#[test]
fn the_index_and_the_folder_name_the_same_files() {
    let listed: BTreeSet<String> = cases().into_iter().map(|c| c.file).collect();
    let there: BTreeSet<String> = fs::read_dir(folder())
        .unwrap()
        .map(|e| e.unwrap().file_name().into_string().unwrap())
        .filter(|name| name.ends_with(".toml"))
        .collect();
    assert_eq!(listed, there);
    assert_eq!(listed.len(), cases().len(), "a file is listed once");
}

/// Numbers from a seed (xorshift, Marsaglia 2003).
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % (n.max(1) as u64)) as usize
    }
}

/// Pieces that a careless or a hostile hand puts into a scene file.
const PIECES: [&str; 32] = [
    "\n",
    "\"",
    "'",
    "\"\"\"",
    "'''",
    "[",
    "]",
    "[[",
    "]]",
    "{",
    "}",
    "=",
    ",",
    ".",
    "#",
    "\\",
    "\0",
    "\r",
    "\u{feff}",
    "я",
    "nan",
    "-inf",
    "1e999",
    "-0.0",
    "99999999999999999999",
    "0x7fffffff",
    "[[object]]\n",
    "[render]\n",
    "[object.x]\n",
    "mesh = \"good.obj\"\n",
    "sphere = { center = [0, 0, 0], radius = 1 }\n",
    "luch = 1\n",
];

fn mutate(seed: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = seed.to_vec();
    for _ in 0..=random.below(3) {
        let (at, to) = (random.below(bytes.len() + 1), random.below(bytes.len() + 1));
        let (start, end) = (at.min(to), at.max(to));
        match random.below(6) {
            // Cut off, cut out, flip a bit, put in, double, swap two lines.
            0 => bytes.truncate(at),
            1 => drop(bytes.drain(start..end.min(start + 20))),
            2 if !bytes.is_empty() => {
                let at = random.below(bytes.len());
                bytes[at] ^= 1 << random.below(8);
            }
            3 => drop(bytes.splice(at..at, PIECES[random.below(PIECES.len())].bytes())),
            4 => {
                let piece = bytes[start..end.min(start + 300)].to_vec();
                bytes.splice(end..end, piece);
            }
            _ => {
                let mut lines: Vec<&[u8]> = bytes.split(|&b| b == b'\n').collect();
                let count = lines.len();
                lines.swap(random.below(count), random.below(count));
                bytes = lines.join(&b'\n');
            }
        }
    }
    bytes
}

#[test]
fn no_mutation_of_good_and_bad_files_makes_the_reader_panic() {
    let mut seeds: Vec<(String, Vec<u8>)> = cases()
        .into_iter()
        .map(|case| (case.file.clone(), fs::read(folder().join(&case.file)).unwrap()))
        .chain(builtin::ids().map(|id| (id.to_owned(), builtin::text(id).unwrap().into())))
        .collect();
    let whole = "luch = 1\nname = \"все\"\n[[light]]\nposition = [1, 2, 3]\n[[camera]]\nposition = [0, 2, 7]\nlook_at = [0, 0, 0]\n\
                 [[object]]\nsphere = { center = [0, 1, 0], radius = 1 }\npattern = { checker = { size = 1, color = \"#fff\" } }\n\
                 [[object]]\nmesh = \"good.obj\"\nscale = 2\nshading = \"flat\"\n[object.pattern.checker]\nsize = 1\ncolor = [0, 0, 1]\n\
                 [render]\nantialiasing = { on = true, rays = 4 }\n";
    seeds.push(("whole".into(), whole.into()));
    assert!(parse(whole.as_bytes(), "whole").is_ok());

    let (mut read, mut refused) = (0_u32, 0_u32);
    for (n, (name, seed)) in seeds.iter().enumerate() {
        let mut random = Random(0x5eed_1234_abcd_0001 + n as u64);
        // Good files are changed more often: a change of a bad one is mostly stopped at its first fault.
        let good = parse(seed, name).is_ok();
        for _ in 0..if good { 3_000 } else { 120 } {
            let bytes = mutate(seed, &mut random);
            let start = Instant::now();
            match parse(&bytes, name) {
                Ok(scene) => {
                    read += 1;
                    // What was read can be written, and is read again as the same.
                    let text = luch_io::write_scene(&scene);
                    let again = parse(text.as_bytes(), name).unwrap_or_else(|e| panic!("{e}\n{text}"));
                    assert_eq!(luch_io::write_scene(&again), text);
                }
                Err(error) => {
                    refused += 1;
                    assert!(!error.text.is_empty() && error.to_string().len() < 4_000, "{error}");
                }
            }
            assert!(start.elapsed() < Duration::from_secs(1), "{name} takes too long");
        }
    }
    // The mutations are of use only if some of them go deep.
    assert!(read > 1_000 && refused > 20_000, "{read} read, {refused} refused");
}
