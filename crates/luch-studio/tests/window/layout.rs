//! No text of the window is cut off, wrapped where it should not be, or lies over another: in both languages, at the
//! sizes that people have.

use crate::support::{Desk, LANGUAGES, Words};
use egui::accesskit::Role;
use egui::epaint::{ClippedShape, Shape, TextShape};
use egui::{Key, Modifiers, Rect};
use egui_kittest::kittest::Queryable;
use luch_studio::Start;

/// A size of the window in points, and pixels per point.
type Size = ([f32; 2], f32);

/// The least window, a small screen, and a large one at 150 %, whose 1920 x 1080 pixels are 1280 x 720 points.
const SIZES: [Size; 3] = [([720.0, 480.0], 1.0), ([1280.0, 720.0], 1.0), ([1280.0, 720.0], 1.5)];

/// Names of fields have one line; a sentence may have more.
const SENTENCE: usize = 45;

/// A text as it is drawn: where, and what of it may be seen.
#[derive(Clone, PartialEq)]
struct Drawn {
    text: String,
    rect: Rect,
    clip: Rect,
    lines: usize,
    cut: bool,
}

impl Drawn {
    fn seen(&self) -> Rect {
        self.rect.intersect(self.clip)
    }
}

/// All texts of the last frame that are in sight, from the back to the front.
fn drawn(desk: &Desk) -> Vec<Drawn> {
    fn collect(shape: &Shape, clip: Rect, into: &mut Vec<Drawn>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, clip, into)),
            Shape::Text(TextShape { pos, galley, .. }) if !galley.text().trim().is_empty() => {
                let rect = galley.mesh_bounds.translate(pos.to_vec2());
                let (text, lines) = (galley.text().to_owned(), galley.rows.len());
                into.push(Drawn { text, rect, clip, lines, cut: galley.elided });
            }
            _ => {}
        }
    }
    let mut texts = Vec::new();
    for ClippedShape { clip_rect, shape, .. } in &desk.harness.output().shapes {
        collect(shape, *clip_rect, &mut texts);
    }
    // What is scrolled out of sight is no fault; what is half out of sight to a side is.
    texts.retain(|d| d.clip.intersects(d.rect.shrink(0.5)));
    texts
}

/// What is wrong with the texts that are seen and were not there `before`, behind what has been opened since.
fn faults(desk: &Desk, before: &[Drawn]) -> Vec<String> {
    let texts: Vec<Drawn> = drawn(desk).into_iter().filter(|d| !before.contains(d)).collect();
    assert!(!texts.is_empty(), "there is nothing to read");
    let window = desk.harness.ctx.content_rect();
    let mut faults = Vec::new();
    for Drawn { text, rect, clip, lines, cut } in &texts {
        if *cut {
            faults.push(format!("“{text}” is cut short"));
        }
        if *lines > 1 && text.chars().count() < SENTENCE {
            faults.push(format!("“{text}” has {lines} lines"));
        }
        let is_in = |area: Rect| area.left() - 1.0 <= rect.left() && rect.right() <= area.right() + 1.0;
        if !is_in(*clip) || !is_in(window) || (clip.contains_rect(window) && !window.expand(1.0).contains_rect(*rect)) {
            faults.push(format!("“{text}” is cut off: {rect:?} in {clip:?}"));
        }
    }
    for (index, a) in texts.iter().enumerate() {
        for b in &texts[index + 1..] {
            // The letters of a formula have their indices close by.
            let is_formula = a.text.chars().count() < 3 && b.text.chars().count() < 3;
            if !is_formula && a.seen().shrink(1.0).intersects(b.seen().shrink(1.0)) {
                faults.push(format!("“{}” lies over “{}”: {:?}, {:?}", a.text, b.text, a.seen(), b.seen()));
            }
        }
    }
    faults
}

fn assert_good(desk: &Desk, before: &[Drawn], what: &str) {
    let faults = faults(desk, before);
    let size = desk.harness.ctx.content_rect().size();
    assert!(faults.is_empty(), "{what}, {}, {size:?}:\n{}", desk.words.language, faults.join("\n"));
}

/// The window of that size with a small picture of a scene.
fn desk(words: Words, (size, pixels_per_point): Size, scene: &str) -> Desk {
    let start = Start { still: true, ..Start::default() };
    let mut desk = Desk::in_window(words, start, size, pixels_per_point);
    desk.choose(words.scene, scene);
    desk.resize(96, 54);
    desk.harness.remove_cursor();
    desk.settle();
    desk
}

/// The keys of the dialogs for files.
const COMMAND_O: (Modifiers, Key) = (Modifiers::COMMAND, Key::O);
const COMMAND_E: (Modifiers, Key) = (Modifiers::COMMAND, Key::E);
const COMMAND_SHIFT_S: (Modifiers, Key) = (Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::S);

#[test]
fn no_text_of_the_panels_is_cut_off_or_covered() {
    for words in LANGUAGES {
        for size in SIZES {
            let mut desk = desk(words, size, words.knight);
            for part in ["Knight", "Cube", "Sphere", "Floor", "Lamp"] {
                desk.select_in_list(part);
                for field in [words.scene, words.light_intensity, words.focal_distance] {
                    desk.scroll_to_field(field);
                    assert_good(&desk, &[], &format!("{part}, at {field}"));
                }
            }
            desk.set_live(false);
            desk.type_into(words.field_of_view, "50");
            assert_good(&desk, &[], "changes that wait");
            desk.type_into(words.field_of_view, "five hundred");
            assert_good(&desk, &[], "a complaint");
        }
    }
}

#[test]
fn no_text_of_the_menus_and_dialogs_is_cut_off_or_covered() {
    let bars = [["File", "Edit", "Add", "View", "Help"], ["Файл", "Правка", "Добавить", "Вид", "Справка"]];
    let dialogs = [["Keys and mouse", "About Luch"], ["Клавиши и мышь", "О программе «Луч»"]];
    let studies = ["Study…", "Исследование…"];
    let paths = ["Path", "Путь"];
    for (language, words) in LANGUAGES.into_iter().enumerate() {
        let [.., view, help] = bars[language];
        for size in SIZES {
            let mut desk = desk(words, size, words.chess);
            let before = drawn(&desk);
            for menu in bars[language] {
                desk.menu(&[menu]);
                assert_good(&desk, &before, menu);
                desk.key(Modifiers::NONE, Key::Escape);
            }
            for dialog in dialogs[language] {
                desk.menu(&[help, dialog]);
                assert_good(&desk, &before, dialog);
                desk.key(Modifiers::NONE, Key::Escape);
            }
            for (modifiers, key) in [COMMAND_O, COMMAND_E, COMMAND_SHIFT_S] {
                desk.key(modifiers, key);
                // Not a folder of this machine, whose path may be longer than the field.
                desk.begin_typing(paths[language], "/");
                desk.settle();
                desk.harness.remove_cursor();
                desk.settle();
                assert_good(&desk, &before, &format!("the dialog of {key:?}"));
                desk.key(Modifiers::NONE, Key::Escape);
            }
            desk.menu(&[view, studies[language]]);
            assert_good(&desk, &before, "the study");
            desk.menu(&[view, studies[language]]);
            desk.type_into(words.field_of_view, "50");
            let before = drawn(&desk);
            desk.key(Modifiers::COMMAND, Key::N);
            assert_good(&desk, &before, "unsaved changes");
        }
    }
}

#[test]
fn no_text_of_an_explained_pixel_is_cut_off_or_covered() {
    for words in LANGUAGES {
        // In the least window the formulas are scrolled sideways, and names of objects are shortened.
        for size in &SIZES[1..] {
            let mut desk = desk(words, *size, words.knight);
            desk.key(Modifiers::NONE, Key::X);
            desk.click_picture(0.5, 0.7);
            desk.harness.remove_cursor();
            desk.settle();
            assert!(desk.harness.state().explained_rays() > 0);
            assert_good(&desk, &[], "an explained pixel");
        }
    }
}

#[test]
fn the_hints_of_the_first_run_fit() {
    for words in LANGUAGES {
        for (size, pixels_per_point) in SIZES {
            let [with, without] = [true, false].map(|hints| {
                let start = Start { still: true, hints, ..Start::default() };
                Desk::in_window(words, start, size, pixels_per_point)
            });
            assert_good(&with, &drawn(&without), "the hints");
        }
    }
}

/// A row that is wider than the panel would make the panel wider, a little in each frame.
#[test]
fn the_panel_keeps_its_width() {
    for words in LANGUAGES {
        for size in SIZES {
            let mut desk = desk(words, size, words.knight);
            desk.select_in_list("Floor");
            for _ in 0..60 {
                desk.harness.step();
            }
            let field = desk.harness.get_by_role_and_label(Role::TextInput, words.find_by_name).rect();
            let window = desk.harness.ctx.content_rect();
            assert!(window.right() - field.left() < 360.0, "{}, {size:?}: {field:?}", words.language);
        }
    }
}
