//! Tests 1 to 3: the built-in scenes.

use crate::support::{Desk, LANGUAGES};

#[test]
fn test_1_a_fresh_start_renders_two_spheres() {
    for words in LANGUAGES {
        let mut desk = Desk::new(words);
        let picture = desk.render();
        assert_eq!((picture.width, picture.height), (960, 720));
        assert_eq!(desk.harness.state().scene().name, "Two spheres");
    }
}
