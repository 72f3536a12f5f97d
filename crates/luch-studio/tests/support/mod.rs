//! A studio without a display: its widgets are found by their names, its picture is looked at pixel by pixel.

#![allow(dead_code, unreachable_pub, reason = "every test program uses its part of this")]

use egui::{Modifiers, PointerButton, Pos2, accesskit::Role};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use luch_studio::{Start, Studio};

/// What the tests look for, in one language.
#[derive(Debug, Clone, Copy)]
pub struct Words {
    pub language: &'static str,
    pub scene: &'static str,
    pub knight: &'static str,
    pub chess: &'static str,
    pub camera: &'static str,
    pub render: &'static str,
    pub field_of_view: &'static str,
    pub color: &'static str,
    pub reflection: &'static str,
    pub gloss: &'static str,
    pub light_intensity: &'static str,
    pub antialiasing: &'static str,
    pub rays_per_pixel: &'static str,
    pub depth_of_field: &'static str,
    pub focal_distance: &'static str,
    pub picture: &'static str,
    pub picture_width: &'static str,
    pub picture_height: &'static str,
}

/// Both languages of the window. The Russian words are those of the original program.
pub const LANGUAGES: [Words; 2] = [
    Words {
        language: "en",
        scene: "Scene",
        knight: "Knight, cube and sphere",
        chess: "Chess",
        camera: "Camera",
        render: "Render",
        field_of_view: "Field of view",
        color: "Color",
        reflection: "Reflection",
        gloss: "Gloss",
        light_intensity: "Light intensity",
        antialiasing: "Antialiasing",
        rays_per_pixel: "Rays per pixel",
        depth_of_field: "Depth of field",
        focal_distance: "Focal distance",
        picture: "Picture",
        picture_width: "Picture width",
        picture_height: "Picture height",
    },
    Words {
        language: "ru",
        scene: "Сцена",
        knight: "Конь, куб и сфера",
        chess: "Шахматы",
        camera: "Камера",
        render: "Визуализировать",
        field_of_view: "Поле зрения",
        color: "Цвет",
        reflection: "Зеркальность",
        gloss: "Глянцевость",
        light_intensity: "Интенсивность света",
        antialiasing: "Сглаживание",
        rays_per_pixel: "Лучей на пиксель",
        depth_of_field: "Глубина поля",
        focal_distance: "Фокусное расстояние",
        picture: "Изображение",
        picture_width: "Ширина изображения",
        picture_height: "Высота изображения",
    },
];

/// A picture as the window shows it.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    pub width: u32,
    pub height: u32,
    pub pixels: Vec<[u8; 4]>,
}

/// A studio at work.
pub struct Desk {
    pub harness: Harness<'static, Studio>,
    pub words: Words,
}

impl Desk {
    /// A fresh studio in a window of 1280 x 800 points, its first picture shown.
    pub fn new(words: Words) -> Self {
        Self::start(words, Start::default())
    }

    /// A studio that starts in some way, in the language of the words.
    pub fn start(words: Words, start: Start) -> Self {
        Self::in_window(words, start, [1280.0, 800.0], 1.0)
    }

    /// The same in a window of another size, in points.
    pub fn in_window(words: Words, start: Start, size: [f32; 2], pixels_per_point: f32) -> Self {
        let start = Start { language: Some(words.language.to_owned()), ..start };
        let harness = Harness::builder()
            .with_size(size)
            .with_pixels_per_point(pixels_per_point)
            .build_eframe(|creation| Studio::new(creation, start).expect("a thread to render on"));
        let mut desk = Self { harness, words };
        desk.settle();
        desk
    }

    /// Draws frames until nothing is under way.
    pub fn settle(&mut self) {
        for _ in 0..2 {
            self.harness.step();
        }
        while !self.harness.state().is_settled() {
            self.harness.step();
            std::thread::yield_now();
        }
        for _ in 0..3 {
            self.harness.step();
        }
    }

    /// Presses the button for a picture and waits for it.
    pub fn render(&mut self) -> Picture {
        self.harness.get_by_role_and_label(Role::Button, self.words.render).click();
        self.settle();
        self.picture()
    }

    pub fn picture(&self) -> Picture {
        let (width, height, pixels) = self.harness.state().picture().expect("a picture");
        Picture { width, height, pixels: pixels.to_vec() }
    }

    /// Makes pictures of another size, as a person would by typing.
    pub fn resize(&mut self, width: u32, height: u32) {
        self.type_into(self.words.picture_width, &width.to_string());
        self.type_into(self.words.picture_height, &height.to_string());
    }

    /// Opens the list of that name and clicks an entry of it.
    pub fn choose(&mut self, list: &str, entry: &str) {
        self.harness.get_by_role_and_label(Role::ComboBox, list).click();
        self.harness.step();
        self.harness.step();
        self.harness.get_by_role_and_label(Role::Button, entry).click();
        self.settle();
    }

    /// Types a value into the field of that name and presses Enter.
    pub fn type_into(&mut self, name: &str, text: &str) {
        let field = self.harness.get_by_role_and_label(Role::TextInput, name);
        field.scroll_to_me();
        self.harness.step();
        self.harness.step();
        self.harness.get_by_role_and_label(Role::TextInput, name).click();
        self.harness.step();
        self.harness.key_press_modifiers(Modifiers::COMMAND, egui::Key::A);
        self.harness.step();
        self.harness.get_by_role_and_label(Role::TextInput, name).type_text(text);
        self.harness.step();
        self.harness.key_press(egui::Key::Enter);
        self.settle();
    }

    /// Ticks or unticks the box of that name.
    pub fn tick(&mut self, name: &str) {
        self.harness.get_by_role_and_label(Role::CheckBox, name).scroll_to_me();
        self.harness.step();
        self.harness.step();
        self.harness.get_by_role_and_label(Role::CheckBox, name).click();
        self.settle();
    }

    /// Clicks a row of the list of objects.
    pub fn select_in_list(&mut self, name: &str) {
        self.harness.get_by_role_and_label(Role::Button, name).scroll_to_me();
        self.harness.step();
        self.harness.step();
        self.harness.get_by_role_and_label(Role::Button, name).click();
        self.settle();
    }

    /// Clicks the picture at a part of its width and height, counted from the upper left.
    pub fn click_picture(&mut self, across: f32, down: f32) {
        let at = self.point_of_picture(across, down);
        self.harness.hover_at(at);
        self.harness.step();
        for pressed in [true, false] {
            let button = PointerButton::Primary;
            self.harness.event(egui::Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE });
            self.harness.step();
        }
        self.settle();
    }

    /// The point of the window at a part of the picture.
    pub fn point_of_picture(&self, across: f32, down: f32) -> Pos2 {
        let area = self.harness.get_by_role_and_label(Role::Image, self.words.picture).rect();
        let Picture { width, height, .. } = self.picture();
        // As the window says it fits: a margin of 12 points, never stretched.
        let room = area.size() - egui::vec2(24.0, 24.0);
        let scale = (room.x / width as f32).min(room.y / height as f32);
        let size = egui::vec2(width as f32, height as f32) * scale;
        area.center() - size * 0.5 + size * egui::vec2(across, down)
    }
}

impl Picture {
    /// How many pixels differ from those of another picture of the same size by more than `step` of 255.
    pub fn differences(&self, other: &Self, step: u8) -> usize {
        assert_eq!((self.width, self.height), (other.width, other.height));
        let differs = |(a, b): (&[u8; 4], &[u8; 4])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > step);
        self.pixels.iter().zip(&other.pixels).filter(|pair| differs(*pair)).count()
    }

    /// The mean of red, green and blue over the whole picture.
    pub fn mean(&self) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for pixel in &self.pixels {
            for (sum, value) in sums.iter_mut().zip(pixel) {
                *sum += f64::from(*value);
            }
        }
        sums.map(|sum| sum / self.pixels.len() as f64)
    }

    pub fn pixel(&self, x: u32, y: u32) -> [u8; 4] {
        self.pixels[(y * self.width + x) as usize]
    }
}
