//! The same object in an older or newer state of a scene: a picture may be older than what is edited.

use luch_scene::Scene;

/// The place in `there` of the object that has place `index` in `here`: the one of the same name.
///
/// Asked for in every frame, so it looks at the same place first: all others are searched only while a picture shows a
/// scene with other objects or names than there are now.
pub(super) fn same_object(here: &Scene, index: usize, there: &Scene) -> Option<usize> {
    let object = here.objects.get(index)?;
    if std::ptr::eq(here, there) {
        return Some(index);
    }
    if there.objects.get(index).is_some_and(|other| other.name == object.name) {
        return Some(index);
    }
    // One of as many objects whose name is gone has been renamed.
    let renamed = (here.objects.len() == there.objects.len()).then_some(index);
    there.object_named(&object.name).or(renamed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use luch_scene::{Edit, Object, ObjectEdit, Point, Shape, Size};

    fn scene() -> Scene {
        let mut scene = Scene::new("s");
        for name in ["a", "b", "c"] {
            scene.objects.push(Object::new(name, Shape::Sphere { center: Point::ORIGIN, radius: Size::ONE }));
        }
        scene
    }

    #[test]
    fn an_object_is_found_after_removals_and_renames() {
        let (before, mut after) = (scene(), scene());
        assert_eq!(same_object(&before, 1, &after), Some(1));
        Edit::Object(1, ObjectEdit::Rename("d".to_owned())).apply(&mut after).unwrap();
        assert_eq!(same_object(&before, 1, &after), Some(1));
        Edit::RemoveObject(0).apply(&mut after).unwrap();
        assert_eq!(same_object(&before, 2, &after), Some(1));
        assert_eq!(same_object(&after, 1, &before), Some(2));
        assert_eq!(same_object(&before, 0, &after), None);
        assert_eq!(same_object(&before, 9, &after), None);
    }
}
