//! Every flag does what it says, and nothing that it does not say.

use crate::support::{Folder, Png};

#[test]
fn the_size_is_the_size() {
    let folder = Folder::with_small_scene();
    let figures = folder.figures(&["small.toml", "--size", "33x17"]);
    assert_eq!((figures["width"].as_u64(), figures["height"].as_u64()), (Some(33), Some(17)));
    let png = Png::decode(&folder.read("figures.png"));
    assert_eq!((png.width, png.height, png.bits), (33, 17, 8));
    folder.ok(&["render", "small.toml", "-o", "own.png"]);
    let png = Png::decode(&folder.read("own.png"));
    assert_eq!((png.width, png.height), (40, 30), "the scene's own size");
}

#[test]
fn a_camera_is_chosen_by_name_or_number() {
    let folder = Folder::with_small_scene();
    let hash = |camera: &str| folder.hash(&["small.toml", "--camera", camera]);
    let first = folder.hash(&["small.toml"]);
    assert_eq!(hash("1"), first);
    assert_eq!(hash("Front"), first);
    assert_eq!(hash("2"), hash("Above"));
    assert_ne!(hash("2"), first);
}

#[test]
fn flags_of_the_camera_change_the_chosen_camera() {
    let folder = Folder::with_small_scene();
    let plain = folder.hash(&["small.toml", "--camera", "2"]);
    let with = |more: &[&str]| folder.hash(&[&["small.toml", "--camera", "2"], more].concat());
    assert_eq!(with(&["--fov", "45"]), plain, "45 degrees is the default");
    assert_ne!(with(&["--fov", "90"]), plain);
    assert_eq!(with(&["--fov", "90"]), with(&["--set", "Above.fov=90"]));
    let blurred = with(&["--depth-of-field", "4", "--focal-distance", "3"]);
    assert_ne!(blurred, plain);
    assert_ne!(with(&["--depth-of-field", "4", "--focal-distance", "8"]), blurred);
    assert_ne!(with(&["--depth-of-field", "4", "--focal-distance", "3", "--lens-radius", "0.5"]), blurred);
    assert_eq!(with(&["--focal-distance", "3", "--lens-radius", "0.5"]), plain, "without depth of field no blur");
}

#[test]
fn rays_per_pixel_are_those_asked_for() {
    let folder = Folder::with_small_scene();
    let rays = |args: &[&str]| folder.figures(&[&["small.toml"], args].concat())["rays_per_pixel"].as_u64().unwrap();
    assert_eq!(rays(&[]), 1);
    assert_eq!(rays(&["--antialiasing", "5"]), 5);
    assert_eq!(rays(&["--antialiasing", "off"]), 1);
    assert_eq!(rays(&["--depth-of-field", "3"]), 3);
    assert_eq!(rays(&["--antialiasing", "5", "--depth-of-field", "3"]), 5, "the effects share their rays");
    let on = crate::support::SMALL_SCENE.replace("[render]", "[render]\nantialiasing = { on = true, rays = 7 }");
    folder.write("on.toml", on);
    assert_eq!(folder.figures(&["on.toml"])["rays_per_pixel"], 7);
    assert_eq!(folder.figures(&["on.toml", "--antialiasing", "off"])["rays_per_pixel"], 1);
}

#[test]
fn depth_ends_the_mirrors() {
    let folder = Folder::with_small_scene();
    let hash = |depth: &str| folder.hash(&["small.toml", "--depth", depth]);
    assert_eq!(hash("5"), folder.hash(&["small.toml"]), "5 is the default");
    assert_ne!(hash("1"), hash("5"));
    assert_ne!(hash("0"), hash("1"));
}

#[test]
fn shading_is_set_for_the_whole_scene_and_changed_back_for_one_mesh() {
    let folder = Folder::with_small_scene();
    let own = crate::support::SMALL_SCENE
        .replace("mesh = \"roof.obj\"", "mesh = \"roof.obj\"\nshading = \"flat\"\ngloss = 0.9");
    folder.write("own.toml", own);
    let hash = |args: &[&str]| folder.hash(&[&["own.toml", "--camera", "2"], args].concat());
    let [flat, gouraud, phong] = ["flat", "gouraud", "phong"].map(|model| hash(&["--shading", model]));
    assert!(flat != gouraud && gouraud != phong && phong != flat);
    assert_eq!(hash(&[]), flat, "the mesh's own");
    assert_eq!(hash(&["--shading", "phong", "--set", "Roof.shading=flat"]), flat);
}

#[test]
fn light_intensity_is_that_of_every_light() {
    let folder = Folder::with_small_scene();
    let hash = |args: &[&str]| folder.hash(&[&["small.toml"], args].concat());
    assert_eq!(hash(&["--light-intensity", "100"]), hash(&[]));
    assert_eq!(hash(&["--light-intensity", "80"]), hash(&["--set", "Lamp.intensity=80%"]));
    assert_eq!(hash(&["--light-intensity", "80%"]), hash(&["--set", "Lamp.intensity=0.8"]));
    assert_eq!(hash(&["--light-intensity", "0"]), hash(&["--set", "Lamp.hidden=true"]));
    assert_ne!(hash(&["--light-intensity", "80"]), hash(&[]));
}

#[test]
fn every_integrator_makes_its_own_picture() {
    let folder = Folder::with_small_scene();
    let hash = |name: &str| folder.hash(&["small.toml", "--integrator", name]);
    let mut hashes: Vec<String> = ["classic", "normal", "depth", "objects", "cost"].map(hash).into();
    assert_eq!(hashes[0], folder.hash(&["small.toml"]), "classic is the default");
    hashes.sort_unstable();
    hashes.dedup();
    assert_eq!(hashes.len(), 5);
}

#[test]
fn the_picture_of_a_crop_is_that_part_of_the_whole() {
    let folder = Folder::with_small_scene();
    let render = |name: &str, more: &[&str]| {
        let fixed = ["render", "small.toml", "--size", "60x44", "--antialiasing", "3", "--bits", "16", "-o", name];
        folder.ok(&[&fixed, more].concat());
        Png::decode(&folder.read(name))
    };
    let whole = render("whole.png", &[]);
    for [x, y, width, height] in [[0, 0, 60, 44], [7, 5, 33, 34], [59, 43, 1, 1], [0, 20, 60, 1]] {
        let part = render("part.png", &["--crop", &format!("{x},{y},{width},{height}")]);
        assert_eq!((part.width, part.height), (width, height));
        assert!(part.bytes == whole.part(x, y, width, height), "{x},{y},{width},{height}");
    }
}

#[test]
fn the_picture_depends_neither_on_threads_nor_on_the_instruction_set_nor_on_the_run() {
    let folder = Folder::with_small_scene();
    let hash = |more: &[&str]| {
        let fixed = ["small.toml", "--size", "97x71", "--antialiasing", "2", "--depth-of-field", "3", "--camera", "2"];
        folder.hash(&[&fixed, more].concat())
    };
    let truth = hash(&["--threads", "1", "--simd", "scalar"]);
    assert_eq!(hash(&[]), truth);
    assert_eq!(hash(&[]), truth, "two runs");
    for threads in ["2", "3", "64", "1024"] {
        assert_eq!(hash(&["--threads", threads]), truth, "{threads} threads");
    }
    let refusal = folder.luch(&["render", "small.toml", "-o", "a.png", "--simd", "neon"]).stderr;
    // Where the machine has NEON, it has nothing else: then there is no list, and nothing more to try.
    let levels = refusal.split_once("it can run auto, ").map_or("", |(_, levels)| levels.trim());
    for level in levels.split(", ").filter(|level| !level.is_empty()) {
        assert_eq!(hash(&["--simd", level]), truth, "{level}");
    }
}

#[test]
fn quiet_leaves_out_the_warnings() {
    let folder = Folder::with_small_scene();
    folder.write("roof.obj", format!("{}l 1 2\n", crate::support::SMALL_MODEL));
    let loud = folder.ok(&["render", "small.toml", "-o", "a.png", "--focal-distance", "3"]);
    assert!(loud.stderr.contains("warning: lines and points"), "{}", loud.stderr);
    assert!(loud.stderr.contains("warning: --focal-distance has no effect"), "{}", loud.stderr);
    assert_eq!(loud.stdout, "");
    for quiet in ["--quiet", "-q"] {
        let outcome = folder.ok(&["render", "small.toml", "-o", "a.png", "--focal-distance", "3", quiet]);
        assert_eq!((outcome.stdout.as_str(), outcome.stderr.as_str()), ("", ""));
    }
}

#[test]
fn a_lens_without_radius_is_told_of() {
    let folder = Folder::with_small_scene();
    let outcome = folder.ok(&["render", "small.toml", "-o", "a.png", "--depth-of-field", "2"]);
    assert!(outcome.stderr.contains("nothing will blur"), "{}", outcome.stderr);
}
