//! `luch [SCENE]`: the window.

use crate::exit::{Code, Failure};
use crate::output;
use luch_io::SceneSource;
use luch_io::scene_file::nearest;
use luch_studio::{Milestone, Start};
use std::path::Path;
use std::sync::OnceLock;
use std::time::Instant;

/// The commands that a wrong word may have been meant for.
const COMMANDS: [&str; 6] = ["render", "explain", "scenes", "info", "study", "bench"];

/// Opens the window and waits until it is closed.
///
/// # Errors
/// For a scene that is not there, and where no window can be opened.
pub(crate) fn run(scene: Option<&Path>, times: bool, started: Instant) -> Result<(), Failure> {
    let milestone = times.then_some(tell as fn(Milestone));
    STARTED.get_or_init(|| started);
    let start = Start { scene: scene.map(find).transpose()?, hints: true, milestone, ..Start::default() };
    luch_studio::run(start).map_err(|error| {
        Failure::new(Code::Render, format!("no window can be opened: {error}"))
            .hint("without a display, make pictures with: luch render SCENE -o picture.png")
    })
}

/// When the program was started.
static STARTED: OnceLock<Instant> = OnceLock::new();

/// Says how long it took to come that far.
fn tell(milestone: Milestone) {
    let what = match milestone {
        Milestone::Window => "window",
        Milestone::FirstPicture => "first picture",
        Milestone::WholePicture => "whole picture",
    };
    let elapsed = STARTED.get().map(Instant::elapsed).unwrap_or_default();
    output::note(&format!("{what}: {:.0} ms", elapsed.as_secs_f64() * 1e3));
}

fn find(word: &Path) -> Result<SceneSource, Failure> {
    SceneSource::find(word).map_err(|error| {
        let mut failure = Failure::from(error);
        // A word alone may as well be a mistyped command.
        if let Some(command) = word.to_str().and_then(|word| nearest(word, COMMANDS)) {
            failure = failure.hint(format!("or did you mean the command `luch {command}`?"));
        }
        failure
    })
}
