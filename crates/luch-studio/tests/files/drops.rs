//! Files dropped on the window, and those that were used last.

use crate::desk::{BALL, Folder, TENT, studio, studio_with};
use crate::support::Desk;
use egui::{HoveredFile, Modifiers};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        Err("nobody reads it here".into())
    }
}

impl Desk {
    fn hover(&mut self, path: &Path) {
        let file = HoveredFile { path: Some(path.to_owned()), ..HoveredFile::default() };
        self.harness.input_mut().hovered_files.push(file);
        self.steps(3);
    }

    fn drop_files(&mut self, paths: &[&Path], modifiers: Modifiers) {
        self.let_go_of(paths, modifiers);
        self.settle();
    }

    /// Drops files and waits for nothing.
    pub(crate) fn let_go_of(&mut self, paths: &[&Path], modifiers: Modifiers) {
        self.harness.input_mut().hovered_files.clear();
        self.harness.event(egui::Event::ModifiersChanged(modifiers));
        self.harness.step();
        for path in paths {
            self.harness.input_mut().dropped_files.push(Arc::new(Dropped((*path).to_owned())));
        }
        self.harness.step();
        self.harness.event(egui::Event::ModifiersChanged(Modifiers::NONE));
        self.steps(2);
    }
}

#[test]
fn a_dropped_scene_is_opened_and_a_model_added() {
    let folder = Folder::new();
    let (scene, model) = (folder.write("ball.toml", BALL), folder.write("tent.obj", TENT));
    let mut desk = studio();
    desk.hover(&model);
    assert!(desk.says("Drop to add the model"));
    desk.drop_files(&[&model], Modifiers::NONE);
    assert!(!desk.says("Drop to"));
    assert_eq!(desk.harness.state().selected(), Some("tent"));
    assert_eq!(desk.harness.state().scene().name, "Two spheres");
    // The scene asks first, for there is a change now.
    desk.drop_files(&[&scene], Modifiers::NONE);
    desk.press_top("Do not save");
    assert_eq!(desk.harness.state().scene().name, "Ball");
    desk.drop_files(&[&model], Modifiers::SHIFT);
    assert_eq!(desk.harness.state().scene().name, "tent", "with Shift it is opened alone");
}

#[test]
fn what_is_neither_is_told() {
    let folder = Folder::new();
    let mut desk = studio();
    let text = folder.write("notes.txt", "");
    desk.hover(&text);
    assert!(desk.says("Only scenes"));
    desk.drop_files(&[&text, &folder.0], Modifiers::NONE);
    assert!(desk.says("notes.txt") && desk.says("Not opened"));
    assert_eq!(desk.harness.state().scene().name, "Two spheres");
}

#[test]
fn several_models_are_added_and_the_bad_one_is_told() {
    let folder = Folder::new();
    let models = [folder.write("a.obj", TENT), folder.write("b.obj", ""), folder.write("c.obj", TENT)];
    let mut desk = studio();
    desk.drop_files(&[&models[0], &models[1], &models[2]], Modifiers::NONE);
    let scene = desk.harness.state().scene();
    assert!(scene.object_named("a").is_some() && scene.object_named("c").is_some());
    assert!(desk.says("b.obj: the file is empty"));
}

#[test]
fn files_used_last_are_opened_again_and_missing_ones_dropped() {
    let folder = Folder::new();
    let files = [folder.write("ball.toml", BALL), folder.write("deep/tent.obj", TENT)];
    let mut desk = studio_with(&files[0]);
    desk.open_menu("File", "Open…");
    desk.enter_path(&files[1]);
    desk.recent("ball.toml");
    assert_eq!(desk.harness.state().scene().name, "Ball");
    fs::remove_file(&files[1]).unwrap();
    desk.recent("tent.obj");
    assert!(desk.says("The scene was not loaded") && desk.says("no such file"));
    assert_eq!(desk.harness.state().scene().name, "Ball");
    desk.show_menu("File");
    desk.show_menu("Open recent");
    assert!(desk.offers("ball.toml") && !desk.offers("tent.obj"));
}

impl Desk {
    fn show_menu(&mut self, name: &str) {
        self.press_starting(name);
        self.steps(3);
    }

    fn recent(&mut self, name: &str) {
        self.show_menu("File");
        self.show_menu("Open recent");
        self.press_top(name);
    }
}
