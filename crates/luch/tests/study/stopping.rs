//! Ctrl-C in a study: what was measured is not lost.

use crate::support::Folder;
use crate::support::terminal::Session;
use rustix::process::Signal;

/// A study that would take hours, in runs that take no time.
const ENDLESS: &[&str] = &[
    "study",
    "threads",
    "--threads",
    "1,2",
    "--size",
    "64x48",
    "--runs",
    "10000",
    "--warm-up",
    "0",
    "--language",
    "en",
    "-o",
    "out",
];

fn json(folder: &Folder) -> serde_json::Value {
    serde_json::from_slice(&folder.read("out/study.json")).unwrap()
}

#[test]
fn a_study_that_is_stopped_writes_what_it_has_marked_as_partial() {
    for (signal, code, words) in [(Signal::INT, 130, "Ctrl-C"), (Signal::TERM, 143, "SIGTERM")] {
        let folder = Folder::new();
        let mut session = Session::start(folder.path(), ENDLESS, &[]);
        assert!(session.wait_for(&["measuring ["]), "the study began");
        session.signal(signal);
        let (ended, screen, stdout) = session.end();
        assert_eq!((ended, stdout.as_str()), (code, ""), "{screen}");
        assert!(screen.contains(&format!("stopped by {words}: the runs made until then are in out")), "{screen}");

        let findings = json(&folder);
        assert_eq!(findings["partial"], true);
        let runs = |case: &serde_json::Value| case["render"]["runs_ms"].as_array().unwrap().len();
        let cases = findings["cases"].as_array().unwrap();
        assert!(cases.iter().map(runs).sum::<usize>() > 4, "half a second passed before the bar was shown");
        assert!(cases.iter().all(|case| runs(case) < 10_000));
        let report = String::from_utf8(folder.read("out/study.md")).unwrap();
        assert!(report.contains("> **Partial.** The study was stopped before its end"), "{report}");
        let csv = String::from_utf8(folder.read("out/study.csv")).unwrap();
        assert!(csv.lines().skip(1).all(|row| row.starts_with("threads,true,")), "{csv}");
        let entries = std::fs::read_dir(folder.path().join("out")).unwrap();
        assert_eq!(entries.count(), 9, "no temporary file is left");
    }
}

#[test]
fn a_long_run_is_stopped_in_its_middle() {
    let folder = Folder::new();
    let args = [
        "study",
        "rays",
        "--rays",
        "1,2048",
        "--reference",
        "4096",
        "--size",
        "4000x3000",
        "--warm-up",
        "0",
        "-o",
        "out",
    ];
    let mut session = Session::start(folder.path(), &args, &[]);
    // The picture that stands for the truth alone takes longer than anybody waits.
    assert!(session.wait_for(&["measuring ["]), "the study began");
    session.signal(Signal::INT);
    let (code, screen, _) = session.end();
    assert_eq!(code, 130, "{screen}");
    assert!(screen.contains("stopped by Ctrl-C: nothing was written"), "{screen}");
    assert!(folder.names().is_empty(), "the folder that was made for it is gone");
}

#[test]
fn the_bar_tells_how_long_a_study_will_take() {
    let folder = Folder::new();
    let mut session = Session::start(folder.path(), ENDLESS, &[]);
    assert!(session.wait_for(&[" left"]), "the bar is complete");
    session.signal(Signal::INT);
    session.signal(Signal::INT);
    let (code, screen, _) = session.end();
    assert_eq!(code, 130, "{screen}");
    for word in ["measuring [", " %", "ray/s", " left"] {
        assert!(screen.contains(word), "{word} is not in {screen}");
    }
    let left = std::fs::read_dir(folder.path().join("out")).map_or(0, |entries| {
        entries.filter(|e| e.as_ref().unwrap().file_name().to_string_lossy().contains(".tmp-")).count()
    });
    assert_eq!(left, 0, "a second signal leaves no half file either");
}
