//! The scene: everything that a picture is made from.

use crate::camera::Camera;
use crate::color::Color;
use crate::light::Light;
use crate::number::{MAX_COORDINATE, NonNegative, Positive};
use crate::object::Object;
use crate::settings::RenderSettings;
use glam::Vec3;
use std::collections::HashSet;

/// A scene. Its parts are found by their place in the lists; names are unique, for people.
#[derive(Debug, Clone, PartialEq)]
pub struct Scene {
    /// What people call it.
    pub name: String,
    /// The colour of where there is nothing.
    pub background: Color,
    /// I_a, the light that is everywhere.
    pub ambient: NonNegative,
    /// K, the distance at which a light has half its strength.
    pub attenuation: Positive,
    /// The lights.
    pub lights: Vec<Light>,
    /// The cameras.
    pub cameras: Vec<Camera>,
    /// The objects.
    pub objects: Vec<Object>,
    /// Defaults of its pictures.
    pub settings: RenderSettings,
}

/// A name that two things share, or that is no name.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum NameError {
    /// Another one has it.
    #[error("the name \"{0}\" is taken")]
    Taken(String),
    /// Nothing to call it by.
    #[error("a name must have at least one visible character")]
    Empty,
    /// Longer than [`Scene::MAX_NAME`] bytes.
    #[error("a name may have 256 bytes at most")]
    TooLong,
    /// A line break or another control character.
    #[error("a name must not hold control characters")]
    Control,
}

impl Scene {
    /// The longest name, in bytes.
    pub const MAX_NAME: usize = 256;

    /// An empty scene: a black background, a little ambient light, nothing in it.
    #[must_use]
    pub fn new(name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            background: Color::BLACK,
            ambient: NonNegative::clamped(0.1),
            attenuation: Positive::clamped(4.0),
            lights: Vec::new(),
            cameras: Vec::new(),
            objects: Vec::new(),
            settings: RenderSettings::default(),
        }
    }

    /// The object of that name.
    #[must_use]
    pub fn object_named(&self, name: &str) -> Option<usize> {
        self.objects.iter().position(|o| o.name == name)
    }

    /// The light of that name.
    #[must_use]
    pub fn light_named(&self, name: &str) -> Option<usize> {
        self.lights.iter().position(|l| l.name == name)
    }

    /// The camera of that name.
    #[must_use]
    pub fn camera_named(&self, name: &str) -> Option<usize> {
        self.cameras.iter().position(|c| c.name == name)
    }

    /// Whether `name` may be given to an object or light.
    ///
    /// # Errors
    /// [`NameError`] says why not.
    pub fn check_new_name(&self, name: &str) -> Result<(), NameError> {
        check_form(name)?;
        if self.object_named(name).is_some() || self.light_named(name).is_some() {
            return Err(NameError::Taken(name.to_owned()));
        }
        Ok(())
    }

    /// Whether a word has the form of a name, be it of a scene or of something in it.
    ///
    /// # Errors
    /// [`NameError`] says why not.
    pub fn check_form(name: &str) -> Result<(), NameError> {
        check_form(name)
    }

    /// `base`, or `base 2`, `base 3`, ...: the first that no object or light has.
    #[must_use]
    pub fn free_name(&self, base: &str) -> String {
        let taken: HashSet<&str> =
            self.objects.iter().map(|o| o.name.as_str()).chain(self.lights.iter().map(|l| l.name.as_str())).collect();
        first_free(base, |name| taken.contains(name))
    }

    /// `base`, or `base 2`, `base 3`, ...: the first that no camera has.
    #[must_use]
    pub fn free_camera_name(&self, base: &str) -> String {
        first_free(base, |name| self.camera_named(name).is_some())
    }

    /// Lower and upper corner of the box around all visible bounded objects; `None` if there are none.
    #[must_use]
    pub fn bounds(&self) -> Option<[Vec3; 2]> {
        let boxes = self.objects.iter().filter(|o| !o.hidden).filter_map(|o| o.shape.bounds());
        boxes.reduce(|[lo, hi], [a, b]| [lo.min(a), hi.max(b)])
    }

    /// Triangles of all visible objects, shared meshes counted once for each object.
    #[must_use]
    pub fn triangle_count(&self) -> u64 {
        let count = |o: &Object| match &o.shape {
            crate::shape::Shape::Mesh(instance) => instance.mesh.triangles().len() as u64,
            _ => 0,
        };
        self.objects.iter().filter(|o| !o.hidden).map(count).sum()
    }
}

impl Object {
    /// Whether the object, scaled and placed, still lies within the coordinates that a scene may have.
    #[must_use]
    pub fn is_within_limits(&self) -> bool {
        self.shape.bounds().is_none_or(|[lo, hi]| {
            // Written so that NaN, which fails every comparison, is outside.
            lo.to_array().into_iter().chain(hi.to_array()).all(|c| c.abs() <= MAX_COORDINATE * 2.0)
        })
    }
}

/// Whether a word has the form of a name.
pub(crate) fn check_form(name: &str) -> Result<(), NameError> {
    if name.trim().is_empty() {
        return Err(NameError::Empty);
    }
    if name.len() > Scene::MAX_NAME {
        return Err(NameError::TooLong);
    }
    if name.chars().any(char::is_control) {
        return Err(NameError::Control);
    }
    Ok(())
}

/// The first free name. A base that is too long for a number behind it loses letters at its end.
fn first_free(base: &str, taken: impl Fn(&str) -> bool) -> String {
    let base = shortened(base, Scene::MAX_NAME);
    if !taken(base) {
        return base.to_owned();
    }
    let mut number = 2_u64;
    loop {
        let ending = format!(" {number}");
        let name = shortened(base, Scene::MAX_NAME - ending.len()).to_owned() + &ending;
        if !taken(&name) {
            return name;
        }
        number += 1;
    }
}

/// As much of the beginning of a text as fits into so many bytes, in whole characters.
fn shortened(text: &str, most: usize) -> &str {
    &text[..text.floor_char_boundary(most)]
}
