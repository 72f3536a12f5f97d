//! A studio without a display: its widgets are found by their names, its picture is looked at pixel by pixel.

#![allow(dead_code, unreachable_pub, reason = "every test program uses its part of this")]

pub mod reference;
mod tree;

use egui::{Key, Modifiers, PointerButton, Pos2, accesskit::Role};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use luch_scene::color::linear_from_srgb;
use luch_studio::{Start, Studio};
use std::sync::mpsc::{Receiver, sync_channel};
use std::time::Duration;

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
    pub rays_over_the_lens: &'static str,
    pub focal_distance: &'static str,
    pub picture: &'static str,
    pub picture_width: &'static str,
    pub picture_height: &'static str,
    pub live_update: &'static str,
    pub find_by_name: &'static str,
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
        rays_over_the_lens: "Rays over the lens",
        focal_distance: "Focal distance",
        picture: "Picture",
        picture_width: "Picture width",
        picture_height: "Picture height",
        live_update: "Live update",
        find_by_name: "Find by name",
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
        rays_over_the_lens: "Лучей на объектив",
        focal_distance: "Фокусное расстояние",
        picture: "Изображение",
        picture_width: "Ширина изображения",
        picture_height: "Высота изображения",
        live_update: "Обновлять сразу",
        find_by_name: "Найти по имени",
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
    live: bool,
    /// Gets a message whenever a thread has something new for the window.
    woken: Receiver<()>,
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
        let mut desk = Self::opening(words, start, size, pixels_per_point);
        desk.settle();
        desk
    }

    /// The same as the first frame finds it, whatever is under way.
    pub fn opening(words: Words, start: Start, size: [f32; 2], pixels_per_point: f32) -> Self {
        let start = Start { language: Some(words.language.to_owned()), ..start };
        let (wake, woken) = sync_channel(1);
        let harness = Harness::builder().with_size(size).with_pixels_per_point(pixels_per_point).build_eframe(
            move |creation: &mut eframe::CreationContext<'_>| {
                // What a frame asks for later, such as progress, is nothing to wake for.
                creation.egui_ctx.set_request_repaint_callback(move |request| {
                    if request.delay.is_zero() {
                        let _ = wake.try_send(());
                    }
                });
                Studio::new(creation, start).expect("a thread to render on")
            },
        );
        Self { harness, words, live: true, woken }
    }

    /// Draws frames until nothing is under way.
    pub fn settle(&mut self) {
        for _ in 0..2 {
            self.harness.step();
        }
        while !self.harness.state().is_settled() {
            // Frames that show nothing new would only take time from the renderer.
            let _ = self.woken.recv_timeout(Duration::from_millis(20));
            self.harness.step();
        }
        for _ in 0..3 {
            self.harness.step();
        }
    }

    /// Whether changes show by themselves from now on.
    pub fn set_live(&mut self, live: bool) {
        if self.live != live {
            self.tick(self.words.live_update);
            self.live = live;
        }
    }

    /// Changes something. Where changes wait for the button, the picture stays until it is pressed.
    pub fn change(&mut self, change: impl FnOnce(&mut Self)) {
        let before = self.picture();
        change(self);
        if !self.live {
            assert!(self.picture() == before, "the picture changed before the button was pressed");
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
        self.scroll_to(Role::ComboBox, list);
        self.harness.get_by_role_and_label(Role::ComboBox, list).click();
        self.harness.step();
        self.harness.step();
        self.harness.get_by_role_and_label(Role::Button, entry).click();
        self.settle();
    }

    /// Scrolls until a widget is in sight and comes to rest.
    pub fn scroll_to(&mut self, role: Role, name: &str) {
        let place = |desk: &Self| desk.harness.get_by_role_and_label(role, name).rect();
        self.harness.get_by_role_and_label(role, name).scroll_to_me();
        let mut before = egui::Rect::NOTHING;
        while before != place(self) {
            before = place(self);
            for _ in 0..3 {
                self.harness.step();
            }
        }
    }

    /// Scrolls to a field or a list to choose from.
    pub fn scroll_to_field(&mut self, name: &str) {
        let is_list = self.harness.query_by_role_and_label(Role::ComboBox, name).is_some();
        self.scroll_to(if is_list { Role::ComboBox } else { Role::TextInput }, name);
    }

    /// Types a value into the field of that name and presses Enter.
    pub fn type_into(&mut self, name: &str, text: &str) {
        self.begin_typing(name, text);
        self.harness.key_press(Key::Enter);
        self.settle();
    }

    /// Types a value into the field of that name and stays there.
    pub fn begin_typing(&mut self, name: &str, text: &str) {
        self.scroll_to(Role::TextInput, name);
        self.harness.get_by_role_and_label(Role::TextInput, name).click();
        self.harness.step();
        self.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        self.harness.key_press(Key::Backspace);
        self.harness.step();
        if !text.is_empty() {
            self.harness.get_by_role_and_label(Role::TextInput, name).type_text(text);
            self.harness.step();
        }
    }

    /// Ticks or unticks the box of that name.
    pub fn tick(&mut self, name: &str) {
        self.scroll_to(Role::CheckBox, name);
        self.harness.get_by_role_and_label(Role::CheckBox, name).click();
        self.settle();
    }

    /// Chooses one of several that exclude each other.
    pub fn choose_radio(&mut self, name: &str) {
        self.scroll_to(Role::RadioButton, name);
        self.harness.get_by_role_and_label(Role::RadioButton, name).click();
        self.settle();
    }

    /// Clicks a row of the list of objects.
    pub fn select_in_list(&mut self, name: &str) {
        self.press_in_list(name);
        assert_eq!(self.harness.state().selected(), Some(name));
    }

    /// Clicks a button in the list of objects.
    pub fn press_in_list(&mut self, name: &str) {
        // The list lies below the field that filters it, and scrolls by itself.
        self.scroll_to(Role::TextInput, self.words.find_by_name);
        self.scroll_list_to(name);
        self.scroll_to(Role::Button, name);
        self.harness.get_by_role_and_label(Role::Button, name).click();
        self.settle();
    }

    /// Turns the wheel over the list of objects until there is such a button: what is out of sight has no row.
    fn scroll_list_to(&mut self, name: &str) {
        let is_there = |desk: &Self| desk.harness.query_by_role_and_label(Role::Button, name).is_some();
        if is_there(self) {
            return;
        }
        let field = self.harness.get_by_role_and_label(Role::TextInput, self.words.find_by_name).rect();
        self.harness.hover_at(field.center_bottom() + egui::vec2(0.0, 20.0));
        // Up to its beginning, then down.
        for lines in std::iter::once(1000.0).chain(std::iter::repeat_n(-2.0, 1000)) {
            let (unit, delta) = (egui::MouseWheelUnit::Line, egui::vec2(0.0, lines));
            let (phase, source) = (egui::TouchPhase::Move, egui::MouseWheelSource::Unknown);
            let modifiers = Modifiers::NONE;
            self.harness.event(egui::Event::MouseWheel { unit, delta, phase, source, modifiers });
            for _ in 0..3 {
                self.harness.step();
            }
            if is_there(self) {
                return;
            }
        }
    }

    /// Clicks the picture at a part of its width and height, counted from the upper left.
    pub fn click_picture(&mut self, across: f32, down: f32) {
        self.click_at(self.point_of_picture(across, down));
    }

    /// Clicks a point of the window.
    pub fn click_at(&mut self, at: Pos2) {
        self.harness.hover_at(at);
        self.harness.step();
        for pressed in [true, false] {
            let button = PointerButton::Primary;
            self.harness.event(egui::Event::PointerButton { pos: at, button, pressed, modifiers: Modifiers::NONE });
            self.harness.step();
        }
        self.settle();
    }

    /// The point of the window in the middle of the picture, whatever its scale.
    pub fn middle_of_picture(&self) -> Pos2 {
        self.harness.get_by_role_and_label(Role::Image, self.words.picture).rect().center()
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

    /// Those of the pixels whose red, green or blue differ by more than `step` of 255 between two pictures.
    pub fn changed(&self, other: &Self, pixels: &[usize], step: u8) -> Vec<usize> {
        assert_eq!((self.width, self.height), (other.width, other.height));
        let differs = |i: &usize| self.pixels[*i].iter().zip(other.pixels[*i]).any(|(a, b)| a.abs_diff(b) > step);
        pixels.iter().copied().filter(differs).collect()
    }

    /// Red, green and blue of a pixel in linear light.
    pub fn linear(&self, pixel: usize) -> [f64; 3] {
        let [r, g, b, _] = self.pixels[pixel];
        [r, g, b].map(|value| f64::from(linear_from_srgb(f32::from(value) / 255.0)))
    }

    /// The luminance (Rec. 709) of a pixel.
    pub fn luminance(&self, pixel: usize) -> f64 {
        let [r, g, b] = self.linear(pixel);
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    /// The mean of some pixels in linear light.
    pub fn mean_of(&self, pixels: &[usize]) -> [f64; 3] {
        let sum = |channel: usize| pixels.iter().map(|&i| self.linear(i)[channel]).sum::<f64>();
        [0, 1, 2].map(|channel| sum(channel) / pixels.len() as f64)
    }

    /// Standard deviation of the luminance over its mean.
    pub fn contrast(&self, pixels: &[usize]) -> f64 {
        let count = pixels.len() as f64;
        let mean = pixels.iter().map(|&i| self.luminance(i)).sum::<f64>() / count;
        let variance = pixels.iter().map(|&i| (self.luminance(i) - mean).powi(2)).sum::<f64>() / count;
        variance.sqrt() / mean
    }

    pub fn pixel(&self, x: u32, y: u32) -> [u8; 4] {
        self.pixels[(y * self.width + x) as usize]
    }
}
