//! Ctrl-C, SIGTERM and the progress that a terminal shows.

use crate::support::Folder;
use crate::support::terminal::Session;
use rustix::process::Signal;

/// A render that would take hours.
const ENDLESS: &[&str] =
    &["render", "chess", "--size", "4000x3000", "--antialiasing", "4096", "-o", "a.png", "--stats", "a.json"];

#[test]
fn a_render_is_stopped_and_leaves_nothing_behind() {
    for (signal, code, words) in [(Signal::INT, 130, "Ctrl-C"), (Signal::TERM, 143, "SIGTERM")] {
        let folder = Folder::new();
        folder.write("a.png", "old");
        let mut session = Session::start(folder.path(), ENDLESS, &[]);
        assert!(session.wait_for(&["rendering ["]), "the render began");
        session.signal(signal);
        let (ended, screen, stdout) = session.end();
        assert_eq!((ended, stdout.as_str()), (code, ""), "{screen}");
        assert!(screen.contains(&format!("stopped by {words}")), "{screen}");
        assert_eq!(folder.names(), ["a.png"]);
        assert_eq!(folder.read("a.png"), b"old");
    }
}

#[test]
fn a_second_signal_is_no_worse() {
    let folder = Folder::new();
    let mut session = Session::start(folder.path(), ENDLESS, &[]);
    assert!(session.wait_for(&["rendering ["]), "the render began");
    session.signal(Signal::INT);
    session.signal(Signal::INT);
    let (code, screen, _) = session.end();
    assert_eq!(code, 130, "{screen}");
    assert!(folder.names().is_empty());
}

#[test]
fn loading_is_stopped_too() {
    let folder = Folder::new();
    // A million small triangles: long enough to be seen, and if not, the build or the render is stopped instead.
    let mut model = String::new();
    for i in 0..300_000 {
        let (x, y) = (i % 600, i / 600);
        model += &format!("v {x} {y} 0\nv {x}.5 {y} 1\nv {x} {y}.5 2\nf -3 -2 -1\n");
    }
    folder.write("big.obj", model);
    let args = ["render", "big.obj", "-o", "a.png", "--size", "4000x4000", "--antialiasing", "4096"];
    let mut session = Session::start(folder.path(), &args, &[]);
    assert!(session.wait_for(&["loading", "building", "rendering"]), "something is shown");
    session.signal(Signal::TERM);
    let (code, screen, _) = session.end();
    assert_eq!(code, 143, "{screen}");
    assert_eq!(folder.names(), ["big.obj"]);
}

#[test]
fn the_bar_tells_how_far_how_fast_and_how_long() {
    let folder = Folder::new();
    let mut session = Session::start(folder.path(), ENDLESS, &[]);
    assert!(session.wait_for(&[" left"]), "the bar is complete");
    session.signal(Signal::INT);
    let (_, screen, _) = session.end();
    for word in ["rendering [", " %", "ray/s", " left"] {
        assert!(screen.contains(word), "{word} is not in {screen}");
    }
}

#[test]
fn a_short_render_needs_no_progress() {
    let folder = Folder::with_small_scene();
    let (code, screen, _) = Session::start(folder.path(), &["render", "small.toml", "-o", "a.png"], &[]).end();
    assert_eq!((code, screen.as_str()), (0, ""));
}

#[test]
fn quiet_shows_no_progress() {
    let folder = Folder::new();
    let quiet: Vec<&str> = ENDLESS.iter().copied().chain(["--quiet"]).collect();
    let session = Session::start(folder.path(), &quiet, &[]);
    // There is nothing to wait for but the time after which progress would be shown. Too short a time proves nothing,
    // but is no failure either.
    std::thread::sleep(std::time::Duration::from_millis(1_500));
    session.signal(Signal::INT);
    let (code, screen, _) = session.end();
    assert_eq!(code, 130, "{screen}");
    assert!(screen.contains("stopped by Ctrl-C") && !screen.contains("rendering"), "{screen}");
}

#[cfg(target_os = "linux")]
#[test]
fn as_many_threads_render_as_were_asked_for() {
    let folder = Folder::new();
    let args: Vec<&str> = ENDLESS.iter().copied().chain(["--threads", "3"]).collect();
    let mut session = Session::start(folder.path(), &args, &[]);
    assert!(session.wait_for(&["rendering ["]), "the render began");
    // The third has no core of its own on a small machine and begins a little later.
    let patience = std::time::Instant::now() + std::time::Duration::from_secs(60);
    let renderers = |session: &Session| session.thread_names().iter().filter(|n| n.starts_with("luch-render")).count();
    while renderers(&session) < 3 && std::time::Instant::now() < patience {
        std::thread::yield_now();
    }
    let most = renderers(&session);
    session.signal(Signal::INT);
    assert_eq!((session.end().0, most), (130, 3));
}
