//! `luch explain`: the account is right, its forms are what they claim, and mistakes are told.

mod errors;
mod forms;
mod lesson;
mod schema;
#[path = "../support/mod.rs"]
mod support;

use support::Folder;

/// The three numbers of a JSON list, as an EXR picture would hold them.
fn bits(value: &serde_json::Value) -> [u32; 3] {
    std::array::from_fn(|c| {
        let number = value[c].as_f64().unwrap_or_else(|| panic!("{value}"));
        (number as f32).to_bits()
    })
}

/// The pixel of an EXR picture of one pixel.
fn bits_of_exr(folder: &Folder, name: &str) -> [u32; 3] {
    use exr::prelude::*;
    let path = folder.path().join(name);
    let image = read_first_rgba_layer_from_file(
        path,
        |size, _| vec![[0_f32; 3]; size.area()],
        |pixels: &mut Vec<[f32; 3]>, at, (r, g, b, _): (f32, f32, f32, f32)| pixels[at.x() + at.y()] = [r, g, b],
    );
    image.unwrap().layer_data.channel_data.pixels[0].map(f32::to_bits)
}

#[test]
fn the_pixel_is_that_of_render_bit_for_bit_whatever_the_flags() {
    let folder = Folder::with_small_scene();
    for (place, flags) in [
        ("13,17", vec![]),
        ("22,16", vec!["--antialiasing", "7"]),
        ("20,5", vec!["--camera", "Above", "--depth-of-field", "5", "--focal-distance", "3"]),
        ("19,12", vec!["--shading", "gouraud", "--set", "Roof.gloss=80%", "--set", "Roof.reflection=0.3"]),
        ("39,29", vec!["--fov", "70", "--light-intensity", "80", "--depth", "1"]),
        ("1,0", vec!["--size", "20x10", "--depth", "0"]),
    ] {
        let crop = format!("{place},1,1");
        let mut render = vec!["render", "small.toml", "-o", "pixel.exr", "--crop", &crop];
        render.extend(&flags);
        folder.ok(&render);
        let mut explain = vec!["explain", "small.toml", "--pixel", place, "--json"];
        explain.extend(&flags);
        let account = folder.ok(&explain).json();
        assert_eq!(bits(&account["pixel"]), bits_of_exr(&folder, "pixel.exr"), "{place} {flags:?}");
    }
}

#[test]
fn the_account_names_what_is_there() {
    let folder = Folder::with_small_scene();
    let account = folder.ok(&["explain", "small.toml", "--pixel", "13,17", "--json"]).json();
    let camera = &account["rays"][0];
    assert_eq!(camera["kind"], "camera");
    assert_eq!(camera["hit"]["object"]["name"], "Ball");
    assert_eq!(camera["hit"]["kind"], "sphere");
    assert_eq!(camera["hit"]["material"]["reflection"], 0.5);
    let kinds: Vec<&str> =
        account["rays"].as_array().unwrap().iter().map(|ray| ray["kind"].as_str().unwrap()).collect();
    assert!(kinds.contains(&"shadow") && kinds.contains(&"mirror"), "{kinds:?}");
    assert_eq!(account["setting"]["lights"][0]["name"], "Lamp");
    // The floor under the ball: the ball stands before the lamp.
    let shadow = folder.ok(&["explain", "small.toml", "--pixel", "13,17", "--json", "--set", "Ball.hidden=true"]);
    assert_ne!(shadow.json()["rays"][0]["hit"]["object"]["name"], "Ball");
}

#[test]
fn what_blocks_a_light_is_named() {
    let folder = Folder::new();
    // A lamp, a shade under it, and a camera that looks at the floor below.
    folder.write(
        "shade.toml",
        "luch = 1\nname = \"Shade\"\n[[light]]\nname = \"Lamp\"\nposition = [0.0, 5.0, 0.0]\n\
         [[camera]]\nname = \"C\"\nposition = [0.0, 2.0, 6.0]\nlook_at = [0.0, 0.0, 0.0]\n\
         [[object]]\nname = \"Floor\"\nwall = { point = [0.0, 0.0, 0.0], normal = [0.0, 1.0, 0.0] }\n\
         [[object]]\nname = \"Shade\"\nsphere = { center = [0.0, 4.0, 0.0], radius = 0.5 }\n",
    );
    let account = folder.ok(&["explain", "shade.toml", "--pixel", "480,360", "--json"]).json();
    let light = &account["rays"][0]["hit"]["lights"][0];
    assert_eq!(light["visibility"], "blocked");
    assert_eq!(light["blocked_by"]["name"], "Shade");
    let shadow = &account["rays"][1];
    assert_eq!((&shadow["kind"], &shadow["end"]), (&"shadow".into(), &"blocked".into()));
    assert_eq!(shadow["blocker"]["object"]["name"], "Shade");
    let height = shadow["blocker"]["position"][1].as_f64().unwrap();
    assert!((height - 3.5).abs() < 0.01, "{height}");
    let text = folder.ok(&["explain", "shade.toml", "--pixel", "480,360"]).stdout;
    assert!(text.contains("blocked by “Shade”"), "{text}");
}
