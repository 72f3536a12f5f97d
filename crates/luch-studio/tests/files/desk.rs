//! What the tests of files have in common: a folder of their own, and hands for menus and dialogs.

use crate::support::{Desk, LANGUAGES};
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT, Queryable};
use luch_studio::Start;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, Ordering};

/// A folder of its own for a test, removed at its end.
pub(crate) struct Folder(pub(crate) PathBuf);

impl Folder {
    pub(crate) fn new() -> Self {
        static NEXT: AtomicU32 = AtomicU32::new(0);
        let n = NEXT.fetch_add(1, Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("luch-studio-files-{}-{n}", std::process::id()));
        fs::create_dir_all(&path).unwrap();
        Self(fs::canonicalize(path).unwrap())
    }

    pub(crate) fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    pub(crate) fn write(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.path(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, content).unwrap();
        path
    }

    pub(crate) fn names(&self) -> Vec<String> {
        let name = |entry: Result<fs::DirEntry, _>| entry.unwrap().file_name().to_string_lossy().into_owned();
        let mut names: Vec<_> = fs::read_dir(&self.0).unwrap().map(name).collect();
        names.sort();
        names
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// A small scene with one red sphere.
pub(crate) const BALL: &str = "luch = 1\nname = \"Ball\"\n[[light]]\nname = \"Lamp\"\nposition = [3.0, 6.0, 4.0]\n\
    [[camera]]\nname = \"Camera 1\"\nposition = [0.0, 1.0, 5.0]\nlook_at = [0.0, 0.0, 0.0]\n\
    [[object]]\nname = \"Red\"\nsphere = { center = [0.0, 0.0, 0.0], radius = 1.0 }\ncolor = \"#c83232\"\n\
    [render]\nsize = [64, 48]\n";

/// A tetrahedron.
pub(crate) const TENT: &str = "v 0 0 0\nv 1 0 0\nv 0 0 1\nv 0 1 0\nf 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n";

/// An English studio.
pub(crate) fn studio() -> Desk {
    Desk::new(LANGUAGES[0])
}

/// An English studio that shows a file.
pub(crate) fn studio_with(path: &Path) -> Desk {
    let scene = luch_io::SceneSource::of_path(path);
    Desk::start(LANGUAGES[0], Start { scene, ..Start::default() })
}

impl Desk {
    /// Opens a menu and clicks an entry.
    pub(crate) fn open_menu(&mut self, menu: &str, entry: &str) {
        self.harness.get_by_role_and_label(Role::Button, menu).click();
        self.steps(4);
        self.press_starting(entry);
        self.settle();
    }

    /// Clicks an entry of the open menu.
    pub(crate) fn press_starting(&mut self, entry: &str) {
        // Behind the name stands the key; the row of a list, which may have the same name, is on or off.
        let is_it = |node: &egui_kittest::kittest::AccessKitNode<'_>| {
            let label = node.label().unwrap_or_default();
            let rest = label.strip_prefix(entry);
            node.role() == Role::Button
                && node.toggled().is_none()
                && rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(" Ctrl"))
        };
        let found = self.harness.query_all_by(is_it).last();
        found.unwrap_or_else(|| panic!("there is no entry {entry}")).click();
    }

    /// Clicks a button; of several, the one on top.
    pub(crate) fn press_top(&mut self, name: &str) {
        let found = self.harness.query_all_by_role_and_label(Role::Button, name).last();
        found.unwrap_or_else(|| panic!("there is no button {name}")).click();
        self.settle();
    }

    /// Draws frames until something is so.
    pub(crate) fn wait(&mut self, is_so: impl Fn(&Self) -> bool) {
        // So long that only what never ends is stopped.
        let patience = std::time::Instant::now() + std::time::Duration::from_secs(120);
        while !is_so(self) {
            assert!(std::time::Instant::now() < patience, "it never comes");
            self.harness.step();
            std::thread::yield_now();
        }
        self.steps(3);
    }

    pub(crate) fn steps(&mut self, count: usize) {
        for _ in 0..count {
            self.harness.step();
        }
    }

    /// Whether there is such a button.
    pub(crate) fn offers(&self, button: &str) -> bool {
        self.harness.query_all_by_role_and_label(Role::Button, button).next().is_some()
    }

    /// Types a path into the dialog and presses Enter.
    pub(crate) fn enter_path(&mut self, path: &Path) {
        self.type_into("Path", &path.display().to_string());
    }

    /// What stands in the path field.
    pub(crate) fn path_field(&self) -> String {
        self.harness.get_by_role_and_label(Role::TextInput, "Path").accesskit_node().value().unwrap_or_default()
    }

    /// Changes the scene.
    pub(crate) fn alter(&mut self) {
        self.type_into("Field of view", "33");
    }

    /// Whether the window has been told to close.
    pub(crate) fn is_closing(&self) -> bool {
        self.commands().any(|command| matches!(command, egui::ViewportCommand::Close))
    }

    /// What the last frame asked the system for.
    pub(crate) fn commands(&self) -> impl Iterator<Item = &egui::ViewportCommand> {
        self.harness.output().viewport_output.values().flat_map(|viewport| &viewport.commands)
    }
}
