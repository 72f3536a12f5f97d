//! What makes no study says why, and leaves nothing.

use crate::support::Folder;

#[test]
fn plans_that_make_no_sense_are_wrong_usage() {
    let folder = Folder::new();
    for (args, words) in [
        (&["threads", "--runs", "0"][..], "\"0\" is not a number of runs from 1 to 10000"),
        (&["threads", "--runs", "many"], "\"many\" is not a number of runs"),
        (&["threads", "--runs", "-5"], "\"-5\" is not a number of runs"),
        (&["threads", "--warm-up", "1001"], "warm-up runs from 0 to 1000"),
        (&["threads", "--threads", "0"], "\"0\" is not a number of threads from 1 to 1024"),
        (&["threads", "--threads", "1,100000"], "\"100000\" is not a number of threads from 1 to 1024"),
        (&["threads", "--threads", ""], "with commas between them"),
        (&["threads", "--threads", "1,,2"], "\"\" is not a number of threads"),
        (&["threads", "--threads", "1,2,1"], "1 is there twice"),
        (&["threads", "--size", "0x0"], "\"0\" is not a number of pixels"),
        (&["threads", "--size", "big"], "as in 1920x1080"),
        (&["threads", "--size", "65535x65535"], "too large for a study"),
        (&["threads", "--scene", "one-sphere", "--scene", "one-sphere"], "the scene one-sphere is given twice"),
        (&["threads", "--language", "de"], "en, ru"),
        (&["threads", "--simd", "mmx"], "possible values"),
        (&["triangles", "--triangles", "7"], "\"7\" is not a number of triangles from 8 to 10000000"),
        (&["triangles", "--triangles", "1000,1001"], "would be the same mesh"),
        (&["triangles", "--threads", "0"], "threads from 1 to 1024"),
        (&["rays", "--rays", "5000"], "rays per pixel from 1 to 4096"),
        (&["rays", "--rays", "1,64", "--reference", "64"], "the reference needs more rays per pixel than the 64"),
        (&["rays", "--effect", "blur"], "antialiasing, depth-of-field, both"),
        (&["tiles", "--tiles", "0"], "pixels from 1 to 1024"),
        (&["tiles", "--tiles", "2048"], "pixels from 1 to 1024"),
    ] {
        let mut all = vec!["study"];
        all.extend(args);
        all.extend(["-o", "out"]);
        let outcome = folder.luch(&all);
        assert_eq!((outcome.code, outcome.stdout.as_str()), (2, ""), "{args:?}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{args:?}: {}", outcome.stderr);
        assert!(folder.names().is_empty(), "{args:?}");
    }
    let outcome = folder.luch(&["study", "threads"]);
    assert_eq!(outcome.code, 2, "{}", outcome.stderr);
    assert!(outcome.stderr.contains("--output <DIR>"), "{}", outcome.stderr);
}

#[test]
fn scenes_that_cannot_be_read_have_the_codes_of_their_fault() {
    let folder = Folder::new();
    folder.write("bad.toml", "luch = 2\n");
    for (scene, code) in [("nowhere", 4), ("bad.toml", 3)] {
        let outcome = folder.luch(&["study", "tiles", "--scene", scene, "-o", "out"]);
        assert_eq!(outcome.code, code, "{}", outcome.stderr);
        assert!(outcome.stderr.contains(scene), "{}", outcome.stderr);
        assert_eq!(folder.names(), ["bad.toml"]);
    }
}

#[test]
fn what_cannot_be_written_is_found_out_before_it_is_measured() {
    let folder = Folder::new();
    folder.write("file", "content");
    std::fs::create_dir_all(folder.path().join("taken/study.csv")).unwrap();
    // Hours, if they were measured.
    let endless = ["study", "threads", "--size", "7680x4320", "--runs", "10000"];
    for (place, words) in
        [("file", "a study is written to a folder"), ("file/deep", "cannot be"), ("taken", "study.csv: is a folder")]
    {
        let outcome = folder.luch(&[&endless[..], &["-o", place]].concat());
        assert_eq!(outcome.code, 6, "{place}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{place}: {}", outcome.stderr);
    }
    assert_eq!(folder.read("file"), b"content");
    assert_eq!(folder.names(), ["file", "taken"]);
}
