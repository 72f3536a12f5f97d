//! Any bytes as a model: a mesh that passes every check, or an error.
#![no_main]

use libfuzzer_sys::fuzz_target;
use luch_io::budget::Budget;
use luch_io::{Report, obj};
use luch_scene::Mesh;
use std::path::Path;

fuzz_target!(|bytes: &[u8]| {
    // Every library that is named has the same bytes: they are read as MTL, too.
    let mut library = |_: &str, _: &mut Budget| Ok(bytes.to_vec());
    let (mut budget, mut report) = (Budget::new(256 << 20), Report::default());
    if let Ok(data) = obj::read(bytes.to_vec(), Path::new("m.obj"), &mut library, &mut budget, &mut report) {
        let mesh = Mesh::new(data).expect("the reader checks all that the mesh checks");
        assert!(mesh.normals().iter().flatten().all(|c| c.is_finite()));
    }
    let _ = report.lines();
});
