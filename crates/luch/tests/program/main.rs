//! The program as a whole: help, version, streams.

#[path = "../support/mod.rs"]
mod support;

use std::io::pipe;
use support::{Folder, program};

/// A program that finds no display.
fn without_display(args: &[&str]) -> (Option<i32>, String) {
    let folder = Folder::new();
    let mut command = program(folder.path(), args);
    command.env_remove("DISPLAY").env_remove("WAYLAND_DISPLAY").env_remove("WAYLAND_SOCKET");
    let output = command.output().unwrap();
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

#[cfg(target_os = "linux")]
#[test]
fn without_a_display_the_studio_says_what_to_do_instead() {
    for args in [&[][..], &["chess"]] {
        let (code, stderr) = without_display(args);
        assert_eq!(code, Some(1), "{args:?}: {stderr}");
        assert!(stderr.contains("no window can be opened"), "{args:?}: {stderr}");
        assert!(stderr.contains("luch render SCENE -o"), "{args:?}: {stderr}");
        assert!(!stderr.contains(".rs"), "{args:?} tells of a source file: {stderr}");
        assert!(!stderr.contains("panic") && !stderr.contains("internal error"), "{args:?}: {stderr}");
    }
}

#[test]
fn every_help_text_has_an_example_and_fits_a_terminal() {
    let folder = Folder::new();
    for command in [&[][..], &["render"], &["scenes"], &["info"], &["bench"], &["bench", "rays"]] {
        for flag in ["--help", "-h"] {
            let args: Vec<&str> = command.iter().copied().chain([flag]).collect();
            let outcome = folder.luch(&args);
            assert_eq!((outcome.code, outcome.stderr.as_str()), (0, ""), "{args:?}");
            assert!(outcome.stdout.contains("Example"), "{args:?}");
            assert!(outcome.stdout.contains("Usage: luch"), "{args:?}");
            for line in outcome.stdout.lines() {
                assert!(line.chars().count() <= 100, "{args:?}: {line}");
            }
        }
    }
}

#[test]
fn the_help_of_render_names_every_flag_of_the_contract() {
    let help = Folder::new().ok(&["render", "--help"]).stdout;
    for flag in [
        "--output",
        "--camera",
        "--size",
        "--threads",
        "--depth",
        "--fov",
        "--antialiasing",
        "--depth-of-field",
        "--focal-distance",
        "--lens-radius",
        "--shading",
        "--light-intensity",
        "--set",
        "--integrator",
        "--crop",
        "--simd",
        "--stats",
        "--quiet",
        "--bits",
        "--memory",
    ] {
        assert!(help.contains(&format!("{flag} ")) || help.contains(&format!("{flag}\n")), "{flag}");
    }
}

#[test]
fn the_version_is_that_of_the_package() {
    let outcome = Folder::new().ok(&["--version"]);
    assert_eq!(outcome.stdout, format!("luch {}\n", env!("CARGO_PKG_VERSION")));
}

#[test]
fn a_word_that_is_neither_scene_nor_command_is_told_both() {
    let (code, stderr) = without_display(&["ches"]);
    assert_eq!(code, Some(4), "{stderr}");
    assert!(stderr.contains("did you mean the built-in scene `chess`"), "{stderr}");
    let (code, stderr) = without_display(&["rendr"]);
    assert_eq!(code, Some(4), "{stderr}");
    assert!(stderr.contains("did you mean the command `luch render`"), "{stderr}");
}

#[test]
fn a_reader_that_has_gone_away_is_no_panic() {
    let folder = Folder::with_small_scene();
    for (args, code) in [
        (&["scenes", "--json"][..], 6),
        (&["info", "small.toml"], 6),
        (&["render", "small.toml", "-o", "a.png", "--stats", "-"], 6),
        (&["render", "small.toml", "-o", "-"], 6),
        (&["--help"], 0),
        (&["render", "--help"], 0),
        (&["--version"], 0),
    ] {
        let (reader, writer) = pipe().unwrap();
        drop(reader);
        let output = program(folder.path(), args).stdout(writer).stderr(std::process::Stdio::piped()).output().unwrap();
        let stderr = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(code), "{args:?}: {stderr}");
        assert!(!stderr.contains("panic") && !stderr.contains("internal error"), "{args:?}: {stderr}");
        assert_eq!(folder.names(), ["roof.obj", "small.toml"], "{args:?}: no picture without success");
    }
}

#[test]
fn messages_are_plain_when_nobody_looks() {
    let outcome = Folder::new().luch(&["render", "nothing", "-o", "a.png"]);
    assert!(outcome.stderr.starts_with("error: nothing: there is no such scene"), "{}", outcome.stderr);
    assert!(!outcome.stderr.contains('\x1b'));
}

#[cfg(unix)]
#[test]
fn messages_are_coloured_at_a_terminal_unless_the_user_minds() {
    let folder = Folder::new();
    for (environment, colored) in [(&[][..], true), (&[("NO_COLOR", "1")], false), (&[("NO_COLOR", "")], true)] {
        for args in [&["render", "nothing", "-o", "a.png"][..], &["render", "--nonsense"]] {
            let (code, screen, _) = support::terminal::Session::start(folder.path(), args, environment).end();
            assert!(code > 0 && screen.contains("error"), "{screen}");
            assert_eq!(screen.contains("\x1b["), colored, "{environment:?} {args:?}: {screen:?}");
        }
    }
}
