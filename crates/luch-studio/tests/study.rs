//! The study window: a plan is typed in, measured, plotted and saved.

#[path = "support/mod.rs"]
mod support;

use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT, Queryable};
use support::{Desk, LANGUAGES};

/// What the tests look for beyond the words of the window.
struct StudyWords {
    menu: &'static str,
    entry: &'static str,
    threads: &'static str,
    runs: &'static str,
    start: &'static str,
    folder: &'static str,
    save: &'static str,
}

const WORDS: [StudyWords; 2] = [
    StudyWords {
        menu: "View",
        entry: "Study…",
        threads: "Numbers of threads",
        runs: "Runs of each",
        start: "Start measuring",
        folder: "Folder for the report",
        save: "Save report and plots",
    },
    StudyWords {
        menu: "Вид",
        entry: "Исследование…",
        threads: "Числа потоков",
        runs: "Повторов каждого",
        start: "Начать измерения",
        folder: "Папка для отчёта",
        save: "Сохранить отчёт и графики",
    },
];

/// The last of the fields of that name: the window lies over the panels, which have some of the same.
fn type_into_last(desk: &mut Desk, name: &str, text: &str) {
    let field =
        |desk: &Desk| desk.harness.get_all_by_role_and_label(Role::TextInput, name).last().map(|node| node.rect());
    let at = field(desk).expect("a field of that name").center();
    for pressed in [true, false] {
        let (button, modifiers) = (egui::PointerButton::Primary, egui::Modifiers::NONE);
        desk.harness.hover_at(at);
        desk.harness.event(egui::Event::PointerButton { pos: at, button, pressed, modifiers });
        desk.harness.step();
    }
    desk.harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
    desk.harness.step();
    desk.harness.event(egui::Event::Text(text.to_owned()));
    desk.settle();
}

#[test]
fn a_study_is_measured_plotted_and_saved() {
    for (words, study) in LANGUAGES.into_iter().zip(WORDS) {
        let mut desk = Desk::new(words);
        desk.harness.get_by_label(study.menu).click();
        desk.settle();
        desk.harness.get_by_label_contains(study.entry).click();
        desk.settle();

        type_into_last(&mut desk, study.threads, "0");
        assert!(desk.harness.get_by_role_and_label(Role::Button, study.start).accesskit_node().is_disabled());
        type_into_last(&mut desk, study.threads, "1, 2");
        type_into_last(&mut desk, study.runs, "3");
        type_into_last(&mut desk, words.picture_width, "64");
        type_into_last(&mut desk, words.picture_height, "48");
        desk.harness.get_by_role_and_label(Role::Button, study.start).click();
        desk.settle();

        let folder = std::env::temp_dir().join(format!("luch-studio-study-{}-{}", words.language, std::process::id()));
        desk.harness.get_by_role_and_label(Role::TextInput, study.folder).scroll_to_me();
        desk.settle();
        type_into_last(&mut desk, study.folder, folder.to_str().expect("a plain path"));
        desk.harness.get_by_role_and_label(Role::Button, study.save).click();
        desk.settle();
        let mut names: Vec<_> = std::fs::read_dir(&folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .collect();
        std::fs::remove_dir_all(&folder).unwrap();
        names.sort();
        for name in ["study.csv", "study.json", "study.md", "threads-all.png", "threads-all.svg", "threads-from-2.svg"]
        {
            assert!(names.iter().any(|known| known == name), "{name} is not among {names:?}");
        }
    }
}
