//! The forms: JSON by its schema, text, Markdown, LaTeX, files.

use crate::schema::validate;
use crate::support::Folder;
use serde_json::Value;

const SCHEMA: &str = include_str!("../../../../docs/explain.schema.json");

#[test]
fn json_is_what_its_schema_says() {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    let folder = Folder::with_small_scene();
    for (scene, pixel, flags) in [
        ("small.toml", "13,17", vec!["--boxes"]),
        ("small.toml", "20,12", vec!["--boxes", "--shading", "gouraud", "--antialiasing", "3"]),
        ("small.toml", "20,1", vec!["--shading", "flat"]),
        ("small.toml", "20,15", vec!["--depth", "0"]),
        ("two-spheres", "330,380", vec!["--depth-of-field", "2"]),
        ("knight", "640,300", vec!["--boxes"]),
    ] {
        let mut args = vec!["explain", scene, "--pixel", pixel, "--json"];
        args.extend(&flags);
        let account = folder.ok(&args).json();
        validate(&account, &schema).unwrap_or_else(|wrong| panic!("{scene} {pixel} {flags:?}: {wrong}"));
        assert_eq!(flags.contains(&"--boxes"), account["rays"][0].get("way").is_some());
    }
}

#[test]
fn the_validator_finds_what_is_wrong() {
    let schema: Value = serde_json::from_str(SCHEMA).unwrap();
    let folder = Folder::with_small_scene();
    let account = folder.ok(&["explain", "small.toml", "--pixel", "13,17", "--json"]).json();
    let with = |change: &dyn Fn(&mut Value)| {
        let mut changed = account.clone();
        change(&mut changed);
        validate(&changed, &schema).unwrap_err()
    };
    assert!(with(&|a| a["pixel"][1] = "red".into()).contains("$.pixel[1]"));
    assert!(with(&|a| a["pixel"] = serde_json::json!([0.1, 0.2])).contains("minItems"));
    assert!(with(&|a| a["rays"][0]["kind"] = "light".into()).contains("$.rays[0].kind"));
    assert!(with(&|a| a["rays"][0]["colour"] = 1.into()).contains("with colour"));
    assert!(with(&|a| a["rays"][0]["weight"] = (-1).into()).contains("minimum"));
    assert!(with(&|a| a["srgb"] = "white".into()).contains("$.srgb"));
    assert!(with(&|a| drop(a.as_object_mut().unwrap().remove("spread"))).contains("without spread"));
}

#[test]
fn the_name_of_the_file_chooses_the_form_and_a_flag_wins() {
    let folder = Folder::with_small_scene();
    let base = ["explain", "small.toml", "--pixel", "13,17", "-o"];
    let write = |name: &str, flags: &[&str]| {
        let mut args = base.to_vec();
        args.push(name);
        args.extend(flags);
        let outcome = folder.ok(&args);
        assert_eq!(outcome.stdout, "");
        String::from_utf8(folder.read(name)).unwrap()
    };
    assert!(serde_json::from_str::<Value>(&write("a.json", &[])).is_ok());
    assert!(write("a.md", &[]).starts_with("# Pixel 13,17"));
    assert!(write("a.tex", &[]).contains("\\begin{document}"));
    assert!(write("a.txt", &[]).starts_with("Pixel 13,17"));
    assert!(write("b.txt", &["--markdown"]).starts_with("# Pixel 13,17"));
    assert_eq!(folder.names(), ["a.json", "a.md", "a.tex", "a.txt", "b.txt", "roof.obj", "small.toml"]);
    let to_stdout = folder.ok(&["explain", "small.toml", "--pixel", "13,17", "--markdown", "-o", "-"]);
    assert_eq!(to_stdout.stdout, String::from_utf8(folder.read("b.txt")).unwrap());
}

#[test]
fn text_is_in_the_language_asked_for_and_without_colours_in_a_pipe() {
    let folder = Folder::with_small_scene();
    let english = folder.ok(&["explain", "small.toml", "--pixel", "13,17"]).stdout;
    assert!(english.contains("Camera ray 0: hits “Ball”") && !english.contains('\x1b'), "{english}");
    let russian = folder.ok(&["explain", "small.toml", "--pixel", "13,17", "--language", "ru"]).stdout;
    assert!(russian.contains("Луч камеры 0: попадает в «Ball»"), "{russian}");
}

#[test]
fn samples_are_listed_and_the_one_asked_for_is_shown() {
    let folder = Folder::with_small_scene();
    let base = ["explain", "small.toml", "--pixel", "13,17", "--antialiasing", "4"];
    let rays = |text: &str| text.matches("Camera ray").count();
    let with = |flags: &[&str]| folder.ok(&[base.as_slice(), flags].concat()).stdout;
    let (first, all, last) = (with(&[]), with(&["--sample", "all"]), with(&["--sample", "3"]));
    assert_eq!((rays(&first), rays(&last), rays(&all)), (1, 1, 4));
    assert_ne!(first, last);
    assert!(first.contains("standard deviation"));
}
