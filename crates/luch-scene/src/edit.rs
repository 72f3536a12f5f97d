//! Every change that a person can make to a scene, as a value. Applying one answers with the edit that undoes it.
//!
//! The window, the command line's `--set` and scripts use the same edits, so what one can do the others can too.

use crate::camera::{Aim, Camera};
use crate::color::Color;
use crate::light::Light;
use crate::number::{FieldOfView, NonNegative, Positive, Unit};
use crate::object::{Checker, Object, Shading};
use crate::scene::{NameError, Scene, check_form};
use crate::settings::{ImageSize, RenderSettings, Sampling};
use crate::shape::Shape;
use crate::vector::Point;
use std::mem::replace;

/// A change of a scene. Numbers are places in the scene's lists.
#[derive(Debug, Clone, PartialEq)]
pub enum Edit {
    /// Change one object.
    Object(usize, ObjectEdit),
    /// Put an object into the list; the ones from there on move up.
    AddObject(usize, Box<Object>),
    /// Take an object out of the list.
    RemoveObject(usize),
    /// Put a copy of an object behind it, under a free name.
    DuplicateObject(usize),
    /// Change one light.
    Light(usize, LightEdit),
    /// Put a light into the list.
    AddLight(usize, Light),
    /// Take a light out of the list.
    RemoveLight(usize),
    /// Put a copy of a light behind it, under a free name.
    DuplicateLight(usize),
    /// Change one camera.
    Camera(usize, CameraEdit),
    /// Put a camera into the list.
    AddCamera(usize, Camera),
    /// Take a camera out of the list.
    RemoveCamera(usize),
    /// Change what belongs to the scene as a whole.
    Scene(SceneEdit),
    /// Change the defaults of its pictures.
    Settings(SettingsEdit),
    /// Several changes as one: applied in order, all or none.
    Group(Vec<Edit>),
}

/// A change of an object.
#[derive(Debug, Clone, PartialEq)]
pub enum ObjectEdit {
    /// Give it another name.
    Rename(String),
    /// Give it a colour, or (for a mesh) its file's own back.
    SetColor(Option<Color>),
    /// Set the share of the mirror.
    SetReflection(Unit),
    /// Set the highlight, or (for a mesh) its file's own.
    SetGloss(Option<Unit>),
    /// Give it a second colour, or none.
    SetChecker(Option<Checker>),
    /// Give a mesh a shading model of its own, or the scene's.
    SetShading(Option<Shading>),
    /// Move it.
    MoveTo(Point),
    /// Turn, scale or otherwise remake its geometry.
    SetShape(Shape),
    /// Leave it out of the picture, or show it again.
    SetHidden(bool),
}

/// A change of a light.
#[derive(Debug, Clone, PartialEq)]
pub enum LightEdit {
    /// Give it another name.
    Rename(String),
    /// Move it.
    MoveTo(Point),
    /// Make it brighter or darker.
    SetIntensity(NonNegative),
    /// Give it a colour.
    SetColor(Color),
    /// Switch it off or on.
    SetHidden(bool),
}

/// A change of a camera.
#[derive(Debug, Clone, PartialEq)]
pub enum CameraEdit {
    /// Give it another name.
    Rename(String),
    /// Move it.
    MoveTo(Point),
    /// Turn it.
    SetAim(Aim),
    /// Set the vertical field of view.
    SetFov(FieldOfView),
    /// Set the distance of focus.
    SetFocalDistance(Option<Positive>),
    /// Set the radius of the lens.
    SetLensRadius(NonNegative),
}

/// A change of what belongs to the scene as a whole.
#[derive(Debug, Clone, PartialEq)]
pub enum SceneEdit {
    /// Give it another name.
    Rename(String),
    /// Set the colour of where there is nothing.
    SetBackground(Color),
    /// Set the ambient light.
    SetAmbient(NonNegative),
    /// Set the attenuation constant K.
    SetAttenuation(Positive),
}

/// A change of the defaults of a scene's pictures.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SettingsEdit {
    /// Set the size.
    SetSize(ImageSize),
    /// Set the number of surfaces along a path.
    SetDepth(u32),
    /// Set antialiasing.
    SetAntialiasing(Sampling),
    /// Set depth of field.
    SetDepthOfField(Sampling),
    /// Set the shading model of meshes that name none.
    SetShading(Shading),
}

/// Why an edit was refused. The scene is as it was.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum EditError {
    /// There is no such object, light or camera.
    #[error("there is no {what} {index}")]
    NoSuch {
        /// `object`, `light` or `camera`.
        what: &'static str,
        /// The place that was named.
        index: usize,
    },
    /// The name cannot be given.
    #[error(transparent)]
    Name(#[from] NameError),
    /// A scene keeps at least one camera.
    #[error("the last camera cannot be removed")]
    LastCamera,
    /// The object would reach beyond the coordinates of a scene.
    #[error("the object would reach beyond 2e9 units from the origin")]
    OutOfBounds,
    /// A depth above the limit.
    #[error(transparent)]
    Number(#[from] crate::number::NumberError),
}

impl Edit {
    /// Applies the change and answers with the one that undoes it.
    ///
    /// # Errors
    /// [`EditError`] if it cannot be done; the scene is then as it was.
    pub fn apply(self, scene: &mut Scene) -> Result<Self, EditError> {
        match self {
            Self::Object(index, edit) => {
                apply_to_object(scene, index, edit).map(|inverse| Self::Object(index, inverse))
            }
            Self::AddObject(index, object) => {
                scene.check_new_name(&object.name)?;
                check_place(&scene.objects, index, "object")?;
                if !object.is_within_limits() {
                    return Err(EditError::OutOfBounds);
                }
                scene.objects.insert(index, *object);
                Ok(Self::RemoveObject(index))
            }
            Self::RemoveObject(index) => {
                get(&scene.objects, index, "object")?;
                Ok(Self::AddObject(index, Box::new(scene.objects.remove(index))))
            }
            Self::DuplicateObject(index) => {
                let mut copy = get(&scene.objects, index, "object")?.clone();
                copy.name = scene.free_name(&copy.name);
                Self::AddObject(index + 1, Box::new(copy)).apply(scene)
            }
            Self::Light(index, edit) => apply_to_light(scene, index, edit).map(|inverse| Self::Light(index, inverse)),
            Self::AddLight(index, light) => {
                scene.check_new_name(&light.name)?;
                check_place(&scene.lights, index, "light")?;
                scene.lights.insert(index, light);
                Ok(Self::RemoveLight(index))
            }
            Self::RemoveLight(index) => {
                get(&scene.lights, index, "light")?;
                Ok(Self::AddLight(index, scene.lights.remove(index)))
            }
            Self::DuplicateLight(index) => {
                let mut copy = get(&scene.lights, index, "light")?.clone();
                copy.name = scene.free_name(&copy.name);
                Self::AddLight(index + 1, copy).apply(scene)
            }
            Self::Camera(index, edit) => {
                apply_to_camera(scene, index, edit).map(|inverse| Self::Camera(index, inverse))
            }
            Self::AddCamera(index, camera) => {
                check_camera_name(scene, &camera.name)?;
                check_place(&scene.cameras, index, "camera")?;
                scene.cameras.insert(index, camera);
                Ok(Self::RemoveCamera(index))
            }
            Self::RemoveCamera(index) => {
                get(&scene.cameras, index, "camera")?;
                if scene.cameras.len() == 1 {
                    return Err(EditError::LastCamera);
                }
                Ok(Self::AddCamera(index, scene.cameras.remove(index)))
            }
            Self::Scene(edit) => apply_to_scene(scene, edit).map(Self::Scene),
            Self::Settings(edit) => apply_to_settings(&mut scene.settings, edit).map(Self::Settings),
            Self::Group(edits) => apply_group(scene, edits),
        }
    }
}

/// Applies the edits in order; if one is refused, those before it are undone.
fn apply_group(scene: &mut Scene, edits: Vec<Edit>) -> Result<Edit, EditError> {
    let mut inverses = Vec::with_capacity(edits.len());
    for edit in edits {
        match edit.apply(scene) {
            Ok(inverse) => inverses.push(inverse),
            Err(error) => {
                for inverse in inverses.into_iter().rev() {
                    inverse.apply(scene)?;
                }
                return Err(error);
            }
        }
    }
    inverses.reverse();
    Ok(Edit::Group(inverses))
}

fn apply_to_object(scene: &mut Scene, index: usize, edit: ObjectEdit) -> Result<ObjectEdit, EditError> {
    if let ObjectEdit::Rename(name) = &edit
        && get(&scene.objects, index, "object")?.name != *name
    {
        scene.check_new_name(name)?;
    }
    let object = get_mut(&mut scene.objects, index, "object")?;
    Ok(match edit {
        ObjectEdit::Rename(name) => ObjectEdit::Rename(replace(&mut object.name, name)),
        ObjectEdit::SetColor(color) => ObjectEdit::SetColor(replace(&mut object.material.color, color)),
        ObjectEdit::SetReflection(share) => ObjectEdit::SetReflection(replace(&mut object.material.reflection, share)),
        ObjectEdit::SetGloss(gloss) => ObjectEdit::SetGloss(replace(&mut object.material.gloss, gloss)),
        ObjectEdit::SetChecker(checker) => ObjectEdit::SetChecker(replace(&mut object.material.checker, checker)),
        ObjectEdit::SetShading(shading) => ObjectEdit::SetShading(replace(&mut object.shading, shading)),
        ObjectEdit::MoveTo(to) => {
            let from = object.shape.position();
            object.shape.set_position(to);
            if !object.is_within_limits() {
                object.shape.set_position(from);
                return Err(EditError::OutOfBounds);
            }
            ObjectEdit::MoveTo(from)
        }
        ObjectEdit::SetShape(shape) => {
            let old = replace(&mut object.shape, shape);
            if !object.is_within_limits() {
                object.shape = old;
                return Err(EditError::OutOfBounds);
            }
            ObjectEdit::SetShape(old)
        }
        ObjectEdit::SetHidden(hidden) => ObjectEdit::SetHidden(replace(&mut object.hidden, hidden)),
    })
}

fn apply_to_light(scene: &mut Scene, index: usize, edit: LightEdit) -> Result<LightEdit, EditError> {
    if let LightEdit::Rename(name) = &edit
        && get(&scene.lights, index, "light")?.name != *name
    {
        scene.check_new_name(name)?;
    }
    let light = get_mut(&mut scene.lights, index, "light")?;
    Ok(match edit {
        LightEdit::Rename(name) => LightEdit::Rename(replace(&mut light.name, name)),
        LightEdit::MoveTo(to) => LightEdit::MoveTo(replace(&mut light.position, to)),
        LightEdit::SetIntensity(intensity) => LightEdit::SetIntensity(replace(&mut light.intensity, intensity)),
        LightEdit::SetColor(color) => LightEdit::SetColor(replace(&mut light.color, color)),
        LightEdit::SetHidden(hidden) => LightEdit::SetHidden(replace(&mut light.hidden, hidden)),
    })
}

fn apply_to_camera(scene: &mut Scene, index: usize, edit: CameraEdit) -> Result<CameraEdit, EditError> {
    if let CameraEdit::Rename(name) = &edit
        && get(&scene.cameras, index, "camera")?.name != *name
    {
        check_camera_name(scene, name)?;
    }
    let camera = get_mut(&mut scene.cameras, index, "camera")?;
    Ok(match edit {
        CameraEdit::Rename(name) => CameraEdit::Rename(replace(&mut camera.name, name)),
        CameraEdit::MoveTo(to) => CameraEdit::MoveTo(replace(&mut camera.position, to)),
        CameraEdit::SetAim(aim) => CameraEdit::SetAim(replace(&mut camera.aim, aim)),
        CameraEdit::SetFov(fov) => CameraEdit::SetFov(replace(&mut camera.fov, fov)),
        CameraEdit::SetFocalDistance(d) => CameraEdit::SetFocalDistance(replace(&mut camera.focal_distance, d)),
        CameraEdit::SetLensRadius(radius) => CameraEdit::SetLensRadius(replace(&mut camera.lens_radius, radius)),
    })
}

fn apply_to_scene(scene: &mut Scene, edit: SceneEdit) -> Result<SceneEdit, EditError> {
    Ok(match edit {
        SceneEdit::Rename(name) => {
            check_form(&name)?;
            SceneEdit::Rename(replace(&mut scene.name, name))
        }
        SceneEdit::SetBackground(color) => SceneEdit::SetBackground(replace(&mut scene.background, color)),
        SceneEdit::SetAmbient(ambient) => SceneEdit::SetAmbient(replace(&mut scene.ambient, ambient)),
        SceneEdit::SetAttenuation(k) => SceneEdit::SetAttenuation(replace(&mut scene.attenuation, k)),
    })
}

fn apply_to_settings(settings: &mut RenderSettings, edit: SettingsEdit) -> Result<SettingsEdit, EditError> {
    Ok(match edit {
        SettingsEdit::SetSize(size) => SettingsEdit::SetSize(replace(&mut settings.size, size)),
        SettingsEdit::SetDepth(depth) => {
            SettingsEdit::SetDepth(replace(&mut settings.depth, RenderSettings::checked_depth(depth)?))
        }
        SettingsEdit::SetAntialiasing(s) => SettingsEdit::SetAntialiasing(replace(&mut settings.antialiasing, s)),
        SettingsEdit::SetDepthOfField(s) => SettingsEdit::SetDepthOfField(replace(&mut settings.depth_of_field, s)),
        SettingsEdit::SetShading(shading) => SettingsEdit::SetShading(replace(&mut settings.shading, shading)),
    })
}

fn check_camera_name(scene: &Scene, name: &str) -> Result<(), NameError> {
    check_form(name)?;
    if scene.camera_named(name).is_some() {
        return Err(NameError::Taken(name.to_owned()));
    }
    Ok(())
}

fn get<'a, T>(list: &'a [T], index: usize, what: &'static str) -> Result<&'a T, EditError> {
    list.get(index).ok_or(EditError::NoSuch { what, index })
}

fn get_mut<'a, T>(list: &'a mut [T], index: usize, what: &'static str) -> Result<&'a mut T, EditError> {
    list.get_mut(index).ok_or(EditError::NoSuch { what, index })
}

fn check_place<T>(list: &[T], index: usize, what: &'static str) -> Result<(), EditError> {
    if index > list.len() { Err(EditError::NoSuch { what, index }) } else { Ok(()) }
}
