//! The language is switched while the window is open, and no word of the other one is left.

use crate::support::{Desk, LANGUAGES, Words};
use egui::{Key, Modifiers};
use std::collections::BTreeSet;

/// The menus of the bar, the way to the languages, and what tells something in a dialog.
struct Menus {
    bar: [&'static str; 4],
    language: [&'static str; 2],
    theme: &'static str,
    dialogs: [&'static str; 2],
    close: &'static str,
}

const MENUS: [Menus; 2] = [
    Menus {
        bar: ["File", "Edit", "View", "Help"],
        language: ["View", "Language / Язык"],
        theme: "Theme",
        dialogs: ["Keys and mouse", "About Luch"],
        close: "Close",
    },
    Menus {
        bar: ["Файл", "Правка", "Вид", "Справка"],
        language: ["Вид", "Язык / Language"],
        theme: "Оформление",
        dialogs: ["Клавиши и мышь", "О программе «Луч»"],
        close: "Закрыть",
    },
];

/// Words that are the same in both languages: names, units of files, keys, formulas.
const SHARED: [&str; 46] = [
    "Ctrl", "Shift", "Delete", "Escape", "Esc", "Home", "Enter", "Tab", "OBJ", "PNG", "EXR", "TOML", "AVX", "SSE",
    "NEON", "avx", "sse", "neon", "avx512", "avx2", "sse2", "scalar", "MIT", "OR", "Apache", "I_a", "I_l", "k_s",
    "k_d", "cos", "cosⁿ", "Luch", "luch", "SVG", "study", "md", "csv", "json", "sRGB", "RGB", "Markdown", "LaTeX",
    "JSON", "explain", "toml", "obj",
];

fn is_latin(c: char) -> bool {
    c.is_ascii_alphabetic()
}

fn is_cyrillic(c: char) -> bool {
    ('\u{400}'..='\u{4ff}').contains(&c)
}

/// Words of more than one letter of a script, but those that are allowed.
fn words_of(texts: &BTreeSet<String>, script: fn(char) -> bool, allowed: &BTreeSet<String>) -> Vec<String> {
    let parts = |text: &String| -> Vec<String> {
        let words = text.split(|c: char| !(c.is_alphanumeric() || c == '_' || c == 'ⁿ')).map(str::to_owned);
        words.filter(|word| word.chars().count() > 1 && word.chars().any(script) && !is_code(word)).collect()
    };
    texts.iter().flat_map(parts).filter(|word| !allowed.contains(word) && !is_function_key(word)).collect()
}

/// Whether a word is the code of a color.
fn is_code(word: &str) -> bool {
    matches!(word.len(), 6 | 8) && word.chars().all(|c| c.is_ascii_hexdigit())
}

fn is_function_key(word: &str) -> bool {
    word.strip_prefix('F').is_some_and(|number| number.parse::<u8>().is_ok())
}

/// All texts of the window, its menus, its dialogs, and of whatever is selected.
fn all_texts(desk: &mut Desk, menus: &Menus) -> BTreeSet<String> {
    let mut texts: BTreeSet<String> = desk.texts().into_iter().collect();
    for part in ["Knight", "Cube", "Sphere", "Floor", "Lamp"] {
        desk.select_in_list(part);
        texts.extend(desk.texts());
    }
    for name in menus.bar {
        desk.menu(&[name]);
        texts.extend(desk.texts());
        desk.key(Modifiers::NONE, Key::Escape);
    }
    for sub in [menus.theme, menus.language[1]] {
        desk.menu(&[menus.bar[2], sub]);
        texts.extend(desk.texts());
        desk.key(Modifiers::NONE, Key::Escape);
        desk.key(Modifiers::NONE, Key::Escape);
    }
    for dialog in menus.dialogs {
        desk.menu(&[menus.bar[3], dialog]);
        texts.extend(desk.texts());
        desk.press(menus.close);
        // Where the menu is still open, a click on its name would close it.
        desk.key(Modifiers::NONE, Key::Escape);
    }
    texts
}

/// Words of the scene's own names.
fn names(desk: &Desk) -> BTreeSet<String> {
    let scene = desk.harness.state().scene();
    let mut names = vec![scene.name.clone(), "models/knight.obj".to_owned()];
    names.extend(scene.objects.iter().map(|o| o.name.clone()));
    names.extend(scene.lights.iter().map(|l| l.name.clone()));
    names.extend(scene.cameras.iter().map(|c| c.name.clone()));
    names.iter().flat_map(|name| name.split(|c: char| !c.is_alphanumeric())).map(str::to_owned).collect()
}

#[test]
fn switched_while_it_is_open_the_window_speaks_the_other_language_only() {
    let [english, russian]: [Words; 2] = LANGUAGES;
    let mut desk = Desk::new(english);
    desk.choose(english.scene, english.knight);
    desk.resize(48, 27);
    let mut allowed = names(&desk);
    allowed.extend(SHARED.map(str::to_owned));
    // The languages have their own names everywhere, for those who look for theirs.
    allowed.extend(["English", "Language", "Русский", "Язык"].map(str::to_owned));

    let before = all_texts(&mut desk, &MENUS[0]);
    assert!(before.len() > 120, "only {} texts", before.len());
    assert_eq!(words_of(&before, is_cyrillic, &allowed), [""; 0]);

    let [view, language] = MENUS[0].language;
    desk.menu(&[view, language, "Русский"]);
    desk.words = russian;
    let after = all_texts(&mut desk, &MENUS[1]);
    assert!(after.len() > 120, "only {} texts", after.len());
    assert_eq!(words_of(&after, is_latin, &allowed), [""; 0]);

    let [view, language] = MENUS[1].language;
    desk.menu(&[view, language, "English"]);
    desk.words = english;
    assert_eq!(words_of(&all_texts(&mut desk, &MENUS[0]), is_cyrillic, &allowed), [""; 0]);
}

/// The texts of a language as they stand in its files: key and text, without what is put in.
fn texts_in_files(language: &str) -> Vec<(String, String)> {
    let folder = format!("{}/locales/{language}", env!("CARGO_MANIFEST_DIR"));
    let mut texts = Vec::new();
    for entry in std::fs::read_dir(&folder).unwrap() {
        let path = entry.unwrap().path();
        let mut key = String::new();
        for line in std::fs::read_to_string(&path).unwrap().lines().filter(|line| !line.starts_with('#')) {
            let text = match line.split_once(" = ").filter(|_| !line.starts_with(' ')) {
                Some((name, text)) => {
                    name.clone_into(&mut key);
                    text
                }
                // The next form of a text with numbers.
                None => line.trim().split_once(']').map_or(line, |(_, text)| text),
            };
            let mut plain = String::new();
            let mut depth = 0_i32;
            for c in text.chars() {
                depth += i32::from(c == '{');
                if depth == 0 {
                    plain.push(c);
                }
                depth -= i32::from(c == '}');
            }
            texts.push((key.clone(), plain));
        }
    }
    texts
}

#[test]
fn no_text_of_a_language_has_words_of_the_other() {
    let mut allowed: BTreeSet<String> = SHARED.map(str::to_owned).into();
    allowed.extend(["English", "Language", "Русский", "Язык"].map(str::to_owned));
    for (language, script) in [("ru", is_latin as fn(char) -> bool), ("en", is_cyrillic)] {
        let texts = texts_in_files(language);
        assert!(texts.len() > 150, "{}", texts.len());
        for (key, text) in texts {
            let wrong = words_of(&BTreeSet::from([text]), script, &allowed);
            assert_eq!(wrong, [""; 0], "{language}: {key}");
        }
    }
}
