//! Every way to write the same thing.

use super::{CUBE, bad, good};

const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

#[test]
fn line_ends_marks_and_blanks_do_not_matter() {
    let (plain, _) = good("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let spellings = [
        "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n",
        "v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r",
        "v 0 0 0\rv 1 0 0\nv 0 1 0\r\n\n\r\r\nf 1 2 3",
        "\u{feff}v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3",
        "  v\t0  0 0 \n\tv 1 0 0\t\n \nv 0 1 0 # a corner\n   # c\nf 1 2 3#c",
        "v 0 \\\n0 0\nv 1 0 0\nv \\\r\n\\\n 0 1 0\nf 1 2\\\n3\n",
        "v +0 -0 0.\nv 1.e0 .0 0e5\nv 0 10e-1 0\nf 1 2 3\n",
        "v 0 0 0 1.0\nv 1 0 0 0.5 0.5 0.5\nv 0 1 0 1 0 0 1\nf 1 2 3\n",
        "g a b\no \u{448}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nfo 1 2 3\n",
        "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n",
        "vt 0 0\nvt 1 nonsense\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1/1 2/2 3/1\n",
    ];
    for text in spellings {
        let (mesh, _) = good(text);
        assert_eq!(mesh.positions(), plain.positions(), "{text:?}");
        assert_eq!(mesh.triangles(), plain.triangles(), "{text:?}");
    }
}

#[test]
fn indices_below_zero_count_from_what_was_read() {
    let absolute = format!("{CUBE}vn 0 0 1\nvn 0 1 0\nf 1//1 2//2 3//1\nv 5 5 5\nf 9 8 7\n");
    let relative = format!("{CUBE}vn 0 0 1\nvn 0 1 0\nf -8//-2 -7//-1 -6//-2\nv 5 5 5\nf -1 -2 -3\n");
    let ((a, _), (b, _)) = (good(&absolute), good(&relative));
    assert_eq!(a.triangles(), b.triangles());
    assert_eq!(a.normal_triangles(), b.normal_triangles());
    assert_eq!(a.triangles()[1], [8, 7, 6]);
}

#[test]
fn normals_of_the_file_are_taken_and_made_unit() {
    let (mesh, _) = good(&format!("{TRIANGLE}vn 0 0 5\nvn 3 0 4\nvn 0 1 1e30\nf 1/1/2 2//1 3//3\nvt 0 0\n"));
    assert_eq!(mesh.normal_triangles(), [[1, 0, 2]]);
    assert_eq!(mesh.normals(), [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, 1e-30, 1.0]]);
}

#[test]
fn a_face_that_lacks_one_normal_gets_computed_ones() {
    let (mesh, report) = good(&format!("{TRIANGLE}vn 1 0 0\nf 1//1 2//1 3\n"));
    assert!(report.lines()[0].contains("m.obj:5"), "{:?}", report.lines());
    for n in mesh.normal_triangles()[0] {
        assert_eq!(mesh.normals()[n as usize], [0.0, 0.0, 1.0]);
    }
}

#[test]
fn what_is_left_out_is_counted() {
    let text = format!(
        "{TRIANGLE}f 1 2 3\nl 1 2\np 1\nl 2 3\ncurv 1 2 \\\n 3\nfoo bar\nfoo\nbar\nf 1 2\nf 1 1 2\nf 1 1 2 3\ncall rm -rf\n"
    );
    let (mesh, report) = good(&text);
    assert_eq!(mesh.triangles(), [[0, 1, 2], [0, 1, 2]]);
    assert_eq!(report.count("lines and points are skipped"), 3);
    assert_eq!(report.count("curves and surfaces are skipped"), 1);
    assert_eq!(report.count("unknown statements are skipped"), 2, "once for each word");
    assert_eq!(report.count("faces of fewer than three corners are skipped"), 1);
    assert_eq!(report.count("faces without area are dropped"), 1);
    assert_eq!(report.count("corners that repeat their neighbour are dropped"), 1);
    assert_eq!(report.count("commands in a model are never run"), 1);
    assert!(report.lines().iter().any(|l| l.contains("\"foo\" (m.obj:10)")), "{:?}", report.lines());
}

#[test]
fn an_error_shows_its_place() {
    assert_eq!(
        bad("v 0 0 0\nv 1 0 0\n\nv 1 0,5 0\nf 1 2 3"),
        "m.obj:4:5: \"0,5\" is not a number\n   |\n 4 | v 1 0,5 0\n   |     ^^^\nhint: the decimal separator is a point"
    );
    assert_eq!(
        bad(&format!("{TRIANGLE}f 1 2 4 # four\n")),
        "m.obj:4:7: vertex 4 does not exist: the file has 3 vertices\n   |\n 4 | f 1 2 4 # four\n   |       ^\nhint: indices count from 1"
    );
    for (text, words) in [
        ("v 0 0\n", "m.obj:1:6: the line ends too early: a vertex has three coordinates"),
        ("v\n", "m.obj:1:2: the line ends too early"),
        ("v 0 nan 0\n", "m.obj:1:5: \"nan\" is not a number"),
        ("v 0 -inf 0\n", "\"-inf\" is not a number"),
        ("v 0 1e400 0\n", "1:5: 1e400 is too large"),
        ("v 0 2e9 0\n", "from -1e9 to 1e9"),
        ("v 1 2 3 x\n", "1:9: \"x\" is not a number"),
        ("vn 1 2 3 4\n", "1:10: \"4\" is more than the statement has"),
        ("v 0 0 0\nf 0 1 1\n", "2:3: \"0\" has the index 0"),
        ("v 0 0 0\nf -1 -2 -1\n", "2:6: vertex -2 does not exist: 1 come before this line"),
        ("v 0 0 0\nf 1/2/3/4 1 1\n", "2:3: \"1/2/3/4\" is no corner"),
        ("v 0 0 0\nf 1.5 1 1\n", "\"1.5\" is no corner"),
        ("v 0 0 0\nf 99999999999999999999 1 1\n", "has an index that no model reaches"),
        ("v 0 0 0\r\nf 1 x 1\r\n", "2:5: \"x\" is no corner"),
        ("", "the file is empty"),
        ("# nothing\n", "the file has no faces and no vertices"),
        ("v 0 0 0\n", "1 vertices but no faces"),
        ("v 0 0 0\nl 1 1\np 1\n", "2 lines and points but no faces"),
        ("v 0 0 0\nf 1 1 1\n", "no faces with an area"),
    ] {
        assert!(bad(text).contains(words), "{text:?} gives {}", bad(text));
    }
}
