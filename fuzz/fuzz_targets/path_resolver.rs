//! Any word as a path: nothing outside the scene's folder is ever found.
#![no_main]

use libfuzzer_sys::fuzz_target;
use luch_io::resolve::{Found, SceneFolder, components_of, encode_name};
use std::path::PathBuf;
use std::sync::OnceLock;

/// A folder with a file, a folder, a link out and a link in; beside it a file that must never be found.
fn scene_folder() -> &'static PathBuf {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    FOLDER.get_or_init(|| {
        let root = std::env::temp_dir().join(format!("luch-fuzz-{}", std::process::id()));
        let scene = root.join("s");
        std::fs::create_dir_all(scene.join("d")).expect("a scratch folder");
        for file in ["../secret", "a", "d/b"] {
            std::fs::write(scene.join(file), "x").expect("a scratch file");
        }
        #[cfg(unix)]
        for (to, name) in [("..", "up"), ("../secret", "out"), ("a", "in"), ("/", "root")] {
            let _ = std::os::unix::fs::symlink(to, scene.join(name));
        }
        std::fs::canonicalize(scene).expect("it was made")
    })
}

fuzz_target!(|name: &str| {
    let root = scene_folder();
    let folder = SceneFolder::new(root).expect("it was made");
    match folder.find(name) {
        Ok(Found::File(file)) => assert!(file.path().starts_with(root), "{name:?} found {:?}", file.path()),
        Ok(Found::BuiltIn(model)) => assert_eq!(model.path, name),
        Err(error) => assert_eq!(error.exit_code(), 4, "{error}"),
    }
    if let Ok(parts) = components_of(&[], name) {
        assert!(parts.iter().all(|p| !matches!(p.as_str(), "" | "." | "..") && !p.contains(['/', '\\', '\0'])));
    }
    if !name.contains(['/', '\\', '\0']) && !matches!(name.trim(), "" | "." | "..") && name.len() < 1000 {
        assert_eq!(components_of(&[], &encode_name(name)), Ok(vec![name.to_owned()]));
    }
});
