//! Pictures that are larger than a texture may be: they are shown all the same, and clicked where they show things.

use crate::support::reference::Reference;
use crate::support::{Desk, LANGUAGES};
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable;

/// The longest side of the textures that are there, in pixels.
fn longest_texture(desk: &Desk) -> usize {
    let textures = desk.harness.ctx.tex_manager();
    let sides: Vec<_> = textures.read().allocated().flat_map(|(_, texture)| texture.size).collect();
    sides.into_iter().max().expect("a texture")
}

#[test]
fn a_picture_wider_than_any_texture_is_shown_and_picked_by_its_own_pixels() {
    let size = [5001, 12];
    let reference = Reference::new("two-spheres", 1, size, |_| {});
    for (words, focus) in LANGUAGES.into_iter().zip(["Focus", "Фокус"]) {
        let mut desk = Desk::new(words);
        let most = desk.harness.ctx.input(|i| i.max_texture_side);
        assert!(most < size[0] as usize, "the window may have textures of {most}");
        desk.resize(size[0], size[1]);
        reference.assert_shown(&desk);
        assert!(longest_texture(&desk) <= most);
        let [across, down] = reference.inside("Left sphere");
        desk.click_picture(across, down);
        assert_eq!(desk.harness.state().selected(), Some("Left sphere"));
        // What is in focus is shown by a texture as well.
        desk.harness.get_by_role_and_label(Role::Button, focus).click();
        desk.settle();
        assert!(longest_texture(&desk) <= most);
    }
}
