//! The program: typed arguments (`args`, `values`) -> what they mean (`meaning`, `set`) -> doing it (`run`).

#![forbid(unsafe_code)]

mod args;
mod clock;
mod exit;
mod meaning;
mod output;
mod progress;
mod run;
mod set;
mod shot;
mod signals;
mod source;
mod text;
mod values;

use clap::Parser;
use std::process::ExitCode;
use std::time::Instant;

fn main() -> ExitCode {
    ExitCode::from(exit::guarded(program))
}

/// Does what the command line says and answers with the exit code.
fn program() -> u8 {
    let started = Instant::now();
    let cli = match args::Cli::try_parse() {
        Ok(cli) => cli,
        Err(refusal) => {
            // Help and version go to stdout, mistakes to stderr. If nobody reads either, there is nothing left to do.
            let _ = refusal.print();
            return u8::try_from(refusal.exit_code()).unwrap_or(exit::Code::Usage as u8);
        }
    };
    let outcome = match cli.command {
        None => run::studio::run(cli.scene.as_deref(), cli.times, started),
        Some(command) => run::run(command),
    };
    match outcome {
        Ok(()) => 0,
        Err(failure) => {
            output::error(&failure.to_string());
            failure.code as u8
        }
    }
}
