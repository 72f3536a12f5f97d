//! Wrong input of every kind: the exit code, words that must occur, and nothing written.

use crate::support::Folder;

/// A folder full of trouble.
fn trouble() -> Folder {
    let folder = Folder::with_small_scene();
    let mesh = |path: &str| format!("luch = 1\n[[object]]\nmesh = \"{path}\"\n");
    folder
        .write("old.png", "old")
        .write("sub/inside.txt", "")
        .write("notes.txt", "no scene")
        .write("empty.toml", "")
        .write("typo.toml", "luch = 1\n[[object]]\nsphere = { center = [0, 0, 0], radius = 1 }\ncolr = \"#fff\"\n")
        .write("future.toml", "luch = 99\n")
        .write("binary.toml", [0xff, 0xfe, 0x00])
        .write("gone.toml", mesh("gone.obj"))
        .write("escape.toml", mesh("../../../etc/passwd"))
        .write("absolute.toml", mesh("/etc/passwd"))
        .write("remote.toml", mesh("http://example.com/a.obj"))
        .write("bad_model.toml", mesh("bad.obj"))
        .write("bad.obj", "v 0 0 0\nf 1 2 3\n")
        .write("nan.obj", "v 0 nan 0\n")
        .write("nothing.obj", "# nothing\n");
    folder
}

/// A command line behind `luch render`, what it must end with, and what it must say.
type Case = (&'static [&'static str], i32, &'static [&'static str]);

#[rustfmt::skip]
const CASES: &[Case] = &[
    // The command line itself.
    (&[], 2, &["--output", "<SCENE>"]),
    (&["small.toml"], 2, &["--output"]),
    (&["-o", "a.png"], 2, &["<SCENE>"]),
    (&["small.toml", "-o", "a.png", "more"], 2, &["unexpected argument", "more"]),
    (&["small.toml", "-o", "a.png", "--szie", "8x8"], 2, &["--szie", "--size"]),
    (&["small.toml", "-o", "a.png", "-o", "b.png"], 2, &["--output", "multiple times"]),
    (&["small.toml", "-o", "a.png", "--size"], 2, &["--size", "value is required"]),
    // Numbers and words.
    (&["small.toml", "-o", "a.png", "--size", "0x0"], 2, &["--size", "pixels from 1 to 65535"]),
    (&["small.toml", "-o", "a.png", "--size", "100000x1"], 2, &["--size", "100000", "65535"]),
    (&["small.toml", "-o", "a.png", "--size", "99999999999999999999x1"], 2, &["65535"]),
    (&["small.toml", "-o", "a.png", "--size", "640"], 2, &["1920x1080"]),
    (&["small.toml", "-o", "a.png", "--size", "big"], 2, &["1920x1080"]),
    (&["small.toml", "-o", "a.png", "--size", "-1x5"], 2, &["--size"]),
    (&["small.toml", "-o", "a.png", "--size", ""], 2, &["--size"]),
    (&["small.toml", "-o", "a.png", "--threads", "0"], 2, &["threads from 1 to 1024"]),
    (&["small.toml", "-o", "a.png", "--threads", "100000"], 2, &["threads from 1 to 1024"]),
    (&["small.toml", "-o", "a.png", "--threads", "-1"], 2, &["threads from 1 to 1024"]),
    (&["small.toml", "-o", "a.png", "--threads", "two"], 2, &["\"two\""]),
    (&["small.toml", "-o", "a.png", "--depth", "-1"], 2, &["0 to 10000"]),
    (&["small.toml", "-o", "a.png", "--depth", "10001"], 2, &["0 to 10000"]),
    (&["small.toml", "-o", "a.png", "--fov", "0"], 2, &["0.01 to 179"]),
    (&["small.toml", "-o", "a.png", "--fov", "180"], 2, &["0.01 to 179"]),
    (&["small.toml", "-o", "a.png", "--fov", "-45"], 2, &["0.01 to 179"]),
    (&["small.toml", "-o", "a.png", "--fov", "nan"], 2, &["0.01 to 179"]),
    (&["small.toml", "-o", "a.png", "--fov", "45,5"], 2, &["with a point"]),
    (&["small.toml", "-o", "a.png", "--antialiasing", "0"], 2, &["1 to 4096", "off"]),
    (&["small.toml", "-o", "a.png", "--antialiasing", "4097"], 2, &["1 to 4096"]),
    (&["small.toml", "-o", "a.png", "--antialiasing", "on"], 2, &["1 to 4096", "off"]),
    (&["small.toml", "-o", "a.png", "--depth-of-field", "many"], 2, &["1 to 4096"]),
    (&["small.toml", "-o", "a.png", "--focal-distance", "0"], 2, &["above 0"]),
    (&["small.toml", "-o", "a.png", "--focal-distance", "inf"], 2, &["above 0"]),
    (&["small.toml", "-o", "a.png", "--lens-radius", "-1"], 2, &["at least 0"]),
    (&["small.toml", "-o", "a.png", "--lens-radius", "1e400"], 2, &["finite"]),
    (&["small.toml", "-o", "a.png", "--shading", "smooth"], 2, &["flat, gouraud, phong"]),
    (&["small.toml", "-o", "a.png", "--light-intensity", "-5"], 2, &["at least 0"]),
    (&["small.toml", "-o", "a.png", "--light-intensity", "bright"], 2, &["\"bright\" is not a number"]),
    (&["small.toml", "-o", "a.png", "--integrator", "path"], 2, &["classic, normal, depth, objects, cost"]),
    (&["small.toml", "-o", "a.png", "--crop", "1,2,3"], 2, &["100,50,320,240"]),
    (&["small.toml", "-o", "a.png", "--crop", "0,0,0,5"], 2, &["at least 1"]),
    (&["small.toml", "-o", "a.png", "--crop", "-1,0,5,5"], 2, &["100,50,320,240"]),
    (&["small.toml", "-o", "a.png", "--crop", "40,0,1,1"], 2, &["reaches out of the picture", "40x30"]),
    (&["small.toml", "-o", "a.png", "--crop", "0,0,41,30"], 2, &["reaches out"]),
    (&["small.toml", "-o", "a.png", "--crop", "4294967295,0,4294967295,1"], 2, &["reaches out"]),
    (&["small.toml", "-o", "a.png", "--simd", "mmx"], 2, &["auto, scalar"]),
    (&["small.toml", "-o", "a.png", "--bits", "12"], 2, &["8, 16"]),
    (&["small.toml", "-o", "a.exr", "--bits", "16"], 2, &["--bits is for PNG"]),
    (&["small.toml", "-o", "a.png", "--memory", "lots"], 2, &["512M"]),
    (&["small.toml", "-o", "a.png", "--memory", "0"], 2, &["512M"]),
    // Names of the scene.
    (&["small.toml", "-o", "a.png", "--camera", "0"], 2, &["cameras 1 to 2"]),
    (&["small.toml", "-o", "a.png", "--camera", "3"], 2, &["cameras 1 to 2", "\"Above\""]),
    (&["small.toml", "-o", "a.png", "--camera", "-1"], 2, &["no camera"]),
    (&["small.toml", "-o", "a.png", "--camera", "Abowe"], 2, &["did you mean \"Above\"?"]),
    (&["small.toml", "-o", "a.png", "--set", "Kube.color=red"], 2, &["did you mean \"Cube\"?", "\"No. 1 = best\"", "\"Lamp\""]),
    (&["small.toml", "-o", "a.png", "--set", "Cube.colour=red"], 2, &["did you mean `color`?", "reflection"]),
    (&["small.toml", "-o", "a.png", "--set", "Cube.color=rad"], 2, &["did you mean \"red\"?"]),
    (&["small.toml", "-o", "a.png", "--set", "Cube.reflection=95"], 2, &["write 95%"]),
    (&["small.toml", "-o", "a.png", "--set", "Ball.side=1"], 2, &["a sphere has no `side`", "radius"]),
    (&["small.toml", "-o", "a.png", "--set", "Cube"], 2, &["OBJECT.key=value"]),
    (&["small.toml", "-o", "a.png", "--set", ""], 2, &["OBJECT.key=value"]),
    (&["small.toml", "-o", "a.png", "--set", "Cube.color=red", "--set", "Cube.name=Ball"], 2, &["\"Ball\" is taken"]),
    // Scenes and models.
    (&["nowhere.toml", "-o", "a.png"], 4, &["nowhere.toml", "two-spheres"]),
    (&["ches", "-o", "a.png"], 4, &["did you mean the built-in scene `chess`?"]),
    (&["", "-o", "a.png"], 2, &["<SCENE>"]),
    (&["sub", "-o", "a.png"], 4, &["sub", "folder"]),
    (&["notes.txt", "-o", "a.png"], 3, &["notes.txt", ".toml"]),
    (&["empty.toml", "-o", "a.png"], 3, &["empty.toml", "luch"]),
    (&["typo.toml", "-o", "a.png"], 3, &["typo.toml:4:1", "did you mean `color`?"]),
    (&["future.toml", "-o", "a.png"], 3, &["future.toml:1", "99"]),
    (&["binary.toml", "-o", "a.png"], 3, &["binary.toml", "UTF-8"]),
    (&["gone.toml", "-o", "a.png"], 4, &["gone.toml:3", "gone.obj"]),
    (&["escape.toml", "-o", "a.png"], 4, &["escape.toml:3", "passwd"]),
    (&["absolute.toml", "-o", "a.png"], 4, &["absolute.toml:3"]),
    (&["remote.toml", "-o", "a.png"], 4, &["remote.toml:3"]),
    (&["bad_model.toml", "-o", "a.png"], 3, &["bad.obj:2"]),
    (&["bad.obj", "-o", "a.png"], 3, &["bad.obj:2"]),
    (&["nan.obj", "-o", "a.png"], 3, &["nan.obj:1"]),
    (&["nothing.obj", "-o", "a.png"], 3, &["nothing.obj"]),
    // Limits.
    (&["small.toml", "-o", "a.png", "--size", "65535x65535", "--memory", "1G"], 5, &["GiB", "--memory"]),
    (&["roof.obj", "-o", "a.png", "--memory", "64"], 5, &["roof.obj", "--memory"]),
    // Outputs.
    (&["small.toml", "-o", "a.bmp"], 2, &["a.bmp", ".png or .exr"]),
    (&["small.toml", "-o", "picture"], 2, &["picture", ".png or .exr"]),
    (&["small.toml", "-o", ""], 2, &["--output"]),
    (&["small.toml", "-o", "nowhere/a.png"], 6, &["nowhere/a.png", "mkdir"]),
    (&["small.toml", "-o", "notes.txt/a.png"], 6, &["notes.txt is a file"]),
    (&["small.toml", "-o", "a.png", "--stats", "nowhere/a.json"], 6, &["nowhere/a.json", "mkdir"]),
    (&["small.toml", "-o", "a.png", "--stats", "sub"], 6, &["sub", "folder"]),
    (&["small.toml", "-o", "a.png", "--stats", "a.png"], 2, &["the same place"]),
    (&["small.toml", "-o", "-", "--stats", "-"], 2, &["the same place"]),
];

#[test]
fn wrong_input_is_one_clear_error_and_writes_nothing() {
    assert!(CASES.len() >= 60);
    let folder = trouble();
    let before = folder.names();
    let mut wrong = Vec::new();
    for (args, code, words) in CASES {
        let outcome = folder.luch(&[&["render"], *args].concat());
        let said = |word: &&str| outcome.stderr.contains(*word);
        let right = outcome.code == *code
            && words.iter().all(said)
            && outcome.stderr.starts_with("error: ")
            && !outcome.stderr.contains("internal error")
            && outcome.stdout.is_empty()
            && folder.names() == before;
        if !right {
            wrong.push(format!("{args:?}: expected {code} and {words:?}, got {outcome:?}"));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn an_older_picture_outlives_a_failure() {
    let folder = trouble();
    for args in
        [&["typo.toml"][..], &["gone.toml"], &["small.toml", "--set", "x.y=z"], &["small.toml", "--memory", "9K"]]
    {
        let outcome = folder.luch(&[&["render", "-o", "old.png", "--stats", "old.png.json"], args].concat());
        assert!(outcome.code > 0, "{args:?}");
        assert_eq!(folder.read("old.png"), b"old", "{args:?}");
    }
}

#[test]
fn a_level_of_simd_that_the_machine_lacks_lists_those_that_it_has() {
    let folder = trouble();
    // No machine has both.
    let outcomes =
        ["neon", "sse4.2"].map(|level| folder.luch(&["render", "small.toml", "-o", "a.png", "--simd", level]));
    let refused = outcomes.iter().find(|o| o.code == 2).expect("one of them is lacking");
    assert!(refused.stderr.contains("it can run auto, scalar"), "{}", refused.stderr);
}

#[test]
fn names_that_are_hard_on_a_terminal_are_shown_harmless() {
    let folder = trouble();
    let outcome = folder.luch(&["render", "\x1b[31mred.toml", "-o", "a.png"]);
    assert_eq!(outcome.code, 4);
    assert!(!outcome.stderr.contains('\x1b'), "{:?}", outcome.stderr);
}

#[cfg(unix)]
#[test]
fn a_name_that_is_no_unicode_is_a_name() {
    use std::os::unix::ffi::OsStrExt;
    let folder = trouble();
    let name = std::ffi::OsStr::from_bytes(b"\xff.toml");
    std::fs::copy(folder.path().join("small.toml"), folder.path().join(name)).unwrap();
    let output = crate::support::program(folder.path(), &["render"]).arg(name).args(["-o", "a.png"]).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
}
