//! What a study leaves: files that are there, whole, and say the same.

use crate::support::{Folder, Png, program};
use serde_json::Value;

/// Small enough to take no time.
const SMALL: [&str; 6] = ["--size", "24x18", "--runs", "2", "--warm-up", "1"];

fn study(folder: &Folder, args: &[&str]) -> Value {
    let mut all = vec!["study"];
    all.extend(args.iter().chain(&SMALL));
    all.extend(["-o", "out", "--quiet"]);
    let outcome = folder.ok(&all);
    assert_eq!((outcome.stdout.as_str(), outcome.stderr.as_str()), ("", ""), "quiet");
    serde_json::from_slice(&folder.read("out/study.json")).unwrap()
}

fn names(folder: &Folder) -> Vec<String> {
    let entries = std::fs::read_dir(folder.path().join("out")).unwrap();
    let mut names: Vec<String> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn threads_of_both_scenes_are_measured_and_written() {
    let folder = Folder::new();
    let findings = study(&folder, &["threads", "--threads", "1,2,3", "--language", "en"]);
    let expected = [
        "study.csv",
        "study.json",
        "study.md",
        "threads-all.png",
        "threads-all.svg",
        "threads-from-2.png",
        "threads-from-2.svg",
        "threads-speed-up.png",
        "threads-speed-up.svg",
    ];
    assert_eq!(names(&folder), expected);
    assert_eq!((&findings["study"], &findings["partial"]), (&"threads".into(), &false.into()));
    let cases = findings["cases"].as_array().unwrap();
    let seen: Vec<(&str, u64)> =
        cases.iter().map(|c| (c["scene"].as_str().unwrap(), c["threads"].as_u64().unwrap())).collect();
    let scenes = ["one-sphere", "two-spheres"];
    assert_eq!(seen, scenes.iter().flat_map(|s| [1, 2, 3].map(|n| (*s, n))).collect::<Vec<_>>());
    for case in cases {
        assert_eq!(case["render"]["runs_ms"].as_array().unwrap().len(), 2);
        assert!(case["render"]["summary_ms"]["median"].as_f64().unwrap() > 0.0);
        assert!(case["speed_up"].is_f64() && case["rays"].as_u64().unwrap() > 24 * 18);
    }
    // More of the scene, more rays; the picture is the same at any number of threads, and so are its rays.
    assert!(cases[3]["rays"].as_u64() > cases[0]["rays"].as_u64());
    assert_eq!(cases[0]["rays"], cases[2]["rays"]);

    let csv = String::from_utf8(folder.read("out/study.csv")).unwrap();
    let rows: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!((rows.len(), rows[0][9]), (7, "median_ms"));
    assert_eq!(rows[4][9].parse::<f64>().ok(), cases[3]["render"]["summary_ms"]["median"].as_f64());

    let report = String::from_utf8(folder.read("out/study.md")).unwrap();
    assert!(report.starts_with("# Render time against the number of threads\n"), "{report}");
    for part in ["(threads-all.svg)", "(threads-from-2.svg)", "626.01", "24x18"] {
        assert!(report.contains(part), "{part}: {report}");
    }
    for name in expected.iter().filter(|name| name.ends_with(".png")) {
        assert_eq!(Png::decode(&folder.read(&format!("out/{name}"))).width, 1920, "{name}");
    }
    assert!(folder.read("out/threads-all.svg").starts_with(b"<svg "));
}

#[test]
fn the_other_studies_have_their_own_files() {
    for (args, plots) in [
        (&["triangles", "--triangles", "100,1000"][..], &["triangles"][..]),
        (&["rays", "--rays", "1,4", "--reference", "16"], &["rays-noise", "rays-time"]),
        (&["tiles", "--tiles", "8,16"], &["tiles"]),
    ] {
        let folder = Folder::new();
        let findings = study(&folder, args);
        assert_eq!(findings["study"], args[0]);
        assert_eq!(findings["cases"].as_array().unwrap().len(), 2);
        let mut expected: Vec<String> = ["study.csv", "study.json", "study.md"].map(str::to_owned).to_vec();
        expected.extend(plots.iter().flat_map(|p| [format!("{p}.png"), format!("{p}.svg")]));
        expected.sort();
        assert_eq!(names(&folder), expected);
    }
}

#[test]
fn more_rays_are_less_noise_and_more_triangles_take_longer_to_build() {
    let folder = Folder::new();
    let rays = study(&folder, &["rays", "--rays", "1,16", "--reference", "256", "--effect", "both"]);
    let noise = |i: usize| rays["cases"][i]["noise_rmse"].as_f64().unwrap();
    assert!(noise(0) > 2.0 * noise(1) && noise(1) > 0.0, "{} {}", noise(0), noise(1));
    assert_eq!((&rays["setting"]["effect"], &rays["setting"]["reference_rays"]), (&"both".into(), &256.into()));
    let triangles = study(&folder, &["triangles", "--triangles", "100,20000", "--threads", "1"]);
    let build = |i: usize| triangles["cases"][i]["build"]["summary_ms"]["minimum"].as_f64().unwrap();
    assert!(build(1) > build(0), "two hundred times as much work: {} {}", build(0), build(1));
    // Within the same folder the other study's plots stay; the three common files are of the last study.
    assert!(names(&folder).contains(&"rays-noise.svg".to_owned()));
}

#[test]
fn a_scene_of_ones_own_is_studied_by_its_path() {
    let folder = Folder::with_small_scene();
    let findings = study(&folder, &["threads", "--threads", "1,2", "--scene", "small.toml", "--scene", "one-sphere"]);
    assert_eq!(findings["setting"]["scenes"][0]["id"], "small.toml");
    assert_eq!(findings["cases"][0]["triangles"], 4, "a roof of two slopes");
    assert_eq!(findings["growth"][0]["from"], "small.toml");
}

#[test]
fn the_language_is_the_systems_unless_it_is_chosen() {
    let folder = Folder::new();
    let title = |language: &[&str], variables: &[(&str, &str)]| {
        let mut args = vec!["study", "tiles", "--tiles", "16,32", "-o", "out"];
        args.extend(SMALL.iter().chain(language));
        let mut command = program(folder.path(), &args);
        command.env_remove("LC_ALL").env_remove("LC_MESSAGES").env_remove("LANG").envs(variables.iter().copied());
        let output = command.output().unwrap();
        assert!(output.status.success());
        let report = String::from_utf8(folder.read("out/study.md")).unwrap();
        (report.lines().next().unwrap().to_owned(), String::from_utf8(output.stdout).unwrap())
    };
    let (english, russian) =
        ("# Render time against the size of the tiles", "# Зависимость времени визуализации от размера плиток");
    assert_eq!(title(&[], &[]).0, english);
    let (report, stdout) = title(&[], &[("LANG", "ru_RU.UTF-8")]);
    assert_eq!(report, russian);
    assert!(stdout.contains("быстрее всего плитки") && stdout.ends_with("study.md\n"), "{stdout}");
    assert_eq!(title(&["--language", "en"], &[("LC_ALL", "ru_RU.UTF-8")]).0, english);
    assert_eq!(title(&["--language", "ru"], &[]).0, russian);
}

#[test]
fn an_older_study_is_replaced() {
    let folder = Folder::new();
    folder.write("out/study.md", "old").write("out/notes.txt", "mine");
    study(&folder, &["tiles", "--tiles", "16"]);
    assert!(folder.read("out/study.md").starts_with(b"# "));
    assert_eq!(folder.read("out/notes.txt"), b"mine");
}
