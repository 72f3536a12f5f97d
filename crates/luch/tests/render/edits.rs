//! `--set` on the real program, and the command lines of the fourteen functional tests.

use crate::support::Folder;

#[test]
fn assignments_change_the_picture_in_their_order() {
    let folder = Folder::with_small_scene();
    let hash = |sets: &[&str]| {
        let mut args = vec!["small.toml"];
        args.extend(sets.iter().flat_map(|set| ["--set", set]));
        folder.hash(&args)
    };
    let plain = hash(&[]);
    for set in [
        "Cube.color=yellow",
        "Cube.reflection=95%",
        "Ball.gloss=1",
        "Ball.position=0,1,0",
        "Ball.radius=0.5",
        "Cube.side=2",
        "Cube.rotation=0,30,0",
        "Floor.checker=1,#404040",
        "Cube.hidden=true",
        "No. 1 = best.color=#0f0",
        "Roof.scale=1.5",
        "Lamp.position=-3,6,4",
        "Lamp.color=red",
        "Front.position=0,3,7",
        "scene.ambient=90%",
    ] {
        assert_ne!(hash(&[set]), plain, "{set}");
    }
    assert_eq!(hash(&["Cube.color=#3264c8"]), plain, "the colour that it has");
    assert_eq!(hash(&["Cube.color=yellow", "Cube.color=#3264c8"]), plain, "the last one counts");
    assert_eq!(hash(&["Cube.name=Box", "Box.color=yellow"]), hash(&["Cube.color=yellow"]), "by its new name");
    assert_eq!(hash(&["Cube.color=yellow"]), hash(&["Cube.color=#ffff00"]));
}

#[test]
fn the_fourteen_functional_tests_are_command_lines() {
    let folder = Folder::new();
    let hash = |line: &str| folder.hash(&line.split(' ').collect::<Vec<_>>());
    let pictures = [
        "two-spheres",
        "chess",
        "knight",
        "two-spheres --camera 2",
        "two-spheres --camera 3",
        "chess --camera 2",
        "two-spheres --camera 3 --fov 90",
        "knight --camera 3 --set Knight.color=yellow",
        "knight --camera 2 --set Cube.reflection=95%",
        "two-spheres --light-intensity 80",
        "two-spheres --camera 2 --antialiasing 64",
        "knight --depth-of-field 64 --focal-distance 4",
        "two-spheres --set SPHERE.gloss=0 --set SPHERE.reflection=0",
        "two-spheres --set SPHERE.gloss=100% --set SPHERE.reflection=20%",
    ];
    let scenes = folder.ok(&["scenes", "--json"]).json();
    let spheres: Vec<&str> = scenes[0]["objects"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|o| o["kind"] == "sphere")
        .map(|o| o["name"].as_str().unwrap())
        .collect();
    let mut hashes: Vec<String> = Vec::new();
    for picture in pictures {
        if picture.contains("SPHERE") {
            let sets: Vec<String> = spheres
                .iter()
                .flat_map(|name| {
                    picture.split(' ').filter(|w| w.contains("SPHERE")).map(move |w| w.replace("SPHERE", name))
                })
                .collect();
            let mut args = vec!["two-spheres"];
            args.extend(sets.iter().flat_map(|set| ["--set", set.as_str()]));
            hashes.push(folder.hash(&args));
        } else {
            hashes.push(hash(picture));
        }
    }
    let count = hashes.len();
    hashes.sort_unstable();
    hashes.dedup();
    assert_eq!(hashes.len(), count, "fourteen different pictures");
}
