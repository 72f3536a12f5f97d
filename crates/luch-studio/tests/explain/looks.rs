//! Pictures for people: `LUCH_LOOK=folder cargo test -p luch-studio --test explain`.

use crate::support::{Desk, LANGUAGES, Words};
use egui::Theme;
use egui_kittest::kittest::Queryable;
use luch_studio::Start;

/// The names of the pages in both languages.
const PAGES: [[&str; 3]; 2] = [["Sum", "From above", "Boxes"], ["Сумма", "Вид сверху", "Боксы"]];

#[test]
fn look() {
    let Ok(folder) = std::env::var("LUCH_LOOK") else { return };
    for (words, pages) in LANGUAGES.into_iter().zip(PAGES) {
        for (theme, size, scale) in [(Theme::Dark, [1280.0, 720.0], 1.0), (Theme::Light, [1280.0, 720.0], 1.5)] {
            let mut desk = Desk::in_window(words, Start::default(), size, scale);
            desk.harness.ctx.set_theme(theme);
            for scene in [None, Some(words.knight), Some(words.chess)] {
                photograph(&mut desk, words, scene, pages, &format!("{folder}/{}-{theme:?}", words.language));
            }
        }
    }
}

fn photograph(desk: &mut Desk, words: Words, scene: Option<&str>, pages: [&str; 3], name: &str) {
    if let Some(scene) = scene {
        desk.choose(words.scene, scene);
    }
    desk.harness.key_press(egui::Key::X);
    desk.settle();
    desk.click_picture(0.36, 0.55);
    let scene = scene.map_or("spheres", |scene| if scene == words.chess { "chess" } else { "knight" });
    for (number, page) in pages.into_iter().enumerate() {
        desk.harness.get_by_label(page).click();
        desk.settle();
        desk.harness.render().unwrap().save(format!("{name}-{scene}-{number}.png")).unwrap();
    }
    desk.harness.get_by_label(pages[0]).click();
    desk.settle();
    desk.harness.set_size(egui::vec2(1280.0, 1500.0));
    desk.settle();
    drag_panel(desk);
    desk.harness.render().unwrap().save(format!("{name}-{scene}-tall.png")).unwrap();
    desk.harness.set_size(egui::vec2(1280.0, 720.0));
    desk.settle();
    desk.harness.key_press(egui::Key::Escape);
    desk.settle();
}

/// Makes the panel as tall as it goes, by its edge.
fn drag_panel(desk: &mut Desk) {
    let edge = desk.harness.get_by_role(egui::accesskit::Role::Image).rect();
    let from = egui::pos2(edge.center().x, edge.bottom() + 1.0);
    desk.harness.drag_at(from);
    desk.harness.step();
    desk.harness.hover_at(from - egui::vec2(0.0, 700.0));
    desk.harness.step();
    desk.harness.drop_at(from - egui::vec2(0.0, 700.0));
    desk.settle();
}
