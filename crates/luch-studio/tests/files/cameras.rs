//! Cameras added, renamed, removed.

use crate::desk::{BALL, Folder, studio, studio_with};
use crate::support::Desk;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;

impl Desk {
    /// Clicks an entry of the list of cameras that is no camera.
    fn camera_command(&mut self, entry: &str) {
        self.harness.get_by_role_and_label(Role::ComboBox, "Camera").click();
        self.steps(3);
        self.press_starting(entry);
        self.settle();
    }
}

#[test]
fn a_camera_is_made_of_what_is_seen() {
    let mut desk = studio();
    desk.camera_command("Camera from this view");
    let scene = desk.harness.state().scene();
    assert_eq!(scene.cameras.len(), 4);
    assert_eq!(scene.cameras[3].name, "Camera 4");
    assert_eq!(scene.cameras[3].position, scene.cameras[0].position);
    assert_eq!(desk.harness.state().camera().unwrap().name, "Camera 4");
    desk.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.harness.state().scene().cameras.len(), 3);
    assert!(desk.harness.state().camera().is_some());
}

#[test]
fn a_camera_is_renamed_and_no_name_is_given_twice() {
    let mut desk = studio();
    desk.camera_command("Rename the camera…");
    for name in ["Camera 2", "", "From above"] {
        desk.type_into("Name", name);
        assert_eq!(desk.offers("Rename"), name != "From above", "{name}");
    }
    assert_eq!(desk.harness.state().camera().unwrap().name, "From above");
}

#[test]
fn the_last_camera_stays() {
    let folder = Folder::new();
    let mut desk = studio();
    desk.camera_command("Remove the camera");
    desk.camera_command("Remove the camera");
    assert_eq!(desk.harness.state().scene().cameras.len(), 1);
    assert_eq!(desk.harness.state().camera().unwrap().name, "Camera 3");
    let mut desk = studio_with(&folder.write("ball.toml", BALL));
    desk.camera_command("Remove the camera");
    assert_eq!(desk.harness.state().scene().cameras.len(), 1);
    assert!(!desk.says("The change was refused"), "it cannot even be asked for");
}

#[test]
fn the_view_stays_on_its_camera_when_others_come_back() {
    let mut desk = studio();
    desk.camera_command("Remove the camera");
    desk.choose("Camera", "Camera 3");
    // The view is moved by a key of the picture.
    desk.click_picture(0.5, 0.02);
    desk.key(Modifiers::NONE, Key::ArrowLeft);
    let seen = desk.harness.state().camera().unwrap();
    assert!(desk.says("Camera 3 *"));
    desk.key(Modifiers::COMMAND, Key::Z);
    assert_eq!(desk.harness.state().scene().cameras.len(), 3);
    assert_eq!(desk.harness.state().camera().unwrap(), seen);
    desk.key(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z);
    assert_eq!(desk.harness.state().camera().unwrap(), seen);
}
