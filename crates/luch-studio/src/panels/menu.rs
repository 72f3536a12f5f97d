//! The menu bar.

use crate::command::{Command, Zoom};
use crate::dialogs::Dialog;
use crate::files::shown;
use crate::l10n::Language;
use crate::placement::Addition;
use crate::state::Desk;
use crate::study::StudyCommand;
use egui::{Button, MenuBar, ThemePreference, Ui};
use luch_io::SceneSource;
use luch_render::Integrator;

pub(crate) fn show(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    MenuBar::new().ui(ui, |ui| {
        ui.menu_button(texts.menu_file(), |ui| {
            item(ui, desk, Command::New, true);
            item(ui, desk, Command::OpenDialog, true);
            recent_menu(ui, desk);
            ui.separator();
            let document = &desk.state.document;
            let savable = document.is_changed() || document.file().is_none();
            item(ui, desk, Command::Save, savable);
            item(ui, desk, Command::SaveAs, true);
            item(ui, desk, Command::ExportDialog, true);
            ui.separator();
            item(ui, desk, Command::Quit, true);
        });
        ui.menu_button(texts.menu_edit(), |ui| {
            item(ui, desk, Command::Undo, desk.state.document.can_undo());
            item(ui, desk, Command::Redo, desk.state.document.can_redo());
            ui.separator();
            let selected = desk.state.selection.is_some();
            for command in [Command::Duplicate, Command::Delete, Command::ToggleHidden, Command::Select(None)] {
                item(ui, desk, command, selected);
            }
        });
        ui.menu_button(texts.menu_add(), |ui| {
            for what in Addition::ALL {
                item(ui, desk, Command::Add(what), true);
            }
            item(ui, desk, Command::AddModelDialog, true);
            ui.separator();
            item(ui, desk, Command::AddCamera, true);
        });
        ui.menu_button(texts.menu_view(), |ui| {
            item(ui, desk, Command::SetZoom(Zoom::Fit), true);
            item(ui, desk, Command::SetZoom(Zoom::Factor(1.0)), true);
            ui.separator();
            item(ui, desk, Command::Frame, true);
            item(ui, desk, Command::SetPose(None), desk.state.view.pose.is_some());
            item(ui, desk, Command::StorePose, desk.state.view.pose.is_some());
            ui.separator();
            view_menu(ui, desk);
            ui.separator();
            item(ui, desk, Command::Study(StudyCommand::Open(true)), true);
            ui.separator();
            theme_menu(ui, desk);
            language_menu(ui, desk);
        });
        ui.menu_button(texts.menu_help(), |ui| {
            item(ui, desk, Command::Show(Dialog::Shortcuts), true);
            item(ui, desk, Command::Show(Dialog::About), true);
        });
    });
}

/// A command as a line of a menu, with its key.
pub(crate) fn item(ui: &mut Ui, desk: &mut Desk<'_>, command: Command, enabled: bool) {
    let mut button = Button::new(command.label(desk.texts));
    if let Some(shortcut) = command.shortcut() {
        button = button.shortcut_text(ui.ctx().format_shortcut(&shortcut));
    }
    if ui.add_enabled(enabled, button).clicked() {
        desk.send(command);
    }
}

/// What the picture shows: light, or what the rays meet and what it costs.
fn view_menu(ui: &mut Ui, desk: &mut Desk<'_>) {
    ui.menu_button(desk.texts.menu_shows(), |ui| {
        for integrator in Integrator::ALL {
            let [name, tip] = crate::viewport::view_name(desk.texts, integrator);
            if ui.radio(desk.state.integrator == integrator, name).on_hover_text(tip).clicked() {
                desk.send(Command::SetIntegrator(integrator));
            }
        }
    });
}

/// The files that were used last.
fn recent_menu(ui: &mut Ui, desk: &mut Desk<'_>) {
    let recent: Vec<_> = desk.state.preferences.recent.iter().filter_map(|path| SceneSource::of_path(path)).collect();
    ui.add_enabled_ui(!recent.is_empty(), |ui| {
        ui.menu_button(desk.texts.menu_recent(), |ui| {
            for source in recent {
                let path = source.path().unwrap_or(std::path::Path::new(""));
                let name = shown(path.file_name().unwrap_or_default());
                if ui.button(name).on_hover_text(shown(path.as_os_str())).clicked() {
                    desk.send(Command::Open(source));
                }
            }
        });
    });
}

fn theme_menu(ui: &mut Ui, desk: &mut Desk<'_>) {
    let texts = desk.texts;
    ui.menu_button(texts.menu_theme(), |ui| {
        let themes = [
            (ThemePreference::System, texts.theme_system()),
            (ThemePreference::Light, texts.theme_light()),
            (ThemePreference::Dark, texts.theme_dark()),
        ];
        for (theme, name) in themes {
            if ui.radio(desk.state.preferences.theme == theme, name).clicked() {
                desk.send(Command::SetTheme(theme));
            }
        }
    });
}

/// The languages by their own names; the word for it stands in both, for those who look for theirs.
fn language_menu(ui: &mut Ui, desk: &mut Desk<'_>) {
    ui.menu_button(desk.texts.menu_language(), |ui| {
        for &language in Language::iter() {
            if ui.radio(desk.state.preferences.language == language, language.language_name()).clicked() {
                desk.send(Command::SetLanguage(language));
            }
        }
    });
}
