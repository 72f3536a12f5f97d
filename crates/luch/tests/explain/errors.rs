//! Mistakes: what is wrong, what would be right, and the exit code.

use crate::support::Folder;

/// Explains with these arguments and expects failure.
fn refused(folder: &Folder, args: &[&str], code: i32) -> String {
    let outcome = folder.luch(&[&["explain"], args].concat());
    assert_eq!((outcome.code, outcome.stdout.as_str()), (code, ""), "{args:?}: {}", outcome.stderr);
    outcome.stderr
}

#[test]
fn a_pixel_outside_the_picture_is_told_the_range() {
    let folder = Folder::with_small_scene();
    for pixel in ["40,0", "0,30", "-1,0", "3,-2", "9999999999,0"] {
        let told = refused(&folder, &["small.toml", "--pixel", pixel], 2);
        assert!(told.contains(&format!("--pixel {pixel} lies outside the picture of 40x30 pixels")), "{told}");
        assert!(told.contains("columns go from 0 to 39, rows from 0 to 29"), "{told}");
    }
    let told = refused(&folder, &["small.toml", "--pixel", "39,29", "--size", "39x29"], 2);
    assert!(told.contains("columns go from 0 to 38, rows from 0 to 28"), "{told}");
}

#[test]
fn what_is_no_pixel_is_told_how_one_is_written() {
    let folder = Folder::with_small_scene();
    for pixel in ["", "12", "12,", "1,2,3", "a,b", "1.5,2", "10x10"] {
        let told = refused(&folder, &["small.toml", "--pixel", pixel], 2);
        assert!(told.contains("as in 480,360"), "{pixel}: {told}");
    }
    assert!(refused(&folder, &["small.toml"], 2).contains("--pixel"));
}

#[test]
fn an_unknown_scene_camera_or_sample_is_told_what_there_is() {
    let folder = Folder::with_small_scene();
    let told = refused(&folder, &["two-sphere", "--pixel", "1,1"], 4);
    assert!(told.contains("two-spheres"), "{told}");
    let told = refused(&folder, &["small.toml", "--pixel", "1,1", "--camera", "3"], 2);
    assert!(told.contains("cameras 1 to 2"), "{told}");
    let told = refused(&folder, &["small.toml", "--pixel", "1,1", "--sample", "1"], 2);
    assert!(told.contains("has 1 samples, 0 to 0") && told.contains("--antialiasing"), "{told}");
    let told = refused(&folder, &["small.toml", "--pixel", "1,1", "--sample", "x"], 2);
    assert!(told.contains("all"), "{told}");
    refused(&folder, &["small.toml", "--pixel", "1,1", "--json", "--latex"], 2);
}

#[test]
fn an_account_beyond_all_bounds_is_a_limit_and_not_the_end_of_the_memory() {
    let folder = Folder::new();
    // Two perfect mirrors face each other: every ray goes on until the depth ends it.
    folder.write(
        "mirrors.toml",
        "luch = 1\nname = \"Mirrors\"\n[[light]]\nname = \"Lamp\"\nposition = [0.0, 0.0, 0.0]\n\
         [[camera]]\nname = \"C\"\nposition = [0.1, 0.1, 0.0]\ndirection = [0.0, 0.0, 1.0]\n\
         [[object]]\nname = \"A\"\nreflection = 1.0\n\
         wall = { point = [0.0, 0.0, 5.0], normal = [0.0, 0.0, -1.0] }\n\
         [[object]]\nname = \"B\"\nreflection = 1.0\n\
         wall = { point = [0.0, 0.0, -5.0], normal = [0.0, 0.0, 1.0] }\n",
    );
    let base = ["mirrors.toml", "--pixel", "480,360", "--depth", "10000"];
    let deep = folder.ok(&[&["explain"], base.as_slice(), &["--json"]].concat()).json();
    assert_eq!(deep["rays"].as_array().unwrap().len(), 20_001, "10,000 surfaces, a shadow ray each, and the end");
    let told = refused(&folder, &[base.as_slice(), &["--antialiasing", "4096"]].concat(), 5);
    assert!(told.contains("fewer rays"), "{told}");
}

#[test]
fn a_file_that_cannot_be_written_is_told_before_the_work() {
    let folder = Folder::with_small_scene();
    let told = refused(&folder, &["small.toml", "--pixel", "1,1", "-o", "nowhere/a.md"], 6);
    assert!(told.contains("there is no folder nowhere"), "{told}");
}
