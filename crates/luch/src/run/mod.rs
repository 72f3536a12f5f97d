//! Does what a command means.

mod bench_rays;
mod explain;
mod info;
mod render;
mod scenes;
pub(crate) mod studio;
mod study;

use crate::args::{BenchCommand, Command};
use crate::exit::Failure;
use crate::meaning::Request;
use crate::signals::Watch;

/// Runs the command to its end.
///
/// # Errors
/// What the user is to read; the exit code is in it.
pub(crate) fn run(command: Command) -> Result<(), Failure> {
    let watch = Watch::start()?;
    match command {
        Command::Render(args) => render::run(&Request::of(*args)?, &watch),
        Command::Explain(args) => explain::run(*args, &watch),
        Command::Scenes(args) => scenes::run(&args, &watch),
        Command::Info(args) => info::run(&args, &watch),
        Command::Study(command) => study::run(command, &watch),
        Command::Bench(BenchCommand::Rays(args)) => bench_rays::run(&args, &watch),
    }
}
