//! `luch info`.

#[path = "../support/mod.rs"]
mod support;

use support::Folder;

#[test]
fn a_scene_is_described() {
    let info = Folder::with_small_scene().ok(&["info", "small.toml", "--json"]).json();
    assert_eq!(info["name"], "Small");
    assert_eq!(info["objects"].as_array().unwrap().len(), 5);
    assert_eq!(info["objects"][1], serde_json::json!({ "name": "Cube", "kind": "cube" }));
    assert_eq!(info["objects"][4]["kind"], "mesh");
    assert_eq!(info["cameras"][1]["name"], "Above");
    assert_eq!(info["lights"][0]["name"], "Lamp");
    assert_eq!(info["triangles"], 4);
    assert_eq!(info["bounds"], serde_json::json!({ "min": [-2.5, 0.0, -1.0], "max": [2.0, 2.5, 2.4] }));
    assert!(info["memory_bytes"].as_u64().unwrap() > 0);
    assert_eq!(info["warnings"], serde_json::json!([]));
}

#[test]
fn instances_are_counted_in_triangles_and_not_in_memory() {
    let folder = Folder::with_small_scene();
    folder.write("roof.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\n".repeat(100));
    let one = folder.ok(&["info", "small.toml", "--json"]).json();
    let again = format!("{}[[object]]\nmesh = \"roof.obj\"\n", support::SMALL_SCENE);
    let two = folder.write("two.toml", again).ok(&["info", "two.toml", "--json"]).json();
    assert_eq!((&one["triangles"], &two["triangles"]), (&100.into(), &200.into()));
    let bytes = |info: &serde_json::Value| info["memory_bytes"].as_u64().unwrap();
    // Three vertices, a normal and a triangle, each of 12 bytes, for each of the hundred.
    assert!(bytes(&one) > 6_000, "{one}");
    assert!(bytes(&two) < bytes(&one) + 1_000, "the second roof shares the mesh of the first");
}

#[test]
fn a_bare_model_is_a_scene_and_its_warnings_are_told() {
    let folder = Folder::new();
    folder.write("roof.obj", format!("{}l 1 2\np 1\nmtllib gone.mtl\n", support::SMALL_MODEL));
    let info = folder.ok(&["info", "roof.obj", "--json"]).json();
    assert_eq!(info["triangles"], 4);
    assert_eq!(info["cameras"].as_array().unwrap().len(), 3);
    let warnings = info["warnings"].to_string();
    assert!(warnings.contains("lines and points") && warnings.contains("gone.mtl"), "{warnings}");
    let text = folder.ok(&["info", "roof.obj"]).stdout;
    assert!(text.contains("triangles  4") && text.contains("gone.mtl"), "{text}");
}

#[test]
fn an_endless_scene_has_no_bounds() {
    let folder = Folder::new();
    folder.write("floor.toml", "luch = 1\n[[object]]\nwall = { point = [0, 0, 0], normal = [0, 1, 0] }\n");
    assert_eq!(folder.ok(&["info", "floor.toml", "--json"]).json()["bounds"], serde_json::Value::Null);
}

#[test]
fn what_cannot_be_described_says_why() {
    let folder = Folder::new();
    folder.write("bad.toml", "luch = 1\ncolr = 2\n").write("bad.obj", "v 1 2\n");
    for (args, code, words) in [
        (&["info", "bad.toml"][..], 3, "bad.toml:2:1"),
        (&["info", "bad.obj", "--json"], 3, "bad.obj:1"),
        (&["info", "gone.toml"], 4, "gone.toml"),
        (&["info", "chess.obj"], 4, "did you mean the built-in scene `chess`?"),
        (&["info", "."], 4, "folder"),
        (&["info", "chess", "--memory", "ten"], 2, "--memory"),
        (&["info"], 2, "<SCENE>"),
        (&["info", "chess", "--jsn"], 2, "--json"),
    ] {
        let outcome = folder.luch(args);
        assert_eq!((outcome.code, outcome.stdout.as_str()), (code, ""), "{args:?}: {}", outcome.stderr);
        assert!(outcome.stderr.contains(words), "{args:?}: {}", outcome.stderr);
    }
}
