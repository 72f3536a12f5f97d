//! The scale beside the views that show counts.

use crate::support::{Folder, Png};

#[test]
fn the_scale_stands_beside_the_picture_and_leaves_it_as_it_is() {
    let folder = Folder::with_small_scene();
    let base = ["render", "small.toml", "--size", "60x90", "--integrator", "triangles"];
    let stats = |more: &[&str]| folder.ok(&[base.as_slice(), &["--stats", "-"], more].concat()).json();
    let (alone, beside) = (stats(&["-o", "alone.png"]), stats(&["-o", "beside.png", "--color-bar"]));
    assert_eq!(alone["hash"], beside["hash"], "the hash and the size are the picture's");
    assert_eq!(beside["width"], 60);
    let (alone, beside) = (Png::decode(&folder.read("alone.png")), Png::decode(&folder.read("beside.png")));
    assert_eq!((beside.height, beside.width > 60 + 20), (90, true));
    assert_eq!(beside.part(0, 0, 60, 90), alone.bytes);
    let margin = beside.part(60, 0, beside.width - 60, 90);
    let colors: std::collections::BTreeSet<&[u8]> = margin.chunks_exact(3).collect();
    assert!(colors.len() > 30, "a bar of many colours: {}", colors.len());
    assert!(beside.texts.contains("\"color_bar\":true") && !alone.texts.contains("color_bar"));
    folder.ok(&[base.as_slice(), &["-o", "deep.png", "--color-bar", "--bits", "16"]].concat());
    assert_eq!(Png::decode(&folder.read("deep.png")).width, beside.width);
}

#[test]
fn there_is_no_scale_where_nothing_is_counted_or_nothing_but_light_fits() {
    let folder = Folder::with_small_scene();
    let refused = |args: &[&str]| {
        let outcome = folder.luch(&[&["render", "small.toml", "--color-bar"], args].concat());
        assert_eq!(outcome.code, 2, "{}", outcome.stderr);
        outcome.stderr
    };
    assert!(refused(&["-o", "a.png"]).contains("--integrator nodes"));
    assert!(refused(&["-o", "a.png", "--integrator", "cost"]).contains("cost shows no counts"));
    assert!(refused(&["-o", "a.exr", "--integrator", "nodes"]).contains("PNG"));
    assert_eq!(folder.names(), ["roof.obj", "small.toml"]);
}
