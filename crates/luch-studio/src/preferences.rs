//! What the window remembers between runs.

use crate::l10n::{self, Language};
use egui::ThemePreference;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// What a person has chosen for all scenes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Preferences {
    pub(crate) language: Language,
    pub(crate) theme: ThemePreference,
    /// Whether every change starts a picture by itself.
    pub(crate) live: bool,
    /// Threads to use; `None`: one per core.
    pub(crate) threads: Option<usize>,
    /// Scene files and models that were opened or saved, the last first.
    pub(crate) recent: Vec<PathBuf>,
    /// Whether the hints of the first run were read.
    pub(crate) hints_read: bool,
}

/// The same as it is stored. Fields that a newer or older version lacks have their defaults.
#[derive(Debug, Default, Serialize, Deserialize)]
#[serde(default)]
struct Stored {
    language: Option<String>,
    theme: Option<ThemePreference>,
    live: Option<bool>,
    threads: Option<usize>,
    /// As [`luch_io::encode_path`] writes them: JSON has no paths that are no text.
    recent: Vec<String>,
    hints_read: bool,
}

impl Preferences {
    /// The most files that are remembered.
    pub(crate) const RECENT: usize = 10;
    /// The most threads that can be asked for.
    pub(crate) const MAX_THREADS: usize = 1024;
    const KEY: &'static str = "preferences";

    /// The preferences of a first run.
    pub(crate) const fn first_run(language: Language) -> Self {
        Self {
            language,
            theme: ThemePreference::System,
            live: true,
            threads: None,
            recent: Vec::new(),
            hints_read: false,
        }
    }

    /// What was stored, or the preferences of a first run. What cannot be read counts as not stored.
    pub(crate) fn load(storage: Option<&dyn eframe::Storage>) -> Self {
        let stored = storage.and_then(|s| s.get_string(Self::KEY));
        let stored: Stored = stored.and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default();
        let first = Self::first_run(l10n::system_language());
        Self {
            language: stored.language.as_deref().and_then(l10n::of_tag).unwrap_or(first.language),
            theme: stored.theme.unwrap_or(first.theme),
            live: stored.live.unwrap_or(first.live),
            threads: stored.threads.filter(|n| (1..=Self::MAX_THREADS).contains(n)),
            recent: stored.recent.iter().filter_map(|path| luch_io::decode_path(path)).take(Self::RECENT).collect(),
            hints_read: stored.hints_read,
        }
    }

    pub(crate) fn store(&self, storage: &mut dyn eframe::Storage) {
        let stored = Stored {
            language: Some(l10n::tag(self.language).to_owned()),
            theme: Some(self.theme),
            live: Some(self.live),
            threads: self.threads,
            recent: self.recent.iter().map(|path| luch_io::encode_path(path)).collect(),
            hints_read: self.hints_read,
        };
        if let Ok(text) = serde_json::to_string(&stored) {
            storage.set_string(Self::KEY, text);
        }
    }

    /// Threads to render with.
    pub(crate) fn threads_in_use(&self) -> usize {
        self.threads.unwrap_or_else(cores)
    }

    /// Puts a file at the head of the recent ones.
    pub(crate) fn remember(&mut self, path: &Path) {
        // The next run may be started in another folder.
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        self.recent.retain(|known| *known != path);
        self.recent.insert(0, path);
        self.recent.truncate(Self::RECENT);
    }

    /// Takes a file out of the recent ones: it is no longer there.
    pub(crate) fn forget(&mut self, path: &Path) {
        let absolute = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        self.recent.retain(|known| *known != absolute);
    }
}

/// Threads that the machine runs at once.
pub(crate) fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, std::num::NonZero::get)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashMap;

    #[derive(Default)]
    struct Memory(HashMap<String, String>);

    impl eframe::Storage for Memory {
        fn get_string(&self, key: &str) -> Option<String> {
            self.0.get(key).cloned()
        }

        fn set_string(&mut self, key: &str, value: String) {
            self.0.insert(key.to_owned(), value);
        }

        fn remove_string(&mut self, key: &str) {
            self.0.remove(key);
        }

        fn flush(&mut self) {}
    }

    #[cfg(unix)]
    #[test]
    fn what_is_stored_is_read_back_whatever_the_files_are_called() {
        use std::os::unix::ffi::OsStrExt;
        let mut preferences = Preferences::first_run(Language::Ru);
        let odd = Path::new(std::ffi::OsStr::from_bytes(b"/caf\xe9/100%.toml"));
        for path in [odd, Path::new("/b.toml"), odd] {
            preferences.remember(path);
        }
        assert_eq!(preferences.recent, [odd, Path::new("/b.toml")]);
        let mut storage = Memory::default();
        preferences.store(&mut storage);
        assert_eq!(Preferences::load(Some(&storage)), preferences);
        preferences.forget(odd);
        assert_eq!(preferences.recent, [Path::new("/b.toml")]);
        storage.0.insert(Preferences::KEY.into(), "{nonsense".into());
        assert!(Preferences::load(Some(&storage)).recent.is_empty());
    }
}
