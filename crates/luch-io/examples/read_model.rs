//! Reads a model and says how long it took and how much memory was charged for it.
//!
//! `cargo run --release -p luch-io --example read_model -- MODEL.obj`; with `/usr/bin/time -v` before the built program
//! the system's own figure for the peak stands beside.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "it is a program")]

use luch_io::budget::{Budget, human_bytes};
use luch_io::library::MeshLibrary;
use luch_io::resolve::{SceneFile, SceneFolder};
use luch_io::{Report, Result};
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    let Some(path) = std::env::args_os().nth(1) else {
        eprintln!("name a model");
        return ExitCode::from(2);
    };
    match read(Path::new(&path)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::from(error.exit_code())
        }
    }
}

fn read(path: &Path) -> Result<()> {
    let start = Instant::now();
    let (mut budget, mut report) = (Budget::default(), Report::default());
    let (folder, file) = (SceneFolder::of_file(path)?, SceneFile::of_user(path)?);
    let mesh = MeshLibrary::new().mesh_of_file(&folder, &file, &mut budget, &mut report)?;
    let seconds = start.elapsed().as_secs_f64();
    for line in report.lines() {
        println!("warning: {line}");
    }
    println!(
        "{} triangles, {} vertices, {} normals",
        mesh.triangles().len(),
        mesh.positions().len(),
        mesh.normals().len()
    );
    println!(
        "file {}, mesh {}",
        human_bytes(file.bytes()),
        human_bytes(u64::try_from(mesh.memory_bytes()).unwrap_or(0))
    );
    #[allow(clippy::cast_precision_loss, reason = "figures for people")]
    let (rate, peak) = (file.bytes() as f64 / seconds / 1e6, budget.peak() as f64 / file.bytes() as f64);
    println!("{:.1} ms, {rate:.0} MB/s, peak of what was charged {peak:.2} times the file", seconds * 1e3);
    Ok(())
}
