//! A click in the picture, and what the panel says of it.

use crate::support::{Desk, LANGUAGES};
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT, Queryable};

/// A studio of the first scene in English, the pixel at a part of the picture explained.
pub(crate) fn explained(across: f32, down: f32) -> Desk {
    let mut desk = Desk::new(LANGUAGES[0]);
    desk.harness.key_press(egui::Key::X);
    desk.settle();
    desk.click_picture(across, down);
    desk
}

/// The names of the rows of the tree that are laid out.
pub(crate) fn rows(desk: &Desk) -> Vec<String> {
    let rows = desk.harness.query_all_by_role(Role::TreeItem);
    rows.map(|row| row.accesskit_node().label().unwrap_or_default()).collect()
}

/// The pixel that the panel says it explains.
pub(crate) fn pixel(desk: &Desk) -> [u32; 2] {
    let title = desk.harness.get_by_label_contains("Pixel ").accesskit_node().value().unwrap_or_default();
    let mut places = title["Pixel ".len()..].split(", ").map(|place| place.parse().unwrap());
    [places.next().unwrap(), places.next().unwrap()]
}

/// The bytes of a pixel as the panel writes them.
pub(crate) fn bytes(desk: &Desk, [x, y]: [u32; 2]) -> String {
    let [r, g, b, _] = desk.picture().pixel(x, y);
    format!("{r} {g} {b}  #{r:02x}{g:02x}{b:02x}")
}

/// The row that is looked at.
pub(crate) fn looked_at(desk: &Desk) -> String {
    let rows = desk.harness.query_all_by_role(Role::TreeItem);
    let mut selected = rows.filter(|row| row.accesskit_node().is_selected() == Some(true));
    selected.next().and_then(|row| row.accesskit_node().label()).unwrap_or_default()
}

#[test]
fn a_click_on_the_left_sphere_shows_the_rays_whose_sum_is_the_pixel() {
    let desk = explained(0.36, 0.5);
    let [x, y] = pixel(&desk);
    assert!(x.abs_diff(345) < 3 && y.abs_diff(360) < 3, "{x}, {y}");
    desk.harness.get_by_label(&bytes(&desk, [x, y]));
    let rows = rows(&desk);
    assert!(rows[0].starts_with("Camera ray: Left sphere"), "{rows:?}");
    assert!(rows.iter().any(|row| row.starts_with("Mirror ray: Right wall")), "{rows:?}");
    assert!(rows.iter().any(|row| row.starts_with("Shadow ray, free: Lamp")), "{rows:?}");
}

#[test]
fn the_arrow_keys_go_to_the_next_pixels_and_escape_closes() {
    let mut desk = explained(0.36, 0.5);
    let [x, y] = pixel(&desk);
    desk.harness.key_press(egui::Key::ArrowRight);
    desk.harness.key_press(egui::Key::ArrowUp);
    desk.settle();
    desk.harness.key_press_modifiers(egui::Modifiers::SHIFT, egui::Key::ArrowDown);
    desk.settle();
    assert_eq!(pixel(&desk), [x + 1, y + 9]);
    desk.harness.get_by_label(&bytes(&desk, [x + 1, y + 9]));
    desk.harness.key_press(egui::Key::Escape);
    desk.settle();
    assert!(rows(&desk).is_empty());
}

#[test]
fn the_tree_is_walked_by_keys_and_folds() {
    let mut desk = explained(0.36, 0.5);
    let all = rows(&desk);
    desk.harness.get_by_label(&all[0]).click();
    desk.settle();
    for (key, row) in [(egui::Key::ArrowDown, 1), (egui::Key::End, all.len() - 1), (egui::Key::Home, 0)] {
        desk.harness.key_press(key);
        desk.settle();
        assert_eq!(looked_at(&desk), all[row]);
    }
    desk.harness.key_press(egui::Key::ArrowLeft);
    desk.settle();
    assert_eq!(rows(&desk).len(), 1);
    desk.harness.key_press(egui::Key::ArrowRight);
    desk.settle();
    assert_eq!(rows(&desk), all);
}

#[test]
fn an_edit_is_followed_and_the_same_ray_stays_looked_at() {
    let mut desk = explained(0.36, 0.5);
    let mirror = rows(&desk).into_iter().find(|row| row.starts_with("Mirror ray")).unwrap();
    desk.harness.get_by_label(&mirror).click();
    desk.settle();
    let at = pixel(&desk);
    let before = bytes(&desk, at);
    desk.type_into(desk.words.light_intensity, "90");
    let after = bytes(&desk, at);
    assert_ne!(after, before);
    desk.harness.get_by_label(&after);
    assert_eq!(looked_at(&desk), mirror);
}
