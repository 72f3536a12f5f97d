//! Tests 3, 8 and 9: the knight, the cube and the sphere.

use crate::lab::Lab;
use crate::picture::Picture;

const SIZE: [usize; 2] = [160, 120];

#[test]
fn test_03_the_knight_scene_shows_knight_cube_and_sphere() {
    let lab = Lab::new(SIZE);
    let (picture, objects) = (lab.png(3), lab.objects(3));
    for (name, least) in [("Knight", 0.08), ("Cube", 0.04), ("Sphere", 0.03), ("Floor", 0.15), ("Back wall", 0.15)] {
        assert!(objects.share(name) > least, "{name}: {}", objects.share(name));
    }
    for name in ["Knight", "Cube", "Sphere"] {
        assert!(!objects.is_cut_off(name), "{name} is cut off");
        let contrast = picture.contrast(&objects.of(name));
        assert!(contrast > 0.15, "{name} is flat: {contrast}");
    }
    let [sphere, knight, cube] = ["Sphere", "Knight", "Cube"].map(|name| objects.middle(name)[0]);
    assert!(sphere < knight && knight < cube, "{sphere} {knight} {cube}");

    // Each in its own colour: cream, red, blue.
    let [red, green, blue] = picture.mean(&objects.of("Knight"));
    assert!(red > green && green > blue && blue < 0.6 * red, "the knight: {red} {green} {blue}");
    let [red, green, blue] = picture.mean(&objects.of("Cube"));
    assert!(red > 3.0 * green && red > 3.0 * blue, "the cube: {red} {green} {blue}");
    let [red, green, blue] = picture.mean(&objects.of("Sphere"));
    assert!(blue > 1.3 * green && green > red, "the sphere: {red} {green} {blue}");
}

#[test]
fn test_08_the_knight_in_the_middle_turns_yellow_and_nothing_else_does() {
    let lab = Lab::new(SIZE);
    let (picture, objects) = (lab.png(8), lab.objects(8));
    let before = lab.linear(3, "--camera 3");
    let after = lab.linear(8, "");

    // A click into the middle of the picture picks the knight.
    assert_eq!(objects.name_at(SIZE[1] / 2 * SIZE[0] + SIZE[0] / 2), "Knight");

    // Yellow but for the highlights.
    let knight = objects.of("Knight");
    let yellow = |picture: &Picture, i: usize| {
        let [red, green, blue] = picture.pixels[i];
        (red - green).abs() < 0.2 * red && blue < 0.25 * green
    };
    let share = |picture: &Picture| knight.iter().filter(|i| yellow(picture, **i)).count() as f64 / knight.len() as f64;
    assert!(share(&picture) > 0.85, "{} of the knight is yellow", share(&picture));
    assert!(share(&before) < 0.01, "{} of the knight was yellow before", share(&before));
    assert!(objects.share("Knight") > 0.1);

    // What mirrors nothing stays as it was, bit for bit; mirrors may show the knight, and the sphere does.
    let wall = objects.of("Back wall");
    assert!(wall.len() > 2000);
    assert_eq!(after.changed(&before, &wall, 0.0), [0; 0]);
    let sphere = objects.of("Sphere");
    let mirrored = after.changed(&before, &sphere, 0.01);
    assert!(mirrored.len() > 10 && mirrored.len() < sphere.len() / 2, "{} pixels", mirrored.len());
    for i in mirrored {
        assert!(after.pixels[i][2] < before.pixels[i][2], "the sphere mirrors less blue");
    }
}

#[test]
fn test_09_a_mirror_cube_shows_the_room() {
    let lab = Lab::new(SIZE);
    let (picture, objects) = (lab.png(9), lab.objects(9));
    let cube = objects.of("Cube");
    assert!(objects.share("Cube") > 0.05);
    let reflecting = |share: &str| lab.linear(3, &format!("--camera 2 --set 'Cube.reflection={share}'"));
    let (before, after) = (lab.linear(3, "--camera 2"), lab.linear(9, ""));

    // (1-r) local + r mirrored, at every pixel. The cube is seen again in what it mirrors, hence the tolerance.
    let (local, mirrored) = (reflecting("0"), reflecting("1"));
    for &i in &cube {
        for c in 0..3 {
            let mixed = 0.05 * local.pixels[i][c] + 0.95 * mirrored.pixels[i][c];
            assert!((after.pixels[i][c] - mixed).abs() < 0.01, "{i}: {} {mixed}", after.pixels[i][c]);
        }
    }

    // The mean moves to what is mirrored, the picture on the cube gets richer.
    let apart = |a: &Picture| {
        let (a, b) = (a.mean(&cube), mirrored.mean(&cube));
        (0..3).map(|c| (a[c] - b[c]).powi(2)).sum::<f64>().sqrt()
    };
    assert!(apart(&after) < 0.1 * apart(&before), "{} {}", apart(&after), apart(&before));
    let contrast = [&before, &picture].map(|p| p.contrast(&cube));
    assert!(contrast[1] > 1.3 * contrast[0], "{contrast:?}");

    // The cube's own hue counts 1-r: its share is what painting the cube black takes away.
    let own_share = |with: &Picture, share: &str| {
        let black = reflecting(&format!("{share}' --set 'Cube.color=#000000"));
        cube.iter().map(|&i| f64::from(with.pixels[i][0] - black.pixels[i][0])).sum::<f64>()
    };
    let (few, many) = (own_share(&after, "95%"), own_share(&before, "12%"));
    let expected = (1.0 - 0.95) / (1.0 - 0.12);
    assert!((few / many / expected - 1.0).abs() < 0.1, "{} instead of {expected}", few / many);

    // The knight is in the mirror.
    let green = lab.linear(9, "--set 'Knight.color=#00ff00'");
    let reflected = after.changed(&green, &cube, 0.05).len();
    assert!(reflected > cube.len() / 20, "{reflected} of {}", cube.len());
}
