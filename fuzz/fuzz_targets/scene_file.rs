//! Any bytes as a scene file; and what is read, written and read again is the same scene.
#![no_main]

use libfuzzer_sys::fuzz_target;
use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::resolve::SceneFolder;
use luch_io::{Report, parse_scene, write_scene};
use std::path::Path;

fuzz_target!(|bytes: &[u8]| {
    let folder = SceneFolder::built_in();
    let mut library = MeshLibrary::new();
    let mut load = |path: &str, report: &mut Report| {
        let mut budget = Budget::new(256 << 20);
        library.mesh(&folder, path, &mut budget, report)
    };
    let file = Path::new("s.toml");
    if let Ok(scene) = parse_scene(bytes, file, &mut load, &mut Report::default()) {
        let text = write_scene(&scene);
        let again = parse_scene(text.as_bytes(), file, &mut load, &mut Report::default());
        assert_eq!(again.as_ref(), Ok(&scene), "{text}");
    }
});
