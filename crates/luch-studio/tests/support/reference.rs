//! What the command line would make: the picture of a scene, and what is seen at each of its pixels.

use super::{Desk, Picture};
use glam::Vec3;
use luch_io::budget::Budget;
use luch_io::library::MeshLibrary;
use luch_io::{Report, SceneSource, load_scene, write_scene};
use luch_render::film::tonemap::srgb8;
use luch_render::session::live::{Pick, pick};
use luch_render::{MeshTrees, Progress, RenderJob, compile, render};
use luch_scene::{ImageSize, Scene};
use std::sync::{Mutex, PoisonError};

/// Trees that all tests share: building those of the chess set takes longest here.
static TREES: Mutex<Option<MeshTrees>> = Mutex::new(None);

/// A picture made without a window.
pub struct Reference {
    pub scene: Scene,
    pub picture: Picture,
    job: RenderJob,
    picks: Vec<Option<Pick>>,
}

impl Reference {
    /// The picture from a camera of a built-in scene, counted from 1, at a size, after a change of the scene.
    pub fn new(id: &'static str, camera: usize, size: [u32; 2], change: impl FnOnce(&mut Scene)) -> Self {
        let mut scene = scene(id);
        scene.settings.size = ImageSize::new(size[0], size[1]).unwrap();
        change(&mut scene);
        let job = RenderJob { threads: 2, ..RenderJob::of_scene(&scene, camera - 1) };
        let mut trees = TREES.lock().unwrap_or_else(PoisonError::into_inner);
        let compiled = compile(&scene, trees.get_or_insert_default(), 2);
        drop(trees);
        let film = render(&compiled, &job, &Progress::default()).unwrap();
        let bytes = srgb8(&film.linear());
        let pixels = bytes.chunks_exact(3).map(|p| [p[0], p[1], p[2], 255]).collect();
        let picture = Picture { width: size[0], height: size[1], pixels };
        let places = (0..size[1]).flat_map(|y| (0..size[0]).map(move |x| (x, y)));
        let picks = places.map(|(x, y)| pick(&compiled, &job, x, y)).collect();
        Self { scene, picture, job, picks }
    }

    /// The name of the object that is seen at a pixel; empty for the background.
    pub fn name_at(&self, pixel: usize) -> &str {
        self.picks[pixel].map_or("", |pick| &self.scene.objects[pick.object].name)
    }

    /// The pixels where an object of such a name is seen.
    pub fn pixels(&self, of: impl Fn(&str) -> bool) -> Vec<usize> {
        (0..self.picks.len()).filter(|&i| of(self.name_at(i))).collect()
    }

    /// The pixels of one object.
    pub fn of(&self, name: &str) -> Vec<usize> {
        assert!(self.scene.object_named(name).is_some(), "the scene has no {name}");
        self.pixels(|n| n == name)
    }

    /// The share of the picture that an object takes.
    pub fn share(&self, name: &str) -> f64 {
        self.of(name).len() as f64 / self.picks.len() as f64
    }

    /// The distance along the view of what is seen at a pixel, infinite for the background.
    pub fn distance(&self, pixel: usize) -> f32 {
        let camera = &self.job.camera;
        let [_, _, forward]: [Vec3; 3] = camera.frame();
        self.picks[pixel].map_or(f32::INFINITY, |pick| forward.dot(pick.point - camera.position.get()))
    }

    /// The middle of the pixel of an object that is farthest from all others, as parts of the picture's width and height.
    pub fn inside(&self, name: &str) -> [f32; 2] {
        let (width, height) = (self.picture.width as usize, self.picture.height as usize);
        let pixels = self.of(name);
        let is_inside = |x: usize, y: usize| x < width && y < height && self.name_at(y * width + x) == name;
        // How far left, right, up and down the object reaches, the nearest of the four.
        let room = |&i: &usize| {
            let (x, y) = (i % width, i / width);
            let reaches = |dx: isize, dy: isize| {
                (1..).take_while(|n| is_inside(x.wrapping_add_signed(n * dx), y.wrapping_add_signed(n * dy))).count()
            };
            [reaches(1, 0), reaches(-1, 0), reaches(0, 1), reaches(0, -1)].into_iter().min()
        };
        let best = *pixels.iter().max_by_key(|i| room(i)).unwrap_or_else(|| panic!("{name} is not seen"));
        [((best % width) as f32 + 0.5) / width as f32, ((best / width) as f32 + 0.5) / height as f32]
    }

    /// The window has this scene and shows this picture, to the last byte.
    pub fn assert_shown(&self, desk: &Desk) {
        let scene = desk.harness.state().scene();
        let lines = [scene, &self.scene].map(|scene| write_scene(scene).lines().map(str::to_owned).collect::<Vec<_>>());
        let unlike: Vec<_> = lines[0].iter().zip(&lines[1]).filter(|(a, b)| a != b).collect();
        assert!(*scene == self.scene, "the window has another scene: {unlike:?}");
        let shown = desk.picture();
        let different = shown.differences(&self.picture, 0);
        assert_eq!(different, 0, "{different} pixels differ from those of the command line");
    }
}

/// A built-in scene as the library reads it.
pub fn scene(id: &'static str) -> Scene {
    let source = SceneSource::BuiltIn(id);
    load_scene(&source, &mut MeshLibrary::new(), &mut Budget::default(), &mut Report::default()).unwrap()
}
