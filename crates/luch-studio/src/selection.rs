//! What is selected: an object or a light of the scene.

use luch_scene::{Edit, LightEdit, ObjectEdit, Point, Scene};

/// A thing in the list of the scene's objects.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Part {
    /// The object at this place of the scene's list.
    Object(usize),
    /// The light at this place.
    Light(usize),
}

impl Part {
    /// Whether the scene has it.
    pub(crate) fn exists(self, scene: &Scene) -> bool {
        self.name(scene).is_some()
    }

    pub(crate) fn name(self, scene: &Scene) -> Option<&str> {
        match self {
            Self::Object(index) => scene.objects.get(index).map(|o| o.name.as_str()),
            Self::Light(index) => scene.lights.get(index).map(|l| l.name.as_str()),
        }
    }

    /// The part of that name; names are unique among objects and lights.
    pub(crate) fn named(scene: &Scene, name: &str) -> Option<Self> {
        let object = scene.object_named(name).map(Self::Object);
        object.or_else(|| scene.light_named(name).map(Self::Light))
    }

    pub(crate) fn is_hidden(self, scene: &Scene) -> bool {
        match self {
            Self::Object(index) => scene.objects.get(index).is_some_and(|o| o.hidden),
            Self::Light(index) => scene.lights.get(index).is_some_and(|l| l.hidden),
        }
    }

    /// Where it stands: a centre, a wall's point, a model's origin.
    pub(crate) fn position(self, scene: &Scene) -> Option<Point> {
        match self {
            Self::Object(index) => scene.objects.get(index).map(|o| o.shape.position()),
            Self::Light(index) => scene.lights.get(index).map(|l| l.position),
        }
    }

    pub(crate) fn move_to(self, to: Point) -> Edit {
        match self {
            Self::Object(index) => Edit::Object(index, ObjectEdit::MoveTo(to)),
            Self::Light(index) => Edit::Light(index, LightEdit::MoveTo(to)),
        }
    }

    pub(crate) fn rename(self, name: String) -> Edit {
        match self {
            Self::Object(index) => Edit::Object(index, ObjectEdit::Rename(name)),
            Self::Light(index) => Edit::Light(index, LightEdit::Rename(name)),
        }
    }

    pub(crate) fn set_hidden(self, hidden: bool) -> Edit {
        match self {
            Self::Object(index) => Edit::Object(index, ObjectEdit::SetHidden(hidden)),
            Self::Light(index) => Edit::Light(index, LightEdit::SetHidden(hidden)),
        }
    }

    pub(crate) fn duplicate(self) -> Edit {
        match self {
            Self::Object(index) => Edit::DuplicateObject(index),
            Self::Light(index) => Edit::DuplicateLight(index),
        }
    }

    pub(crate) fn remove(self) -> Edit {
        match self {
            Self::Object(index) => Edit::RemoveObject(index),
            Self::Light(index) => Edit::RemoveLight(index),
        }
    }

    /// The part that an edit brings into the scene, once it is applied.
    pub(crate) fn added_by(edit: &Edit) -> Option<Self> {
        match edit {
            Edit::AddObject(index, _) => Some(Self::Object(*index)),
            Edit::DuplicateObject(index) => Some(Self::Object(index + 1)),
            Edit::AddLight(index, _) => Some(Self::Light(*index)),
            Edit::DuplicateLight(index) => Some(Self::Light(index + 1)),
            _ => None,
        }
    }
}

/// What must be known of a selection to find it again after the scene's lists have changed.
#[derive(Debug, Clone)]
pub(crate) struct Anchor {
    part: Part,
    name: String,
    counts: [usize; 2],
}

impl Anchor {
    pub(crate) fn of(part: Part, scene: &Scene) -> Option<Self> {
        Some(Self { part, name: part.name(scene)?.to_owned(), counts: counts(scene) })
    }

    /// The same thing in the changed scene; `None` if it is gone.
    pub(crate) fn find(&self, scene: &Scene) -> Option<Part> {
        // With as many things as before only a name or a property can have changed, so the place still holds.
        if self.counts == counts(scene) && self.part.exists(scene) {
            return Some(self.part);
        }
        Part::named(scene, &self.name)
    }
}

fn counts(scene: &Scene) -> [usize; 2] {
    [scene.objects.len(), scene.lights.len()]
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::{Light, Object, Shape, Size};

    fn scene() -> Scene {
        let mut scene = Scene::new("s");
        for name in ["a", "b", "c"] {
            let ball = Shape::Sphere { center: Point::ORIGIN, radius: Size::ONE };
            scene.objects.push(Object::new(name, ball));
        }
        scene.lights.push(Light::new("lamp", Point::ORIGIN));
        scene
    }

    #[test]
    fn a_selection_is_found_again_after_removals_and_renames() {
        let mut scene = scene();
        let anchor = Anchor::of(Part::Object(2), &scene).unwrap();
        Edit::RemoveObject(0).apply(&mut scene).unwrap();
        assert_eq!(anchor.find(&scene), Some(Part::Object(1)));
        let anchor = Anchor::of(Part::Object(1), &scene).unwrap();
        Part::Object(1).rename("d".into()).apply(&mut scene).unwrap();
        assert_eq!(anchor.find(&scene), Some(Part::Object(1)));
        let anchor = Anchor::of(Part::Object(1), &scene).unwrap();
        Edit::RemoveObject(1).apply(&mut scene).unwrap();
        assert_eq!(anchor.find(&scene), None);
    }

    #[test]
    fn a_copy_is_what_an_edit_adds() {
        let mut scene = scene();
        let edit = Part::Object(0).duplicate();
        let added = Part::added_by(&edit).unwrap();
        edit.apply(&mut scene).unwrap();
        assert_eq!(added.name(&scene), Some("a 2"));
    }
}
