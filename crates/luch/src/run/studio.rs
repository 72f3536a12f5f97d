//! `luch [SCENE]`: the window.

use crate::exit::{Code, Failure};
use luch_io::SceneSource;
use luch_io::scene_file::nearest;
use luch_studio::Start;
use std::path::Path;

/// The commands that a wrong word may have been meant for.
const COMMANDS: [&str; 6] = ["render", "explain", "scenes", "info", "study", "bench"];

/// Opens the window and waits until it is closed.
///
/// # Errors
/// For a scene that is not there, and where no window can be opened.
pub(crate) fn run(scene: Option<&Path>) -> Result<(), Failure> {
    let start = Start { scene: scene.map(find).transpose()?, hints: true, ..Start::default() };
    luch_studio::run(start).map_err(|error| {
        Failure::new(Code::Render, format!("no window can be opened: {error}"))
            .hint("without a display, make pictures with: luch render SCENE -o picture.png")
    })
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
