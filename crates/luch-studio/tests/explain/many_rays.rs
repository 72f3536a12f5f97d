//! An account of ten thousand rays: the window lays out what is in sight, and no more.

use crate::clicks::{looked_at, rows};
use crate::support::{Desk, LANGUAGES};
use egui_kittest::kittest::Queryable;
use luch_io::SceneSource;
use luch_studio::Start;

/// Two mirrors that face each other, two lamps between them, 64 rays for each pixel, up to 64 mirrors deep.
const HALL_OF_MIRRORS: &str = r#"
luch = 1
name = "Hall of mirrors"
[[light]]
name = "Lamp"
position = [0.5, 1.0, 0.5]
[[light]]
name = "Second lamp"
position = [-0.5, 1.0, 0.5]
[[camera]]
name = "Camera"
position = [0.0, 0.2, 2.0]
look_at = [0.1, 0.1, -3.0]
fov = 50.0
[[object]]
name = "Front mirror"
wall = { point = [0.0, 0.0, -3.0], normal = [0.0, 0.0, 1.0] }
reflection = 0.9
[[object]]
name = "Back mirror"
wall = { point = [0.0, 0.0, 3.0], normal = [0.0, 0.0, -1.0] }
reflection = 0.9
[render]
size = [48, 36]
depth = 64
antialiasing = { on = true, rays = 64 }
"#;

#[test]
fn of_ten_thousand_rays_the_rows_in_sight_alone_are_laid_out() {
    let folder = std::env::temp_dir().join(format!("luch-many-rays-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("mirrors.toml");
    std::fs::write(&path, HALL_OF_MIRRORS).unwrap();
    let start = Start { scene: Some(SceneSource::File(path)), ..Start::default() };
    let mut desk = Desk::start(LANGUAGES[0], start);
    std::fs::remove_dir_all(&folder).unwrap();
    desk.harness.key_press(egui::Key::X);
    desk.settle();
    desk.click_picture(0.5, 0.5);
    assert!(rows(&desk)[0].starts_with("Camera ray: Sample 1: Front mirror"), "{:?}", rows(&desk));
    // A camera ray, 63 mirror rays, and a shadow ray to each lamp from each of 64 surfaces; 64 times.
    desk.harness.get_by_label("64 samples");
    desk.harness.get_by_label("Unfold all").click();
    desk.settle();
    let height = desk.harness.get_by_role(egui::accesskit::Role::Tree).rect().height();
    let most = (height / 20.0) as usize + 3;
    let top = rows(&desk);
    assert!(top.len() > 5 && top.len() <= most, "{} of {most}", top.len());
    desk.harness.get_by_label(&top[0]).click();
    desk.settle();
    desk.harness.key_press(egui::Key::End);
    desk.settle();
    let bottom = rows(&desk);
    assert!(bottom.len() > 5 && bottom.len() <= most, "{} of {most}", bottom.len());
    assert!(looked_at(&desk).contains("Depth used up"), "{}", looked_at(&desk));
    // The last of them has the highest number.
    assert!(desk.harness.state().explained_rays() >= 10_000, "{}", desk.harness.state().explained_rays());
}
