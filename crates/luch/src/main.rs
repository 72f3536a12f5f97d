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
mod signals;
mod source;
mod text;
mod values;

use clap::error::{ContextKind, ContextValue};
use clap::{CommandFactory, Parser};
use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(exit::guarded(program))
}

/// Does what the command line says and answers with the exit code.
fn program() -> u8 {
    let cli = match args::Cli::try_parse() {
        Ok(cli) => cli,
        Err(refusal) => {
            if let Some(failure) = scene_without_command(&refusal) {
                output::error(&failure.to_string());
                return failure.code as u8;
            }
            // Help and version go to stdout, mistakes to stderr. If nobody reads either, there is nothing left to do.
            let _ = refusal.print();
            return u8::try_from(refusal.exit_code()).unwrap_or(exit::Code::Usage as u8);
        }
    };
    let outcome = match cli.command {
        None => {
            let _ = args::Cli::command().print_help();
            Ok(())
        }
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

/// `luch SCENE` opens the studio, one day: until then say how to get a picture.
fn scene_without_command(refusal: &clap::Error) -> Option<exit::Failure> {
    let Some(ContextValue::String(word)) = refusal.get(ContextKind::InvalidSubcommand) else { return None };
    luch_io::SceneSource::find(word.as_ref()).ok()?;
    let failure = exit::Failure::usage("the window of the studio is not part of this build");
    Some(failure.hint(format!("to make a picture: luch render {word} -o picture.png")))
}
