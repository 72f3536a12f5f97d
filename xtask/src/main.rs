//! `cargo xtask`: the tools of the repository.

use std::path::PathBuf;
use std::process::ExitCode;

const USAGE: &str = "usage: cargo xtask models [--out DIR] [--only PIECE]";

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
