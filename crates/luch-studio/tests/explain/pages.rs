//! The sides of the account: the sum, the scene from above, the boxes; and the picture in other views.

use crate::clicks::{bytes, explained, pixel, rows};
use crate::support::{Desk, LANGUAGES};
use egui::accesskit::Role;
use egui::{Color32, Shape};
use egui_kittest::kittest::{NodeT, Queryable};

/// The formulas that are in sight, as a screen reader says them.
fn formulas(desk: &Desk) -> Vec<String> {
    let all = desk.harness.query_all_by_role(Role::Math);
    all.map(|formula| formula.accesskit_node().label().unwrap_or_default()).collect()
}

/// The widest line of a color that was drawn in the last frame.
fn widest_line(desk: &Desk, color: Color32) -> f32 {
    let lines = desk.harness.output().shapes.iter().filter_map(|clipped| match &clipped.shape {
        Shape::LineSegment { stroke, .. } if stroke.color == color => Some(stroke.width),
        _ => None,
    });
    lines.fold(0.0, f32::max)
}

#[test]
fn the_sum_of_the_ray_that_is_looked_at_is_told_with_its_numbers() {
    let mut desk = explained(0.36, 0.5);
    let before = formulas(&desk);
    assert!(before.iter().any(|formula| formula.starts_with("A = k_a · I_a = ")), "{before:?}");
    let mirror = rows(&desk).into_iter().find(|row| row.starts_with("Mirror ray")).unwrap();
    desk.harness.get_by_label(&mirror).click();
    desk.settle();
    assert_ne!(formulas(&desk), before);
}

#[test]
fn the_row_that_is_looked_at_lights_its_ray_in_the_picture() {
    let mut desk = explained(0.36, 0.5);
    let mirror_blue = Color32::from_rgb(86, 180, 233);
    let faint = widest_line(&desk, mirror_blue);
    let mirror = rows(&desk).into_iter().find(|row| row.starts_with("Mirror ray")).unwrap();
    desk.harness.get_by_label(&mirror).hover();
    desk.settle();
    let lit = widest_line(&desk, mirror_blue);
    assert!(lit > faint && lit > 2.5, "{faint} {lit}");
    desk.harness.get_by_label(&mirror).click();
    desk.harness.hover_at(egui::pos2(2.0, 2.0));
    desk.settle();
    assert_eq!(widest_line(&desk, mirror_blue), lit);
}

#[test]
fn the_scene_is_seen_from_above_and_a_drag_moves_it() {
    let mut desk = explained(0.36, 0.5);
    desk.harness.get_by_label("From above").click();
    desk.settle();
    let map = desk.harness.get_by_role_and_label(Role::Image, "From above").rect();
    // The tree and the list of objects have the name as well.
    let name = |desk: &Desk| {
        let mut all = desk.harness.output().shapes.iter().filter_map(|clipped| match &clipped.shape {
            Shape::Text(text) if map.contains(text.pos) && text.galley.text() == "Left sphere" => Some(text.pos),
            _ => None,
        });
        all.next().unwrap()
    };
    let before = name(&desk);
    let from = map.left_top() + egui::vec2(20.0, 20.0);
    desk.harness.drag_at(from);
    desk.harness.step();
    desk.harness.hover_at(from + egui::vec2(30.0, 20.0));
    desk.harness.step();
    desk.harness.drop_at(from + egui::vec2(30.0, 20.0));
    desk.settle();
    assert!((name(&desk) - before - egui::vec2(30.0, 20.0)).length() < 1.0, "{before} {}", name(&desk));
}

#[test]
fn the_boxes_of_a_ray_are_counted_listed_and_drawn_by_level() {
    let mut desk = Desk::new(LANGUAGES[0]);
    desk.choose(desk.words.scene, desk.words.knight);
    desk.harness.key_press(egui::Key::X);
    desk.settle();
    desk.click_picture(0.5, 0.5);
    desk.harness.get_by_label("Boxes").click();
    desk.settle();
    let steps: Vec<String> =
        desk.harness.query_all_by_role(Role::ListItem).filter_map(|row| row.accesskit_node().label()).collect();
    assert!(steps.iter().any(|step| step.starts_with("Box of Knight")), "{steps:?}");
    let counts = desk.harness.get_by_label_contains("Boxes entered: ").accesskit_node().value().unwrap();
    assert!(!counts.starts_with("Boxes entered: 0"), "{counts}");
    let blue = Color32::from_rgb(86, 180, 233);
    let lines = |desk: &Desk| {
        let all = desk.harness.output().shapes.iter();
        all.filter(
            |c| matches!(&c.shape, Shape::LineSegment { stroke, .. } if stroke.color == blue && stroke.width == 1.6),
        )
        .count()
    };
    assert!(lines(&desk) >= 3, "the box around the knight has edges in sight: {}", lines(&desk));
    desk.harness.get_by_label("Sum").click();
    desk.settle();
    assert_eq!(lines(&desk), 0);
}

#[test]
fn another_view_of_the_picture_has_a_legend_and_the_account_stays_that_of_the_light() {
    let mut desk = explained(0.36, 0.5);
    let at = pixel(&desk);
    let light = bytes(&desk, at);
    for entry in ["View", "Picture shows", "Heat map: boxes"] {
        desk.harness.get_by_label_contains(entry).click();
        desk.harness.step();
        desk.harness.step();
        desk.harness.step();
    }
    desk.settle();
    assert_ne!(bytes(&desk, at), light);
    desk.harness.get_by_label(&light);
    desk.harness.get_by_label("The picture shows another view");
    let legend = |shape: &Shape| matches!(shape, Shape::Text(text) if text.galley.text() == "Boxes entered");
    assert!(desk.harness.output().shapes.iter().any(|clipped| legend(&clipped.shape)));
}
