//! `cargo xtask`: the tools of the repository.

#![forbid(unsafe_code)]

use std::path::PathBuf;
use std::process::{Command, ExitCode};

use xtask::gallery::Gallery;

const USAGE: &str = "usage: cargo xtask models [--out DIR] [--only PIECE]
       cargo xtask gallery [--out DIR] [--only TEXT] [--rays N] [--luch PROGRAM]";

#[allow(clippy::print_stderr, reason = "a command line tool reports on the terminal")]
fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    match run(&args) {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}

fn run(args: &[String]) -> Result<(), String> {
    match args.first().map(String::as_str) {
        Some("models") => models(&args[1..]),
        Some("gallery") => gallery(&args[1..]),
        _ => Err(USAGE.to_owned()),
    }
}

/// Writes the OBJ file of each piece (or of the one named by `--only`) and prints its figures.
#[allow(clippy::print_stdout, reason = "a command line tool reports on the terminal")]
fn models(args: &[String]) -> Result<(), String> {
    let mut out = PathBuf::from(xtask::MODELS_DIR);
    let mut only = None;
    let mut args = args.iter();
    while let Some(flag) = args.next() {
        let value = args.next().ok_or(USAGE)?;
        match flag.as_str() {
            "--out" => out = PathBuf::from(value),
            "--only" => only = Some(value.as_str()),
            _ => return Err(USAGE.to_owned()),
        }
    }
    std::fs::create_dir_all(&out).map_err(|e| format!("{}: {e}", out.display()))?;
    for piece in xtask::models::Piece::ALL {
        if only.is_some_and(|name| name != piece.name()) {
            continue;
        }
        let mesh = piece.build();
        let text = xtask::models::obj::write(piece.name(), &mesh);
        let path = out.join(format!("{}.obj", piece.name()));
        std::fs::write(&path, &text).map_err(|e| format!("{}: {e}", path.display()))?;
        println!("{}: {} triangles, {} bytes", path.display(), mesh.faces.len(), text.len());
    }
    Ok(())
}

/// Renders the pictures of docs/gallery; builds the program first unless `--luch` names one.
#[allow(clippy::print_stdout, reason = "a command line tool reports on the terminal")]
fn gallery(args: &[String]) -> Result<(), String> {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| PathBuf::from("target"), PathBuf::from);
    let mut luch = None;
    let mut gallery = Gallery {
        luch: target.join("release").join("luch"),
        out: PathBuf::from(xtask::gallery::GALLERY_DIR),
        scratch: target.join("gallery"),
        only: None,
        rays: 64,
    };
    let mut args = args.iter();
    while let Some(flag) = args.next() {
        let value = args.next().ok_or(USAGE)?;
        match flag.as_str() {
            "--out" => gallery.out = PathBuf::from(value),
            "--only" => gallery.only = Some(value.clone()),
            "--rays" => gallery.rays = value.parse().map_err(|_| USAGE)?,
            "--luch" => luch = Some(PathBuf::from(value)),
            _ => return Err(USAGE.to_owned()),
        }
    }
    match luch {
        Some(luch) => gallery.luch = luch,
        None => {
            let build = Command::new("cargo").args(["build", "--release", "--package", "luch"]).status();
            if !build.is_ok_and(|status| status.success()) {
                return Err("cargo build --release --package luch failed".to_owned());
            }
        }
    }
    gallery.render(|picture| println!("{}", picture.display()))
}
