//! Any bytes as a material library: materials in range, and warnings.
#![no_main]

use libfuzzer_sys::fuzz_target;
use luch_io::{Report, obj};
use std::path::Path;

fuzz_target!(|bytes: &[u8]| {
    let (mut materials, mut report) = (Vec::new(), Report::default());
    obj::mtl::read(bytes, Path::new("m.mtl"), &mut materials, &mut report);
    for material in &materials {
        let _ = material.gloss();
    }
    let _ = report.lines();
});
