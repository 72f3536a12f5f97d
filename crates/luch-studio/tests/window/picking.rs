//! A click selects what is drawn at that pixel; a click on nothing selects nothing.

use crate::support::reference::Reference;
use crate::support::{Desk, LANGUAGES};

#[test]
fn a_click_selects_what_the_picture_shows_there() {
    let size = [96, 54];
    for camera in [1, 3] {
        let reference = Reference::new("knight", camera, size, |_| {});
        for words in LANGUAGES {
            let mut desk = Desk::new(words);
            desk.choose(words.scene, words.knight);
            desk.resize(size[0], size[1]);
            desk.choose(words.camera, &reference.scene.cameras[camera - 1].name);
            for name in ["Knight", "Cube", "Sphere", "Floor", "Back wall"] {
                let [across, down] = reference.inside(name);
                desk.click_picture(across, down);
                assert_eq!(desk.harness.state().selected(), Some(name), "{name} from camera {camera}");
            }
            for (x, y) in (0..9).flat_map(|y| (0..16).map(move |x| (x * 6 + 2, y * 6 + 2))) {
                let name = reference.name_at((y * size[0] + x) as usize);
                desk.click_picture((x as f32 + 0.5) / size[0] as f32, (y as f32 + 0.5) / size[1] as f32);
                let selected = desk.harness.state().selected().unwrap_or_default();
                // A lamp is drawn over the picture.
                assert!(
                    selected == name || ["Lamp", "Fill"].contains(&selected),
                    "{selected}, not {name}, at {x}, {y}"
                );
            }
        }
    }
}
