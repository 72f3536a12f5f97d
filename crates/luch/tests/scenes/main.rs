//! `luch scenes`.

#[path = "../support/mod.rs"]
mod support;

use support::Folder;

#[test]
fn the_built_in_scenes_are_listed_with_their_cameras_and_objects() {
    let scenes = Folder::new().ok(&["scenes", "--json"]).json();
    let ids: Vec<&str> = scenes.as_array().unwrap().iter().map(|s| s["id"].as_str().unwrap()).collect();
    assert_eq!(ids, ["two-spheres", "one-sphere", "knight", "chess"]);
    for scene in scenes.as_array().unwrap() {
        let keys: Vec<&str> = scene.as_object().unwrap().keys().map(String::as_str).collect();
        for key in ["id", "name", "cameras", "objects"] {
            assert!(keys.contains(&key), "{keys:?}");
        }
        let cameras = scene["cameras"].as_array().unwrap();
        assert_eq!(cameras.len(), 3, "{}", scene["id"]);
        assert!(cameras.iter().all(|c| c["name"].is_string()));
        for object in scene["objects"].as_array().unwrap() {
            assert!(object["name"].is_string());
            let kind = object["kind"].as_str().unwrap();
            assert!(["sphere", "cube", "box", "wall", "mesh"].contains(&kind), "{kind}");
        }
    }
    let kinds = |i: usize| {
        let objects = scenes[i]["objects"].as_array().unwrap();
        objects.iter().map(|o| o["kind"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    let count = |i: usize, kind: &str| kinds(i).iter().filter(|k| *k == kind).count();
    assert_eq!((count(0, "sphere"), count(1, "sphere"), count(3, "mesh")), (2, 1, 32));
    assert_eq!((count(2, "mesh"), count(2, "cube"), count(2, "sphere")), (1, 1, 1));
}

#[test]
fn the_list_for_people_has_a_line_for_each_scene() {
    let text = Folder::new().ok(&["scenes"]).stdout;
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines.len(), 4, "{text}");
    assert!(lines[0].starts_with("two-spheres"), "{text}");
}
