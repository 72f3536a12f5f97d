//! No text of the window is cut off or lies over another, in both languages, at the sizes that people have.

use crate::support::{Desk, LANGUAGES, Words};
use egui::epaint::{ClippedShape, Shape, TextShape};
use egui::{Key, Modifiers, Rect};
use luch_studio::Start;

/// The sizes to look at, in points: the least window, a small screen, and a large one at 150 %, whose 1920 x 1080 pixels
/// are 1280 x 720 points.
const SIZES: [([f32; 2], f32); 3] = [([720.0, 480.0], 1.0), ([1280.0, 720.0], 1.0), ([1280.0, 720.0], 1.5)];

/// A text as it is drawn: where, and what of it may be seen.
struct Drawn {
    text: String,
    rect: Rect,
    clip: Rect,
    cut: bool,
}

/// All texts of the last frame, from the back to the front.
fn drawn(desk: &Desk) -> Vec<Drawn> {
    fn collect(shape: &Shape, clip: Rect, into: &mut Vec<Drawn>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, clip, into)),
            Shape::Text(TextShape { pos, galley, .. }) if !galley.text().trim().is_empty() => {
                let rect = galley.mesh_bounds.translate(pos.to_vec2());
                into.push(Drawn { text: galley.text().to_owned(), rect, clip, cut: galley.elided });
            }
            _ => {}
        }
    }
    let mut texts = Vec::new();
    for ClippedShape { clip_rect, shape } in &desk.harness.output().shapes {
        collect(shape, *clip_rect, &mut texts);
    }
    texts
}

/// What is wrong with the texts that are seen.
fn faults(desk: &Desk) -> Vec<String> {
    // What is scrolled out of sight is no fault; what is half out of sight to a side is.
    let texts: Vec<Drawn> = drawn(desk).into_iter().filter(|d| d.clip.intersects(d.rect.shrink(0.5))).collect();
    let mut faults = Vec::new();
    for text in &texts {
        if text.cut {
            faults.push(format!("“{}” is cut short", text.text));
        }
        if text.rect.left() < text.clip.left() - 1.0 || text.rect.right() > text.clip.right() + 1.0 {
            faults.push(format!("“{}” is cut off: {:?} in {:?}", text.text, text.rect, text.clip));
        }
    }
    for (index, a) in texts.iter().enumerate() {
        for b in &texts[index + 1..] {
            let (seen_a, seen_b) = (a.rect.intersect(a.clip), b.rect.intersect(b.clip));
            // Of what lies in layers over the rest, such as a menu, the background is not seen; it is tested without.
            if a.clip == b.clip && seen_a.shrink(1.0).intersects(seen_b.shrink(1.0)) {
                faults.push(format!("“{}” lies over “{}”", a.text, b.text));
            }
        }
    }
    faults
}

fn assert_good(desk: &Desk, what: &str) {
    let faults = faults(desk);
    assert!(faults.is_empty(), "{what}, {}:\n{}", desk.words.language, faults.join("\n"));
}

/// The window of that size with the scene.
fn desk(words: Words, (size, pixels_per_point): ([f32; 2], f32), scene: &str) -> Desk {
    let start = Start { still: true, ..Start::default() };
    let mut desk = Desk::in_window(words, start, size, pixels_per_point);
    desk.choose(words.scene, scene);
    desk.resize(96, 54);
    desk
}

#[test]
fn no_text_of_the_panels_is_cut_off_or_covered() {
    for words in LANGUAGES {
        for size in SIZES {
            let mut desk = desk(words, size, words.knight);
            for part in ["Knight", "Cube", "Sphere", "Floor", "Lamp"] {
                desk.select_in_list(part);
                for field in [words.scene, words.light_intensity, words.focal_distance] {
                    desk.scroll_to_field(field);
                    assert_good(&desk, &format!("{part} at {size:?}, {field}"));
                }
            }
            desk.set_live(false);
            desk.type_into(words.field_of_view, "50");
            assert_good(&desk, &format!("waiting at {size:?}"));
            desk.type_into(words.field_of_view, "five hundred");
            assert_good(&desk, &format!("a complaint at {size:?}"));
        }
    }
}

#[test]
fn no_text_of_the_menus_and_dialogs_is_cut_off_or_covered() {
    let bars = [["File", "Edit", "View", "Help"], ["Файл", "Правка", "Вид", "Справка"]];
    let dialogs = [["Keys and mouse", "About Luch"], ["Клавиши и мышь", "О программе «Луч»"]];
    for ((words, bar), dialogs) in LANGUAGES.into_iter().zip(bars).zip(dialogs) {
        for size in SIZES {
            let mut desk = desk(words, size, words.chess);
            for menu in bar {
                desk.menu(&[menu]);
                assert_good(&desk, &format!("{menu} at {size:?}"));
                desk.key(Modifiers::NONE, Key::Escape);
            }
            for dialog in dialogs {
                desk.menu(&[bar[3], dialog]);
                assert_good(&desk, &format!("{dialog} at {size:?}"));
                desk.key(Modifiers::NONE, Key::Escape);
            }
        }
    }
}

#[test]
fn the_hints_of_the_first_run_fit() {
    for words in LANGUAGES {
        for (size, pixels_per_point) in SIZES {
            let start = Start { still: true, hints: true, ..Start::default() };
            let desk = Desk::in_window(words, start, size, pixels_per_point);
            assert_good(&desk, &format!("hints at {size:?}"));
        }
    }
}
