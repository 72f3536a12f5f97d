//! Pictures and figures: what is in them, and where they go.

use crate::support::{Folder, Png};

#[test]
fn the_figures_have_exactly_their_keys() {
    let folder = Folder::with_small_scene();
    let text = folder.ok(&["render", "small.toml", "-o", "a.png", "--stats", "-", "--threads", "2"]).stdout;
    let keys: Vec<&str> =
        text.lines().filter_map(|l| l.trim().strip_prefix('"')?.split_once('"')).map(|(key, _)| key).collect();
    assert_eq!(
        keys,
        [
            "width",
            "height",
            "rays_per_pixel",
            "threads",
            "simd",
            "load_ms",
            "build_ms",
            "render_ms",
            "cpu_ms",
            "rays",
            "rays_per_s",
            "triangles",
            "hash"
        ]
    );
    let figures: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(figures["threads"], 2);
    assert_eq!(figures["triangles"], 4);
    assert_ne!(figures["simd"], "auto");
    for key in ["load_ms", "build_ms", "render_ms", "cpu_ms", "rays_per_s"] {
        assert!(figures[key].as_f64().is_some_and(|v| v >= 0.0), "{key}");
    }
    assert!(figures["rays"].as_u64().unwrap() > 40 * 30, "camera, shadow and mirror rays");
    let hash = figures["hash"].as_str().unwrap();
    assert!(hash.len() == 64 && hash.bytes().all(|b| b.is_ascii_hexdigit()), "{hash}");
}

#[test]
fn the_figures_go_to_a_file_too() {
    let folder = Folder::with_small_scene();
    let outcome = folder.ok(&["render", "small.toml", "-o", "a.png", "--stats", "a.json"]);
    assert_eq!(outcome.stdout, "");
    let figures: serde_json::Value = serde_json::from_slice(&folder.read("a.json")).unwrap();
    assert_eq!(figures["hash"], folder.figures(&["small.toml"])["hash"]);
    assert_eq!(
        folder.names(),
        ["a.json", "a.png", "figures.png", "roof.obj", "small.toml"],
        "and nothing else is left"
    );
}

#[test]
fn a_picture_says_how_it_was_made() {
    let folder = Folder::with_small_scene();
    let figures = folder.figures(&["small.toml", "--antialiasing", "3", "--crop", "1,2,30,20"]);
    let texts = Png::decode(&folder.read("figures.png")).texts;
    for word in
        ["Small", "\"camera\":\"Front\"", "\"rays_per_pixel\":3", "[1,2,30,20]", figures["hash"].as_str().unwrap()]
    {
        assert!(texts.contains(word), "{word} is not in {texts}");
    }
}

#[test]
fn formats() {
    let folder = Folder::with_small_scene();
    for (name, bits, magic) in [
        ("a.png", &[][..], &b"\x89PNG"[..]),
        ("b.PNG", &["--bits", "8"], b"\x89PNG"),
        ("c.png", &["--bits", "16"], b"\x89PNG"),
        ("d.exr", &[], b"\x76\x2f\x31\x01"),
    ] {
        folder.ok(&[&["render", "small.toml", "-o", name], bits].concat());
        assert!(folder.read(name).starts_with(magic), "{name}");
    }
    assert_eq!(Png::decode(&folder.read("a.png")).bits, 8);
    let (eight, sixteen) = (Png::decode(&folder.read("a.png")), Png::decode(&folder.read("c.png")));
    assert_eq!(sixteen.bits, 16);
    for (eight, sixteen) in eight.bytes.iter().zip(sixteen.bytes.chunks_exact(2)) {
        let wide = f64::from(u16::from_be_bytes([sixteen[0], sixteen[1]])) / 257.0;
        assert!((wide - f64::from(*eight)).abs() <= 0.51, "{wide} and {eight}");
    }
}

#[test]
fn a_picture_goes_to_a_pipe() {
    let folder = Folder::with_small_scene();
    folder.ok(&["render", "small.toml", "-o", "a.png"]);
    let output = crate::support::program(folder.path(), &["render", "small.toml", "-o", "-"]).output().unwrap();
    assert!(output.status.success());
    assert!(output.stdout == folder.read("a.png"), "the same bytes as in a file");
}

#[test]
fn an_older_picture_is_replaced() {
    let folder = Folder::with_small_scene();
    folder.write("a.png", "old").write("a.json", "old");
    folder.ok(&["render", "small.toml", "-o", "a.png", "--stats", "a.json"]);
    assert!(folder.read("a.png").starts_with(b"\x89PNG"));
    assert!(folder.read("a.json").starts_with(b"{"));
    assert_eq!(folder.names(), ["a.json", "a.png", "roof.obj", "small.toml"]);
}

#[test]
fn the_output_is_tried_before_the_scene_is_read() {
    let folder = Folder::new();
    folder.write("broken.toml", "this is no scene");
    let outcome = folder.luch(&["render", "broken.toml", "-o", "nowhere/a.png"]);
    assert_eq!(outcome.code, 6, "{}", outcome.stderr);
    assert!(outcome.stderr.contains("mkdir -p nowhere"), "{}", outcome.stderr);
}

#[test]
fn memory_is_counted_before_the_work() {
    let folder = Folder::with_small_scene();
    let outcome = folder.luch(&["render", "small.toml", "-o", "a.png", "--size", "40000x40000", "--memory", "8G"]);
    assert_eq!(outcome.code, 5);
    assert!(outcome.stderr.contains("GiB") && outcome.stderr.contains("--memory"), "{}", outcome.stderr);
    assert_eq!(folder.luch(&["render", "small.toml", "-o", "a.png", "--memory", "1K"]).code, 5);
    folder.ok(&["render", "small.toml", "-o", "a.png", "--memory", "64M"]);
    // A part of a huge picture is no huge picture.
    let corner = ["--size", "65535x65535", "--crop", "65530,65530,5,5", "--memory", "64M"];
    folder.ok(&[&["render", "small.toml", "-o", "a.png"], &corner[..]].concat());
}
